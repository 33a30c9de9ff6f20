#include "calibration/assessment/residual_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vignole {

namespace {

constexpr double kNormalMad = 1.4826;

/// Pairs of neighbours, runs and squares over all sequences that start at 0 .. step - 1.
struct Sums {
  double products = 0, squares = 0;
  double pairs = 0;
  double runs = 0, expectedRuns = 0, runsVariance = 0;

  void add(const std::vector<double>& residuals, std::size_t step) {
    for (std::size_t from = 0; from < step; ++from) {
      double count = 0, changes = 0;
      for (std::size_t i = from; i < residuals.size(); i += step) {
        count += 1;
        squares += residuals[i] * residuals[i];
        if (i + step >= residuals.size()) continue;
        products += residuals[i] * residuals[i + step];
        pairs += 1;
        if ((residuals[i] > 0) != (residuals[i + step] > 0)) changes += 1;
      }
      if (count < 2) continue;
      runs += changes;
      expectedRuns += (count - 1) / 2;
      runsVariance += (count - 1) / 4;
    }
  }
};

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double shareBeyond3(const std::vector<double>& all) {
  if (all.empty()) return 0;
  std::vector<double> sizes;
  sizes.reserve(all.size());
  for (const double r : all) sizes.push_back(std::abs(r));
  const double scale = kNormalMad * medianOf(sizes);
  const auto beyond = std::count_if(sizes.begin(), sizes.end(), [&](double s) { return s > 3 * scale; });
  return static_cast<double>(beyond) / static_cast<double>(sizes.size());
}

ResidualStatistics statisticsOf(const RigAdjustment& adjustment, int camera) {
  const RangeFinderFit& fit = adjustment.finders[static_cast<std::size_t>(camera)];
  // Errors d points apart are correlated by exp(-d^2 / 4 s^2), c = 2 sqrt(pi) s of them are shared: 4 s apart, 0.02.
  const auto step = static_cast<std::size_t>(std::ceil(std::max(1.0, 4 * fit.correlatedPoints / 3.545)));
  Sums sums;
  std::vector<double> all;
  for (const PinView& view : adjustment.pins) {
    if (!view.used || view.camera != camera) continue;
    sums.add(view.residualPx, step);
    all.insert(all.end(), view.residualPx.begin(), view.residualPx.end());
  }
  ResidualStatistics s;
  const double independent = sums.pairs / static_cast<double>(step);
  s.samples = static_cast<int>(all.size() / step);
  if (!(independent > 1) || !(sums.squares > 0)) return s;
  s.autocorrelation = (sums.products / sums.pairs) / (sums.squares / static_cast<double>(all.size()));
  s.uAutocorrelation = 1 / std::sqrt(independent);
  // Sequences that start one point apart share their errors: together they are worth one.
  s.runsZ = (sums.runs - sums.expectedRuns) / static_cast<double>(step) /
            std::sqrt(sums.runsVariance / static_cast<double>(step));
  s.beyond3 = shareBeyond3(all);
  s.noiseRatio = fit.expectedNoisePx > 0 ? fit.noisePx / fit.expectedNoisePx : 0;
  return s;
}

constexpr double kMostAutocorrelation = 0.1, kMostRunsZ = 4, kMostBeyond3 = 0.03, kMostNoiseRatio = 2;

std::string said(const char* format, double value, int camera) {
  char text[160];
  std::snprintf(text, sizeof text, format, camera, value);
  return text;
}

}  // namespace

std::array<ResidualStatistics, kCameraCount> residualStatistics(const RigAdjustment& adjustment) {
  std::array<ResidualStatistics, kCameraCount> all;
  for (int c = 0; c < kCameraCount; ++c) all[static_cast<std::size_t>(c)] = statisticsOf(adjustment, c);
  return all;
}

std::vector<Check> residualChecks(const RigAdjustment& adjustment) {
  const auto all = residualStatistics(adjustment);
  const auto worst = [&](auto of) {
    std::size_t w = 0;
    for (std::size_t c = 1; c < all.size(); ++c)
      if (of(all[c]) > of(all[w])) w = c;
    return w;
  };
  std::vector<Check> checks;
  {
    // What noise alone may show is not held against it.
    const auto beyondNoise = [](const ResidualStatistics& s) {
      return std::max(0.0, std::abs(s.autocorrelation) - 3 * s.uAutocorrelation);
    };
    const std::size_t w = worst(beyondNoise);
    checks.push_back({"residual whiteness", all[w].samples > 0, std::abs(all[w].autocorrelation),
                      kMostAutocorrelation + 3.5 * all[w].uAutocorrelation, "", true,
                      said("residuals of camera %d that share no noise are correlated by %.2f", all[w].autocorrelation,
                           static_cast<int>(w) + 1),
                      "look whether pins are worn or dirty, whether the plate moved while it was seen, and whether the "
                      "intrinsic parameters are of this lens at this focus"});
  }
  {
    const std::size_t w = worst([](const ResidualStatistics& s) { return -s.runsZ; });
    checks.push_back({"residual runs", all[w].samples > 0, std::max(0.0, -all[w].runsZ), kMostRunsZ, "sd", false,
                      said("the residuals of camera %d keep their sign %.1f standard deviations too long",
                           -all[w].runsZ, static_cast<int>(w) + 1),
                      "look at the residuals along the arcs"});
  }
  {
    const std::size_t w = worst([](const ResidualStatistics& s) { return s.beyond3; });
    checks.push_back({"residual distribution", all[w].samples > 0, all[w].beyond3, kMostBeyond3, "", true,
                      said("of the residuals of camera %d, a share of %.3f lies beyond three standard deviations",
                           all[w].beyond3, static_cast<int>(w) + 1),
                      "clean the pins and keep other light away, then take the pictures again"});
  }
  {
    const std::size_t w = worst([](const ResidualStatistics& s) { return s.noiseRatio; });
    checks.push_back({"residual noise", all[w].samples > 0, all[w].noiseRatio, kMostNoiseRatio, "", true,
                      said("the points of camera %d scatter %.1f times as much as the noise of its pictures",
                           all[w].noiseRatio, static_cast<int>(w) + 1),
                      "look whether the pins are smooth and the lasers and cameras stand still while a picture is "
                      "taken"});
  }
  return checks;
}

}  // namespace vignole
