#include "engine/optics/paper_parameters.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vignole {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

double standard(const Eigen::MatrixXd& covariance, CameraParameter parameter) {
  const int i = static_cast<int>(parameter);
  return i < covariance.rows() ? std::sqrt(std::max(0.0, covariance(i, i))) : 0;
}

}  // namespace

Eigen::Vector3d eulerAngles(const Eigen::Matrix3d& rotation) {
  // Rx Ry Rz has sin(beta) in its upper right corner.
  return {std::atan2(-rotation(1, 2), rotation(2, 2)), std::asin(std::clamp(rotation(0, 2), -1.0, 1.0)),
          std::atan2(-rotation(0, 1), rotation(0, 0))};
}

std::vector<PaperParameter> paperParameters(const Intrinsics& in, const Eigen::MatrixXd& covariance) {
  const auto u = [&](CameraParameter parameter) { return standard(covariance, parameter); };
  std::vector<PaperParameter> all = {{"f", in.focalMm, u(CameraParameter::F), "mm"},
                                     {"s^x", in.pixelWidthMm, 0, "mm/px"},
                                     {"s^y", in.pixelHeightMm, u(CameraParameter::PixelHeight), "mm/px"},
                                     {"u_0", in.cxPx, u(CameraParameter::U0), "px"},
                                     {"v_0", in.cyPx, u(CameraParameter::V0), "px"}};
  if (in.model == DistortionModel::Division) {
    all.push_back({"kappa", in.kappa, u(CameraParameter::Kappa), "1/mm^2"});
    return all;
  }
  all.insert(all.end(), {{"k_1", in.k1, u(CameraParameter::K1), "1/mm^2"},
                         {"k_2", in.k2, u(CameraParameter::K2), "1/mm^4"},
                         {"k_3", in.k3, u(CameraParameter::K3), "1/mm^6"},
                         {"p_1", in.p1, u(CameraParameter::P1), "1/mm"},
                         {"p_2", in.p2, u(CameraParameter::P2), "1/mm"}});
  return all;
}

std::vector<PaperParameter> paperParameters(const RangeFinderCalibration& finder, const Eigen::MatrixXd& covariance) {
  std::vector<PaperParameter> all = paperParameters(finder.intrinsics, covariance);
  const Eigen::Matrix3d& rotation = finder.cameraFromWorld.rotation;
  const Eigen::Vector3d angles = eulerAngles(rotation);
  Eigen::Vector3d u = Eigen::Vector3d::Zero();
  if (covariance.rows() == kCameraParameters) {
    // The turns that the covariance speaks of are small ones about the camera's own axes.
    constexpr double kStep = 1e-6;
    Eigen::Matrix3d jacobian;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i);
      const auto turned = [&](double step) -> Eigen::Matrix3d {
        return Eigen::AngleAxisd(step, axis).toRotationMatrix() * rotation;
      };
      jacobian.col(i) = (eulerAngles(turned(kStep)) - eulerAngles(turned(-kStep))) / (2 * kStep);
    }
    const int first = static_cast<int>(CameraParameter::TurnX);
    u = (jacobian * covariance.block<3, 3>(first, first) * jacobian.transpose()).diagonal().cwiseMax(0).cwiseSqrt();
  }
  const std::array<const char*, 3> names = {"alpha", "beta", "gamma"};
  for (int i = 0; i < 3; ++i)
    all.push_back({names[static_cast<std::size_t>(i)], angles[i] * kDegrees, u[i] * kDegrees, "deg"});
  const std::array<CameraParameter, 3> shifts = {CameraParameter::T1, CameraParameter::T2, CameraParameter::T3};
  for (int i = 0; i < 3; ++i) {
    const CameraParameter t = shifts[static_cast<std::size_t>(i)];
    all.push_back({std::string(name(t)), finder.cameraFromWorld.translationMm[i], standard(covariance, t), "mm"});
  }
  return all;
}

}  // namespace vignole
