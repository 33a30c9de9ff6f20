#include "calibration/assessment/seam_check.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

namespace vignole {

namespace {

constexpr double kMostTimesExpected = 2.5;
constexpr double kFloorMm = 0.004;  // what the model of the pins' light may be off by

struct Place {
  PinCentre centre;
  Eigen::Matrix<double, 2, kRigParameters> byRig = Eigen::Matrix<double, 2, kRigParameters>::Zero();
};

struct PairSums {
  PinMisfit misfit;
  // By the noise of the points alone, which is new on every pin; what the calibration leaves is common to all.
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  Point2 weighted{0, 0};
  Eigen::Matrix<double, 2, kRigParameters> byRig = Eigen::Matrix<double, 2, kRigParameters>::Zero();

  void add(const Point2& between, const Eigen::Matrix2d& noise, const Eigen::Matrix<double, 2, kRigParameters>& rig) {
    const Eigen::Matrix2d weight = noise.inverse();
    information += weight;
    weighted += weight * between;
    byRig += weight * rig;
  }
  void conclude(const Eigen::MatrixXd& covariance, PairSeam& seam) const {
    const Eigen::Matrix2d noise = information.inverse();
    seam.meanMm = noise * weighted;
    Eigen::Matrix2d u = noise;
    if (covariance.size() > 0) {
      const Eigen::Matrix<double, 2, kRigParameters> rig = noise * byRig;
      u += rig * covariance * rig.transpose();
    }
    const double length = seam.meanMm.norm();
    const Point2 along = length > 0 ? Point2(seam.meanMm / length) : Point2(1, 0);
    seam.uMeanMm = std::sqrt(along.dot(u * along));
  }
};

const CalibratedPin* pinOf(std::span<const CalibratedPin> pins, int number) {
  const auto found = std::find_if(pins.begin(), pins.end(), [&](const CalibratedPin& p) { return p.number == number; });
  return found == pins.end() ? nullptr : &*found;
}

}  // namespace

std::vector<PairSeam> pairSeams(std::span<const PinPixels> arcs, const RigCalibration& calibration,
                                std::span<const CalibratedPin> pins) {
  const bool known = calibration.covariance.size() > 0;
  std::vector<std::optional<Place>> places(arcs.size());
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const CalibratedPin* pin = pinOf(pins, arcs[i].pin);
    if (pin == nullptr) continue;
    const auto c = static_cast<std::size_t>(arcs[i].camera);
    Place place;
    place.centre = centreOf(arcs[i], calibration.rangeFinders[c], pin->radiusMm);
    if (!place.centre.valid) continue;
    if (known)
      place.byRig.middleCols<kCameraParameters>(static_cast<Eigen::Index>(c) * kCameraParameters) =
          placeJacobian(calibration.rangeFinders[c], pixelOf(calibration.rangeFinders[c], place.centre.mm));
    places[i] = place;
  }
  std::array<std::array<PairSums, kCameraCount>, kCameraCount> sums{};
  for (std::size_t i = 0; i < arcs.size(); ++i)
    for (std::size_t j = 0; j < arcs.size(); ++j) {
      if (arcs[i].camera >= arcs[j].camera || arcs[i].pin != arcs[j].pin || arcs[i].placement != arcs[j].placement ||
          !places[i] || !places[j])
        continue;
      const Point2 between = places[i]->centre.mm - places[j]->centre.mm;
      const Eigen::Matrix2d noise = places[i]->centre.covariance + places[j]->centre.covariance;
      const Eigen::Matrix<double, 2, kRigParameters> jacobian = places[i]->byRig - places[j]->byRig;
      Eigen::Matrix2d covariance = noise;
      if (known) covariance += jacobian * calibration.covariance * jacobian.transpose();
      PairSums& pair = sums[static_cast<std::size_t>(arcs[i].camera)][static_cast<std::size_t>(arcs[j].camera)];
      pair.misfit.add(between, covariance);
      pair.add(between, noise, jacobian);
    }
  std::vector<PairSeam> seams;
  for (int a = 0; a < kCameraCount; ++a)
    for (int b = a + 1; b < kCameraCount; ++b) {
      const PairSums& s = sums[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
      if (s.misfit.count() == 0) continue;
      PairSeam seam{a, b, s.misfit.count(), s.misfit.rmsMm(), s.misfit.expectedMm(), {0, 0}, 0};
      s.conclude(calibration.covariance, seam);
      seams.push_back(seam);
    }
  return seams;
}

Check seamCheck(std::span<const PairSeam> seams) {
  Check check{"seam", !seams.empty(), 0, 0, "mm", true, "", ""};
  if (seams.empty()) {
    check.words = "no pin is seen by two cameras";
    return check;
  }
  const auto limitOf = [](const PairSeam& s) { return std::max(kFloorMm, kMostTimesExpected * s.expectedMm); };
  const PairSeam& worst = *std::max_element(seams.begin(), seams.end(), [&](const PairSeam& a, const PairSeam& b) {
    return a.rmsMm * limitOf(b) < b.rmsMm * limitOf(a);
  });
  check.value = worst.rmsMm;
  check.limit = limitOf(worst);
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), "cameras %d and %d see the same pin %.4f mm apart where %.4f mm are expected",
                worst.first + 1, worst.second + 1, worst.rmsMm, worst.expectedMm);
  check.words = text.data();
  check.remedy = "look whether one of the two has moved or its lens has changed, then calibrate again";
  return check;
}

Check seamShiftCheck(std::span<const PairSeam> seams) {
  constexpr double kMostU = 5;
  Check check{"seam shift", !seams.empty(), 0, 0, "mm", true, "no pin is seen by two cameras", ""};
  if (seams.empty()) return check;
  const auto limitOf = [](const PairSeam& s) { return std::max(kFloorMm, kMostU * s.uMeanMm); };
  const PairSeam& worst = *std::max_element(seams.begin(), seams.end(), [&](const PairSeam& a, const PairSeam& b) {
    return a.meanMm.norm() * limitOf(b) < b.meanMm.norm() * limitOf(a);
  });
  check.value = worst.meanMm.norm();
  check.limit = limitOf(worst);
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), "cameras %d and %d see all pins %.4f mm apart (x %+.4f, y %+.4f), u %.4f",
                worst.first + 1, worst.second + 1, check.value, worst.meanMm.x(), worst.meanMm.y(), worst.uMeanMm);
  check.words = text.data();
  check.remedy = "look whether one of the two has moved or its lens has changed, then calibrate again";
  return check;
}

}  // namespace vignole
