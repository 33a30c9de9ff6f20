#pragma once
// Section 1.1 of the optics design: world -> camera -> sensor (mm) -> pixel and back, for both distortion models.
// Templates over the scalar so that calibration can differentiate them (ceres::Jet) and the engine can run them
// (double). Sensor coordinates in mm from the principal point, column then row; pixel (0,0) is the centre of the
// top-left pixel.

#include <Eigen/Core>
#include <cmath>

#include "engine/optics/calibration.h"

namespace vignole {

template <typename T>
using Vector2T = Eigen::Matrix<T, 2, 1>;
template <typename T>
using Vector3T = Eigen::Matrix<T, 3, 1>;
template <typename T>
using Matrix3T = Eigen::Matrix<T, 3, 3>;

/// Intrinsics whose numbers may be unknowns of an adjustment. Units as in Intrinsics.
template <typename T>
struct Lens {
  T focalMm, pixelWidthMm, pixelHeightMm, cxPx, cyPx;
  DistortionModel model;
  T kappa, k1, k2, k3, p1, p2;
};

template <typename T = double>
[[nodiscard]] Lens<T> lens(const Intrinsics& in) {
  return {T(in.focalMm), T(in.pixelWidthMm), T(in.pixelHeightMm),
          T(in.cxPx),    T(in.cyPx),         in.model,
          T(in.kappa),   T(in.k1),           T(in.k2),
          T(in.k3),      T(in.p1),           T(in.p2)};
}

/// Polynomial model with its derivatives: u (undistorted) of the distorted point d, J = du/dd.
template <typename T>
void undistortPolynomial(const Lens<T>& lens, const Vector2T<T>& d, Vector2T<T>& u, Eigen::Matrix<T, 2, 2>& jacobian) {
  const T x = d.x(), y = d.y();
  const T r2 = x * x + y * y;
  const T radial = T(1) + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  const T slope = T(2) * (lens.k1 + r2 * (T(2) * lens.k2 + T(3) * r2 * lens.k3));  // (d radial / d r2) * 2
  u.x() = x * radial + lens.p1 * (r2 + T(2) * x * x) + T(2) * lens.p2 * x * y;
  u.y() = y * radial + T(2) * lens.p1 * x * y + lens.p2 * (r2 + T(2) * y * y);
  const T mixed = x * y * slope + T(2) * (lens.p1 * y + lens.p2 * x);
  jacobian(0, 0) = radial + x * x * slope + T(6) * lens.p1 * x + T(2) * lens.p2 * y;
  jacobian(1, 1) = radial + y * y * slope + T(6) * lens.p2 * y + T(2) * lens.p1 * x;
  jacobian(0, 1) = mixed;
  jacobian(1, 0) = mixed;
}

/// Distorted -> undistorted, mm on the sensor: closed form in both models (Lenz/HALCON direction).
template <typename T>
[[nodiscard]] Vector2T<T> undistort(const Lens<T>& lens, const Vector2T<T>& distorted) {
  if (lens.model == DistortionModel::Division)
    return distorted / (T(1) + lens.kappa * (distorted.x() * distorted.x() + distorted.y() * distorted.y()));
  Vector2T<T> u;
  Eigen::Matrix<T, 2, 2> jacobian;
  undistortPolynomial(lens, distorted, u, jacobian);
  return u;
}

/// Undistorted -> distorted, mm on the sensor. Division: closed form, NaN where 4 kappa r^2 > 1. Polynomial: Newton,
/// whose last step is taken with the derivatives, so that a Jet carries those of the implicit function.
template <typename T>
[[nodiscard]] Vector2T<T> distort(const Lens<T>& lens, const Vector2T<T>& undistorted) {
  using std::sqrt;
  if (lens.model == DistortionModel::Division) {
    const T r2 = undistorted.x() * undistorted.x() + undistorted.y() * undistorted.y();
    return undistorted * (T(2) / (T(1) + sqrt(T(1) - T(4) * lens.kappa * r2)));
  }
  constexpr int kMaxSteps = 20;
  constexpr double kConverged = 1e-22;  // mm^2: 1e-11 mm is 1e-9 px
  Vector2T<T> d = undistorted;
  bool converged = false;
  for (int step = 0; step < kMaxSteps; ++step) {
    Vector2T<T> u;
    Eigen::Matrix<T, 2, 2> j;
    undistortPolynomial(lens, d, u, j);
    const T ex = undistorted.x() - u.x(), ey = undistorted.y() - u.y();
    const T det = j(0, 0) * j(1, 1) - j(0, 1) * j(1, 0);
    const T dx = (j(1, 1) * ex - j(0, 1) * ey) / det;
    const T dy = (j(0, 0) * ey - j(1, 0) * ex) / det;
    d.x() += dx;
    d.y() += dy;
    if (converged) break;
    converged = dx * dx + dy * dy < T(kConverged);
  }
  return d;
}

template <typename T>
[[nodiscard]] Vector2T<T> pixelFromSensor(const Lens<T>& lens, const Vector2T<T>& distorted) {
  return {distorted.x() / lens.pixelWidthMm + lens.cxPx, distorted.y() / lens.pixelHeightMm + lens.cyPx};
}

template <typename T>
[[nodiscard]] Vector2T<T> sensorFromPixel(const Lens<T>& lens, const Vector2T<T>& pixel) {
  return {(pixel.x() - lens.cxPx) * lens.pixelWidthMm, (pixel.y() - lens.cyPx) * lens.pixelHeightMm};
}

/// Point in the camera's frame (mm, z > 0) -> pixel.
template <typename T>
[[nodiscard]] Vector2T<T> projectFromCamera(const Lens<T>& lens, const Vector3T<T>& pointInCamera) {
  const T scale = lens.focalMm / pointInCamera.z();
  const Vector2T<T> undistorted(pointInCamera.x() * scale, pointInCamera.y() * scale);
  return pixelFromSensor(lens, distort(lens, undistorted));
}

/// Point in the world (mm) -> pixel.
template <typename T>
[[nodiscard]] Vector2T<T> project(const Lens<T>& lens, const Matrix3T<T>& rotation, const Vector3T<T>& translationMm,
                                  const Vector3T<T>& pointInWorld) {
  const Vector3T<T> pointInCamera = rotation * pointInWorld + translationMm;
  return projectFromCamera(lens, pointInCamera);
}

/// Pixel -> undistorted sensor point, mm; its ray in the camera's frame is (u, v, focal).
template <typename T>
[[nodiscard]] Vector2T<T> undistortedFromPixel(const Lens<T>& lens, const Vector2T<T>& pixel) {
  return undistort(lens, sensorFromPixel(lens, pixel));
}

}  // namespace vignole
