#pragma once
// The seams between cameras on every rail that the line measures: drift without a plate. Written by the engine's last
// stage, read by the window's thread.

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "calibration/drift/drift_watch.h"
#include "engine/inspection/inspection.h"

namespace vignole {

/// The indicators after each rail, oldest first, since the calibration was put to use.
struct DriftTrack {
  struct Rail {
    std::array<double, kCameraCount> valueMm{}, limitMm{};
  };
  DriftIndicators latest;
  int baselineRails = 0;    ///< that must pass before there are values
  std::vector<Rail> rails;  ///< after the baseline, the last few hundred
};

class SeamWatch {
 public:
  explicit SeamWatch(const Section& section, const DriftSettings& settings = {});
  /// Another calibration or section: everything is learnt anew. Not while an inspection runs.
  void restart(const Section& section);
  /// Tells the seams of every profile, then what `other` tells; this object outlives the inspection.
  [[nodiscard]] InspectionObserver watched(InspectionObserver other);
  [[nodiscard]] std::shared_ptr<const DriftTrack> track() const;

 private:
  void endRail();

  DriftSettings settings_;
  std::unique_ptr<DriftWatch> watch_;  ///< the engine's last stage alone
  std::vector<DriftTrack::Rail> rails_;
  mutable std::mutex mutex_;
  std::shared_ptr<const DriftTrack> track_;
};

}  // namespace vignole
