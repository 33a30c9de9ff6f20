#include "calibration/detection/circle_fit.h"

#include <Eigen/Eigenvalues>
#include <numbers>
#include <vector>

#include "calibration/detection/edge_blur.h"
#include "calibration/detection/patch_fit.h"

namespace vignole {
namespace {

// Parameters of the model: centre, the ellipse's matrix, blur, grey outside, grey inside less grey
// outside, relative change of the light by x and y.
enum Parameter { kX, kY, kL1, kL2, kL3, kBlur, kOutside, kContrast, kSlopeX, kSlopeY, kParameters };
using Vector = Eigen::Matrix<double, kParameters, 1>;

constexpr double kHopeless = 0.25;    // of the contrast: no such shape
constexpr int kRounds = 4;            // the band of pixels follows the ellipse
constexpr double kFirstPixels = 300;  // are enough for the first round, whose start is rough
constexpr std::uint8_t kClipped = 254;

/// A blurred edge along an ellipse.
class EdgeModel {
 public:
  explicit EdgeModel(const Vector& p) : p_(p), blur_(p[kBlur]) {}
  double operator()(double x, double y, Vector& derivatives) const {
    const double dx = x - p_[kX], dy = y - p_[kY];
    const double u = p_[kL1] * dx + p_[kL2] * dy, v = p_[kL3] * dy;
    const double radius = std::max(std::sqrt(u * u + v * v), 1e-9);
    // Distance from the ellipse to first order: (radius - 1) over the gradient of the radius.
    const double gx = p_[kL1] * u / radius, gy = (p_[kL2] * u + p_[kL3] * v) / radius;
    const double perPx = std::max(std::sqrt(gx * gx + gy * gy), 1e-9);
    const double distance = (radius - 1) / perPx;
    const NormalStep step = normalStep(-distance / blur_.px());
    const double inside = step.value, density = step.density / blur_.px();
    const double light = 1 + p_[kSlopeX] * x + p_[kSlopeY] * y;
    const double grey = p_[kOutside] + p_[kContrast] * inside;
    // Outwards by one pixel the inside loses `density`; that the gradient itself changes matters only off the edge.
    const double outwards = -light * p_[kContrast] * density;
    derivatives[kX] = -outwards * gx / perPx;
    derivatives[kY] = -outwards * gy / perPx;
    derivatives[kL1] = outwards * u * dx / (radius * perPx);
    derivatives[kL2] = outwards * u * dy / (radius * perPx);
    derivatives[kL3] = outwards * v * dy / (radius * perPx);
    derivatives[kBlur] = -outwards * distance * blur_.share();
    derivatives[kOutside] = light;
    derivatives[kContrast] = light * inside;
    derivatives[kSlopeX] = grey * x;
    derivatives[kSlopeY] = grey * y;
    return light * grey;
  }

 private:
  Vector p_;
  EdgeBlur blur_;
};

struct Band {
  std::vector<PatchPixel> pixels;
  double saturatedShare = 0;
};

/// Pixels within `halfWidth` of the ellipse, outside no further than `roomRatio`; origin: that of the picture.
std::optional<Band> bandOf(const ImageView& image, const DotEllipse& ellipse, double halfWidth, double roomRatio,
                           const Point2& origin, int step) {
  const Eigen::Matrix2d spread = (ellipse.toUnitCircle.transpose() * ellipse.toUnitCircle).inverse();
  const double reach = std::min(roomRatio, 1 + halfWidth / ellipse.semiAxesPx().y());
  const double halfX = std::sqrt(spread(0, 0)) * reach + 1, halfY = std::sqrt(spread(1, 1)) * reach + 1;
  const Point2& c = ellipse.centrePx;
  if (!std::isfinite(halfX + halfY) || c.x() - halfX < 0 || c.y() - halfY < 0 || c.x() + halfX > image.width - 1 ||
      c.y() + halfY > image.height - 1) {
    // The dot itself must be inside; its surroundings may be cut off.
    const double ownX = std::sqrt(spread(0, 0)) + 1, ownY = std::sqrt(spread(1, 1)) + 1;
    if (!std::isfinite(ownX + ownY) || c.x() - ownX < 0 || c.y() - ownY < 0 || c.x() + ownX > image.width - 1 ||
        c.y() + ownY > image.height - 1)
      return std::nullopt;
  }
  const int x0 = std::max(0, static_cast<int>(std::floor(c.x() - halfX)));
  const int x1 = std::min(image.width - 1, static_cast<int>(std::ceil(c.x() + halfX)));
  const int y0 = std::max(0, static_cast<int>(std::floor(c.y() - halfY)));
  const int y1 = std::min(image.height - 1, static_cast<int>(std::ceil(c.y() + halfY)));
  Band band;
  const Eigen::Matrix2d& l = ellipse.toUnitCircle;
  std::size_t clipped = 0;
  for (int y = y0; y <= y1; y += step) {
    const std::uint8_t* row = image.row(y);
    for (int x = x0; x <= x1; x += step) {
      const double dx = x - c.x(), dy = y - c.y();
      const double u = l(0, 0) * dx + l(0, 1) * dy, v = l(1, 1) * dy;
      const double radius = std::hypot(u, v);
      if (radius > roomRatio) continue;
      const double gx = l(0, 0) * u, gy = l(0, 1) * u + l(1, 1) * v;
      const double distance = std::abs(radius - 1) * radius / std::max(std::hypot(gx, gy), 1e-9);
      const double weight = std::clamp(halfWidth + 0.5 - distance, 0.0, 1.0);
      if (weight <= 0) continue;
      clipped += row[x] >= kClipped ? 1 : 0;
      band.pixels.push_back({x - origin.x(), y - origin.y(), static_cast<double>(row[x]), weight});
    }
  }
  if (band.pixels.size() < 2 * kParameters) return std::nullopt;
  band.saturatedShare = static_cast<double>(clipped) / static_cast<double>(band.pixels.size());
  return band;
}

/// Mean grey inside and outside the ellipse, as a start.
void startLevels(const Band& band, const DotEllipse& ellipse, const Point2& origin, Vector& p) {
  double inside = 0, outside = 0, nInside = 0, nOutside = 0;
  for (const PatchPixel& pixel : band.pixels) {
    const Point2 at(pixel.x + origin.x(), pixel.y + origin.y());
    const bool within = (ellipse.toUnitCircle * (at - ellipse.centrePx)).squaredNorm() < 1;
    (within ? inside : outside) += pixel.value;
    (within ? nInside : nOutside) += 1;
  }
  p[kOutside] = nOutside > 0 ? outside / nOutside : 128;
  p[kContrast] = (nInside > 0 ? inside / nInside : 128) - p[kOutside];
}

}  // namespace

double DotEllipse::areaPx() const { return std::numbers::pi / std::abs(toUnitCircle.determinant()); }

Eigen::Vector2d DotEllipse::semiAxesPx() const {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(toUnitCircle.transpose() * toUnitCircle);
  return solver.eigenvalues().cwiseMax(1e-30).cwiseSqrt().cwiseInverse();
}

DotEllipse ellipseOfMoments(const Point2& centrePx, const Eigen::Matrix2d& covariance) {
  const Eigen::Matrix2d quadric = (4 * covariance).inverse();
  return {centrePx, quadric.llt().matrixU()};
}

std::optional<DotFit> fitCircle(const ImageView& image, const DotEllipse& start, double roomRatio) {
  const Point2 origin = start.centrePx;
  DotFit result;
  result.ellipse = start;
  double halfWidth = std::clamp(0.5 * start.semiAxesPx().y(), 2.5, 8.0);
  Vector p = Vector::Zero();
  p[kBlur] = EdgeBlur::unknownOf(std::clamp(0.25 * start.semiAxesPx().y(), 0.6, 2.0));
  PatchFit<kParameters> fit;
  for (int round = 0; round < kRounds; ++round) {
    const double expected = 4 * halfWidth * std::sqrt(std::numbers::pi * result.ellipse.areaPx());
    const int step = round == 0 ? std::max(1, static_cast<int>(std::sqrt(expected / kFirstPixels))) : 1;
    const auto band = bandOf(image, result.ellipse, halfWidth, roomRatio, origin, step);
    if (!band) return std::nullopt;
    p[kX] = result.ellipse.centrePx.x() - origin.x();
    p[kY] = result.ellipse.centrePx.y() - origin.y();
    p[kL1] = result.ellipse.toUnitCircle(0, 0);
    p[kL2] = result.ellipse.toUnitCircle(0, 1);
    p[kL3] = result.ellipse.toUnitCircle(1, 1);
    if (round == 0) startLevels(*band, result.ellipse, origin, p);
    fit = fitPatch<kParameters>(
        std::span<const PatchPixel>(band->pixels), p, [](const Vector& at) { return EdgeModel(at); },
        [](Vector& at) { at[kBlur] = EdgeBlur::held(at[kBlur]); }, round == 0 ? PatchEffort::Rough : PatchEffort::Full);
    if (!fit.converged || !fit.parameters.allFinite()) return std::nullopt;
    p = fit.parameters;
    if (fit.rmsDn > kHopeless * std::abs(p[kContrast]) + 3 * fit.noiseDn) return std::nullopt;
    const DotEllipse last = result.ellipse;
    result.ellipse.centrePx = origin + Point2(p[kX], p[kY]);
    result.ellipse.toUnitCircle << p[kL1], p[kL2], 0, p[kL3];
    result.saturatedShare = band->saturatedShare;
    result.blurPx = EdgeBlur(p[kBlur]).px();
    const double area = result.ellipse.areaPx();
    if (!(area > 0.25 * start.areaPx() && area < 4 * start.areaPx())) return std::nullopt;
    const double radius = std::sqrt(start.areaPx() / std::numbers::pi);
    if ((result.ellipse.centrePx - origin).norm() > 0.5 * radius + 1) return std::nullopt;
    const double width = 3 * result.blurPx + 1.5;
    const bool settled = round > 0 && (result.ellipse.centrePx - last.centrePx).norm() < 0.02 &&
                         std::abs(width - halfWidth) < 0.1 * halfWidth;
    halfWidth = width;
    if (settled) break;
  }
  result.contrastDn = p[kContrast];
  result.groundDn = p[kOutside];
  result.noiseDn = fit.noiseDn;
  result.rmsDn = fit.rmsDn;
  result.uPx = std::sqrt(0.5 * (fit.covariance(kX, kX) + fit.covariance(kY, kY)));
  if (!std::isfinite(result.uPx)) return std::nullopt;
  return result;
}

}  // namespace vignole
