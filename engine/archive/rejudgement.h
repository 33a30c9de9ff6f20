#pragma once
// Stored rails judged against other limits, as they would have been: before a recipe is approved.

#include "engine/archive/rail_archive.h"

namespace vignole {

struct RejudgedRail {
  std::int64_t key = 0;
  std::string id;
  Verdict before = Verdict::NotMeasured, after = Verdict::NotMeasured;
  PerDimension<Verdict> dimensionsBefore{}, dimensionsAfter{};
};

/// `limits`: deviations from the nominals the rail was measured against. Every kept profile is judged again by the
/// rules of measuring (verdict.h, RailSummariser); nothing is measured again. Refuses a rail whose recipe cannot be
/// read.
[[nodiscard]] Expected<RejudgedRail> rejudge(const RailArchive& rails, std::int64_t key,
                                             const PerDimension<ToleranceLimits>& limits);

}  // namespace vignole
