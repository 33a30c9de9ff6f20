#include "calibration/assessment/existing_calibration.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "calibration/assessment/pin_centres.h"
#include "calibration/assessment/plane_motion.h"
#include "calibration/range_finders/pin_metrics.h"
#include "engine/geometry/fit.h"

namespace vignole {

namespace {

const Pin* pinOf(const PinPlate& plate, int number) {
  for (const Pin& pin : plate.pins)
    if (pin.number == number) return &pin;
  return nullptr;
}

struct Centre {
  Point2 found{0, 0}, pin{0, 0};
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  const PinPixels* arc = nullptr;
};

/// Where the calibration puts the pins of one placement, each camera by itself.
std::vector<Centre> centresIn(int placement, const std::vector<PinPixels>& arcs, const RigCalibration& calibration,
                              const PinPlate& plate) {
  std::vector<Centre> centres;
  for (const PinPixels& arc : arcs) {
    const Pin* pin = pinOf(plate, arc.pin);
    if (arc.placement != placement || pin == nullptr) continue;
    const auto c = static_cast<std::size_t>(arc.camera);
    const PinCentre centre = centreOf(arc, calibration.rangeFinders[c], pin->radiusMm);
    if (!centre.valid) continue;
    Eigen::Matrix2d covariance = centre.covariance + pin->uCentreMm * pin->uCentreMm * Eigen::Matrix2d::Identity();
    if (calibration.covariance.size() > 0) {
      const auto jacobian = placeJacobian(calibration.rangeFinders[c], pixelOf(calibration.rangeFinders[c], centre.mm));
      const int at = arc.camera * kCameraParameters;
      covariance +=
          jacobian * calibration.covariance.block<kCameraParameters, kCameraParameters>(at, at) * jacobian.transpose();
    }
    centres.push_back({centre.mm, pin->centreMm, covariance, &arc});
  }
  return centres;
}

/// Values of Table IV of one camera.
struct Metrics {
  std::vector<double> cd, rd, pd;
};

void addMetrics(const Centre& centre, const PlaneMap& map, const Transform2& worldFromPlate, double radiusMm,
                Metrics& metrics) {
  if (centre.arc->arcDeg < kLeastMetricArcDeg) return;
  std::vector<Point2> points;
  for (const Point2& px : centre.arc->px) {
    const PlanePoint p = map(px.x(), px.y());
    points.emplace_back(p.x, p.y);
  }
  const auto circle = fitCircle(points);
  if (!circle) return;
  metrics.cd.push_back((circle->centre - worldFromPlate * centre.pin).norm());
  metrics.rd.push_back(std::abs(circle->radiusMm - radiusMm));
  double distance = 0;
  for (const Point2& p : points) distance += std::abs((p - circle->centre).norm() - radiusMm);
  metrics.pd.push_back(distance / static_cast<double>(points.size()));
}

std::string folderOf(const RigInputs& inputs, std::size_t placement) {
  const std::string& folder = inputs.placements[placement].folder;
  return folder.empty() ? "placement " + std::to_string(placement + 1) : folder;
}

Check pinsCheck(const std::vector<Fold>& placements) {
  Check check = foldCheck("pins", placements);
  if (!check.done) return check;
  PinMisfit all;
  for (const Fold& fold : placements) all += fold.misfit;
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "the pins lie %.4f mm off where %.4f mm are expected", check.value,
                all.expectedMm());
  check.words = text.data();
  check.remedy =
      "calibrate again; if the pins do not fit then either, look whether the plate is the one that this calibration "
      "was made with, and undamaged";
  return check;
}

Check dimensionsCheck(const Expected<Comparison>& compared) {
  Check check{"dimensions", true, 1e6, 1, "u", true, "", "calibrate again, and find out what has moved"};
  if (!compared) {
    check.words =
        "what these placements' cameras see of a rail makes none by this calibration (" + compared.error().what + ")";
    return check;
  }
  const Check comparison = comparisonCheck(*compared);
  check.value = comparison.value;
  check.limit = comparison.limit;
  check.words = "beside a calibration by these placements alone, " + comparison.words;
  return check;
}

Check ageCheck(const RigCalibration& calibration, const CalibrationAge& age) {
  Check check{"age",
              calibration.intervalDays > 0,
              age.days.value_or(0),
              static_cast<double>(calibration.intervalDays),
              "days",
              true,
              "",
              "calibrate again"};
  check.words = check.done ? "the calibration is " + (age.overdue ? warningOf(calibration, age) : "within its interval")
                           : "the calibration states no interval";
  if (age.overdue) check.value = std::max(check.value, check.limit + 1);  // made in the future, too
  return check;
}

}  // namespace

Expected<RigInputs> inputsFor(const RigCalibration& calibration, const std::optional<PinPlate>& plate) {
  if (calibration.pins.empty() && !plate)
    return inputError("the calibration", "holds no pins; give the plate with --plate");
  RigInputs inputs;
  if (plate) {
    inputs.plate = *plate;
  } else {
    inputs.plate.id = calibration.plate;
    inputs.plate.measured = true;
    for (const CalibratedPin& pin : calibration.pins)
      inputs.plate.pins.push_back({pin.number, {pin.xMm, pin.yMm}, pin.radiusMm, pin.uMm, pin.uRadiusMm});
  }
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    CalibratedIntrinsics& camera = inputs.cameras[c];
    camera.serial = calibration.rangeFinders[c].serial;
    camera.created = calibration.created;
    camera.intrinsics = calibration.rangeFinders[c].intrinsics;
    const auto at = static_cast<Eigen::Index>(c) * kCameraParameters;
    if (calibration.covariance.size() > 0) camera.covariance = calibration.covariance.block<10, 10>(at, at);
  }
  return inputs;
}

std::vector<DimensionUncertainty> dimensionUncertaintyByCamera(const DimensionJacobian& jacobian,
                                                               const RigCalibration& rig) {
  const std::vector<ErrorSource> whole = {errorSource(rig)};
  std::vector<DimensionUncertainty> all = dimensionUncertainty(jacobian, whole);
  for (DimensionUncertainty& one : all) {
    one.contributions.clear();
    if (rig.covariance.size() == 0) continue;
    const auto row = jacobian.row(static_cast<int>(index(one.dimension)));
    const Eigen::VectorXd shared = rig.covariance * row.transpose();
    for (int c = 0; c < kCameraCount; ++c) {
      const Eigen::Index at = static_cast<Eigen::Index>(c) * kCameraParameters;
      const double part = row.segment<kCameraParameters>(at).dot(shared.segment<kCameraParameters>(at));
      // A part may be negative where cameras' errors cancel: then it takes away, and is told as nothing.
      one.contributions.push_back({"camera " + std::to_string(c + 1), std::sqrt(std::max(0.0, part))});
    }
    std::stable_sort(one.contributions.begin(), one.contributions.end(),
                     [](const Contribution& a, const Contribution& b) { return a.uMm > b.uMm; });
  }
  return all;
}

Expected<ExistingCalibration> judgeExisting(const RigCalibration& calibration, const RigInputs& inputs,
                                            const RigAdjustment& adjustment, const Section& section,
                                            const DimensionParameters& parameters, std::chrono::sys_seconds now) {
  ExistingCalibration result;
  const std::vector<PinPixels> arcs = pinPixels(adjustment);
  const std::vector<PlaneMap> maps(calibration.rangeFinders.begin(), calibration.rangeFinders.end());
  std::array<Metrics, kCameraCount> metrics;
  for (std::size_t m = 0; m < inputs.placements.size(); ++m) {
    const auto centres = centresIn(static_cast<int>(m), arcs, calibration, inputs.plate);
    if (centres.size() < 4) continue;
    std::vector<Point2> pins, found;
    for (const Centre& c : centres) {
      pins.push_back(c.pin);
      found.push_back(c.found);
    }
    const Transform2 worldFromPlate = laidOnto(pins, found);
    Fold fold{folderOf(inputs, m), {}, 0};
    for (const Centre& c : centres) {
      fold.misfit.add(c.found - worldFromPlate * c.pin, c.covariance);
      const auto camera = static_cast<std::size_t>(c.arc->camera);
      addMetrics(c, maps[camera], worldFromPlate, pinOf(inputs.plate, c.arc->pin)->radiusMm, metrics[camera]);
    }
    result.placements.push_back(std::move(fold));
  }
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    result.cd[c] = spreadOf(metrics[c].cd);
    result.rd[c] = spreadOf(metrics[c].rd);
    result.pd[c] = spreadOf(metrics[c].pd);
  }
  std::vector<CalibratedPin> radii;
  for (const Pin& pin : inputs.plate.pins)
    radii.push_back({pin.number, pin.centreMm.x(), pin.centreMm.y(), pin.radiusMm, pin.uCentreMm, pin.uRadiusMm});
  result.seams = pairSeams(arcs, calibration, radii);

  const auto jacobian = dimensionJacobian(section, parameters, calibration);
  if (!jacobian) return tl::unexpected(jacobian.error());
  result.dimensions = dimensionUncertaintyByCamera(*jacobian, calibration);
  // By the world of the calibration, in which the section stands where it does in production.
  const RigCalibration fresh = inWorld(adjustment.calibration, worldOf(calibration, adjustment.calibration));
  const auto compared = compare(calibration, fresh, section, parameters);
  if (compared) result.withNew = *compared;
  result.age = ageOf(calibration, now);

  result.checks = {pinsCheck(result.placements), seamCheck(result.seams), seamShiftCheck(result.seams)};
  result.checks.push_back(dimensionsCheck(compared));
  result.checks.push_back(ageCheck(calibration, result.age));
  return result;
}

}  // namespace vignole
