#include "engine/optics/plane_map.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace vignole {

namespace {

struct SensorPoint {
  double u, v;                    // undistorted, mm
  double dudc, dudr, dvdc, dvdr;  // mm per px
};

SensorPoint undistortDivision(const Lens<double>& lens, double column, double row) {
  const double x = (column - lens.cxPx) * lens.pixelWidthMm;
  const double y = (row - lens.cyPx) * lens.pixelHeightMm;
  const double g = 1 / (1 + lens.kappa * (x * x + y * y));
  const double k = -2 * lens.kappa * g * g;
  return {x * g,
          y * g,
          (g + k * x * x) * lens.pixelWidthMm,
          k * x * y * lens.pixelHeightMm,
          k * x * y * lens.pixelWidthMm,
          (g + k * y * y) * lens.pixelHeightMm};
}

SensorPoint undistortPolynomial(const Lens<double>& lens, double column, double row) {
  const Eigen::Vector2d distorted = sensorFromPixel<double>(lens, {column, row});
  Eigen::Vector2d u;
  Eigen::Matrix2d j;
  vignole::undistortPolynomial<double>(lens, distorted, u, j);
  return {u.x(),
          u.y(),
          j(0, 0) * lens.pixelWidthMm,
          j(0, 1) * lens.pixelHeightMm,
          j(1, 0) * lens.pixelWidthMm,
          j(1, 1) * lens.pixelHeightMm};
}

PlanePoint planePoint(const Eigen::Matrix3d& h, const SensorPoint& s) {
  const double inverse = 1 / (h(2, 0) * s.u + h(2, 1) * s.v + h(2, 2));
  PlanePoint p;
  p.x = (h(0, 0) * s.u + h(0, 1) * s.v + h(0, 2)) * inverse;
  p.y = (h(1, 0) * s.u + h(1, 1) * s.v + h(1, 2)) * inverse;
  const double dxdu = (h(0, 0) - p.x * h(2, 0)) * inverse, dxdv = (h(0, 1) - p.x * h(2, 1)) * inverse;
  const double dydu = (h(1, 0) - p.y * h(2, 0)) * inverse, dydv = (h(1, 1) - p.y * h(2, 1)) * inverse;
  p.dxdc = dxdu * s.dudc + dxdv * s.dvdc;
  p.dxdr = dxdu * s.dudr + dxdv * s.dvdr;
  p.dydc = dydu * s.dudc + dydv * s.dvdc;
  p.dydr = dydu * s.dudr + dydv * s.dvdr;
  return p;
}

}  // namespace

PlaneMap::PlaneMap(const RangeFinderCalibration& calibration) : lens_(lens(calibration.intrinsics)) {
  // The ray of (u, v, f) from the camera's centre C meets n.X = d at X = C + s rho, s = (d - n.C) / (n.rho): a fraction
  // with the common denominator n.rho, hence a homography.
  const Eigen::Matrix3d worldFromCamera = calibration.cameraFromWorld.rotation.transpose();
  const Eigen::Vector3d centre = -(worldFromCamera * calibration.cameraFromWorld.translationMm);
  const Eigen::Matrix3d ray =
      worldFromCamera * Eigen::Vector3d(1, 1, calibration.intrinsics.focalMm).asDiagonal().toDenseMatrix();
  const Eigen::RowVector3d along = calibration.lightPlane.normal.transpose() * ray;
  const double gap = calibration.lightPlane.distanceMm - calibration.lightPlane.normal.dot(centre);
  planeFromSensor_.row(0) = centre.x() * along + gap * ray.row(0);
  planeFromSensor_.row(1) = centre.y() * along + gap * ray.row(1);
  planeFromSensor_.row(2) = along;
}

PlanePoint PlaneMap::operator()(double column, double row) const {
  return planePoint(planeFromSensor_, lens_.model == DistortionModel::Division
                                          ? undistortDivision(lens_, column, row)
                                          : undistortPolynomial(lens_, column, row));
}

void PlaneMap::map(std::span<const float> columns, std::span<const float> rows, std::span<PlanePoint> points) const {
  assert(columns.size() == rows.size() && columns.size() == points.size());
  const Lens<double> lens = lens_;  // copies, so that the loops need not reload them
  const Eigen::Matrix3d h = planeFromSensor_;
  // In blocks with one array a quantity: loops that the compiler turns into vector code, twice as fast as point by
  // point.
  constexpr std::size_t kBlock = 64;
  struct Block {
    std::array<double, kBlock> u, v, dudc, dudr, dvdc, dvdr;
    void set(std::size_t i, const SensorPoint& s) {
      u[i] = s.u;
      v[i] = s.v;
      dudc[i] = s.dudc;
      dudr[i] = s.dudr;
      dvdc[i] = s.dvdc;
      dvdr[i] = s.dvdr;
    }
    [[nodiscard]] SensorPoint get(std::size_t i) const { return {u[i], v[i], dudc[i], dudr[i], dvdc[i], dvdr[i]}; }
  } block;
  std::array<double, kBlock> x, y, dxdc, dxdr, dydc, dydr;
  for (std::size_t from = 0; from < columns.size(); from += kBlock) {
    const std::size_t n = std::min(kBlock, columns.size() - from);
    const float* column = columns.data() + from;
    const float* row = rows.data() + from;
    if (lens.model == DistortionModel::Division) {
      for (std::size_t i = 0; i < n; ++i) block.set(i, undistortDivision(lens, column[i], row[i]));
    } else {
      for (std::size_t i = 0; i < n; ++i) block.set(i, undistortPolynomial(lens, column[i], row[i]));
    }
    for (std::size_t i = 0; i < n; ++i) {
      const PlanePoint p = planePoint(h, block.get(i));
      x[i] = p.x;
      y[i] = p.y;
      dxdc[i] = p.dxdc;
      dxdr[i] = p.dxdr;
      dydc[i] = p.dydc;
      dydr[i] = p.dydr;
    }
    for (std::size_t i = 0; i < n; ++i) points[from + i] = {x[i], y[i], dxdc[i], dxdr[i], dydc[i], dydr[i]};
  }
}

}  // namespace vignole
