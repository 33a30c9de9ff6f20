#include "calibration/next_pose/calibration_worth.h"

#include <Eigen/QR>
#include <array>
#include <cmath>

#include "calibration/intrinsics/reprojection.h"
#include "engine/optics/camera_model.h"
#include "engine/optics/nominal_rig.h"
#include "engine/systematic/calibration_error.h"
#include "engine/target/pin_plate.h"

namespace vignole {

namespace {

using PoseByIntrinsics = Eigen::Matrix<double, 6, kIntrinsicParameters>;

struct SeenPoints {
  Eigen::Matrix<double, Eigen::Dynamic, kIntrinsicParameters> byIntrinsics;
  Eigen::Matrix<double, Eigen::Dynamic, 6> byPose;

  void add(const Reprojection& r) {
    byIntrinsics.conservativeResize(byIntrinsics.rows() + 2, Eigen::NoChange);
    byPose.conservativeResize(byPose.rows() + 2, Eigen::NoChange);
    byIntrinsics.bottomRows<2>() = r.byIntrinsics;
    byPose.bottomRows<2>() = r.byPose;
  }
  /// The change of the pose that makes up best for a change of the intrinsics.
  [[nodiscard]] PoseByIntrinsics refit() const {
    const Eigen::Matrix<double, 6, 1> scale = byPose.colwise().norm().transpose().cwiseInverse();
    const PoseByIntrinsics scaled = (byPose * scale.asDiagonal()).colPivHouseholderQr().solve(byIntrinsics);
    return -(scale.asDiagonal() * scaled);
  }
};

bool inPicture(const Point2& px, const Intrinsics& in) {
  return px.x() >= 0 && px.y() >= 0 && px.x() <= in.widthPx - 1 && px.y() <= in.heightPx - 1;
}

Expected<PoseByIntrinsics> refitOnPins(const Intrinsics& in, const Extrinsics& cameraFromWorld) {
  constexpr int kLeastPins = 4;
  SeenPoints pins;
  for (const Pin& pin : plate13().pins) {
    Reprojection r;
    const Eigen::Vector3d centre(pin.centreMm.x(), pin.centreMm.y(), 0);
    if (reproject(in, cameraFromWorld, centre, 0, r) && inPicture(r.px, in)) pins.add(r);
  }
  if (pins.byPose.rows() < 2 * kLeastPins)
    return inputError("camera", "does not see the pin plate where the rig's drawing has its cameras");
  return pins.refit();
}

/// Not HR: a single profile says nothing of it, and it would outweigh all others.
bool counts(Dimension d) { return d != Dimension::HR; }

}  // namespace

double CalibrationWorth::uncertainty(const Effect& effect, const IntrinsicCovariance& covariance) {
  return std::sqrt((effect.rows * covariance * effect.rows.transpose()).trace());
}

Expected<CalibrationWorth> worthInDimensions(const Intrinsics& in, const Section& section,
                                             const DimensionParameters& parameters) {
  RigCalibration rig = nominalRig();
  for (RangeFinderCalibration& finder : rig.rangeFinders) finder.intrinsics = in;
  std::array<PoseByIntrinsics, kCameraCount> refits;
  for (std::size_t camera = 0; camera < kCameraCount; ++camera) {
    const auto refit = refitOnPins(in, rig.rangeFinders[camera].cameraFromWorld);
    if (!refit) return tl::unexpected<Error>(refit.error());
    refits[camera] = *refit;
  }
  const auto jacobian = dimensionJacobian(section, parameters, rig);
  if (!jacobian) return tl::unexpected<Error>(jacobian.error());
  CalibrationWorth worth;
  for (const Dimension d : kDimensions) {
    const Eigen::RowVectorXd row = jacobian->row(static_cast<Eigen::Index>(index(d)));
    if (!row.allFinite() || !counts(d)) continue;
    CalibrationWorth::Effect effect{d, {}};
    effect.rows.resize(kCameraCount, kIntrinsicParameters);
    for (Eigen::Index camera = 0; camera < kCameraCount; ++camera) {
      const Eigen::RowVectorXd ofCamera = row.segment(camera * kCameraParameters, kCameraParameters);
      effect.rows.row(camera) =
          ofCamera.head<kIntrinsicParameters>() + ofCamera.tail<6>() * refits[static_cast<std::size_t>(camera)];
    }
    worth.effects.push_back(std::move(effect));
  }
  if (worth.effects.empty()) return inputError("section", "has no dimension that the rig measures");
  return worth;
}

CalibrationWorth worthInPicture(const Intrinsics& in, double distanceMm) {
  constexpr int kColumns = 9, kRows = 7;
  const Lens<double> l = lens(in);
  SeenPoints grid;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const Vector2T<double> px((in.widthPx - 1.0) * column / (kColumns - 1), (in.heightPx - 1.0) * row / (kRows - 1));
      const Vector2T<double> ray = undistortedFromPixel(l, px) / in.focalMm;
      Reprojection r;
      if (reproject(in, {}, distanceMm * Eigen::Vector3d(ray.x(), ray.y(), 1), 0, r)) grid.add(r);
    }
  CalibrationWorth::Effect effect;
  const double points = static_cast<double>(grid.byPose.rows()) / 2;
  effect.rows = (grid.byIntrinsics + grid.byPose * grid.refit()) / std::sqrt(points);
  return {{std::move(effect)}};
}

}  // namespace vignole
