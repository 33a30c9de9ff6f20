#include "calibration/range_finders/pose_from_centres.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

#include "engine/optics/camera_model.h"

namespace vignole {

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

Extrinsics moved(const Extrinsics& pose, const Vector6& change) {
  const Eigen::Vector3d turn = change.head<3>();
  const double angle = turn.norm();
  Extrinsics result = pose;
  if (angle > 0) result.rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() * pose.rotation;
  result.translationMm += change.tail<3>();
  return result;
}

struct Equations {
  Matrix6 normal = Matrix6::Zero();
  Vector6 right = Vector6::Zero();
  double square = 0;
};

Equations equationsAt(const Extrinsics& pose, std::span<const PlaneCorrespondence> points, const Lens<double>& camera,
                      bool derivatives) {
  Equations e;
  for (const PlaneCorrespondence& p : points) {
    const Eigen::Vector3d turned = pose.rotation * Eigen::Vector3d(p.planeMm.x(), p.planeMm.y(), 0);
    const Eigen::Vector3d at = turned + pose.translationMm;
    const Eigen::Vector2d seen = projectFromCamera<double>(camera, at);
    const Eigen::Vector2d miss = p.px - seen;
    if (!(at.z() > 0) || !miss.allFinite()) {
      e.square = INFINITY;
      return e;
    }
    e.square += miss.squaredNorm();
    if (!derivatives) continue;
    Eigen::Matrix<double, 2, 3> perPoint;
    for (int k = 0; k < 3; ++k) {
      constexpr double kStepMm = 1e-3;
      Eigen::Vector3d ahead = at, behind = at;
      ahead[k] += kStepMm;
      behind[k] -= kStepMm;
      perPoint.col(k) = (projectFromCamera<double>(camera, ahead) - projectFromCamera<double>(camera, behind)) /
                        (2 * kStepMm);
    }
    Eigen::Matrix<double, 3, 6> perUnknown;
    perUnknown << 0, turned.z(), -turned.y(), 1, 0, 0, -turned.z(), 0, turned.x(), 0, 1, 0, turned.y(), -turned.x(), 0,
        0, 0, 1;
    const Eigen::Matrix<double, 2, 6> j = perPoint * perUnknown;
    e.normal += j.transpose() * j;
    e.right += j.transpose() * miss;
  }
  return e;
}

}  // namespace

Expected<CameraPose> poseFromCentres(std::span<const PlaneCorrespondence> points, const Intrinsics& intrinsics,
                                     const Extrinsics& start) {
  if (points.size() < 4) return inputError("pose", "needs at least 4 centres, there are " + std::to_string(points.size()));
  const Lens<double> camera = lens(intrinsics);
  CameraPose pose;
  pose.cameraFromPlane = start;
  Equations now = equationsAt(start, points, camera, true);
  if (!std::isfinite(now.square)) return inputError("pose", "the pins would lie behind the camera");
  double damping = 1e-3;
  constexpr int kMaxSteps = 60;
  for (int step = 0; step < kMaxSteps; ++step) {
    Matrix6 damped = now.normal;
    damped.diagonal() *= 1 + damping;
    const Vector6 change = damped.ldlt().solve(now.right);
    if (!change.allFinite()) break;
    const Extrinsics there = moved(pose.cameraFromPlane, change);
    const Equations next = equationsAt(there, points, camera, true);
    if (next.square < now.square) {
      const double gain = now.square - next.square;
      pose.cameraFromPlane = there;
      now = next;
      damping = std::max(damping / 10, 1e-12);
      if (gain < 1e-12 * now.square + 1e-18) break;
    } else if (damping > 1e8) {
      break;
    } else {
      damping *= 10;
    }
  }
  const double freedom = 2 * static_cast<double>(points.size()) - 6;
  pose.rmsPx = freedom > 0 ? std::sqrt(now.square / freedom) : 0;
  pose.information = now.normal;
  if (!(now.normal.ldlt().vectorD().minCoeff() > 0)) return inputError("pose", "the pins lie on a line");
  return pose;
}

}  // namespace vignole
