#include "gui/quality/runs_study.h"

#include <algorithm>
#include <cmath>

namespace vignole {

namespace {

constexpr double kUsualSectionM = 10;  // Table VI
constexpr double kMostSections = 6;

double longestM(const std::vector<MeasuredRun>& runs) {
  double longest = 0;
  for (const MeasuredRun& run : runs)
    for (const double at : run.positionM) longest = std::max(longest, at);
  return longest;
}

double medianSpacingM(const std::vector<double>& positionM) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < positionM.size(); ++i) steps.push_back(positionM[i] - positionM[i - 1]);
  if (steps.empty()) return 0.015;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return std::abs(*middle);
}

struct Averaged {
  double valueMm = 0, uMm = 0;
};

/// Of what the run measured within `halfM` of the position; single profiles: of the nearest one.
std::optional<Averaged> around(const MeasuredRun& run, const RunColumn& column, double positionM, double halfM,
                               bool nearestOnly) {
  double sum = 0, varianceSum = 0, calibration = 0, n = 0, best = halfM;
  std::optional<Averaged> nearest;
  const auto first = std::lower_bound(run.positionM.begin(), run.positionM.end(), positionM - halfM);
  for (auto at = first; at != run.positionM.end() && *at <= positionM + halfM; ++at) {
    const auto i = static_cast<std::size_t>(at - run.positionM.begin());
    if (!std::isfinite(column.valueMm[i])) continue;
    if (const double off = std::abs(*at - positionM); off <= best) {
      best = off;
      nearest = Averaged{column.valueMm[i], column.uMm[i]};
    }
    sum += column.valueMm[i];
    calibration += column.uCalibrationMm[i];
    varianceSum += std::max(0.0, column.uMm[i] * column.uMm[i] - column.uCalibrationMm[i] * column.uCalibrationMm[i]);
    n += 1;
  }
  if (nearestOnly || !nearest) return nearest;
  // The scatter of single profiles averages out; what the calibration leaves is the same in all of them.
  return Averaged{sum / n, std::hypot(std::sqrt(varianceSum) / n, calibration / n)};
}

/// A reference as dense as profiles is averaged over the same windows; a sparse one stands for its own place.
std::vector<ReferencePoint> windowed(const std::vector<ReferencePoint>& points, double windowM) {
  if (windowM <= 0) return points;
  std::vector<ReferencePoint> means;
  for (std::size_t i = 0; i < points.size();) {
    const double window = std::floor(points[i].positionM / windowM);
    std::size_t end = i;
    ReferencePoint mean;
    for (; end < points.size() && std::floor(points[end].positionM / windowM) == window; ++end) {
      mean.positionM += points[end].positionM;
      mean.valueMm += points[end].valueMm;
      mean.uMm += points[end].uMm;
    }
    const auto n = static_cast<double>(end - i);
    means.push_back({mean.positionM / n, mean.valueMm / n, mean.uMm / n});
    i = end;
  }
  return means;
}

Expected<AccuracyResult> accuracyOf(const std::vector<MeasuredRun>& runs, std::vector<ReferencePoint> reference,
                                    std::size_t dimension, double windowM) {
  if (reference.empty()) return inputError("", "the reference has no value of it");
  std::sort(reference.begin(), reference.end(), [](const auto& a, const auto& b) { return a.positionM < b.positionM; });
  std::vector<AccuracyPoint> points;
  for (const ReferencePoint& at : windowed(reference, windowM))
    for (const MeasuredRun& run : runs) {
      if (run.dimensions[dimension].valueMm.empty()) continue;
      // A little more than half a spacing: positions of two instruments never meet to the last bit.
      const double half = windowM > 0 ? windowM / 2 : 0.51 * medianSpacingM(run.positionM);
      if (const auto value = around(run, run.dimensions[dimension], at.positionM, half, windowM <= 0))
        points.push_back({at.positionM, run.name, value->valueMm, at.valueMm, value->uMm, at.uMm});
    }
  if (points.empty()) return inputError("", "no run has a value where the reference has one");
  return accuracyStudy(points);
}

std::optional<double> widthOf(const ToleranceLimits& limits) {
  if (limits.lowerMm && limits.upperMm) return *limits.upperMm - *limits.lowerMm;
  if (limits.upperMm) return std::abs(*limits.upperMm);
  if (limits.lowerMm) return std::abs(*limits.lowerMm);
  return {};
}

}  // namespace

double allowedBeyond(std::size_t n) {
  constexpr double kBeyondTwoU = 0.0455, kQuantile = 2.576;
  return kBeyondTwoU +
         kQuantile * std::sqrt(kBeyondTwoU * (1 - kBeyondTwoU) / static_cast<double>(std::max<std::size_t>(n, 1)));
}

bool percentMeans(Dimension dimension) { return dimension != Dimension::HF && dimension != Dimension::FC; }

std::optional<Dimension> RunsStudy::worstShare() const {
  std::optional<Dimension> worst;
  for (const Dimension d : kDimensions)
    if (const auto& share = dimensions[index(d)].sharePercent;
        share && (!worst || *share > *dimensions[index(*worst)].sharePercent))
      worst = d;
  return worst;
}

std::optional<Dimension> RunsStudy::worstAgreement() const {
  std::optional<Dimension> worst;
  double most = -1e9;
  for (const Dimension d : kDimensions) {
    const auto& accuracy = dimensions[index(d)].accuracy;
    if (!accuracy || accuracy->en.empty()) continue;
    const double over = static_cast<double>(accuracy->enBeyond1) / static_cast<double>(accuracy->en.size()) -
                        allowedBeyond(accuracy->en.size());
    if (over <= most) continue;
    most = over;
    worst = d;
  }
  return worst;
}

Expected<RunsStudy> studyRuns(const std::vector<MeasuredRun>& runs, const RunReference& reference,
                              const PerDimension<ToleranceLimits>& limits, const RunsStudySettings& settings) {
  if (runs.empty() || (runs.size() < 2 && reference.empty()))
    return inputError("runs", "at least 2 of the same rail are needed, there is " + std::to_string(runs.size()) +
                                  "; the paper took 5");
  RunsStudy study;
  for (const MeasuredRun& run : runs) study.runs.push_back(run.name);
  study.reference = reference.source;
  study.windowM = settings.windowM;
  study.sectionM =
      settings.sectionM > 0
          ? settings.sectionM
          : kUsualSectionM * std::max(1.0, std::ceil(longestM(runs) / (kUsualSectionM * kMostSections) - 1e-9));
  for (std::size_t d = 0; d < kDimensionCount; ++d) {
    DimensionStudy& is = study.dimensions[d];
    std::vector<RepeatabilityRun> columns;
    for (const MeasuredRun& run : runs)
      if (!run.dimensions[d].valueMm.empty()) columns.push_back({run.name, run.positionM, run.dimensions[d].valueMm});
    RepeatabilitySettings how;
    how.windowM = settings.windowM;
    how.sectionM = study.sectionM;
    if (auto repeats = repeatabilityStudy(columns, how))
      is.repeatability = std::move(*repeats);
    else
      is.whyNotRepeatability = repeats.error().message();
    is.toleranceMm = widthOf(limits[d]);
    if (is.repeatability && is.toleranceMm && *is.toleranceMm > 0)
      is.sharePercent = 100 * 6 * is.repeatability->srMm / *is.toleranceMm;
    if (auto accurate = accuracyOf(runs, reference.points[d], d, settings.windowM))
      is.accuracy = std::move(*accurate);
    else
      is.whyNotAccuracy = accurate.error().message();
  }
  return study;
}

}  // namespace vignole
