#include "calibration/intrinsics/reprojection.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <limits>

#include "engine/optics/camera_model.h"

namespace vignole {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Matrix3x6 = Eigen::Matrix<double, 3, 6>;

constexpr int column(CameraParameter p) { return static_cast<int>(p); }

/// Point in the camera's frame of what is seen, and its derivatives.
struct SeenPoint {
  Vector3d inCamera;
  Matrix3x6 byPose;
  Eigen::Matrix3d byPoint;
};

/// The centre of a circle's ellipse is the image of the point moved by -r^2 h / w, h the first two numbers of the third
/// row of the homography, w its third applied to the centre: here the rotation's row and the depth.
SeenPoint seenPoint(const Extrinsics& pose, const Vector3d& point, double radius) {
  const Eigen::Matrix3d& r = pose.rotation;
  const Vector3d turned = r * point;
  SeenPoint seen;
  seen.inCamera = turned + pose.translationMm;
  seen.byPose << 0, turned.z(), -turned.y(), 1, 0, 0,  //
      -turned.z(), 0, turned.x(), 0, 1, 0,             //
      turned.y(), -turned.x(), 0, 0, 0, 1;
  seen.byPoint = r;
  if (!(radius > 0)) return seen;

  const Vector2d h = r.block<1, 2>(2, 0).transpose();
  const double w = seen.inCamera.z(), r2 = radius * radius;
  const Vector2d shift = -r2 / w * h;
  const Vector3d shiftInCamera = r.leftCols<2>() * shift;
  Eigen::Matrix<double, 2, 6> hByPose = Eigen::Matrix<double, 2, 6>::Zero();
  hByPose.col(0) = r.block<1, 2>(1, 0).transpose();
  hByPose.col(1) = -r.block<1, 2>(0, 0).transpose();
  const Eigen::Matrix<double, 2, 6> shiftByPose = -r2 / w * (hByPose - h / w * seen.byPose.row(2));
  const Eigen::Matrix<double, 2, 3> shiftByPoint = r2 / (w * w) * h * r.row(2);
  Eigen::Matrix3d cross;
  cross << 0, shiftInCamera.z(), -shiftInCamera.y(), -shiftInCamera.z(), 0, shiftInCamera.x(), shiftInCamera.y(),
      -shiftInCamera.x(), 0;
  seen.inCamera += shiftInCamera;
  seen.byPose.leftCols<3>() += cross;
  seen.byPose += r.leftCols<2>() * shiftByPose;
  seen.byPoint += r.leftCols<2>() * shiftByPoint;
  return seen;
}

/// Derivatives of the undistorted point by the distorted one and, at a fixed distorted point, by the distortion's
/// parameters (kappa, k1, k2, k3, p1, p2).
void undistortionDerivatives(const Lens<double>& lens, const Vector2d& d, Matrix2d& byDistorted,
                             Eigen::Matrix<double, 2, 6>& byParameters) {
  const double x = d.x(), y = d.y(), r2 = d.squaredNorm();
  byParameters.setZero();
  if (lens.model == DistortionModel::Division) {
    const double g = 1 / (1 + lens.kappa * r2);
    byDistorted = g * Matrix2d::Identity() - 2 * lens.kappa * g * g * d * d.transpose();
    byParameters.col(0) = -r2 * g * g * d;
    return;
  }
  Vector2d u;
  undistortPolynomial(lens, d, u, byDistorted);
  byParameters.col(1) = r2 * d;
  byParameters.col(2) = r2 * r2 * d;
  byParameters.col(3) = r2 * r2 * r2 * d;
  byParameters.col(4) << r2 + 2 * x * x, 2 * x * y;
  byParameters.col(5) << 2 * x * y, r2 + 2 * y * y;
}

/// Undistorted -> distorted; false where the model has no inverse there.
bool distorted(const Lens<double>& lens, const Vector2d& u, Vector2d& d) {
  constexpr double kClosedMm = 1e-9;
  d = distort(lens, u);
  return d.allFinite() && (undistort(lens, d) - u).squaredNorm() < kClosedMm * kClosedMm;
}

}  // namespace

IntrinsicVector toVector(const Intrinsics& in) {
  IntrinsicVector v;
  v << in.focalMm, in.pixelHeightMm, in.cxPx, in.cyPx, in.kappa, in.k1, in.k2, in.k3, in.p1, in.p2;
  return v;
}

Intrinsics fromVector(const IntrinsicVector& v, const Intrinsics& like) {
  Intrinsics in = like;
  in.focalMm = v[column(CameraParameter::F)];
  in.pixelHeightMm = v[column(CameraParameter::PixelHeight)];
  in.cxPx = v[column(CameraParameter::U0)];
  in.cyPx = v[column(CameraParameter::V0)];
  in.kappa = v[column(CameraParameter::Kappa)];
  in.k1 = v[column(CameraParameter::K1)];
  in.k2 = v[column(CameraParameter::K2)];
  in.k3 = v[column(CameraParameter::K3)];
  in.p1 = v[column(CameraParameter::P1)];
  in.p2 = v[column(CameraParameter::P2)];
  return in;
}

bool reproject(const Intrinsics& in, const Extrinsics& cameraFromTarget, const Vector3d& pointInTarget, double radiusMm,
               Reprojection& result) {
  const SeenPoint seen = seenPoint(cameraFromTarget, pointInTarget, radiusMm);
  const double z = seen.inCamera.z();
  if (!(z > 0)) return false;
  const Vector2d direction = seen.inCamera.head<2>() / z;
  const Lens<double> l = lens(in);
  Vector2d d;
  if (!distorted(l, in.focalMm * direction, d)) return false;

  Matrix2d byDistorted;
  Eigen::Matrix<double, 2, 6> byParameters;
  undistortionDerivatives(l, d, byDistorted, byParameters);
  const double determinant = byDistorted.determinant();
  if (!(determinant > 0)) return false;  // folded over: no lens does that
  const Vector2d perMm(1 / in.pixelWidthMm, 1 / in.pixelHeightMm);
  const Matrix2d pxByUndistorted = perMm.asDiagonal() * byDistorted.inverse();

  result.px = pixelFromSensor(l, d);
  result.byIntrinsics.setZero();
  result.byIntrinsics.col(column(CameraParameter::F)) = pxByUndistorted * direction;
  result.byIntrinsics(1, column(CameraParameter::PixelHeight)) = -d.y() * perMm.y() * perMm.y();
  result.byIntrinsics(0, column(CameraParameter::U0)) = 1;
  result.byIntrinsics(1, column(CameraParameter::V0)) = 1;
  result.byIntrinsics.rightCols<6>() = -pxByUndistorted * byParameters;
  Eigen::Matrix<double, 2, 3> pxByCamera;
  pxByCamera << pxByUndistorted, -pxByUndistorted * direction;
  pxByCamera *= in.focalMm / z;
  result.byPose = pxByCamera * seen.byPose;
  result.byPoint = pxByCamera * seen.byPoint;
  return true;
}

Point2 reprojected(const Intrinsics& in, const Extrinsics& cameraFromTarget, const Vector3d& pointInTarget,
                   double radiusMm) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const Eigen::RowVector3d row = cameraFromTarget.rotation.row(2);
  const double depth = row * pointInTarget + cameraFromTarget.translationMm.z();
  Vector3d shifted = pointInTarget;
  shifted.head<2>() -= radiusMm * radiusMm / depth * row.head<2>().transpose();
  const Vector3d inCamera = cameraFromTarget.rotation * shifted + cameraFromTarget.translationMm;
  if (!(depth > 0 && inCamera.z() > 0)) return {kNaN, kNaN};
  const Lens<double> l = lens(in);
  Vector2d d;
  if (!distorted(l, in.focalMm / inCamera.z() * inCamera.head<2>(), d)) return {kNaN, kNaN};
  return pixelFromSensor(l, d);
}

Extrinsics moved(const Extrinsics& pose, const Eigen::Matrix<double, 6, 1>& change) {
  Extrinsics result = pose;
  const Vector3d turn = change.head<3>();
  if (const double angle = turn.norm(); angle > 0)
    result.rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() * pose.rotation;
  result.translationMm += change.tail<3>();
  return result;
}

}  // namespace vignole
