#include "calibration/intrinsics/outliers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vignole {

namespace {

constexpr double kMedianSquare = 1.3862943611198906;  // median of chi^2 with 2 degrees of freedom, 2 ln 2
constexpr double kLeastPx = 0.002;                    // nobody finds points better than that

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double variance(const Observation& o, double unexplainedPx) {
  return std::max(o.uPx * o.uPx + unexplainedPx * unexplainedPx, kLeastPx * kLeastPx);
}

/// The noise at which `excess`, which falls with it, is zero.
template <typename Excess>
double solveNoise(const Excess& excess) {
  if (excess(0.0) <= 0) return 0;
  double low = 0, high = kLeastPx;
  while (excess(high) > 0 && high < 1e4) high *= 2;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (excess(middle) > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Squares of all residuals in units of their variances, NaN left out.
std::vector<double> normalisedSquares(const ObservedView& view, const std::vector<Point2>& residuals) {
  std::vector<double> squares;
  for (std::size_t i = 0; i < view.size(); ++i) {
    const double square = residuals[i].squaredNorm() / (view[i].sigmaPx * view[i].sigmaPx);
    if (std::isfinite(square)) squares.push_back(square);
  }
  return squares;
}

std::string ratioText(double ratio) {
  char text[16];
  std::snprintf(text, sizeof text, "%.1f", ratio);
  return text;
}

std::string rejectionOf(const std::vector<double>& squares, std::size_t good, std::size_t count,
                        const OutlierSettings& settings) {
  const double ratio = std::sqrt(median(squares) / kMedianSquare);
  if (!(ratio <= settings.viewRatio))
    return "its points lie " + ratioText(ratio) +
           " times as far off as those of the other pictures (moved while it was taken, or another target); take it "
           "again";
  if (static_cast<double>(count - good) > settings.maxPointShare * static_cast<double>(count))
    return std::to_string(count - good) + " of its " + std::to_string(count) +
           " points do not fit the other pictures (hidden, reflecting or bent target); take it again";
  return {};
}

}  // namespace

Selection Selection::all(const TargetObservations& observations) {
  Selection s;
  for (const ObservedView& view : observations.views) s.points.emplace_back(view.size(), true);
  s.viewRejection.resize(observations.views.size());
  return s;
}

std::size_t Selection::usedViews() const {
  return static_cast<std::size_t>(
      std::count_if(viewRejection.begin(), viewRejection.end(), [](const std::string& r) { return r.empty(); }));
}

TargetObservations selected(const TargetObservations& all, const Selection& selection) {
  TargetObservations some{all.points, all.radiusMm, {}};
  some.views.resize(all.views.size());
  for (std::size_t v = 0; v < all.views.size(); ++v) {
    if (!selection.viewRejection[v].empty()) continue;
    for (std::size_t i = 0; i < all.views[v].size(); ++i)
      if (selection.points[v][i]) some.views[v].push_back(all.views[v][i]);
  }
  return some;
}

double unexplainedNoise(const TargetObservations& observations, const std::vector<std::vector<Point2>>& residuals) {
  return solveNoise([&](double noise) {
    std::vector<double> squares;
    for (std::size_t v = 0; v < observations.views.size(); ++v)
      for (std::size_t i = 0; i < observations.views[v].size(); ++i)
        if (residuals[v][i].allFinite())
          squares.push_back(residuals[v][i].squaredNorm() / variance(observations.views[v][i], noise));
    return median(std::move(squares)) - kMedianSquare;
  });
}

double unexplainedNoise(const TargetObservations& observations, const std::vector<std::vector<Point2>>& residuals,
                        double degreesOfFreedom) {
  return solveNoise([&](double noise) {
    double chi2 = 0;
    for (std::size_t v = 0; v < observations.views.size(); ++v)
      for (std::size_t i = 0; i < observations.views[v].size(); ++i)
        chi2 += residuals[v][i].squaredNorm() / variance(observations.views[v][i], noise);
    return chi2 - degreesOfFreedom;
  });
}

void weigh(TargetObservations& observations, double unexplainedPx) {
  for (ObservedView& view : observations.views)
    for (Observation& o : view) o.sigmaPx = std::sqrt(variance(o, unexplainedPx));
}

Selection judge(const TargetObservations& all, const std::vector<std::vector<Point2>>& residuals,
                const Selection& before, const OutlierSettings& settings) {
  Selection selection = before;
  const double limit = settings.pointSigmas * settings.pointSigmas;
  for (std::size_t v = 0; v < all.views.size(); ++v) {
    if (!before.viewRejection[v].empty()) continue;
    std::size_t good = 0;
    for (std::size_t i = 0; i < all.views[v].size(); ++i) {
      const double sigma = all.views[v][i].sigmaPx;
      const bool fits = residuals[v][i].squaredNorm() <= limit * sigma * sigma;  // false for NaN as well
      selection.points[v][i] = fits;
      good += fits ? 1 : 0;
    }
    selection.viewRejection[v] =
        rejectionOf(normalisedSquares(all.views[v], residuals[v]), good, all.views[v].size(), settings);
  }
  return selection;
}

}  // namespace vignole
