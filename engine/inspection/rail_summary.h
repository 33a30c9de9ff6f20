#pragma once
// What is said of one rail when it has passed: per dimension mean, extremes, uncertainty, verdict and exceptions. Fed
// profile by profile, constant memory whatever the length.

#include <cstdint>
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

/// Values along the rail in at most RailSummarySettings::trackBins bins; bins are merged in pairs when a rail is longer.
struct TrackBin {
  double positionM = 0;  ///< middle
  double meanMm = 0, minMm = 0, maxMm = 0;
  std::uint32_t count = 0;  ///< 0: not measured here
};

struct DimensionSummary {
  Dimension dimension = Dimension::RH;
  double nominalMm = 0;
  std::optional<double> lowerMm, upperMm;
  RunningStatistics values;      ///< over the profiles where it was measured
  double uMm = 0;                ///< mean standard uncertainty of a single profile
  std::uint64_t notMeasured = 0;
  std::string reason;            ///< the most recent reason for not measured
  Verdict verdict = Verdict::NotMeasured;
  std::vector<DimensionException> exceptions;
  std::vector<TrackBin> track;
};

struct RailSummary {
  RailBegin rail;
  std::string recipe;            ///< name and version
  std::string calibrationId;
  double lengthM = 0;
  std::uint64_t profiles = 0;
  Verdict verdict = Verdict::NotMeasured;
  PerDimension<DimensionSummary> dimensions;
  TriggerLedger triggers;
};

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
  RailSummary summary_;
  RailSummarySettings settings_;
  struct Run {
    std::uint64_t profiles = 0;
    double fromM = 0, toM = 0, worstMm = 0, worstBy = 0;
  };
  PerDimension<Run> runs_{};
  double binWidthM_ = 0;
};

}  // namespace vignole
