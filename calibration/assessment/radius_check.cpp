#include "calibration/assessment/radius_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vignole {

namespace {

constexpr double kLeastArcDeg = 90;
constexpr double kMostU = 5;
constexpr double kFloorMm = 0.02;  // what the model of the pins' light may be off by, through a curvature

}  // namespace

std::array<RadiusMisfit, kCameraCount> radiusMisfits(std::span<const PinPixels> arcs, const RigCalibration& calibration,
                                                     const PinPlate& plate) {
  std::array<RadiusMisfit, kCameraCount> misfits;
  std::array<double, kCameraCount> weights{}, plateVariance{};
  for (const PinPixels& arc : arcs) {
    const auto pin =
        std::find_if(plate.pins.begin(), plate.pins.end(), [&](const Pin& p) { return p.number == arc.pin; });
    if (pin == plate.pins.end() || arc.arcDeg < kLeastArcDeg) continue;
    const auto c = static_cast<std::size_t>(arc.camera);
    const PinRadius radius = radiusOf(arc, calibration.rangeFinders[c], pin->radiusMm);
    if (!radius.valid || !(radius.uMm > 0)) continue;
    const double weight = 1 / (radius.uMm * radius.uMm);
    weights[c] += weight;
    misfits[c].meanMm += weight * (radius.mm - pin->radiusMm);
    plateVariance[c] = std::max(plateVariance[c], pin->uRadiusMm * pin->uRadiusMm);
    ++misfits[c].arcs;
  }
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    if (misfits[c].arcs == 0) continue;
    misfits[c].meanMm /= weights[c];
    const auto pins = static_cast<double>(std::max<std::size_t>(1, plate.pins.size()));
    misfits[c].uMm = std::sqrt(1 / weights[c] + plateVariance[c] / pins);
  }
  return misfits;
}

Check radiusCheck(const std::array<RadiusMisfit, kCameraCount>& misfits) {
  const auto limitOf = [](const RadiusMisfit& m) { return std::max(kFloorMm, kMostU * m.uMm); };
  std::size_t worst = 0;
  bool any = false;
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    any = any || misfits[c].arcs > 0;
    if (std::abs(misfits[c].meanMm) * limitOf(misfits[worst]) > std::abs(misfits[worst].meanMm) * limitOf(misfits[c]))
      worst = c;
  }
  Check check{"pin radii", any, std::abs(misfits[worst].meanMm), limitOf(misfits[worst]), "mm", true, "", ""};
  if (!any) {
    check.words = "no arc is long enough to tell a radius";
    return check;
  }
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "camera %zu sees the pins' radii %+.4f mm off what the plate's file states",
                worst + 1, misfits[worst].meanMm);
  check.words = text.data();
  check.remedy = "measure the radii, or look whether the plate's file is of this plate (radii, not diameters, in mm)";
  return check;
}

}  // namespace vignole
