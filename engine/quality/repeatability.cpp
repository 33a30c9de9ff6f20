#include "engine/quality/repeatability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/quality/chart_constants.h"

namespace vignole {

namespace {

constexpr double kLimitFactor = 2.8;  // ISO 5725-6: 1.96 sqrt(2), rounded

struct Profile {
  double positionM, valueMm;
};

/// In order of position; a position twice would make two profiles one.
Expected<std::vector<Profile>> sortedRun(const RepeatabilityRun& run) {
  std::vector<Profile> profiles;
  for (std::size_t i = 0; i < run.positionM.size(); ++i) profiles.push_back({run.positionM[i], run.valueMm[i]});
  std::stable_sort(profiles.begin(), profiles.end(),
                   [](const Profile& a, const Profile& b) { return a.positionM < b.positionM; });
  for (std::size_t i = 1; i < profiles.size(); ++i)
    if (profiles[i].positionM == profiles[i - 1].positionM)
      return inputError("run " + run.name, "position " + std::to_string(profiles[i].positionM) +
                                               " m stands there twice; name the runs apart");
  return profiles;
}

double medianSpacing(const std::vector<Profile>& profiles) {
  if (profiles.size() < 2) return 0;
  std::vector<double> gaps;
  for (std::size_t i = 1; i < profiles.size(); ++i) gaps.push_back(profiles[i].positionM - profiles[i - 1].positionM);
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  return *middle;
}

/// Value of the nearest profile within `reachM`, else NaN.
double valueNear(const std::vector<Profile>& profiles, double positionM, double reachM) {
  const auto after = std::lower_bound(profiles.begin(), profiles.end(), positionM,
                                      [](const Profile& p, double x) { return p.positionM < x; });
  const Profile* nearest = nullptr;
  const auto distance = [&](const Profile& p) { return std::abs(p.positionM - positionM); };
  if (after != profiles.end()) nearest = &*after;
  if (after != profiles.begin() && (nearest == nullptr || distance(*std::prev(after)) < distance(*nearest)))
    nearest = &*std::prev(after);
  if (nearest == nullptr || distance(*nearest) > reachM) return std::numeric_limits<double>::quiet_NaN();
  return nearest->valueMm;
}

Expected<void> align(const std::vector<RepeatabilityRun>& runs, RepeatabilityResult& result) {
  std::vector<std::vector<Profile>> sorted;
  for (const RepeatabilityRun& run : runs) {
    auto profiles = sortedRun(run);
    if (!profiles) return tl::unexpected(profiles.error());
    sorted.push_back(std::move(*profiles));
    result.runs.push_back(run.name);
  }
  result.valueMm.resize(runs.size());
  const double reachM = std::max(0.5 * medianSpacing(sorted.front()), 1e-6);
  std::vector<double> row(runs.size());
  for (const Profile& p : sorted.front()) {
    for (std::size_t r = 0; r < runs.size(); ++r)
      row[r] = r == 0 ? p.valueMm : valueNear(sorted[r], p.positionM, reachM);
    if (std::any_of(row.begin(), row.end(), [](double v) { return !std::isfinite(v); })) {
      ++result.dropped;
      continue;
    }
    result.positionM.push_back(p.positionM);
    for (std::size_t r = 0; r < runs.size(); ++r) result.valueMm[r].push_back(row[r]);
  }
  if (result.positionM.empty())
    return inputError("", "the runs have no position in common; are their positions along the rail in metres?");
  return {};
}

/// Number of the stretch (0, length], (length, 2 length] ... that holds a position; the edge belongs to the lower one.
long stretchOf(double positionM, double lengthM) {
  return std::max(0L, std::lround(std::ceil(positionM / lengthM - 1e-9)) - 1);
}

/// Means over windows in place of single profiles.
void average(RepeatabilityResult& result, double windowM) {
  std::vector<double> positions;
  std::vector<std::vector<double>> values(result.runs.size());
  for (std::size_t begin = 0, end = 0; begin < result.positionM.size(); begin = end) {
    const long window = stretchOf(result.positionM[begin], windowM);
    while (end < result.positionM.size() && stretchOf(result.positionM[end], windowM) == window) ++end;
    positions.push_back((static_cast<double>(window) + 0.5) * windowM);
    for (std::size_t r = 0; r < values.size(); ++r)
      values[r].push_back(meanOf(std::span(result.valueMm[r]).subspan(begin, end - begin)));
  }
  result.positionM = std::move(positions);
  result.valueMm = std::move(values);
}

/// What deviates from the mean of the runs, [run][position], while ranges and pooled variance are taken.
std::vector<std::vector<double>> spread(RepeatabilityResult& result, std::vector<double>& variances) {
  const std::size_t runs = result.runs.size(), positions = result.positionM.size();
  std::vector<std::vector<double>> residuals(runs, std::vector<double>(positions));
  std::vector<double> row(runs);
  double squares = 0;
  for (std::size_t i = 0; i < positions; ++i) {
    for (std::size_t r = 0; r < runs; ++r) row[r] = result.valueMm[r][i];
    const Sample s = describe(row);
    result.rangeMm.push_back(s.range());
    variances.push_back(s.variance());
    squares += s.sumOfSquares;
    for (std::size_t r = 0; r < runs; ++r) residuals[r][i] = row[r] - s.mean;
  }
  result.degrees = static_cast<double>(positions * (runs - 1));
  result.srMm = std::sqrt(squares / result.degrees);
  result.meanRangeMm = meanOf(result.rangeMm);
  result.maxRangeMm = *std::max_element(result.rangeMm.begin(), result.rangeMm.end());
  return residuals;
}

void addSections(RepeatabilityResult& result, const std::vector<std::vector<double>>& residuals, double sectionM) {
  const std::size_t positions = result.positionM.size();
  for (std::size_t begin = 0, end = 0; begin < positions; begin = end) {
    const long section = stretchOf(result.positionM[begin], sectionM);
    while (end < positions && stretchOf(result.positionM[end], sectionM) == section) ++end;
    RepeatabilitySection s;
    s.fromM = static_cast<double>(section) * sectionM;
    s.toM = s.fromM + sectionM;
    s.positions = end - begin;
    s.meanRangeMm = meanOf(std::span(result.rangeMm).subspan(begin, s.positions));
    std::vector<double> means, sds;
    for (const auto& run : residuals) {
      const Sample part = describe(std::span(run).subspan(begin, s.positions));
      means.push_back(part.mean);
      sds.push_back(part.sd());
    }
    s.consistency = mandel(means, sds, s.positions);
    result.sections.push_back(std::move(s));
  }
}

void addRuns(RepeatabilityResult& result, const std::vector<std::vector<double>>& residuals) {
  std::vector<double> means, variances;
  double correlation = 0;
  for (std::size_t r = 0; r < residuals.size(); ++r) {
    result.perRun.push_back(describe(result.valueMm[r]));
    const Sample s = describe(residuals[r]);
    means.push_back(s.mean);
    variances.push_back(s.variance());
    correlation += autocorrelation(residuals[r]) / static_cast<double>(residuals.size());
  }
  result.autocorrelation = correlation;
  result.grubbsRuns = grubbs(means);
  result.doubleGrubbsRuns = doubleGrubbs(means);
  result.cochranRuns = cochran(variances, result.positionM.size());
}

}  // namespace

Expected<RepeatabilityResult> repeatabilityStudy(const std::vector<RepeatabilityRun>& runs,
                                                 const RepeatabilitySettings& settings) {
  if (runs.size() < 2)
    return inputError(
        "", "repeatability needs at least two runs of the same rail; there is " + std::to_string(runs.size()));
  RepeatabilityResult result;
  if (auto aligned = align(runs, result); !aligned) return tl::unexpected(aligned.error());
  if (settings.windowM > 0) average(result, settings.windowM);

  std::vector<double> variances;
  const auto residuals = spread(result, variances);
  addSections(result, residuals, settings.sectionM);
  addRuns(result, residuals);
  result.cochranPositions = cochran(variances, runs.size());
  std::vector<double> runMeans;
  for (const Sample& s : result.perRun) runMeans.push_back(s.mean);
  result.meanMm = meanOf(runMeans);
  const double d2 = chartConstants(static_cast<int>(runs.size()), ConstantPrecision::Tabulated).d2;
  result.srFromRangeMm = result.meanRangeMm / d2;
  result.srIntervalMm = sdInterval(result.srMm, result.degrees, settings.alpha);
  result.rMm = kLimitFactor * result.srMm;
  result.notes.formulas = {
      "range = max - min of the runs at a position; mean of the ranges per section of the rail",
      "s_r^2 = sum over positions of sum over runs (x - mean of the runs)^2 / (positions (runs - 1)); r = 2.8 s_r",
      "interval of s_r by chi squared, positions taken as independent; s_r from ranges = mean range / d2",
      "Grubbs on the means of the runs; Cochran on the runs' scatter about their common mean, and on the variances "
      "of the positions; Mandel h and k per run and section, on what deviates from the mean of the runs"};
  result.notes.constants = {{"d2", d2},
                            {"limit_factor", kLimitFactor},
                            {"alpha", settings.alpha},
                            {"section_m", settings.sectionM},
                            {"window_m", settings.windowM}};
  return result;
}

}  // namespace vignole
