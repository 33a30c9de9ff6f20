#include "calibration/lens_files/opencv_lens.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "engine/geometry/transform2.h"
#include "engine/optics/camera_model.h"

namespace vignole {

namespace {

using Eigen::Vector2d;
constexpr int kGridColumns = 50, kGridRows = 40;

std::vector<Point2> gridOver(int widthPx, int heightPx) {
  std::vector<Point2> grid;
  for (int row = 0; row < kGridRows; ++row)
    for (int column = 0; column < kGridColumns; ++column)
      grid.emplace_back((widthPx - 1.0) * column / (kGridColumns - 1), (heightPx - 1.0) * row / (kGridRows - 1));
  return grid;
}

/// A point of the picture before and after distortion, mm on the sensor or in units of the focal length.
struct Pair {
  Vector2d undistorted, distorted;
};

Vector2d distortedByOpenCv(const OpenCvLens& l, const Vector2d& p) {
  const double x = p.x(), y = p.y(), r2 = p.squaredNorm();
  const double radial = (1 + r2 * (l.k1 + r2 * (l.k2 + r2 * l.k3))) / (1 + r2 * (l.k4 + r2 * (l.k5 + r2 * l.k6)));
  return {x * radial + 2 * l.p1 * x * y + l.p2 * (r2 + 2 * x * x),
          y * radial + l.p1 * (r2 + 2 * y * y) + 2 * l.p2 * x * y};
}

/// Newton, its derivatives by differences.
std::optional<Vector2d> undistortedByOpenCv(const OpenCvLens& l, const Vector2d& distorted) {
  constexpr double kStep = 1e-6, kDone = 1e-13;
  Vector2d p = distorted;
  for (int i = 0; i < 50; ++i) {
    const Vector2d error = distorted - distortedByOpenCv(l, p);
    if (error.norm() < kDone) return p;
    const Vector2d ex(kStep, 0), ey(0, kStep);
    const Vector2d byX = (distortedByOpenCv(l, p + ex) - distortedByOpenCv(l, p - ex)) / (2 * kStep);
    const Vector2d byY = (distortedByOpenCv(l, p + ey) - distortedByOpenCv(l, p - ey)) / (2 * kStep);
    const double determinant = byX.x() * byY.y() - byX.y() * byY.x();
    if (!(determinant > 0)) return {};
    p.x() += (error.x() * byY.y() - error.y() * byY.x()) / determinant;
    p.y() += (error.y() * byX.x() - error.x() * byX.y()) / determinant;
  }
  return {};
}

/// The five coefficients k1, k2, k3, pa, pb with which to = from (1 + k1 r^2 ...) + pa (r^2 + 2 x^2, 2 x y) + pb (2 x
/// y, r^2 + 2 y^2), r of `from`: both polynomials have this shape.
using Coefficients = Eigen::Matrix<double, 5, 1>;
using Rows = Eigen::Matrix<double, 2, 5>;
Rows polynomialRows(const Vector2d& p) {
  const double x = p.x(), y = p.y(), r2 = p.squaredNorm();
  Rows rows;
  rows << x * r2, x * r2 * r2, x * r2 * r2 * r2, r2 + 2 * x * x, 2 * x * y,  //
      y * r2, y * r2 * r2, y * r2 * r2 * r2, 2 * x * y, r2 + 2 * y * y;
  return rows;
}

template <typename From, typename To>
Coefficients fitPolynomial(const std::vector<Pair>& pairs, const From& from, const To& to) {
  Eigen::Matrix<double, Eigen::Dynamic, 5> rows(2 * static_cast<Eigen::Index>(pairs.size()), 5);
  Eigen::VectorXd values(rows.rows());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    rows.middleRows<2>(2 * static_cast<Eigen::Index>(i)) = polynomialRows(from(pairs[i]));
    values.segment<2>(2 * static_cast<Eigen::Index>(i)) = to(pairs[i]) - from(pairs[i]);
  }
  const Coefficients scale = rows.colwise().norm().transpose().cwiseMax(1e-300).cwiseInverse();
  return scale.asDiagonal() * (rows * scale.asDiagonal()).colPivHouseholderQr().solve(values);
}

const auto kUndistorted = [](const Pair& p) -> const Vector2d& { return p.undistorted; };
const auto kDistorted = [](const Pair& p) -> const Vector2d& { return p.distorted; };

/// u (1 + kappa r^2) = d is linear in kappa.
double fitDivision(const std::vector<Pair>& pairs) {
  double ab = 0, aa = 0;
  for (const Pair& p : pairs) {
    const Vector2d a = p.distorted.squaredNorm() * p.undistorted;
    ab += a.dot(p.distorted - p.undistorted);
    aa += a.squaredNorm();
  }
  return aa > 0 ? ab / aa : 0;
}

}  // namespace

ToOpenCv toOpenCv(const Intrinsics& in) {
  const Lens<double> l = lens(in);
  const std::vector<Point2> grid = gridOver(in.widthPx, in.heightPx);
  std::vector<Pair> pairs;
  for (const Point2& px : grid)
    pairs.push_back({undistortedFromPixel(l, px) / in.focalMm, sensorFromPixel(l, px) / in.focalMm});
  const Coefficients c = fitPolynomial(pairs, kUndistorted, kDistorted);
  ToOpenCv result;
  result.lens = {in.focalMm / in.pixelWidthMm, in.focalMm / in.pixelHeightMm, in.cxPx, in.cyPx};
  result.lens.k1 = c[0];
  result.lens.k2 = c[1];
  result.lens.k3 = c[2];
  result.lens.p2 = c[3];  // OpenCV's p1 belongs to y
  result.lens.p1 = c[4];
  result.lens.widthPx = in.widthPx;
  result.lens.heightPx = in.heightPx;
  for (const Pair& p : pairs) {
    const Vector2d error = distortedByOpenCv(result.lens, p.undistorted) - p.distorted;
    result.maxResidualPx =
        std::max(result.maxResidualPx, Vector2d(error.x() * result.lens.fxPx, error.y() * result.lens.fyPx).norm());
  }
  return result;
}

Expected<FromOpenCv> fromOpenCv(const OpenCvLens& lensThere, DistortionModel model, double pixelMm) {
  FromOpenCv result;
  Intrinsics& in = result.intrinsics;
  in.pixelWidthMm = pixelMm;
  in.focalMm = lensThere.fxPx * pixelMm;
  in.pixelHeightMm = in.focalMm / lensThere.fyPx;
  in.cxPx = lensThere.cxPx;
  in.cyPx = lensThere.cyPx;
  in.widthPx = lensThere.widthPx;
  in.heightPx = lensThere.heightPx;
  in.model = model;
  const std::vector<Point2> grid = gridOver(in.widthPx, in.heightPx);
  std::vector<Pair> pairs;  // mm on the sensor
  for (const Point2& px : grid) {
    const Vector2d distorted((px.x() - in.cxPx) / lensThere.fxPx, (px.y() - in.cyPx) / lensThere.fyPx);
    const auto undistorted = undistortedByOpenCv(lensThere, distorted);
    if (!undistorted) return inputError("", "its distortion folds the picture over; no lens does that");
    pairs.push_back({*undistorted * in.focalMm, distorted * in.focalMm});
  }
  if (model == DistortionModel::Division) {
    in.kappa = fitDivision(pairs);
  } else {
    const Coefficients c = fitPolynomial(pairs, kDistorted, kUndistorted);
    in.k1 = c[0];
    in.k2 = c[1];
    in.k3 = c[2];
    in.p1 = c[3];
    in.p2 = c[4];
  }
  const Lens<double> here = lens(in);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double off = (pixelFromSensor(here, distort(here, pairs[i].undistorted)) - grid[i]).norm();
    if (!std::isfinite(off)) return inputError("", "its distortion is beyond what the model can say");
    result.maxResidualPx = std::max(result.maxResidualPx, off);
  }
  return result;
}

}  // namespace vignole
