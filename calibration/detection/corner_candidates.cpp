#include "calibration/detection/corner_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "calibration/detection/picture_levels.h"

namespace vignole {
namespace {

constexpr double kSigma = 1.2;               // px, of the smoothing
constexpr int kRingPoints = 32;              // multiple of 4
constexpr double kRingRadius = 4;            // px
constexpr double kNoiseFactor = 5;           // a saddle is so much stronger than noise's second derivative
constexpr double kLeastCurvature = 0.35;     // DN/px^2, where there is no noise
constexpr double kOddShare = 0.45;           // what may change sign across the corner, of what does not
constexpr double kLeastSector = 0.35;        // rad
constexpr std::size_t kMostSaddles = 40000;  // texture everywhere
constexpr int kBorder = 6;

struct Saddle {
  int x = 0, y = 0;
  float strength = 0;
};

/// Local maxima of -det(Hessian).
std::vector<Saddle> saddles(const cv::Mat& smooth, float least) {
  const int width = smooth.cols, height = smooth.rows;
  cv::Mat strength(height, width, CV_32FC1, cv::Scalar(0));
  for (int y = 1; y + 1 < height; ++y) {
    const float *a = smooth.ptr<float>(y - 1), *b = smooth.ptr<float>(y), *c = smooth.ptr<float>(y + 1);
    float* to = strength.ptr<float>(y);
    for (int x = 1; x + 1 < width; ++x) {
      const float xx = b[x - 1] - 2 * b[x] + b[x + 1], yy = a[x] - 2 * b[x] + c[x];
      const float xy = 0.25F * (a[x - 1] - a[x + 1] - c[x - 1] + c[x + 1]);
      to[x] = xy * xy - xx * yy;
    }
  }
  std::vector<Saddle> found;
  constexpr int kReach = 2;
  for (int y = kBorder; y + kBorder < height; ++y) {
    const float* row = strength.ptr<float>(y);
    for (int x = kBorder; x + kBorder < width; ++x) {
      const float s = row[x];
      if (s < least || s < row[x - 1] || s <= row[x + 1]) continue;
      bool greatest = true;
      for (int dy = -kReach; dy <= kReach && greatest; ++dy) {
        const float* other = strength.ptr<float>(y + dy) + x;
        for (int dx = -kReach; dx <= kReach; ++dx) {
          const bool earlier = dy < 0 || (dy == 0 && dx < 0);
          if (earlier ? other[dx] > s : (other[dx] >= s && (dx != 0 || dy != 0))) {
            greatest = false;
            break;
          }
        }
      }
      if (greatest) found.push_back({x, y, s});
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Saddle& a, const Saddle& b) { return a.strength > b.strength; });
  if (found.size() > kMostSaddles) found.resize(kMostSaddles);
  return found;
}

/// Top of the parabola through the saddle and its neighbours: of the grey values, whose gradient vanishes there.
Point2 refined(const cv::Mat& smooth, const Saddle& saddle) {
  const int x = saddle.x, y = saddle.y;
  const float *a = smooth.ptr<float>(y - 1), *b = smooth.ptr<float>(y), *c = smooth.ptr<float>(y + 1);
  const double gx = 0.5 * (b[x + 1] - b[x - 1]), gy = 0.5 * (c[x] - a[x]);
  const double xx = b[x - 1] - 2 * b[x] + b[x + 1], yy = a[x] - 2 * b[x] + c[x];
  const double xy = 0.25 * (a[x - 1] - a[x + 1] - c[x - 1] + c[x + 1]);
  const double det = xx * yy - xy * xy;
  const Point2 at(x, y);
  if (std::abs(det) < 1e-12) return at;
  const Point2 shift(-(yy * gx - xy * gy) / det, -(xx * gy - xy * gx) / det);
  return at + shift * std::min(1.0, 1.5 / std::max(shift.norm(), 1e-9));
}

double bilinear(const cv::Mat& image, double x, double y) {
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const double fx = x - x0, fy = y - y0;
  const float *a = image.ptr<float>(y0) + x0, *b = image.ptr<float>(y0 + 1) + x0;
  return (1 - fy) * ((1 - fx) * a[0] + fx * a[1]) + fy * ((1 - fx) * b[0] + fx * b[1]);
}

/// Grey values on a circle about the place: two dark and two bright sectors, each facing its like.
std::optional<Corner> judged(const cv::Mat& smooth, const Point2& place, double leastContrast) {
  static const auto kDirections = [] {
    std::array<Point2, kRingPoints> all;
    for (int i = 0; i < kRingPoints; ++i) {
      const double angle = 2 * std::numbers::pi * i / kRingPoints;
      all[static_cast<std::size_t>(i)] = Point2(std::cos(angle), std::sin(angle));
    }
    return all;
  }();
  std::array<double, kRingPoints> ring{};
  double sum = 0;
  for (std::size_t i = 0; i < kRingPoints; ++i) {
    const Point2 at = place + kRingRadius * kDirections[i];
    ring[i] = bilinear(smooth, at.x(), at.y());
    sum += ring[i];
  }
  auto sorted = ring;
  std::sort(sorted.begin(), sorted.end());
  // Middle between the bright and the dark quarter.
  constexpr std::size_t kEighth = kRingPoints / 8;
  const double dark = sorted[kEighth], bright = sorted[kRingPoints - 1 - kEighth];
  if (bright - dark < leastContrast) return std::nullopt;
  const double middle = 0.5 * (dark + bright);
  double even = 0, odd = 0;
  constexpr std::size_t kHalf = kRingPoints / 2;
  for (std::size_t i = 0; i < kHalf; ++i) {
    const double e = ring[i] + ring[i + kHalf] - 2 * middle, o = ring[i] - ring[i + kHalf];
    even += e * e;
    odd += o * o;
  }
  if (odd > kOddShare * kOddShare * even) return std::nullopt;
  std::vector<double> crossings;
  bool firstRises = false;
  for (std::size_t i = 0; i < kRingPoints; ++i) {
    const double a = ring[i] - middle, b = ring[(i + 1) % kRingPoints] - middle;
    if ((a < 0) == (b < 0)) continue;
    if (crossings.empty()) firstRises = a < 0;
    crossings.push_back((static_cast<double>(i) + a / (a - b)) * 2 * std::numbers::pi / kRingPoints);
  }
  if (crossings.size() != 4) return std::nullopt;
  Corner corner;
  corner.px = place;
  // The two ends of an edge, as one undirected line.
  const auto line = [&](std::size_t i) {
    const double a = crossings[i], b = crossings[i + 2] - std::numbers::pi;
    return 0.5 * (a + b);
  };
  const double bend1 = std::abs(crossings[2] - crossings[0] - std::numbers::pi);
  const double bend2 = std::abs(crossings[3] - crossings[1] - std::numbers::pi);
  constexpr double kMostBend = 0.6;  // rad
  if (bend1 > kMostBend || bend2 > kMostBend) return std::nullopt;
  corner.angle1 = line(0);
  corner.angle2 = line(1);
  const double between = corner.angle2 - corner.angle1;
  if (between < kLeastSector || between > std::numbers::pi - kLeastSector) return std::nullopt;
  corner.brightBetween = firstRises;
  return corner;
}

}  // namespace

std::vector<Corner> cornerCandidates(const ImageView& image) {
  const cv::Mat grey(image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.data),
                     static_cast<std::size_t>(image.stride));
  cv::Mat values, smooth;
  grey.convertTo(values, CV_32F);
  cv::GaussianBlur(values, smooth, cv::Size(0, 0), kSigma, kSigma, cv::BORDER_REPLICATE);
  const double noise = noiseOf(image);
  const double perNoise = std::sqrt(3 / (16 * std::numbers::pi)) / (kSigma * kSigma * kSigma);
  const double curvature = std::max(kLeastCurvature, kNoiseFactor * perNoise * noise);
  const double smoothedNoise = noise / (2 * kSigma * std::sqrt(std::numbers::pi));
  const double leastContrast = std::max(5.0, 6 * smoothedNoise);
  std::vector<Corner> corners;
  for (const Saddle& saddle : saddles(smooth, static_cast<float>(curvature * curvature))) {
    const Point2 place = refined(smooth, saddle);
    if (const auto corner = judged(smooth, place, leastContrast)) corners.push_back(*corner);
  }
  return corners;
}

}  // namespace vignole
