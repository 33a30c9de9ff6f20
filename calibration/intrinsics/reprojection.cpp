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

/// The centre of a circle's ellipse is the image of the point moved by -r^2 h / w, h the first two numbers of the third
/// row of the homography, w its third applied to the centre: here the rotation's row and the depth.
Vector2d shiftInPlane(const Extrinsics& pose, double depth, double radius) {
  return -radius * radius / depth * pose.rotation.block<1, 2>(2, 0).transpose();
}

/// What is seen of the point, in the camera's frame.
Vector3d seenPoint(const Extrinsics& pose, const Vector3d& point, double radius) {
  const Vector3d centre = pose.rotation * point + pose.translationMm;
  if (!(radius > 0)) return centre;
  return centre + pose.rotation.leftCols<2>() * shiftInPlane(pose, centre.z(), radius);
}

struct SeenDerivatives {
  Matrix3x6 byPose;
  Eigen::Matrix3d byPoint;
};
SeenDerivatives seenDerivatives(const Extrinsics& pose, const Vector3d& point, double radius) {
  const Eigen::Matrix3d& r = pose.rotation;
  const auto byTurn = [](const Vector3d& v) {  // of exp([w]x) v by w
    Eigen::Matrix3d m;
    m << 0, v.z(), -v.y(), -v.z(), 0, v.x(), v.y(), -v.x(), 0;
    return m;
  };
  SeenDerivatives by;
  by.byPose << byTurn(r * point), Eigen::Matrix3d::Identity();
  by.byPoint = r;
  if (!(radius > 0)) return by;

  const Vector2d h = r.block<1, 2>(2, 0).transpose();
  const double w = r.row(2) * point + pose.translationMm.z(), r2 = radius * radius;
  Eigen::Matrix<double, 2, 6> hByPose = Eigen::Matrix<double, 2, 6>::Zero();
  hByPose.col(0) = r.block<1, 2>(1, 0).transpose();
  hByPose.col(1) = -r.block<1, 2>(0, 0).transpose();
  const Eigen::Matrix<double, 2, 6> shiftByPose = -r2 / w * (hByPose - h / w * by.byPose.row(2));
  const Eigen::Matrix<double, 2, 3> shiftByPoint = r2 / (w * w) * h * r.row(2);
  by.byPose.leftCols<3>() += byTurn(r.leftCols<2>() * shiftInPlane(pose, w, radius));
  by.byPose += r.leftCols<2>() * shiftByPose;
  by.byPoint += r.leftCols<2>() * shiftByPoint;
  return by;
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

/// Where a point's light falls on the sensor, mm, and the undistortion's derivatives there.
struct SensorPoint {
  Vector2d direction, distorted;  ///< x / z, y / z; mm
  Matrix2d byDistorted;
  Eigen::Matrix<double, 2, 6> byParameters;
};

/// False behind the camera, and where the model has no inverse or is folded over, which no lens is.
bool reachesSensor(const Lens<double>& lens, const Vector3d& inCamera, SensorPoint& p) {
  constexpr double kClosedMm = 1e-9;
  if (!(inCamera.z() > 0)) return false;
  p.direction = inCamera.head<2>() / inCamera.z();
  const Vector2d undistorted = lens.focalMm * p.direction;
  p.distorted = distort(lens, undistorted);
  if (!p.distorted.allFinite()) return false;
  if (!((undistort(lens, p.distorted) - undistorted).squaredNorm() < kClosedMm * kClosedMm)) return false;
  undistortionDerivatives(lens, p.distorted, p.byDistorted, p.byParameters);
  return p.byDistorted.determinant() > 0;
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
  const Lens<double> l = lens(in);
  const Vector3d seen = seenPoint(cameraFromTarget, pointInTarget, radiusMm);
  SensorPoint onSensor;
  if (!reachesSensor(l, seen, onSensor)) return false;

  const Vector2d perMm(1 / in.pixelWidthMm, 1 / in.pixelHeightMm);
  const Matrix2d pxByUndistorted = perMm.asDiagonal() * onSensor.byDistorted.inverse();
  result.px = pixelFromSensor(l, onSensor.distorted);
  result.byIntrinsics.setZero();
  result.byIntrinsics.col(column(CameraParameter::F)) = pxByUndistorted * onSensor.direction;
  result.byIntrinsics(1, column(CameraParameter::PixelHeight)) = -onSensor.distorted.y() * perMm.y() * perMm.y();
  result.byIntrinsics(0, column(CameraParameter::U0)) = 1;
  result.byIntrinsics(1, column(CameraParameter::V0)) = 1;
  result.byIntrinsics.rightCols<6>() = -pxByUndistorted * onSensor.byParameters;
  Eigen::Matrix<double, 2, 3> pxByCamera;
  pxByCamera << pxByUndistorted, -pxByUndistorted * onSensor.direction;
  pxByCamera *= in.focalMm / seen.z();
  const SeenDerivatives by = seenDerivatives(cameraFromTarget, pointInTarget, radiusMm);
  result.byPose = pxByCamera * by.byPose;
  result.byPoint = pxByCamera * by.byPoint;
  return true;
}

Point2 reprojected(const Intrinsics& in, const Extrinsics& cameraFromTarget, const Vector3d& pointInTarget,
                   double radiusMm) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const Lens<double> l = lens(in);
  SensorPoint onSensor;
  if (!reachesSensor(l, seenPoint(cameraFromTarget, pointInTarget, radiusMm), onSensor)) return {kNaN, kNaN};
  return pixelFromSensor(l, onSensor.distorted);
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
