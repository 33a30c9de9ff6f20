#include "calibration/intrinsics/zhang_start.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <opencv2/calib3d.hpp>

namespace vignole {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double kShortestInWidths = 0.2, kLongestInWidths = 60;  // focal lengths that a lens may have

Matrix3d cameraMatrix(const Intrinsics& in) {
  Matrix3d k;
  k << in.focalMm / in.pixelWidthMm, 0, in.cxPx, 0, in.focalMm / in.pixelHeightMm, in.cyPx, 0, 0, 1;
  return k;
}

Intrinsics camera(const Intrinsics& like, double focalPx, double cx, double cy) {
  Intrinsics in = like;
  in.focalMm = focalPx * like.pixelWidthMm;
  in.cxPx = cx;
  in.cyPx = cy;
  in.kappa = in.k1 = in.k2 = in.k3 = in.p1 = in.p2 = 0;
  return in;
}

bool possible(double focalPx, const Intrinsics& like) {
  return focalPx > kShortestInWidths * like.widthPx && focalPx < kLongestInWidths * like.widthPx;
}

Point2 middle(const Intrinsics& like) { return {(like.widthPx - 1) / 2.0, (like.heightPx - 1) / 2.0}; }

/// Principal point in the middle, pixels as high as stated: each view gives two linear equations for 1 / f^2.
std::optional<Intrinsics> centredStart(const std::vector<Matrix3d>& homographies, const Intrinsics& like) {
  const Point2 c = middle(like);
  const double pixelAspect = like.pixelHeightMm / like.pixelWidthMm;
  double ab = 0, aa = 0;
  for (const Matrix3d& raw : homographies) {
    Matrix3d toMiddle = Matrix3d::Identity();
    toMiddle(0, 2) = -c.x();
    toMiddle(1, 1) = pixelAspect;
    toMiddle(1, 2) = -pixelAspect * c.y();
    Matrix3d h = toMiddle * raw;
    h /= h.leftCols<2>().norm();
    const Vector3d h1 = h.col(0), h2 = h.col(1);
    const double a1 = h1.head<2>().dot(h2.head<2>()), b1 = h1.z() * h2.z();
    const double a2 = (h1.head<2>().squaredNorm() - h2.head<2>().squaredNorm()) / 2,
                 b2 = (h1.z() * h1.z() - h2.z() * h2.z()) / 2;
    ab += a1 * b1 + a2 * b2;
    aa += a1 * a1 + a2 * a2;
  }
  if (!(ab < 0)) return {};
  const double focalPx = std::sqrt(-aa / ab);  // least squares for f^2, which noise shortens less than for 1 / f^2
  if (!possible(focalPx, like)) return {};
  return camera(like, focalPx, c.x(), c.y());
}

Vector6 conicRow(const Matrix3d& h, int i, int j) {
  Vector6 v;
  v << h(0, i) * h(0, j), h(0, i) * h(1, j) + h(1, i) * h(0, j), h(1, i) * h(1, j),
      h(2, i) * h(0, j) + h(0, i) * h(2, j), h(2, i) * h(1, j) + h(1, i) * h(2, j), h(2, i) * h(2, j);
  return v;
}

/// Zhang's closed form with skew; the principal point is taken from it, and one focal length.
std::optional<Intrinsics> zhangClosedForm(const std::vector<Matrix3d>& homographies, const Intrinsics& like) {
  if (homographies.size() < 3) return {};
  const Point2 c = middle(like);
  Matrix3d normalise = Matrix3d::Identity();  // pixels -> about +-1, for the sake of the numbers
  normalise(0, 0) = normalise(1, 1) = 2.0 / like.widthPx;
  normalise(0, 2) = -2 * c.x() / like.widthPx;
  normalise(1, 2) = -2 * c.y() / like.widthPx;
  Eigen::MatrixXd equations(2 * static_cast<Eigen::Index>(homographies.size()), 6);
  for (std::size_t v = 0; v < homographies.size(); ++v) {
    Matrix3d h = normalise * homographies[v];
    h /= h.leftCols<2>().norm();
    equations.row(2 * static_cast<Eigen::Index>(v)) = conicRow(h, 0, 1);
    equations.row(2 * static_cast<Eigen::Index>(v) + 1) = (conicRow(h, 0, 0) - conicRow(h, 1, 1));
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(equations, Eigen::ComputeFullV);
  const Vector6 b = svd.matrixV().col(5);
  const double determinant = b[0] * b[2] - b[1] * b[1];
  if (!(determinant > 0)) return {};
  const double v0 = (b[1] * b[3] - b[0] * b[4]) / determinant;
  const double lambda = b[5] - (b[3] * b[3] + v0 * (b[1] * b[3] - b[0] * b[4])) / b[0];
  if (!(lambda / b[0] > 0)) return {};
  const double fx = std::sqrt(lambda / b[0]), fy = std::sqrt(lambda * b[0] / determinant);
  const double u0 = -(b[3] + b[1] * v0) * fx * fx / lambda;
  const double focalPx = std::sqrt(fx * fy) * like.widthPx / 2;
  const double cx = c.x() + u0 * like.widthPx / 2, cy = c.y() + v0 * like.widthPx / 2;
  const bool inside = cx > 0 && cy > 0 && cx < like.widthPx && cy < like.heightPx;
  if (!inside || !possible(focalPx, like) || fx > 1.5 * fy || fy > 1.5 * fx) return {};
  return camera(like, focalPx, cx, cy);
}

}  // namespace

std::optional<Matrix3d> homography(const std::vector<Vector3d>& points, const ObservedView& view) {
  if (view.size() < 4) return {};
  std::vector<cv::Point2d> from, to;
  for (const Observation& o : view) {
    const Vector3d& p = points[static_cast<std::size_t>(o.point)];
    from.emplace_back(p.x(), p.y());
    to.emplace_back(o.px.x(), o.px.y());
  }
  try {
    const cv::Mat found = cv::findHomography(from, to, view.size() > 4 ? cv::LMEDS : 0);
    if (found.empty()) return {};
    Matrix3d h;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) h(i, j) = found.at<double>(i, j);
    if (!h.allFinite()) return {};
    const Vector3d& first = points[static_cast<std::size_t>(view.front().point)];
    return h.row(2).dot(Vector3d(first.x(), first.y(), 1)) < 0 ? Matrix3d(-h) : h;
  } catch (const cv::Exception&) {
    return {};
  }
}

bool mirrored(const Matrix3d& homography, const Intrinsics& in) {
  return (cameraMatrix(in).inverse() * homography).determinant() < 0;
}

Extrinsics poseFromHomography(const Matrix3d& homography, const Intrinsics& in) {
  const Matrix3d m = cameraMatrix(in).inverse() * homography;  // r1, r2, t up to scale
  const double scale = 2 / (m.col(0).norm() + m.col(1).norm());
  Matrix3d r;
  r << scale * m.col(0), scale * m.col(1), (scale * scale * m.col(0).cross(m.col(1)));
  const Eigen::JacobiSVD<Matrix3d> svd(r, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Extrinsics pose;
  pose.rotation = svd.matrixU() * svd.matrixV().transpose();
  pose.translationMm = scale * m.col(2);
  return pose;
}

std::vector<Intrinsics> zhangStarts(const std::vector<Matrix3d>& homographies, const Intrinsics& like) {
  std::vector<Intrinsics> starts;
  if (const auto closed = zhangClosedForm(homographies, like)) starts.push_back(*closed);
  if (const auto centred = centredStart(homographies, like)) starts.push_back(*centred);
  const Point2 c = middle(like);
  for (const double widths : {1.5, 6.0}) starts.push_back(camera(like, widths * like.widthPx, c.x(), c.y()));
  return starts;
}

}  // namespace vignole
