#include "calibration/light_plane/plane_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "calibration/intrinsics/reprojection.h"

namespace vignole {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix36 = Eigen::Matrix<double, 3, 6>;

constexpr double kHuber = 2.5;  // standard deviations
constexpr int kSteps = 12;

/// The plane written as (normal + a e1 + b e2) . p = distance + c about where it is now.
struct Frame {
  Vector3d normal, e1, e2;
  double distanceMm = 0;
};

Frame frameOf(const FittedPlane& plane) {
  Frame f;
  f.normal = plane.normal;
  f.e1 = plane.normal.unitOrthogonal();
  f.e2 = plane.normal.cross(f.e1);
  f.distanceMm = plane.distanceMm;
  return f;
}

/// What the points say, with the pose's correction of each view eliminated.
struct Reduced {
  Matrix3d normal = Matrix3d::Zero();
  Vector3d gradient = Vector3d::Zero();
  double chi2 = 0;
};

double sigmaOf(const LinePoint& p, const Vector3d& normal) {
  // Across the line in the target's plane is not across the light's plane.
  return std::max(p.sigmaMm * std::abs(normal.dot(p.across)), 1e-6);
}

/// `about`: subtracted from the points for the sake of the numbers. `corrections`: of the poses, improved here.
Reduced reduce(const std::vector<PlaneView>& views, const Frame& f, const Vector3d& about,
               std::vector<Vector6>& corrections) {
  Reduced sums;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const Matrix6 prior = views[v].poseCovariance.ldlt().solve(Matrix6::Identity());
    Matrix3d a = Matrix3d::Zero();
    Matrix36 b = Matrix36::Zero();
    Matrix6 c = prior;
    Vector3d ra = Vector3d::Zero();
    Vector6 rb = Vector6::Zero();
    for (const LinePoint& p : views[v].points) {
      const Vector3d mm = p.mm - about;
      const Eigen::Matrix<double, 1, 6> byPose = f.normal.transpose() * p.byPose;
      const double residual = f.normal.dot(p.mm) - f.distanceMm;
      const double sigma = sigmaOf(p, f.normal);
      const double left = residual + byPose * corrections[v];
      const double size = std::abs(left) / sigma;
      const double weight = (size > kHuber ? kHuber / size : 1) / (sigma * sigma);
      const Vector3d byPlane(f.e1.dot(mm), f.e2.dot(mm), -1);
      a += weight * byPlane * byPlane.transpose();
      b += weight * byPlane * byPose;
      c += weight * byPose.transpose() * byPose;
      ra += weight * byPlane * residual;
      rb += weight * byPose.transpose() * residual;
      sums.chi2 += weight * left * left;
    }
    const Eigen::LDLT<Matrix6> solver(c);
    sums.normal += a - b * solver.solve(b.transpose());
    sums.gradient += ra - b * solver.solve(rb);
    sums.chi2 += corrections[v].dot(prior * corrections[v]);
    // With the plane as it is: the correction that fits it best.
    corrections[v] = -solver.solve(rb);
  }
  return sums;
}

Vector3d middleOf(const std::vector<PlaneView>& views) {
  Vector3d sum = Vector3d::Zero();
  double n = 0;
  for (const PlaneView& view : views)
    for (const LinePoint& p : view.points) {
      sum += p.mm;
      n += 1;
    }
  return sum / std::max(n, 1.0);
}

/// Least squares of the bare distances.
FittedPlane startOf(const std::vector<PlaneView>& views) {
  const Vector3d middle = middleOf(views);
  Matrix3d scatter = Matrix3d::Zero();
  for (const PlaneView& view : views)
    for (const LinePoint& p : view.points) scatter += (p.mm - middle) * (p.mm - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(scatter);
  FittedPlane plane;
  plane.normal = solver.eigenvectors().col(0);
  plane.distanceMm = plane.normal.dot(middle);
  return plane;
}

}  // namespace

PlaneView planeView(const TargetLine& line, const TargetPose& pose, const Intrinsics& in) {
  PlaneView view;
  view.poseCovariance = pose.covariance;
  struct Sample {
    Point2 onTarget;
    double weight;
  };
  std::vector<Sample> samples;
  Point2 middle(0, 0);
  double weights = 0;
  const Matrix3d toTarget = pose.cameraFromTarget.rotation.transpose();
  for (const StripeSample& s : line.samples) {
    const auto at = onTargetPlane(s.px, pose.cameraFromTarget, in);
    const auto beside = onTargetPlane(s.px + s.normalPx, pose.cameraFromTarget, in);
    if (!at || !beside) continue;
    const double sigmaMm = s.sigmaPx * (*beside - *at).norm();
    samples.push_back({(toTarget * (*at - pose.cameraFromTarget.translationMm)).head<2>(), 1 / (sigmaMm * sigmaMm)});
    middle += samples.back().weight * samples.back().onTarget;
    weights += samples.back().weight;
  }
  if (samples.size() < 3) return view;
  middle /= weights;
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Sample& s : samples)
    scatter += s.weight / weights * (s.onTarget - middle) * (s.onTarget - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scatter);
  const Point2 along = solver.eigenvectors().col(1), across = solver.eigenvectors().col(0);
  const double reach = std::sqrt(solver.eigenvalues()[1]);
  // At one standard deviation of the points to either side the errors of offset and slope make independent ones.
  for (const double side : {-1.0, 1.0}) {
    const Point2 place = middle + side * reach * along;
    const Vector3d inTarget(place.x(), place.y(), 0);
    LinePoint p;
    p.mm = pose.cameraFromTarget.rotation * inTarget + pose.cameraFromTarget.translationMm;
    p.across = pose.cameraFromTarget.rotation * Vector3d(across.x(), across.y(), 0);
    p.sigmaMm = std::sqrt(2 / weights);
    const Point2 px = reprojected(in, pose.cameraFromTarget, inTarget, 0);
    bool seen = px.allFinite();
    for (int i = 0; i < 6 && seen; ++i) {
      Vector6 change = Vector6::Zero();
      change[i] = i < 3 ? 1e-5 : 1e-3;
      const auto there = onTargetPlane(px, moved(pose.cameraFromTarget, change), in);
      seen = there.has_value();
      if (seen) p.byPose.col(i) = (*there - p.mm) / change[i];
    }
    if (seen) view.points.push_back(p);
  }
  if (view.points.size() < 2) view.points.clear();
  return view;
}

FittedPlane fitPlane(const std::vector<PlaneView>& views) {
  std::size_t count = 0;
  for (const PlaneView& view : views) count += view.points.size();
  FittedPlane plane;
  if (count < 4) return plane;
  plane = startOf(views);
  const Vector3d about = middleOf(views);
  std::vector<Vector6> corrections(views.size(), Vector6::Zero());
  const auto turn = [&](const Vector3d& change, const Frame& f) {
    const double atMiddle = f.distanceMm - f.normal.dot(about) + change[2];
    plane.normal = (f.normal + change[0] * f.e1 + change[1] * f.e2).normalized();
    plane.distanceMm = plane.normal.dot(about) + atMiddle;
  };
  Reduced sums;
  Frame f = frameOf(plane);
  for (int step = 0; step < kSteps; ++step) {
    f = frameOf(plane);
    sums = reduce(views, f, about, corrections);
    const Vector3d change = -sums.normal.ldlt().solve(sums.gradient);
    if (!change.allFinite()) return plane;
    turn(change, f);
  }
  f = frameOf(plane);
  sums = reduce(views, f, about, corrections);
  const Matrix3d inverse = sums.normal.ldlt().solve(Matrix3d::Identity());
  if (!inverse.allFinite()) return plane;
  plane.chi2PerDof = count > 3 ? sums.chi2 / static_cast<double>(count - 3) : 1;
  // (a, b, c about the middle) -> (normal, distance): the distance is that at the middle and what the turn makes of it.
  Eigen::Matrix<double, 4, 3> by = Eigen::Matrix<double, 4, 3>::Zero();
  by.block<3, 1>(0, 0) = f.e1;
  by.block<3, 1>(0, 1) = f.e2;
  by(3, 0) = f.e1.dot(about);
  by(3, 1) = f.e2.dot(about);
  by(3, 2) = 1;
  plane.covariance = std::max(1.0, plane.chi2PerDof) * by * inverse * by.transpose();
  plane.ok = true;
  if (plane.distanceMm < 0) {
    plane.normal = -plane.normal;
    plane.distanceMm = -plane.distanceMm;
  }
  return plane;
}

}  // namespace vignole
