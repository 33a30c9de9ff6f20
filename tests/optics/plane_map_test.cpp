#include "engine/optics/plane_map.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <vector>

namespace vignole {
namespace {

RangeFinderCalibration finder(DistortionModel model) {
  RangeFinderCalibration c;
  c.intrinsics.model = model;
  c.intrinsics.kappa = -1.2e-3;
  c.intrinsics.k1 = -5e-4;
  c.intrinsics.k2 = 4e-6;
  c.intrinsics.p1 = 1e-4;
  c.cameraFromWorld.rotation =
      (Eigen::AngleAxisd(2.2, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ())).matrix();
  c.cameraFromWorld.translationMm = {10, 30, 420};
  c.lightPlane.normal = Eigen::Vector3d(0.02, -0.03, 1).normalized();
  c.lightPlane.distanceMm = 1.5;
  return c;
}

class PlaneMapOf : public testing::TestWithParam<DistortionModel> {};
INSTANTIATE_TEST_SUITE_P(Models, PlaneMapOf, testing::Values(DistortionModel::Division, DistortionModel::Polynomial));

TEST_P(PlaneMapOf, InvertsTheProjectionOfATiltedPlane) {
  const RangeFinderCalibration c = finder(GetParam());
  const PlaneMap map(c);
  const Lens<double> l = lens(c.intrinsics);
  for (double x = -60; x <= 60; x += 15)
    for (double y = -60; y <= 60; y += 15) {
      const double z = (c.lightPlane.distanceMm - c.lightPlane.normal.x() * x - c.lightPlane.normal.y() * y) /
                       c.lightPlane.normal.z();
      const Eigen::Vector2d pixel =
          project<double>(l, c.cameraFromWorld.rotation, c.cameraFromWorld.translationMm, {x, y, z});
      const PlanePoint p = map(pixel.x(), pixel.y());
      EXPECT_NEAR(p.x, x, 1e-8);
      EXPECT_NEAR(p.y, y, 1e-8);
    }
}

TEST_P(PlaneMapOf, JacobianAgreesWithFiniteDifferences) {
  const PlaneMap map(finder(GetParam()));
  const double h = 1e-3;
  for (double column : {30.0, 700.0, 1370.0})
    for (double row : {10.0, 512.0, 1010.0}) {
      const PlanePoint p = map(column, row);
      const PlanePoint cp = map(column + h, row), cm = map(column - h, row);
      const PlanePoint rp = map(column, row + h), rm = map(column, row - h);
      EXPECT_NEAR(p.dxdc, (cp.x - cm.x) / (2 * h), 1e-7);
      EXPECT_NEAR(p.dydc, (cp.y - cm.y) / (2 * h), 1e-7);
      EXPECT_NEAR(p.dxdr, (rp.x - rm.x) / (2 * h), 1e-7);
      EXPECT_NEAR(p.dydr, (rp.y - rm.y) / (2 * h), 1e-7);
    }
}

TEST_P(PlaneMapOf, BatchGivesTheSameNumbers) {
  const PlaneMap map(finder(GetParam()));
  std::vector<float> columns, rows;
  for (int i = 0; i < 100; ++i) {
    columns.push_back(static_cast<float>(13.37 * i));
    rows.push_back(static_cast<float>(1000 - 9.1 * i));
  }
  std::vector<PlanePoint> points(columns.size());
  map.map(columns, rows, points);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const PlanePoint one = map(columns[i], rows[i]);
    EXPECT_NEAR(points[i].x, one.x, 1e-12);
    EXPECT_NEAR(points[i].dydr, one.dydr, 1e-12);
  }
}

}  // namespace
}  // namespace vignole
