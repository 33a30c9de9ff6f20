#pragma once
// What is said of one rail when it has passed: per dimension mean, extremes, uncertainty, verdict and exceptions. Fed
// profile by profile, constant memory whatever the length.

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/inspection/inspection.h"
#include "engine/quality/running_statistics.h"

namespace vignole {

/// A stretch of at least `RailSummarySettings::minExceptionProfiles` consecutive profiles out of tolerance.
struct DimensionException {
  double fromM = 0, toM = 0;
  double worstMm = 0;  ///< the value furthest outside
};

/// Values along the rail in at most RailSummarySettings::trackBins bins; bins are merged in pairs when a rail is
/// longer.
struct TrackBin {
  double positionM = 0;  ///< middle
  double meanMm = 0, minMm = 0, maxMm = 0;
  std::uint32_t count = 0;  ///< 0: not measured here
};

/// Radii averaged as curvatures with weights 1 / u^2: a radius from one profile is a skewed estimate of little weight
/// where the curve is short, its curvature is not skewed. u: of the mean, from the uncertainties of the profiles alone,
/// without what they have in common (the calibration).
class RadiusMean {
 public:
  RadiusMean() = default;
  /// As it was when these numbers were taken from it; u > 0.
  RadiusMean(double radiusMm, double uMm);
  void add(double radiusMm, double uMm);
  [[nodiscard]] bool empty() const { return !(weight_ > 0); }
  [[nodiscard]] double radiusMm() const { return 1 / curvature_; }
  [[nodiscard]] double uMm() const { return radiusMm() * radiusMm() / std::sqrt(weight_); }

 private:
  double curvature_ = 0;  ///< 1/mm
  double weight_ = 0;     ///< mm^2
};

struct DimensionSummary {
  Dimension dimension = Dimension::RH;
  double nominalMm = 0;
  std::optional<double> lowerMm, upperMm;
  RunningStatistics values;   ///< over the profiles where it was measured
  RadiusMean radius;          ///< HR: the same
  double uMm = 0;             ///< mean standard uncertainty of a single profile, of everything
  double uCalibrationMm = 0;  ///< the part of it that all profiles have in common
  std::uint64_t notMeasured = 0;
  std::string reason;  ///< the most recent reason for not measured
  Verdict verdict = Verdict::NotMeasured;
  std::vector<DimensionException> exceptions;
  std::vector<TrackBin> track;

  /// Over the rail: of HR the radius of the mean curvature. 0 where it was not measured.
  [[nodiscard]] double meanMm() const { return radius.empty() ? values.mean() : radius.radiusMm(); }
  /// Standard uncertainty of that mean: what is new in every profile averages out, the calibration's part stays.
  [[nodiscard]] double uOfMeanMm() const;
};

/// How far a measured value lies beyond its limits (negative: inside, and how far), in the terms in which a dimension is
/// judged. Empty without a value or without limits.
[[nodiscard]] std::optional<double> excessMm(Dimension dimension, const DimensionResult& result);

/// Another section than the recipe's, which explains at least half of the profiles of a rail where the recipe's does
/// not; chi2 as in OtherSection, mean over those profiles.
struct OtherRail {
  std::string section;
  std::uint64_t profiles = 0;
  double chi2 = 0, chi2OfRecipe = 0;
};

struct RailSummary {
  RailBegin rail;
  std::string recipe;  ///< name and version
  std::string calibrationId;
  std::string calibrationWarning;  ///< "overdue by 12 days"; set by who knows the calibration
  double lengthM = 0;
  std::uint64_t profiles = 0;
  Verdict verdict = Verdict::NotMeasured;
  std::optional<OtherRail> looksLike;
  PerDimension<DimensionSummary> dimensions;
  TriggerLedger triggers;
};

/// Verdict of a dimension over the rail. Fail: an exception, or at least half of its measured profiles fail (short
/// rails). Near: short of that, minExceptionProfiles consecutive profiles are near or fail, or the mean lies within the
/// guard band 2 u of a limit (or beyond it). Pass otherwise; NotMeasured without a value; NoLimit without limits.
/// A profile in which the dimension was not measured neither ends a stretch nor lengthens it: a camera that fails now
/// and then must not hide a defect. Verdict of the rail: the worst of fail, not measured, near, pass over the
/// dimensions that have limits.
struct RailSummarySettings {
  int minExceptionProfiles = 3;
  std::size_t trackBins = 512;
  std::size_t maxExceptions = 1000;  ///< per dimension; further ones widen the last
};

class RailSummariser {
 public:
  RailSummariser(const RailBegin& rail, const Recipe& recipe, const std::string& calibrationId,
                 const RailSummarySettings& settings = {});
  void add(const ProfileResult& result);
  [[nodiscard]] RailSummary summary(const TriggerLedger& triggers) const;  ///< so far; may be called at any time

 private:
  /// Consecutive profiles with the same finding, up to the latest.
  struct Run {
    std::uint64_t profiles = 0;
    double fromM = 0, toM = 0;
    double worstMm = 0, worstBy = 0;  ///< value furthest outside, and how far
  };
  [[nodiscard]] std::size_t binAt(double positionM) const;
  void addToTrack(DimensionSummary& dimension, double positionM, double valueMm) const;
  void addToRuns(std::size_t dimension, double positionM, const DimensionResult& result);
  void addToOthers(const OtherSection& other);
  [[nodiscard]] std::optional<OtherRail> otherRail() const;
  void widenBins();
  void appendException(DimensionSummary& dimension, const Run& run) const;
  [[nodiscard]] Verdict verdictOf(std::size_t dimension, const DimensionSummary& summary) const;

  RailSummary summary_;
  RailSummarySettings settings_;
  PerDimension<Run> failing_{};
  PerDimension<std::uint64_t> notPassing_{};  ///< length of the present stretch of near or fail
  PerDimension<std::uint64_t> longestNotPassing_{};
  PerDimension<std::uint64_t> failed_{};  ///< profiles
  std::map<std::string, OtherRail> others_;
  double binWidthM_ = 0;
};

}  // namespace vignole
