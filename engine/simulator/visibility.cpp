#include "engine/simulator/visibility.h"

#include <algorithm>
#include <cmath>

namespace vignole::simulator {

namespace {

using Run = VisibilityScratch::Run;

/// Walks one run by its tangent of the viewing angle, aside / ahead, which rises or falls along it throughout.
class RunWalker {
 public:
  RunWalker(const VisibilityScratch& scratch, const Run& run, std::size_t size)
      : scratch_(scratch), run_(run), size_(size) {}

  [[nodiscard]] std::size_t vertex(std::size_t step) const { return (run_.first + step) % size_; }
  [[nodiscard]] double tangent(std::size_t step) const {
    const std::size_t v = vertex(step);
    return scratch_.aside[v] / scratch_.ahead[v];
  }
  /// Step (fractional, 0 .. edges) at which the run is seen under `tan`.
  [[nodiscard]] double stepAt(double tan) const {
    std::size_t low = 0, high = run_.edges;
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      ((tangent(middle) <= tan) == run_.rising ? low : high) = middle;
    }
    const std::size_t a = vertex(low), b = vertex(high);
    const double over = tan * scratch_.ahead[a] - scratch_.aside[a];
    const double span = scratch_.aside[b] - scratch_.aside[a] - tan * (scratch_.ahead[b] - scratch_.ahead[a]);
    return static_cast<double>(low) + (span == 0 ? 0.5 : std::clamp(over / span, 0.0, 1.0));
  }
  [[nodiscard]] double aheadAt(double tan) const {
    const double step = stepAt(tan);
    const auto low = std::min(static_cast<std::size_t>(step), run_.edges - 1);
    const double share = step - static_cast<double>(low);
    return scratch_.ahead[vertex(low)] * (1 - share) + scratch_.ahead[vertex(low + 1)] * share;
  }

 private:
  const VisibilityScratch& scratch_;
  const Run& run_;
  std::size_t size_;
};

void findRuns(std::span<const Point2> outline, const Point2& eye, VisibilityScratch& scratch) {
  const std::size_t n = outline.size();
  const auto facing = [&](std::size_t i) {
    const Point2 edge = outline[(i + 1) % n] - outline[i], to = eye - outline[i];
    return edge.x() * to.y() - edge.y() * to.x() < 0;  // the outside lies on the right
  };
  scratch.runs.clear();
  std::size_t start = 0;
  while (start < n && facing(start)) ++start;
  if (start == n) return;  // the eye would be inside: nothing is seen
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t i = (start + k) % n;
    if (!facing(i)) continue;
    Run run{i, 0, 0, 0, true};
    while (k <= n && facing((start + k) % n)) ++run.edges, ++k;
    scratch.runs.push_back(run);
  }
  for (Run& run : scratch.runs) {
    const RunWalker walker(scratch, run, n);
    run.low = walker.tangent(0);
    run.high = walker.tangent(run.edges);
    run.rising = run.low <= run.high;
    if (!run.rising) std::swap(run.low, run.high);
  }
}

/// What other runs hide of this one, as ranges of the tangent.
void findHidden(const Run& run, std::size_t size, VisibilityScratch& scratch) {
  scratch.hidden.clear();
  const RunWalker mine(scratch, run, size);
  for (const Run& other : scratch.runs) {
    if (&other == &run) continue;
    const double low = std::max(run.low, other.low), high = std::min(run.high, other.high);
    if (!(low < high)) continue;
    const double middle = (low + high) / 2;
    if (RunWalker(scratch, other, size).aheadAt(middle) < mine.aheadAt(middle)) scratch.hidden.push_back({low, high});
  }
  std::sort(scratch.hidden.begin(), scratch.hidden.end(),
            [](const Interval& a, const Interval& b) { return a.from < b.from; });
}

}  // namespace

void visibleParts(std::span<const Point2> outline, const Viewpoint& viewpoint, VisibilityScratch& scratch,
                  std::vector<Interval>& visible) {
  visible.clear();
  const std::size_t n = outline.size();
  scratch.aside.resize(n);
  scratch.ahead.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 to = outline[i] - viewpoint.position;
    scratch.ahead[i] = to.dot(viewpoint.direction);
    scratch.aside[i] = viewpoint.direction.x() * to.y() - viewpoint.direction.y() * to.x();
  }
  findRuns(outline, viewpoint.position, scratch);

  const auto size = static_cast<double>(n);
  const auto emit = [&](const Run& run, double low, double high) {
    if (!(low < high)) return;
    const RunWalker walker(scratch, run, n);
    double a = walker.stepAt(low), b = walker.stepAt(high);
    if (a > b) std::swap(a, b);
    a += static_cast<double>(run.first);
    b += static_cast<double>(run.first);
    if (!(a < b)) return;
    if (a >= size) a -= size, b -= size;
    if (b <= size) {
      visible.push_back({a, b});
    } else {
      visible.push_back({a, size});
      visible.push_back({0, b - size});
    }
  };
  for (const Run& run : scratch.runs) {
    findHidden(run, n, scratch);
    double from = std::max(run.low, -viewpoint.tanHalfFan);
    const double to = std::min(run.high, viewpoint.tanHalfFan);
    for (const Interval& hidden : scratch.hidden) {
      emit(run, from, std::min(hidden.from, to));
      from = std::max(from, hidden.to);
    }
    emit(run, from, to);
  }
  std::sort(visible.begin(), visible.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
}

}  // namespace vignole::simulator
