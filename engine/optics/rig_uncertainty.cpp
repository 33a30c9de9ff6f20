#include "engine/optics/rig_uncertainty.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <array>
#include <cassert>

namespace vignole {

namespace {

struct Names {
  std::string_view brief, full;
};
constexpr std::array<Names, kCameraParameters> kNames = {
    Names{"f", "focal length"},          Names{"s_y", "pixel height"},       Names{"u_0", "principal point u_0"},
    Names{"v_0", "principal point v_0"}, Names{"kappa", "distortion kappa"}, Names{"k_1", "distortion k_1"},
    Names{"k_2", "distortion k_2"},      Names{"k_3", "distortion k_3"},     Names{"p_1", "distortion p_1"},
    Names{"p_2", "distortion p_2"},      Names{"turn_x", "turn about x"},    Names{"turn_y", "turn about y"},
    Names{"turn_z", "turn about z"},     Names{"t_1", "position t_1"},       Names{"t_2", "position t_2"},
    Names{"t_3", "position t_3"}};

}  // namespace

std::string_view name(CameraParameter parameter) { return kNames[static_cast<std::size_t>(parameter)].brief; }
std::string_view longName(CameraParameter parameter) { return kNames[static_cast<std::size_t>(parameter)].full; }

void apply(const CameraChange& change, RangeFinderCalibration& finder) {
  const auto of = [&](CameraParameter p) { return change[static_cast<int>(p)]; };
  Intrinsics& in = finder.intrinsics;
  in.focalMm += of(CameraParameter::F);
  in.pixelHeightMm += of(CameraParameter::PixelHeight);
  in.cxPx += of(CameraParameter::U0);
  in.cyPx += of(CameraParameter::V0);
  in.kappa += of(CameraParameter::Kappa);
  in.k1 += of(CameraParameter::K1);
  in.k2 += of(CameraParameter::K2);
  in.k3 += of(CameraParameter::K3);
  in.p1 += of(CameraParameter::P1);
  in.p2 += of(CameraParameter::P2);
  const Eigen::Vector3d turn = change.segment<3>(static_cast<int>(CameraParameter::TurnX));
  Extrinsics& pose = finder.cameraFromWorld;
  if (const double angle = turn.norm(); angle > 0)
    pose.rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() * pose.rotation;
  pose.translationMm += change.segment<3>(static_cast<int>(CameraParameter::T1));
}

void apply(const RigChange& change, RigCalibration& rig) {
  for (int camera = 0; camera < kCameraCount; ++camera)
    apply(change.segment<kCameraParameters>(camera * kCameraParameters),
          rig.rangeFinders[static_cast<std::size_t>(camera)]);
}

ErrorSource errorSource(const RigCalibration& rig) {
  ErrorSource source{"calibration", {}};
  source.effects.resize(kRigParameters, 0);
  if (rig.covariance.size() == 0) return source;
  assert(rig.covariance.rows() == kRigParameters && rig.covariance.cols() == kRigParameters);
  // Units differ by orders of magnitude, so the factor is taken of the correlations.
  const RigChange scale = rig.covariance.diagonal().cwiseMax(0).cwiseSqrt();
  const RigChange inverse = scale.unaryExpr([](double s) { return s > 0 ? 1 / s : 0.0; });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(inverse.asDiagonal() * rig.covariance *
                                                              inverse.asDiagonal());
  // What rounding leaves of an eigenvalue that is zero.
  const double nothing = 1e-14 * kRigParameters * solver.eigenvalues().maxCoeff();
  for (int i = 0; i < kRigParameters; ++i) {
    if (!(solver.eigenvalues()[i] > nothing)) continue;
    source.effects.conservativeResize(Eigen::NoChange, source.effects.cols() + 1);
    source.effects.rightCols<1>() =
        scale.asDiagonal() * solver.eigenvectors().col(i) * std::sqrt(solver.eigenvalues()[i]);
  }
  return source;
}

}  // namespace vignole
