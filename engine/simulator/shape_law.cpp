#include "engine/simulator/shape_law.h"

#include <cmath>
#include <numbers>

#include "engine/simulator/hashing.h"

namespace vignole::simulator {

namespace {

struct Amount {
  double mean, amplitude;
};
// mm; in the order of Dimension: RH RFH FW HF HW HWA FT_l FT_r RAS_l RAS_r WT HR FC. HF and FC of rolled rails lean to
// the positive side; HWA and RAS follow from others;
// HF and HR are scaled by what the crown can take (6 mm of HR on 60E1).
constexpr PerDimension<Amount> kAmounts = {{{0.02, 0.14},
                                            {0.0, 0.14},
                                            {-0.05, 0.25},
                                            {0.08, 0.06},
                                            {0.03, 0.12},
                                            {0, 0},
                                            {0.04, 0.15},
                                            {0.02, 0.15},
                                            {0, 0},
                                            {0, 0},
                                            {0.08, 0.18},
                                            {0, 0},
                                            {0.05, 0.06}}};
constexpr Amount kHeadShift = {0.0, 0.2};
constexpr std::array<double, 3> kShares = {0.5, 0.3, 0.2};
constexpr double kShortestMm = 2000, kLongestMm = 40000;
constexpr double kContradictionMm = 1e-9;

}  // namespace

double ShapeLaw::Variation::at(double positionMm) const {
  double value = mean;
  for (std::size_t i = 0; i < sines.size(); ++i)
    value += amplitude * kShares[i] * std::sin(sines[i].waveNumber * positionMm + sines[i].phase);
  return value;
}

Expected<ShapeLaw> ShapeLaw::create(std::uint64_t seed, bool vary, const CrownLatitude& crown,
                                    const PerDimension<std::optional<double>>& deviationMm) {
  ShapeLaw law;
  const auto draw = [&](const Amount& amount, std::uint64_t which) {
    Variation v;
    if (!vary) return v;
    Draws draws(seed, Stream::Shape, {which});
    v.mean = amount.mean;
    v.amplitude = amount.amplitude;
    for (Sine& sine : v.sines) {
      // Uniform in the logarithm: as many short as long waves.
      const double wavelength = kShortestMm * std::pow(kLongestMm / kShortestMm, draws.uniform());
      sine = {2 * std::numbers::pi / wavelength, 2 * std::numbers::pi * draws.uniform()};
    }
    return v;
  };
  PerDimension<Amount> amounts = kAmounts;
  amounts[index(Dimension::HF)].mean *= crown.hfShare;
  amounts[index(Dimension::HF)].amplitude *= crown.hfShare;
  amounts[index(Dimension::HR)].amplitude = crown.hrMm;
  for (const Dimension d : kDimensions) law.variations_[index(d)] = draw(amounts[index(d)], index(d));
  law.headShift_ = draw(kHeadShift, kDimensionCount);

  law.fixed_ = deviationMm;
  for (const auto& deviation : deviationMm)
    if (deviation && !std::isfinite(*deviation)) return inputError("deviation", "is no number");
  auto& hw = law.fixed_[index(Dimension::HW)];
  const auto& hwa = law.fixed_[index(Dimension::HWA)];
  if (hw && hwa && std::abs(*hw - *hwa) > kContradictionMm)
    return inputError("deviation HWA", "contradicts that of HW: both are the width of the same head; give one of them");
  law.headAtArema_ = hwa && !hw;
  if (hwa) hw = hwa;
  // FW = RAS_l + HW + RAS_r: three of them set the fourth.
  auto& fw = law.fixed_[index(Dimension::FW)];
  const auto& l = law.fixed_[index(Dimension::RASl)];
  const auto& r = law.fixed_[index(Dimension::RASr)];
  if (l && r) {
    if (fw && hw && std::abs(*fw - *hw - *l - *r) > kContradictionMm)
      return inputError("deviations of FW, HW, RAS_l and RAS_r", "do not add up: FW = RAS_l + HW + RAS_r; give three");
    if (!hw && fw) hw = *fw - *l - *r;
    if (!fw && hw) fw = *hw + *l + *r;
  }
  return law;
}

OutlineDeviation ShapeLaw::at(double positionMm) const {
  OutlineDeviation deviation;
  auto& mm = deviation.mm;
  for (const Dimension d : kDimensions)
    mm[index(d)] = fixed_[index(d)] ? *fixed_[index(d)] : variations_[index(d)].at(positionMm);
  const auto& l = fixed_[index(Dimension::RASl)];
  const auto& r = fixed_[index(Dimension::RASr)];
  // Both sides given and neither FW nor HW: the head width is what is left.
  if (l && r && !fixed_[index(Dimension::HW)]) mm[index(Dimension::HW)] = mm[index(Dimension::FW)] - *l - *r;
  const double half = (mm[index(Dimension::FW)] - mm[index(Dimension::HW)]) / 2;
  deviation.headShiftMm = r ? half - *r : l ? *l - half : headShift_.at(positionMm);
  deviation.headAtArema = headAtArema_;
  return deviation;
}

}  // namespace vignole::simulator
