#include "calibration/light_plane/light_plane_calibration.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "calibration/detection/pose_difference.h"
#include "calibration/intrinsics/reprojection.h"

namespace vignole {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

template <typename... Values>
std::string text(const char* format, Values... values) {
  std::string buffer(400, '\0');
  const int length = std::snprintf(buffer.data(), buffer.size(), format, values...);
  buffer.resize(static_cast<std::size_t>(std::clamp(length, 0, static_cast<int>(buffer.size()) - 1)));
  return buffer;
}

/// Columns are the changes of the intrinsics by one standard deviation of each independent part of their error.
std::vector<IntrinsicVector> independentErrors(const CalibratedIntrinsics& camera) {
  IntrinsicVector u = camera.covariance.diagonal().cwiseMax(0).cwiseSqrt();
  Eigen::Matrix<double, kIntrinsicParameters, kIntrinsicParameters> correlation = camera.covariance;
  for (int i = 0; i < kIntrinsicParameters; ++i)
    for (int j = 0; j < kIntrinsicParameters; ++j)
      correlation(i, j) = u[i] > 0 && u[j] > 0 ? correlation(i, j) / (u[i] * u[j]) : 0;
  const Eigen::SelfAdjointEigenSolver<decltype(correlation)> solver(correlation);
  std::vector<IntrinsicVector> errors;
  for (int k = 0; k < kIntrinsicParameters; ++k)
    if (solver.eigenvalues()[k] > 1e-9)
      errors.emplace_back(u.cwiseProduct(solver.eigenvectors().col(k)) * std::sqrt(solver.eigenvalues()[k]));
  return errors;
}

Vector4d vectorOf(const FittedPlane& plane) {
  return {plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.distanceMm};
}

class Calibration {
 public:
  Calibration(std::span<const TargetStripe> stripes, const PlanarTarget& target, const CalibratedIntrinsics& camera,
              const LightPlaneSettings& settings, const Job& job)
      : stripes_(stripes.begin(), stripes.end()), target_(target), camera_(camera), settings_(settings), job_(job) {}

  Expected<LightPlaneCalibration> run() {
    job_.report(0, "laser lines");
    leaveOutRepeated();
    chosen_ = chooseLines(stripes_, camera_.intrinsics, settings_.choice);
    for (std::size_t i = 0; i < stripes_.size(); ++i) describe(i);
    const std::size_t used = usedViews();
    if (used < settings_.minPoses) {
      tooFew(used);
      return result_;
    }
    const FittedPlane plane = fitPlane(viewsWith(camera_.intrinsics, false));
    if (!plane.ok) {
      result_.refusals.emplace_back("refused, because the lines do not fix a plane; move and tilt the target more");
      return result_;
    }
    take(plane);
    if (const auto done = addIntrinsics(plane); !done) return tl::unexpected(done.error());
    judge();
    return result_;
  }

 private:
  void leaveOutRepeated() {
    std::vector<TargetView> views;
    for (const TargetStripe& s : stripes_) {
      views.push_back(s.view);
      views.back().file = s.file;
      if (!s.usable()) views.back().refusal = s.refusal;
    }
    const std::vector<int> same = samePose(views, target_, settings_.samePoseShare);
    for (std::size_t i = 0; i < same.size(); ++i)
      if (same[i] >= 0) stripes_[i].refusal = samePoseRefusal(views[static_cast<std::size_t>(same[i])]);
  }

  void describe(std::size_t i) {
    LightPlaneView view;
    view.file = stripes_[i].file;
    view.used = chosen_[i] >= 0;
    if (!stripes_[i].usable())
      view.reason = stripes_[i].refusal;
    else if (!view.used)
      view.reason =
          "its line lies off the plane of the others: a reflection, or the target moved between the two pictures; "
          "take the view again";
    result_.views.push_back(std::move(view));
  }

  [[nodiscard]] std::size_t usedViews() const {
    return static_cast<std::size_t>(std::count_if(chosen_.begin(), chosen_.end(), [](int line) { return line >= 0; }));
  }

  void tooFew(std::size_t used) {
    const auto seen = static_cast<std::size_t>(
        std::count_if(stripes_.begin(), stripes_.end(), [](const TargetStripe& s) { return s.usable(); }));
    if (seen >= settings_.minPoses)
      result_.refusals.push_back(
          text("refused, because the lines of %zu views lie in no common plane; keep target, laser and camera still "
               "for both pictures of a view, and keep reflections out",
               seen));
    else if (seen == 0)
      result_.refusals.emplace_back(
          "refused, because the laser's line was seen on the target in no view (see the views' reasons); let it cross "
          "the target");
    else
      result_.refusals.push_back(
          text("refused, because the line was seen in %zu pose of the target, at least %zu different ones are needed; "
               "move or tilt the target between pictures",
               used, settings_.minPoses));
  }

  /// Of the used views. `newPoses`: found anew with these intrinsics.
  [[nodiscard]] std::vector<PlaneView> viewsWith(const Intrinsics& in, bool newPoses) const {
    std::vector<PlaneView> views;
    for (std::size_t i = 0; i < stripes_.size(); ++i) {
      if (chosen_[i] < 0) continue;
      TargetPose pose = stripes_[i].pose;
      if (newPoses)
        if (const auto found = targetPose(stripes_[i].view, target_, in))
          pose.cameraFromTarget = found->cameraFromTarget;
      views.push_back(planeView(stripes_[i].lines[static_cast<std::size_t>(chosen_[i])], pose, in));
    }
    return views;
  }

  void take(const FittedPlane& plane) {
    result_.normal = plane.normal;
    result_.distanceMm = plane.distanceMm;
    result_.covariance = plane.covariance;
    result_.chi2PerDof = plane.chi2PerDof;
    double squares = 0;
    middle_.setZero();
    for (std::size_t i = 0; i < stripes_.size(); ++i) {
      if (chosen_[i] < 0) continue;
      LightPlaneView& view = result_.views[i];
      const TargetLine& line = stripes_[i].lines[static_cast<std::size_t>(chosen_[i])];
      double sum = 0, sum2 = 0;
      for (const StripeSample& s : line.samples) {
        const auto at = onTargetPlane(s.px, stripes_[i].pose.cameraFromTarget, camera_.intrinsics);
        if (!at) continue;
        const double distance = plane.distance(*at);
        sum += distance;
        sum2 += distance * distance;
        view.pointsInCamera.push_back(*at);
        view.linePx.push_back(s.px);
        middle_ += *at;
      }
      view.points = static_cast<int>(view.pointsInCamera.size());
      view.offsetMm = sum / std::max(view.points, 1);
      view.rmsMm = std::sqrt(sum2 / std::max(view.points, 1));
      squares += sum2;
      result_.points += view.pointsInCamera.size();
    }
    const auto n = static_cast<double>(std::max<std::size_t>(result_.points, 1));
    result_.rmsMm = std::sqrt(squares / n);
    middle_ /= n;
  }

  Expected<void> addIntrinsics(const FittedPlane& plane) {
    const std::vector<IntrinsicVector> errors = independentErrors(camera_);
    for (std::size_t k = 0; k < errors.size(); ++k) {
      if (job_.cancelled()) return cancelledError();
      job_.report(static_cast<double>(k) / static_cast<double>(errors.size()), "uncertainty of the intrinsics");
      const Intrinsics in = fromVector(toVector(camera_.intrinsics) + errors[k], camera_.intrinsics);
      const FittedPlane there = fitPlane(viewsWith(in, true));
      if (!there.ok) continue;
      Vector4d change = vectorOf(there) - vectorOf(plane);
      if (there.normal.dot(plane.normal) < 0) change = -vectorOf(there) - vectorOf(plane);
      result_.covariance += change * change.transpose();
    }
    return {};
  }

  void judge() {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(result_.covariance.topLeftCorner<3, 3>());
    result_.uNormalMrad = 1e3 * std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
    result_.uDistanceMm = std::sqrt(std::max(0.0, result_.covariance(3, 3)));
    const Vector4d at(middle_.x(), middle_.y(), middle_.z(), -1);
    result_.uAtTargetMm = std::sqrt(std::max(0.0, at.dot(result_.covariance * at)));
    if (result_.uNormalMrad > settings_.maxUNormalMrad) {
      // The plane turns about the direction in which its normal does not move.
      const Vector3d axis = result_.normal.cross(Vector3d(solver.eigenvectors().col(2))).normalized();
      result_.refusals.push_back(
          text("refused, because the plane is not determined: it may still turn about the direction (%.2f, %.2f, %.2f) "
               "of the camera's frame (u = %.1f mrad, at most %.1f), along which all lines run too close together; "
               "move the target nearer and farther, or tilt it so that the lines cross",
               axis.x(), axis.y(), axis.z(), result_.uNormalMrad, settings_.maxUNormalMrad));
    }
  }

  std::vector<TargetStripe> stripes_;
  const PlanarTarget& target_;
  const CalibratedIntrinsics& camera_;
  const LightPlaneSettings& settings_;
  const Job& job_;
  std::vector<int> chosen_;
  Vector3d middle_ = Vector3d::Zero();
  LightPlaneCalibration result_;
};

}  // namespace

Expected<LightPlaneCalibration> calibrateLightPlane(std::span<const TargetStripe> stripes, const PlanarTarget& target,
                                                    const CalibratedIntrinsics& camera,
                                                    const LightPlaneSettings& settings, const Job& job) {
  if (job.cancelled()) return cancelledError();
  return Calibration(stripes, target, camera, settings, job).run();
}

}  // namespace vignole
