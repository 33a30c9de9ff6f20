#include "calibration/detection/corner_fit.h"

#include <array>
#include <numbers>
#include <vector>

#include "calibration/detection/edge_blur.h"
#include "calibration/detection/patch_fit.h"

namespace vignole {
namespace {

// Parameters of the model: the corner, angles of the edges, blur, mean grey, half the contrast,
// relative change of the light by x and y.
enum Parameter { kX, kY, kAngle1, kAngle2, kBlur, kMean, kHalf, kSlopeX, kSlopeY, kParameters };
using Vector = Eigen::Matrix<double, kParameters, 1>;

constexpr double kLeastRadius = 3, kMostRadius = 10;  // px; lenses bend longer edges
constexpr double kFade = 2;                           // px over which the patch fades out
constexpr double kHopeless = 0.5;                     // of the contrast: no such shape
constexpr int kRounds = 5;                            // the patch follows the corner
constexpr std::uint8_t kClipped = 254;

/// The crossing of two blurred edges.
class CrossingModel {
 public:
  explicit CrossingModel(const Vector& p)
      : p_(p),
        blur_(p[kBlur]),
        sin1_(std::sin(p[kAngle1])),
        cos1_(std::cos(p[kAngle1])),
        sin2_(std::sin(p[kAngle2])),
        cos2_(std::cos(p[kAngle2])) {}
  double operator()(double x, double y, Vector& derivatives) const {
    const double dx = x - p_[kX], dy = y - p_[kY];
    const Side a = across(-sin1_ * dx + cos1_ * dy), b = across(-sin2_ * dx + cos2_ * dy);
    const double light = 1 + p_[kSlopeX] * x + p_[kSlopeY] * y;
    const double grey = p_[kMean] - p_[kHalf] * a.value * b.value;
    const double byA = -light * p_[kHalf] * a.slope * b.value, byB = -light * p_[kHalf] * a.value * b.slope;
    derivatives[kX] = byA * sin1_ + byB * sin2_;
    derivatives[kY] = -byA * cos1_ - byB * cos2_;
    derivatives[kAngle1] = byA * (-cos1_ * dx - sin1_ * dy);
    derivatives[kAngle2] = byB * (-cos2_ * dx - sin2_ * dy);
    derivatives[kBlur] = (-byA * a.distance - byB * b.distance) * blur_.share();
    derivatives[kMean] = light;
    derivatives[kHalf] = -light * a.value * b.value;
    derivatives[kSlopeX] = grey * x;
    derivatives[kSlopeY] = grey * y;
    return light * grey;
  }

 private:
  struct Side {
    double distance = 0;  // from the edge, px
    double value = 0;     // -1 .. 1 across the edge
    double slope = 0;     // of it, by the distance
  };
  [[nodiscard]] Side across(double distance) const {
    const NormalStep step = normalStep(distance / blur_.px());
    return {distance, 2 * step.value - 1, 2 * step.density / blur_.px()};
  }

  Vector p_;
  EdgeBlur blur_;
  double sin1_, cos1_, sin2_, cos2_;
};

struct Patch {
  std::vector<PatchPixel> pixels;
  double saturatedShare = 0;
};

std::optional<Patch> patchOf(const ImageView& image, const Point2& centre, double radius, const Point2& origin) {
  const int x0 = static_cast<int>(std::floor(centre.x() - radius)),
            x1 = static_cast<int>(std::ceil(centre.x() + radius));
  const int y0 = static_cast<int>(std::floor(centre.y() - radius)),
            y1 = static_cast<int>(std::ceil(centre.y() + radius));
  if (x0 < 0 || y0 < 0 || x1 >= image.width || y1 >= image.height) return std::nullopt;
  Patch patch;
  std::size_t clipped = 0;
  for (int y = y0; y <= y1; ++y) {
    const std::uint8_t* row = image.row(y);
    for (int x = x0; x <= x1; ++x) {
      const double weight = std::clamp((radius - std::hypot(x - centre.x(), y - centre.y())) / kFade, 0.0, 1.0);
      if (weight <= 0) continue;
      clipped += row[x] >= kClipped ? 1 : 0;
      patch.pixels.push_back({x - origin.x(), y - origin.y(), static_cast<double>(row[x]), weight});
    }
  }
  patch.saturatedShare = static_cast<double>(clipped) / static_cast<double>(patch.pixels.size());
  return patch;
}

/// Means of the squares that are bright and dark by the start.
void startLevels(const Patch& patch, const Corner& start, Vector& p) {
  double sum = 0, product = 0, squares = 0;
  const double sign = start.brightBetween ? 1 : -1;
  for (const PatchPixel& pixel : patch.pixels) sum += pixel.value;
  p[kMean] = sum / static_cast<double>(patch.pixels.size());
  for (const PatchPixel& pixel : patch.pixels) {
    const double a = -std::sin(start.angle1) * pixel.x + std::cos(start.angle1) * pixel.y;
    const double b = -std::sin(start.angle2) * pixel.x + std::cos(start.angle2) * pixel.y;
    const double part = a * b < 0 ? 1 : -1;
    product += part * (pixel.value - p[kMean]);
    squares += 1;
  }
  p[kHalf] = product / squares;
  // The start's word on which squares are bright counts where the patch says little.
  if (p[kHalf] * sign < 1) p[kHalf] = sign;
}

/// Means of the four squares' pixels away from the edges: the worst bright against the worst dark.
double evennessOf(const Patch& patch, const Vector& p) {
  std::array<double, 4> sums{}, counts{};
  const double sin1 = std::sin(p[kAngle1]), cos1 = std::cos(p[kAngle1]);
  const double sin2 = std::sin(p[kAngle2]), cos2 = std::cos(p[kAngle2]);
  const double clear = std::min(EdgeBlur(p[kBlur]).px(), 2.0);
  for (const PatchPixel& pixel : patch.pixels) {
    const double x = pixel.x - p[kX], y = pixel.y - p[kY];
    const double a = -sin1 * x + cos1 * y, b = -sin2 * x + cos2 * y;
    if (std::min(std::abs(a), std::abs(b)) < clear) continue;
    const std::size_t square = (a > 0 ? 1U : 0U) + (b > 0 ? 2U : 0U);
    sums[square] += pixel.value;
    counts[square] += 1;
  }
  std::array<double, 4> means{};
  for (std::size_t i = 0; i < 4; ++i) {
    if (counts[i] == 0) return 0;
    means[i] = sums[i] / counts[i];
  }
  // Squares 0 and 3 lie on the same side of both edges or on the other of both.
  const double sign = p[kHalf] > 0 ? 1 : -1;
  const double bright = sign * std::min(sign * means[1], sign * means[2]);
  const double dark = sign * std::max(sign * means[0], sign * means[3]);
  return sign * (bright - dark) / (2 * std::abs(p[kHalf]));
}

}  // namespace

std::optional<CornerFit> fitCorner(const ImageView& image, const Corner& start, double roomPx) {
  const Point2 origin = start.px;
  CornerFit result;
  result.corner = start;
  // Edge 2 lies ahead of edge 1 by less than 180 degrees.
  double ahead = std::fmod(start.angle2 - start.angle1, std::numbers::pi);
  if (ahead < 0) ahead += std::numbers::pi;
  result.corner.angle2 = start.angle1 + ahead;
  Vector p = Vector::Zero();
  p[kAngle1] = result.corner.angle1;
  p[kAngle2] = result.corner.angle2;
  p[kBlur] = EdgeBlur::unknownOf(1);
  double radius = std::clamp(roomPx, kLeastRadius, kMostRadius);
  PatchFit<kParameters> fit;
  for (int round = 0; round < kRounds; ++round) {
    const auto patch = patchOf(image, result.corner.px, radius, origin);
    if (!patch) return std::nullopt;
    if (round == 0) startLevels(*patch, result.corner, p);
    fit = fitPatch<kParameters>(
        std::span<const PatchPixel>(patch->pixels), p, [](const Vector& at) { return CrossingModel(at); },
        [](Vector& at) { at[kBlur] = EdgeBlur::held(at[kBlur]); }, round == 0 ? PatchEffort::Rough : PatchEffort::Full);
    if (!fit.converged || !fit.parameters.allFinite()) return std::nullopt;
    p = fit.parameters;
    if (fit.rmsDn > kHopeless * std::abs(p[kHalf]) + 3 * fit.noiseDn) return std::nullopt;
    const Point2 last = result.corner.px;
    result.corner.px = origin + Point2(p[kX], p[kY]);
    result.saturatedShare = patch->saturatedShare;
    result.evenness = evennessOf(*patch, p);
    result.blurPx = EdgeBlur(p[kBlur]).px();
    if ((result.corner.px - origin).norm() > std::max(2.0, 0.3 * roomPx)) return std::nullopt;
    // A blurred edge needs a longer one to be seen as an edge.
    const double next = std::clamp(roomPx, kLeastRadius, std::max(3.5 * result.blurPx, kMostRadius));
    const bool settled = round > 0 && (result.corner.px - last).norm() < 0.02 && std::abs(next - radius) < 0.1 * radius;
    radius = next;
    if (settled) break;
  }
  result.corner.angle1 = p[kAngle1];
  result.corner.angle2 = p[kAngle2];
  result.corner.brightBetween = p[kHalf] > 0;
  result.contrastDn = 2 * std::abs(p[kHalf]);
  result.groundDn = p[kMean];
  result.noiseDn = fit.noiseDn;
  result.rmsDn = fit.rmsDn;
  result.uPx = std::sqrt(0.5 * (fit.covariance(kX, kX) + fit.covariance(kY, kY)));
  if (!std::isfinite(result.uPx)) return std::nullopt;
  return result;
}

}  // namespace vignole
