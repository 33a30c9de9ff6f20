#include "calibration/assessment/fold_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "calibration/assessment/comparison.h"
#include "calibration/assessment/plane_motion.h"
#include "calibration/range_finders/pin_metrics.h"

namespace vignole {

namespace {

constexpr double kMostTimesExpected = 2;
constexpr double kFloorMm = 0.004;  // what the model of the pins' light may be off by

/// A centre by a solution, and where it should be.
struct Held {
  Point2 found{0, 0}, stated{0, 0};
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of the difference
  double arcDeg = 0;
};

class FoldSums {
 public:
  void add(const Held& h) {
    misfit_.add(h.found - h.stated, h.covariance);
    if (h.arcDeg < kLeastMetricArcDeg) return;
    cd_ += (h.found - h.stated).norm();
    ++cdViews_;
  }
  [[nodiscard]] Fold fold(std::string leftOut) const {
    return {std::move(leftOut), misfit_, cdViews_ > 0 ? cd_ / cdViews_ : 0};
  }

 private:
  PinMisfit misfit_;
  double cd_ = 0;
  int cdViews_ = 0;
};

/// What the solution's covariance gives a place.
Eigen::Matrix2d covarianceOfPlace(const RigCalibration& calibration, int camera, const Point2& mm) {
  if (calibration.covariance.size() == 0) return Eigen::Matrix2d::Zero();
  const RangeFinderCalibration& finder = calibration.rangeFinders[static_cast<std::size_t>(camera)];
  const auto jacobian = placeJacobian(finder, pixelOf(finder, mm));
  const int at = camera * kCameraParameters;
  return jacobian * calibration.covariance.block<kCameraParameters, kCameraParameters>(at, at) * jacobian.transpose();
}

std::optional<Held> heldOut(const PinPixels& arc, const RigCalibration& calibration, const Point2& stated,
                            double radiusMm, double uMm) {
  const PinCentre centre = centreOf(arc, calibration.rangeFinders[static_cast<std::size_t>(arc.camera)], radiusMm);
  if (!centre.valid) return {};
  const Eigen::Matrix2d covariance = centre.covariance + uMm * uMm * Eigen::Matrix2d::Identity() +
                                     covarianceOfPlace(calibration, arc.camera, centre.mm);
  return Held{centre.mm, stated, covariance, arc.arcDeg};
}

}  // namespace

Expected<std::vector<Fold>> pinFolds(const RigInputs& inputs, const RigAdjustmentSettings& settings,
                                     const RigAdjustment& whole, int count, const Job& job) {
  const std::vector<PinPixels> arcs = pinPixels(whole);
  std::vector<Fold> folds;
  for (int k = 0; k < count; ++k) {
    job.report(static_cast<double>(k) / count, "pins left out");
    std::vector<int> left;
    std::string name = "pins";
    for (std::size_t p = static_cast<std::size_t>(k); p < inputs.plate.pins.size();
         p += static_cast<std::size_t>(count)) {
      left.push_back(inputs.plate.pins[p].number);
      name += " " + std::to_string(inputs.plate.pins[p].number);
    }
    const auto isLeft = [&](int pin) { return std::find(left.begin(), left.end(), pin) != left.end(); };
    RigInputs rest = inputs;
    for (PlacementLines& placement : rest.placements)
      for (PinPicture& picture : placement.pictures)
        for (PinArc& arc : picture.arcs)
          if (isLeft(arc.pin)) arc.pin = 0;
    const auto solved = adjustRig(rest, settings, {{}, job.stop});
    if (!solved) return tl::unexpected(solved.error());
    if (!solved->refusals.empty()) continue;  // too few pins for some picture
    FoldSums sums;
    for (const PinPixels& arc : arcs) {
      if (!isLeft(arc.pin)) continue;
      for (const Pin& pin : inputs.plate.pins) {
        if (pin.number != arc.pin) continue;
        const Point2 stated = solved->placements[static_cast<std::size_t>(arc.placement)].worldFromPlate * pin.centreMm;
        if (const auto held = heldOut(arc, solved->calibration, stated, pin.radiusMm, pin.uCentreMm)) sums.add(*held);
      }
    }
    folds.push_back(sums.fold(name));
  }
  return folds;
}

Expected<std::vector<Fold>> placementFolds(const RigInputs& inputs, const RigAdjustmentSettings& settings,
                                           const RigAdjustment& whole, const Job& job) {
  std::vector<Fold> folds;
  const std::size_t count = inputs.placements.size();
  if (count < 2) return folds;
  const std::vector<PinPixels> arcs = pinPixels(whole);
  for (std::size_t m = 0; m < count; ++m) {
    job.report(static_cast<double>(m) / static_cast<double>(count), "placements left out");
    RigInputs rest = inputs;
    rest.placements.erase(rest.placements.begin() + static_cast<std::ptrdiff_t>(m));
    const auto solved = adjustRig(rest, settings, {{}, job.stop});
    if (!solved) return tl::unexpected(solved.error());
    if (!solved->refusals.empty()) continue;
    std::vector<Held> held;
    for (const PinPixels& arc : arcs) {
      if (arc.placement != static_cast<int>(m)) continue;
      for (const CalibratedPin& pin : solved->calibration.pins) {
        if (pin.number != arc.pin) continue;
        if (auto h = heldOut(arc, solved->calibration, {pin.xMm, pin.yMm}, pin.radiusMm, pin.uMm)) held.push_back(*h);
      }
    }
    if (held.size() < 4) continue;
    std::vector<Point2> pins, found;
    for (const Held& h : held) {
      pins.push_back(h.stated);
      found.push_back(h.found);
    }
    const Transform2 worldFromPlate = laidOnto(pins, found);
    FoldSums sums;
    for (Held& h : held) {
      h.stated = worldFromPlate * h.stated;
      sums.add(h);
    }
    folds.push_back(sums.fold(inputs.placements[m].folder.empty() ? "placement " + std::to_string(m + 1)
                                                                  : inputs.placements[m].folder));
  }
  return folds;
}

Check foldCheck(const std::string& what, const std::vector<Fold>& folds) {
  Check check{what, false, 0, 0, "mm", true, "there are too few to leave any out", ""};
  PinMisfit all;
  const Fold* worst = nullptr;
  for (const Fold& fold : folds) {
    if (fold.misfit.count() == 0) continue;
    all += fold.misfit;
    if (worst == nullptr || fold.misfit.rmsMm() > worst->misfit.rmsMm()) worst = &fold;
  }
  if (worst == nullptr) return check;
  check.done = true;
  check.value = all.rmsMm();
  check.limit = std::max(kFloorMm, kMostTimesExpected * all.expectedMm());
  std::array<char, 320> text{};
  std::snprintf(text.data(), text.size(),
                "what was left out lies %.4f mm off where %.4f mm are expected, most of all %s (%.4f mm)", check.value,
                all.expectedMm(), worst->leftOut.c_str(), worst->misfit.rmsMm());
  check.words = text.data();
  check.remedy =
      "look whether the plate's file is of this plate, whether a pin is bent or worn, and whether anything moved "
      "between the pictures of a placement";
  return check;
}

Expected<Reversal> plateReversal(const RigInputs& inputs, const RigAdjustmentSettings& settings,
                                 const RigAdjustment& whole, const Section& section,
                                 const DimensionParameters& parameters, const Job& job) {
  Reversal reversal;
  std::array<RigInputs, 2> halves{inputs, inputs};
  for (RigInputs& half : halves) half.placements.clear();
  for (std::size_t m = 0; m < inputs.placements.size(); ++m) {
    const double turn = std::remainder(whole.placements[m].worldFromPlate.angleRad, 2 * std::numbers::pi);
    halves[std::abs(turn) > std::numbers::pi / 2 ? 1 : 0].placements.push_back(inputs.placements[m]);
  }
  if (halves[0].placements.empty() || halves[1].placements.empty()) {
    reversal.why = "all placements stand the same way round: add one that is turned by 180 degrees";
    return reversal;
  }
  std::array<RigAdjustment, 2> solved;
  for (std::size_t k = 0; k < 2; ++k) {
    job.report(0.5 * static_cast<double>(k), "plate reversed");
    auto one = adjustRig(halves[k], settings, {{}, job.stop});
    if (!one) return tl::unexpected(one.error());
    if (!one->refusals.empty()) {
      reversal.why = "one way round the placements do not suffice: " + one->refusals.front();
      return reversal;
    }
    solved[k] = std::move(*one);
  }
  // In the world of the whole, in which the section stands upright.
  for (RigAdjustment& one : solved)
    one.calibration = inWorld(one.calibration, worldOf(whole.calibration, one.calibration));
  const auto compared = compare(solved[1].calibration, solved[0].calibration, section, parameters);
  if (!compared) {
    reversal.why = "the section cannot be measured: " + compared.error().message();
    return reversal;
  }
  reversal.done = true;
  reversal.differenceMm = compared->differenceMm;
  reversal.uMm = compared->uMm;
  return reversal;
}

Check reversalCheck(const Reversal& reversal) {
  constexpr double kMostU = 5;
  Check check{"plate reversal", reversal.done, 0, kMostU, "u", true, reversal.why, ""};
  if (!reversal.done) return check;
  Dimension worst = Dimension::RH;
  for (const Dimension d : kDimensions) {
    if (d == Dimension::HF || d == Dimension::HR) continue;  // an extreme, and one that its own noise rules
    const double value = std::abs(reversal.differenceMm[index(d)]) / std::max(3e-3, reversal.uMm[index(d)]);
    if (value > check.value) {
      check.value = value;
      worst = d;
    }
  }
  std::array<char, 240> text{};
  std::snprintf(text.data(), text.size(), "the plate and the plate turned by 180 degrees give %s %.4f mm apart, u %.4f",
                std::string(name(worst)).c_str(), reversal.differenceMm[index(worst)], reversal.uMm[index(worst)]);
  check.words = text.data();
  check.remedy = "measure the pins' places, or look whether the plate bends or was touched when it was turned";
  return check;
}

}  // namespace vignole
