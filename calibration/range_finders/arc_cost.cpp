#include "calibration/range_finders/arc_cost.h"

#include <ceres/autodiff_cost_function.h>
#include <ceres/rotation.h>

#include "engine/optics/camera_model.h"

namespace vignole {

namespace {

class ArcResiduals {
 public:
  ArcResiduals(const CameraBase& camera, std::vector<ArcCostPoint> points)
      : camera_(camera), points_(std::move(points)) {}

  template <typename T>
  bool operator()(const T* intrinsics, const T* pose, const T* pin, const T* placement, T* residuals) const {
    const Lens<T> lens = changedLens(intrinsics);
    T turnColumns[9];
    ceres::AngleAxisToRotationMatrix(pose, turnColumns);
    const Eigen::Map<const Matrix3T<T>> turn(turnColumns);
    const Matrix3T<T> worldFromCamera = (turn * camera_.cameraFromWorld.rotation.cast<T>()).transpose();
    const Vector3T<T> translation =
        camera_.cameraFromWorld.translationMm.cast<T>() + Eigen::Map<const Vector3T<T>>(pose + 3);
    const Vector3T<T> centre = -(worldFromCamera * translation);
    using std::cos;
    using std::sin;
    using std::sqrt;
    const T c = cos(placement[2]), s = sin(placement[2]);
    const T pinX = c * pin[0] - s * pin[1] + placement[0], pinY = s * pin[0] + c * pin[1] + placement[1];
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const ArcCostPoint& point = points_[i];
      const Vector2T<T> u = undistortedFromPixel<T>(lens, point.px.cast<T>());
      const Vector3T<T> ray = worldFromCamera * Vector3T<T>(u.x(), u.y(), lens.focalMm);
      const T along = -centre.z() / ray.z();
      const T dx = centre.x() + along * ray.x() - pinX, dy = centre.y() + along * ray.y() - pinY;
      residuals[i] = (sqrt(dx * dx + dy * dy) - pin[2] - point.pullMm) * point.perMm;
    }
    return true;
  }

 private:
  template <typename T>
  Lens<T> changedLens(const T* unknowns) const {
    T change[kIntrinsicsUnknowns];
    for (int row = 0; row < kIntrinsicsUnknowns; ++row) {
      change[row] = T(0);
      for (int column = 0; column <= row; ++column)
        if (const double factor = camera_.intrinsicsFactor(row, column); factor != 0)
          change[row] += factor * unknowns[column];
    }
    const auto of = [&](CameraParameter p) { return change[static_cast<int>(p)]; };
    Lens<T> lens = vignole::lens<T>(camera_.intrinsics);
    lens.focalMm += of(CameraParameter::F);
    lens.pixelHeightMm += of(CameraParameter::PixelHeight);
    lens.cxPx += of(CameraParameter::U0);
    lens.cyPx += of(CameraParameter::V0);
    lens.kappa += of(CameraParameter::Kappa);
    lens.k1 += of(CameraParameter::K1);
    lens.k2 += of(CameraParameter::K2);
    lens.k3 += of(CameraParameter::K3);
    lens.p1 += of(CameraParameter::P1);
    lens.p2 += of(CameraParameter::P2);
    return lens;
  }

  CameraBase camera_;
  std::vector<ArcCostPoint> points_;
};

}  // namespace

std::unique_ptr<ceres::CostFunction> arcCost(const CameraBase& camera, std::vector<ArcCostPoint> points) {
  const int count = static_cast<int>(points.size());
  return std::make_unique<ceres::AutoDiffCostFunction<ArcResiduals, ceres::DYNAMIC, kIntrinsicsUnknowns, kPoseUnknowns,
                                                      kPinUnknowns, kPlacementUnknowns>>(
      new ArcResiduals(camera, std::move(points)), count);
}

}  // namespace vignole
