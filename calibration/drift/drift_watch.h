#pragma once
// Drift in production: a camera that moves after its calibration shows in the seams between it and its neighbours, on
// every rail, without a plate.
//
// Model: the points of camera c lie aside by (x, y) and are turned about the middle of the section; a seam sees the
// difference of two cameras along the outline's normal. Each camera by itself is asked whether its motion alone
// explains how the seams have changed since the first rails after the calibration; the one that explains most is
// named. What cannot be seen: all cameras moving together or growing alike; and hardly: both left cameras against
// both right ones, crosswise (only the slopes of the crown see it), both upper ones against both lower ones, up and
// down (only the fillets of the web see it). Motion along the rail changes nothing. If several cameras have moved, what
// one of them did can often be told as what its neighbours did: then one is named, with the remark that it is not all.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "calibration/drift/rail_seams.h"

namespace vignole {

struct DriftSettings {
  int baselineRails = 6;     ///< first rails after the calibration: what the seams are like when nothing has moved
  double lambda = 0.15;      ///< weight of the newest rail in the mean that is watched (EWMA)
  double limitMm = 0.012;    ///< least shift that is alarming
  double limitInU = 6;       ///< and in standard uncertainties
  int everyNthProfile = 10;  ///< only these are looked at
};

struct CameraDrift {
  int camera = 0;
  /// The largest shift that the camera's points have somewhere on the outline that it shares, if it alone has moved; if
  /// another camera is named, beside that one's motion.
  double valueMm = 0;
  double uMm = 0;                        ///< standard uncertainty of that shift
  double limitMm = 0;                    ///< alarm above
  double xMm = 0, yMm = 0, turnDeg = 0;  ///< of its points, since the baseline; the turn about the section's middle
  bool alarm = false;
  std::string words;  ///< what has happened and what to do; empty without an alarm
};

struct DriftIndicators {
  std::uint64_t rails = 0;  ///< that had seams to look at
  bool learning = true;     ///< the baseline is not complete: no values yet
  std::array<CameraDrift, kCameraCount> cameras;
  /// Seams have changed as no camera's motion explains: chi^2 a degree of freedom that is left, 1 by noise.
  double unexplained = 0;
  [[nodiscard]] bool alarm() const {
    for (const CameraDrift& c : cameras)
      if (c.alarm) return true;
    return false;
  }
};

/// Judges rail after rail by their seams. One for each section and calibration.
class DriftJudge {
 public:
  DriftJudge(std::vector<SeamZone> zones, const DriftSettings& settings);
  /// A rail without seams changes nothing.
  const DriftIndicators& add(const std::vector<Seam>& rail);
  [[nodiscard]] const DriftIndicators& indicators() const { return indicators_; }

 private:
  /// What is known of the seam in one zone.
  struct State {
    int rails = 0;  ///< of the baseline that had it
    double baseWeight = 0, baseMm = 0, baseSquares = 0;
    double changeMm = 0;        ///< since the baseline, weighted mean over the latest rails
    double changeVariance = 0;  ///< of that, for seams of weight 1
  };
  struct Motion;
  void learn(const std::vector<Seam>& rail);
  void finishBaseline();
  void follow(const std::vector<Seam>& rail);
  void judge();
  [[nodiscard]] Motion motionOf(std::vector<int> cameras) const;
  void describe(const Motion& motion, std::size_t which, CameraDrift& drift) const;

  std::vector<SeamZone> zones_;
  DriftSettings settings_;
  std::vector<State> states_;
  double variance_ = 0;  ///< of a seam of weight 1 from one rail to the next, mm^2
  DriftIndicators indicators_;
};

/// The same from profiles. Not for two threads at once.
class DriftWatch {
 public:
  explicit DriftWatch(const Section& section, const DriftSettings& settings = {});
  /// Cheap: most profiles are passed by.
  void add(const Profile& profile, const Registration& registration);
  const DriftIndicators& endRail();
  [[nodiscard]] const DriftIndicators& indicators() const { return judge_.indicators(); }

 private:
  DriftSettings settings_;
  RailSeams seams_;
  DriftJudge judge_;
  std::uint64_t profile_ = 0;
};

}  // namespace vignole
