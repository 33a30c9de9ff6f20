#include "tests/synthetic/stripe_score.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vignole::synthetic {
namespace {

constexpr int kCell = 16;

/// Indices of things by cells of 16 px.
class Cells {
 public:
  Cells(int width, int height)
      : columns_(width / kCell + 1), cells_(static_cast<std::size_t>(columns_ * (height / kCell + 1))) {}
  void add(double x, double y, std::size_t index) {
    const int c = cellOf(x), r = cellOf(y);
    if (auto* cell = at(c, r)) cell->push_back(index);
  }
  template <class Work>
  void around(double x, double y, const Work& work) {
    for (int r = cellOf(y) - 1; r <= cellOf(y) + 1; ++r)
      for (int c = cellOf(x) - 1; c <= cellOf(x) + 1; ++c)
        if (auto* cell = at(c, r))
          for (const std::size_t i : *cell) work(i);
  }

 private:
  static int cellOf(double v) { return static_cast<int>(std::floor(v / kCell)); }
  std::vector<std::size_t>* at(int c, int r) {
    const auto i = static_cast<std::size_t>(r * columns_ + c);
    return c < 0 || r < 0 || c >= columns_ || i >= cells_.size() ? nullptr : &cells_[i];
  }
  int columns_;
  std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace

StripeScore score(const StripeScene& scene, std::span<const StripePoint> points) {
  StripeScore result;
  Cells truth(scene.width, scene.height), found(scene.width, scene.height);
  for (std::size_t i = 0; i < scene.truth.size(); ++i) truth.add(scene.truth[i].x, scene.truth[i].y, i);
  std::vector<double> z2;
  double squares = 0, sum = 0, edgeZ2 = 0;
  int edgePoints = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const StripePoint& p = points[i];
    if ((p.flags & kRejected) != 0) continue;
    found.add(p.x, p.y, i);
    double best = 1e30;
    const TruthSample* nearest = nullptr;
    truth.around(p.x, p.y, [&](std::size_t k) {
      const double d = std::hypot(p.x - scene.truth[k].x, p.y - scene.truth[k].y);
      if (d < best) {
        best = d;
        nearest = &scene.truth[k];
      }
    });
    if (best > 3) {
      ++result.falsePoints;
      continue;
    }
    const double error = (p.x - nearest->x) * nearest->nx + (p.y - nearest->y) * nearest->ny;
    const double z = p.sigmaPx > 0 ? error / p.sigmaPx : 0;
    if (nearest->edgePx < 15) {
      edgeZ2 += z * z;
      ++edgePoints;
      continue;
    }
    squares += error * error;
    sum += error;
    result.worstPx = std::max(result.worstPx, std::abs(error));
    z2.push_back(z * z);
  }
  result.bodyPoints = static_cast<int>(z2.size());
  if (!z2.empty()) {
    const auto n = static_cast<double>(z2.size());
    result.rmsPx = std::sqrt(squares / n);
    result.biasPx = sum / n;
    for (const double z : z2) result.meanSquareZ += z / n;
    std::nth_element(z2.begin(), z2.begin() + static_cast<std::ptrdiff_t>(z2.size() / 2), z2.end());
    result.medianSquareZ = z2[z2.size() / 2];
  }
  if (edgePoints > 0) result.edgeMeanSquareZ = edgeZ2 / edgePoints;
  int visible = 0, detected = 0;
  for (std::size_t i = 0; i < scene.truth.size(); i += 4) {
    const TruthSample& s = scene.truth[i];
    if (!s.visible) continue;
    ++visible;
    bool hit = false;
    found.around(s.x, s.y, [&](std::size_t k) { hit = hit || std::hypot(points[k].x - s.x, points[k].y - s.y) <= 1; });
    if (hit) ++detected;
  }
  result.detection = visible > 0 ? static_cast<double>(detected) / visible : 1;
  return result;
}

}  // namespace vignole::synthetic
