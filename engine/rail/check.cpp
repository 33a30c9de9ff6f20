#include "engine/rail/check.h"

#include <algorithm>
#include <cmath>

namespace vignole {

std::vector<SectionCheck> checkSection(const Section& section) {
  const SectionProperties p = properties(section);
  const PublishedValues& told = section.published;
  const double share = told.areaTolerancePercent / 100;
  constexpr double kMomentRoundingCm4 = 0.05;  // tables print one decimal
  const double centroidMm = section.standing == SectionStanding::Standard ? 0.05 : 1.0;

  std::vector<SectionCheck> checks = {{"gap", "mm", p.maxGapMm, {}, 1e-3, p.maxGapMm < 1e-3},
                                      {"kink", "deg", p.maxKinkDeg, {}, 0.01, p.maxKinkDeg < 0.01}};
  const auto add = [&](const char* what, const char* unit, double value, const std::optional<double>& published,
                       double tolerance) {
    if (published)
      checks.push_back({what, unit, value, published, tolerance, std::abs(value - *published) <= tolerance});
  };
  add("area", "cm2", p.areaMm2 / 100, told.areaCm2, share * told.areaCm2.value_or(0));
  add("mass", "kg/m", p.massKgPerM, told.massKgPerM, share * told.massKgPerM.value_or(0));
  add("Ix", "cm4", p.ixCm4, told.ixCm4, share * told.ixCm4.value_or(0) + kMomentRoundingCm4);
  add("Iy", "cm4", p.iyCm4, told.iyCm4, share * told.iyCm4.value_or(0) + kMomentRoundingCm4);
  add("yG", "mm", p.centroidYMm, told.centroidYMm, centroidMm);
  return checks;
}

}  // namespace vignole
