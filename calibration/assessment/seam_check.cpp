#include "calibration/assessment/seam_check.h"

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
  Misfit misfit;
  Point2 sum{0, 0};
};

const CalibratedPin* pinOf(std::span<const CalibratedPin> pins, int number) {
  const auto found = std::find_if(pins.begin(), pins.end(), [&](const CalibratedPin& p) { return p.number == number; });
  return found == pins.end() ? nullptr : &*found;
}

}  // namespace

std::vector<PairSeam> pairSeams(std::span<const PinPixels> arcs, const RigCalibration& calibration,
                                std::span<const CalibratedPin> pins) {
  std::vector<PlaneMap> maps;
  for (const RangeFinderCalibration& finder : calibration.rangeFinders) maps.emplace_back(finder);
  const bool known = calibration.covariance.size() > 0;
  std::vector<std::optional<Place>> places(arcs.size());
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const CalibratedPin* pin = pinOf(pins, arcs[i].pin);
    if (pin == nullptr) continue;
    const auto c = static_cast<std::size_t>(arcs[i].camera);
    Place place;
    place.centre = centreOf(arcs[i], maps[c], pin->radiusMm);
    if (!place.centre.valid) continue;
    if (known)
      place.byRig.middleCols<kCameraParameters>(arcs[i].camera * kCameraParameters) =
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
      Eigen::Matrix2d covariance = places[i]->centre.covariance + places[j]->centre.covariance;
      if (known) {
        const Eigen::Matrix<double, 2, kRigParameters> jacobian = places[i]->byRig - places[j]->byRig;
        covariance += jacobian * calibration.covariance * jacobian.transpose();
      }
      PairSums& pair = sums[static_cast<std::size_t>(arcs[i].camera)][static_cast<std::size_t>(arcs[j].camera)];
      pair.misfit.add(between, covariance);
      pair.sum += between;
    }
  std::vector<PairSeam> seams;
  for (int a = 0; a < kCameraCount; ++a)
    for (int b = a + 1; b < kCameraCount; ++b) {
      const PairSums& s = sums[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
      const int both = s.misfit.count();
      if (both > 0) seams.push_back({a, b, both, s.misfit.rmsMm(), s.misfit.expectedMm(), s.sum / both});
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

}  // namespace vignole
