#include "calibration/light_plane/target_pose.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "calibration/detection/circle_centre.h"
#include "calibration/intrinsics/reprojection.h"
#include "calibration/intrinsics/zhang_start.h"
#include "engine/optics/camera_model.h"

namespace vignole {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kHuber = 2.5;      // standard deviations
constexpr double kLeastUPx = 0.01;  // what the finder may not know of
constexpr int kMaxSteps = 30;

/// Points as a camera without distortion would see them.
ObservedView undistorted(const TargetView& view, const Intrinsics& in) {
  ObservedView points;
  for (const FoundPoint& p : view.points) {
    const Vector2T<double> mm = undistortedFromPixel(lens(in), Vector2T<double>(p.px));
    points.push_back({p.index, pixelFromSensor(lens(in), mm), p.uPx, std::max(p.uPx, kLeastUPx)});
  }
  return points;
}

Intrinsics withoutDistortion(Intrinsics in) {
  in.kappa = in.k1 = in.k2 = in.k3 = in.p1 = in.p2 = 0;
  return in;
}

struct Equations {
  Matrix6 normal = Matrix6::Zero();
  Vector6 gradient = Vector6::Zero();
  double cost = 0, squares = 0, weighted = 0;
  bool seen = true;
};

class PoseFit {
 public:
  PoseFit(const TargetView& view, const PlanarTarget& target, const Intrinsics& in)
      : view_(view), points_(target.points()), radiusMm_(target.diameterMm / 2), in_(in), shifts_(view.points.size()) {
    for (Point2& shift : shifts_) shift.setZero();
  }

  /// The lens's part in the circles' centres, which hardly depends on the pose.
  void takeShifts(const Extrinsics& pose) {
    if (radiusMm_ <= 0) return;
    for (std::size_t i = 0; i < view_.points.size(); ++i)
      shifts_[i] = circleImageShift(in_, pose, pointOf(i), radiusMm_);
  }

  [[nodiscard]] Equations at(const Extrinsics& pose, double scale) const {
    Equations sums;
    for (std::size_t i = 0; i < view_.points.size(); ++i) {
      const FoundPoint& found = view_.points[i];
      Reprojection seen;
      if (!reproject(in_, pose, Point3(pointOf(i).x(), pointOf(i).y(), 0), radiusMm_, seen)) {
        sums.seen = false;
        return sums;
      }
      const Point2 error = found.px - shifts_[i] - seen.px;
      const double sigma = std::max(found.uPx, kLeastUPx) * scale;
      const double size = error.norm() / sigma;
      const double weight = (size > kHuber ? kHuber / size : 1) / (sigma * sigma);
      sums.normal += weight * seen.byPose.transpose() * seen.byPose;
      sums.gradient += weight * seen.byPose.transpose() * error;
      sums.cost += size > kHuber ? kHuber * (2 * size - kHuber) : size * size;
      sums.squares += error.squaredNorm();
      sums.weighted += weight * error.squaredNorm();
    }
    return sums;
  }

  /// Robust standard deviation of a point's coordinates, in its own uncertainties.
  [[nodiscard]] double scaleAt(const Extrinsics& pose) const {
    std::vector<double> sizes;
    for (std::size_t i = 0; i < view_.points.size(); ++i) {
      const Point2 px = reprojected(in_, pose, Point3(pointOf(i).x(), pointOf(i).y(), 0), radiusMm_);
      sizes.push_back((view_.points[i].px - shifts_[i] - px).norm() / std::max(view_.points[i].uPx, kLeastUPx));
    }
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return std::max(1.0, *middle / 1.1774);  // median of a Rayleigh distribution
  }

 private:
  [[nodiscard]] const Point2& pointOf(std::size_t i) const {
    return points_[static_cast<std::size_t>(view_.points[i].index)];
  }
  const TargetView& view_;
  std::vector<Point2> points_;
  double radiusMm_;
  const Intrinsics& in_;
  std::vector<Point2> shifts_;
};

}  // namespace

Expected<TargetPose> targetPose(const TargetView& view, const PlanarTarget& target, const Intrinsics& in) {
  std::vector<Eigen::Vector3d> points;
  for (const Point2& p : target.points()) points.emplace_back(p.x(), p.y(), 0);
  const auto start = homography(points, undistorted(view, in));
  if (!start) return inputError(view.file, "too few points of the target, or all on one line");
  TargetPose result;
  result.cameraFromTarget = poseFromHomography(*start, withoutDistortion(in));
  PoseFit fit(view, target, in);
  double damping = 1e-6;
  Equations now;
  for (int step = 0; step < kMaxSteps; ++step) {
    fit.takeShifts(result.cameraFromTarget);
    const double scale = fit.scaleAt(result.cameraFromTarget);
    now = fit.at(result.cameraFromTarget, scale);
    if (!now.seen) return inputError(view.file, "the target's pose cannot be found with these intrinsics");
    bool better = false;
    double change = 0;
    for (; !better && damping < 1e6; damping *= 10) {
      Matrix6 damped = now.normal;
      damped.diagonal() *= 1 + damping;
      const Vector6 by = damped.ldlt().solve(now.gradient);
      const Extrinsics next = moved(result.cameraFromTarget, by);
      const Equations there = fit.at(next, scale);
      better = by.allFinite() && there.seen && there.cost <= now.cost;
      if (!better) continue;
      result.cameraFromTarget = next;
      change = now.cost - there.cost;
      damping = std::max(damping * 0.01, 1e-9);
    }
    if (!better || change < 1e-9 * (1 + now.cost)) break;
  }
  const double scale = fit.scaleAt(result.cameraFromTarget);
  now = fit.at(result.cameraFromTarget, 1);
  const auto dof = static_cast<double>(2 * view.points.size()) - 6;
  result.rmsPx = std::sqrt(now.squares / static_cast<double>(view.points.size()));
  result.chi2PerDof = dof > 0 ? std::max(now.weighted / dof, scale * scale) : 1;
  result.covariance = fit.at(result.cameraFromTarget, std::sqrt(std::max(1.0, result.chi2PerDof)))
                          .normal.ldlt()
                          .solve(Matrix6::Identity());
  if (!result.covariance.allFinite()) return inputError(view.file, "the target's points do not fix its pose");
  return result;
}

}  // namespace vignole
