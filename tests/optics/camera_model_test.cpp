#include "engine/optics/camera_model.h"

#include <Eigen/Geometry>
#include <array>
#include <ceres/jet.h>
#include <cmath>
#include <gtest/gtest.h>

namespace vignole {
namespace {

Intrinsics division(double kappa) {
  Intrinsics in;
  in.kappa = kappa;
  return in;
}
Intrinsics polynomial() {
  Intrinsics in;
  in.model = DistortionModel::Polynomial;
  in.k1 = -4e-4;
  in.k2 = 3e-6;
  in.k3 = -2e-8;
  in.p1 = 1e-4;
  in.p2 = -2e-4;
  return in;
}

class CameraModel : public testing::TestWithParam<Intrinsics> {};
INSTANTIATE_TEST_SUITE_P(Lenses, CameraModel,
                         testing::Values(division(0), division(-2e-3), division(1.5e-3), polynomial()));

TEST_P(CameraModel, PixelsSurviveUndistortionAndDistortion) {
  const Lens<double> l = lens(GetParam());
  for (double column = -20; column <= 1420; column += 60)
    for (double row = -20; row <= 1044; row += 56) {
      const Eigen::Vector2d back =
          pixelFromSensor<double>(l, distort<double>(l, undistortedFromPixel<double>(l, {column, row})));
      EXPECT_NEAR(back.x(), column, 1e-9);
      EXPECT_NEAR(back.y(), row, 1e-9);
    }
}

/// All unknowns of Eq. (1): focal, principal point, distortion, rotation vector, translation, and the world point.
constexpr int kUnknowns = 18;
template <typename T>
Vector2T<T> projectUnknowns(const Intrinsics& in, const std::array<T, kUnknowns>& p) {
  Lens<T> l = lens<T>(in);
  l.focalMm = p[0];
  l.cxPx = p[1];
  l.cyPx = p[2];
  l.kappa = p[3];
  l.k1 = p[4];
  l.k2 = p[5];
  l.k3 = p[6];
  l.p1 = p[7];
  l.p2 = p[8];
  // Small-angle product of three rotations keeps this test independent of any rotation helper.
  using std::cos;
  using std::sin;
  Matrix3T<T> rx = Matrix3T<T>::Identity(), ry = Matrix3T<T>::Identity(), rz = Matrix3T<T>::Identity();
  rx(1, 1) = rx(2, 2) = cos(p[9]);
  rx(2, 1) = sin(p[9]);
  rx(1, 2) = -rx(2, 1);
  ry(0, 0) = ry(2, 2) = cos(p[10]);
  ry(0, 2) = sin(p[10]);
  ry(2, 0) = -ry(0, 2);
  rz(0, 0) = rz(1, 1) = cos(p[11]);
  rz(1, 0) = sin(p[11]);
  rz(0, 1) = -rz(1, 0);
  const Matrix3T<T> r = rx * ry * rz;
  return project<T>(l, r, {p[12], p[13], p[14]}, {p[15], p[16], p[17]});
}

TEST_P(CameraModel, DerivativesAgreeWithFiniteDifferences) {
  const Intrinsics in = GetParam();
  const std::array<double, kUnknowns> at = {in.focalMm, in.cxPx, in.cyPx, in.kappa, in.k1, in.k2, in.k3, in.p1, in.p2,
                                            0.3,        -0.4,    0.2,     5,        -7,    400,   60,    50,    0};
  using Jet = ceres::Jet<double, kUnknowns>;
  std::array<Jet, kUnknowns> jets;
  for (int i = 0; i < kUnknowns; ++i) jets[static_cast<std::size_t>(i)] = Jet(at[static_cast<std::size_t>(i)], i);
  const Vector2T<Jet> value = projectUnknowns(in, jets);
  const Eigen::Vector2d plain = projectUnknowns(in, at);
  EXPECT_NEAR(value.x().a, plain.x(), 1e-9);
  EXPECT_NEAR(value.y().a, plain.y(), 1e-9);
  const std::array<double, kUnknowns> step = {1e-4, 1e-3, 1e-3, 1e-6, 1e-6, 1e-8, 1e-10, 1e-6, 1e-6,
                                              1e-5, 1e-5, 1e-5, 1e-3, 1e-3, 1e-3, 1e-3,  1e-3, 1e-3};
  for (std::size_t i = 0; i < kUnknowns; ++i) {
    auto plus = at, minus = at;
    plus[i] += step[i];
    minus[i] -= step[i];
    const Eigen::Vector2d slope = (projectUnknowns(in, plus) - projectUnknowns(in, minus)) / (2 * step[i]);
    for (int row = 0; row < 2; ++row) {
      const double jet = value(row).v(static_cast<int>(i));
      EXPECT_NEAR(jet, slope(row), 1e-5 * std::max(1.0, std::abs(slope(row)))) << "unknown " << i;
    }
  }
}

TEST(CameraModel, PolynomialRoundTripHoldsAtTheCornerOfAStrongLens) {
  Intrinsics in = polynomial();
  in.k1 = -3e-3;
  const Lens<double> l = lens(in);
  const Eigen::Vector2d corner(-0.5, -0.5);
  const Eigen::Vector2d back = pixelFromSensor<double>(l, distort<double>(l, undistortedFromPixel<double>(l, corner)));
  EXPECT_NEAR((back - corner).norm(), 0, 1e-9);
}

TEST(CameraModel, DivisionFormulaIsTheOneOfTheDesign) {
  // (u,v) = (u~,v~)/(1 + kappa r~^2) with kappa < 0 barrel: the undistorted point lies farther out.
  const Eigen::Vector2d u = undistort<double>(lens(division(-2e-3)), {3, 4});
  EXPECT_NEAR(u.x(), 3 / 0.95, 1e-12);
  EXPECT_NEAR(u.y(), 4 / 0.95, 1e-12);
}

TEST(CameraModel, PolynomialFormulaIsTheOneOfTheDesign) {
  const Intrinsics in = polynomial();
  const double x = 1, y = 2, r2 = 5;
  const double radial = 1 + in.k1 * r2 + in.k2 * r2 * r2 + in.k3 * r2 * r2 * r2;
  const Eigen::Vector2d u = undistort<double>(lens(in), {x, y});
  EXPECT_NEAR(u.x(), x * radial + in.p1 * (r2 + 2 * x * x) + 2 * in.p2 * x * y, 1e-14);
  EXPECT_NEAR(u.y(), y * radial + 2 * in.p1 * x * y + in.p2 * (r2 + 2 * y * y), 1e-14);
}

}  // namespace
}  // namespace vignole
