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
  double pointChi2 = 0, poseChi2 = 0, weights = 0;
};

double sigmaOf(const PlanePoint3& p, const Vector3d& normal) {
  // A line that meets the light plane's normal edgewise still has some width.
  return std::max(p.sigmaPx * std::abs(normal.dot(p.perPx)), 1e-6);
}

/// `about`: subtracted from the points for the sake of the numbers. `corrections`: of the poses, improved here.
Reduced reduce(const std::vector<PlaneView>& views, const Frame& f, const Vector3d& about, double pointScale,
               double poseScale, std::vector<Vector6>& corrections) {
  Reduced sums;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const Matrix6 prior = (poseScale * poseScale * views[v].poseCovariance).ldlt().solve(Matrix6::Identity());
    Matrix3d a = Matrix3d::Zero();
    Matrix36 b = Matrix36::Zero();
    Matrix6 c = prior;
    Vector3d ra = Vector3d::Zero();
    Vector6 rb = Vector6::Zero();
    double pointChi2 = 0;
    for (const PlanePoint3& p : views[v].points) {
      const Vector3d mm = p.mm - about;
      const Eigen::Matrix<double, 1, 6> byPose = f.normal.transpose() * p.byPose;
      const double residual = f.normal.dot(p.mm) - f.distanceMm;
      const double sigma = pointScale * sigmaOf(p, f.normal);
      const double left = residual + byPose * corrections[v];
      const double size = std::abs(left) / sigma;
      const double weight = (size > kHuber ? kHuber / size : 1) / (sigma * sigma);
      const Vector3d byPlane(f.e1.dot(mm), f.e2.dot(mm), -1);
      a += weight * byPlane * byPlane.transpose();
      b += weight * byPlane * byPose;
      c += weight * byPose.transpose() * byPose;
      ra += weight * byPlane * residual;
      rb += weight * byPose.transpose() * residual;
      pointChi2 += weight * left * left;
      sums.weights += 1;
    }
    const Eigen::LDLT<Matrix6> solver(c);
    sums.normal += a - b * solver.solve(b.transpose());
    sums.gradient += ra - b * solver.solve(rb);
    sums.pointChi2 += pointChi2;
    sums.poseChi2 += corrections[v].dot(prior * corrections[v]);
    // With the plane as it is: the correction that fits it best.
    corrections[v] = -solver.solve(rb);
  }
  return sums;
}

Vector3d middleOf(const std::vector<PlaneView>& views) {
  Vector3d sum = Vector3d::Zero();
  double n = 0;
  for (const PlaneView& view : views)
    for (const PlanePoint3& p : view.points) {
      sum += p.mm;
      n += 1;
    }
  return sum / std::max(n, 1.0);
}

/// Least squares of the bare distances, every view counting alike.
FittedPlane startOf(const std::vector<PlaneView>& views) {
  Vector3d middle = Vector3d::Zero();
  for (const PlaneView& view : views)
    for (const PlanePoint3& p : view.points) middle += p.mm / static_cast<double>(view.points.size() * views.size());
  Matrix3d scatter = Matrix3d::Zero();
  for (const PlaneView& view : views)
    for (const PlanePoint3& p : view.points)
      scatter += (p.mm - middle) * (p.mm - middle).transpose() / static_cast<double>(view.points.size());
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
  for (const StripeSample& s : line.samples) {
    const auto at = onTargetPlane(s.px, pose.cameraFromTarget, in);
    const auto beside = onTargetPlane(s.px + s.normalPx, pose.cameraFromTarget, in);
    if (!at || !beside) continue;
    PlanePoint3 p;
    p.mm = *at;
    p.perPx = *beside - *at;
    p.sigmaPx = s.sigmaPx;
    bool all = true;
    for (int i = 0; i < 6 && all; ++i) {
      Vector6 change = Vector6::Zero();
      change[i] = i < 3 ? 1e-5 : 1e-3;
      const auto there = onTargetPlane(s.px, moved(pose.cameraFromTarget, change), in);
      all = there.has_value();
      if (all) p.byPose.col(i) = (*there - *at) / change[i];
    }
    if (all) view.points.push_back(p);
  }
  return view;
}

FittedPlane fitPlane(const std::vector<PlaneView>& views) {
  std::size_t count = 0;
  for (const PlaneView& view : views) count += view.points.size();
  FittedPlane plane;
  if (count < 3) return plane;
  plane = startOf(views);
  const Vector3d about = middleOf(views);
  std::vector<Vector6> corrections(views.size(), Vector6::Zero());
  const auto turn = [&](const Vector3d& change, const Frame& f) {
    const double atMiddle = f.distanceMm - f.normal.dot(about) + change[2];
    plane.normal = (f.normal + change[0] * f.e1 + change[1] * f.e2).normalized();
    plane.distanceMm = plane.normal.dot(about) + atMiddle;
  };
  double pointScale = 1, poseScale = 1;
  Reduced sums;
  Frame f = frameOf(plane);
  for (int step = 0; step < kSteps; ++step) {
    f = frameOf(plane);
    sums = reduce(views, f, about, pointScale, poseScale, corrections);
    const Vector3d change = -sums.normal.ldlt().solve(sums.gradient);
    if (!change.allFinite()) return plane;
    turn(change, f);
    if (step + 4 == kSteps) {
      // By now the plane fits: what the uncertainties do not explain widens them.
      const auto views2 = static_cast<double>(2 * views.size());
      plane.chi2PerDof = sums.pointChi2 / std::max(sums.weights - views2, 1.0);
      plane.poseChi2PerDof = views2 > 3 ? sums.poseChi2 / (views2 - 3) : 1;
      pointScale = std::sqrt(std::max(1.0, plane.chi2PerDof));
      poseScale = std::sqrt(std::max(1.0, plane.poseChi2PerDof));
    }
  }
  f = frameOf(plane);
  sums = reduce(views, f, about, pointScale, poseScale, corrections);
  const Matrix3d inverse = sums.normal.ldlt().solve(Matrix3d::Identity());
  if (!inverse.allFinite()) return plane;
  // (a, b, c about the middle) -> (normal, distance): the distance is that at the middle and what the turn makes of it.
  Eigen::Matrix<double, 4, 3> by = Eigen::Matrix<double, 4, 3>::Zero();
  by.block<3, 1>(0, 0) = f.e1;
  by.block<3, 1>(0, 1) = f.e2;
  by(3, 0) = f.e1.dot(about);
  by(3, 1) = f.e2.dot(about);
  by(3, 2) = 1;
  plane.covariance = by * inverse * by.transpose();
  plane.ok = true;
  if (plane.distanceMm < 0) {
    plane.normal = -plane.normal;
    plane.distanceMm = -plane.distanceMm;
  }
  return plane;
}

double lineUncertainty(const PlaneView& view, const Vector3d& normal) {
  if (view.points.empty()) return 0;
  Eigen::Matrix<double, 1, 6> byPose = Eigen::Matrix<double, 1, 6>::Zero();
  double variance = 0;
  const auto n = static_cast<double>(view.points.size());
  for (const PlanePoint3& p : view.points) {
    byPose += normal.transpose() * p.byPose / n;
    variance += std::pow(sigmaOf(p, normal) / n, 2);
  }
  return std::sqrt(variance + (byPose * view.poseCovariance * byPose.transpose()).value());
}

}  // namespace vignole
