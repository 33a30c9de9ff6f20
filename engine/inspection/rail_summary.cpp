#include "engine/inspection/rail_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vignole {

namespace {

/// How far a result lies beyond its limits (negative: inside), and the value that does.
struct Excess {
  double byMm = 0;
  double valueMm = 0;
};

Excess excessOf(Dimension dimension, const DimensionResult& result) {
  const double value = result.valueMm.value_or(0);
  // The crown's lower limit judges its smallest deviation, the foot's concavity only what is hollow (rails.md).
  const double low = dimension == Dimension::HF ? result.secondMm.value_or(value) : value;
  const double high = dimension == Dimension::FC ? std::max(0.0, value) : value;
  Excess excess{-std::numeric_limits<double>::infinity(), value};
  if (result.upperMm) excess = {high - *result.upperMm, high};
  if (result.lowerMm && *result.lowerMm - low > excess.byMm) excess = {*result.lowerMm - low, low};
  return excess;
}

/// What is left of an uncertainty without the calibration's part.
double withoutCalibration(double uMm, double calibrationMm) {
  return calibrationMm > 0 ? std::sqrt(std::max(0.0, uMm * uMm - calibrationMm * calibrationMm)) : uMm;
}

void merge(TrackBin& into, const TrackBin& from) {
  if (from.count == 0) return;
  if (into.count == 0) {
    into = from;
    return;
  }
  const double all = into.count + from.count;
  into.meanMm += (from.meanMm - into.meanMm) * from.count / all;
  into.minMm = std::min(into.minMm, from.minMm);
  into.maxMm = std::max(into.maxMm, from.maxMm);
  into.count += from.count;
}

/// Order of badness for the rail's verdict.
int badness(Verdict verdict) {
  switch (verdict) {
    case Verdict::Fail:
      return 3;
    case Verdict::NotMeasured:
      return 2;
    case Verdict::Near:
      return 1;
    case Verdict::Pass:
    case Verdict::NoLimit:
      return 0;
  }
  return 0;
}

}  // namespace

std::optional<double> excessMm(Dimension dimension, const DimensionResult& result) {
  if (!result.valueMm || (!result.lowerMm && !result.upperMm)) return {};
  return excessOf(dimension, result).byMm;
}

RadiusMean::RadiusMean(double radiusMm, double uMm) : curvature_(1 / radiusMm) {
  const double u = uMm / (radiusMm * radiusMm);
  weight_ = 1 / (u * u);
}

void RadiusMean::add(double radiusMm, double uMm) {
  if (!(uMm > 0)) return;
  const double u = uMm / (radiusMm * radiusMm), weight = 1 / (u * u);
  weight_ += weight;
  curvature_ += (1 / radiusMm - curvature_) * weight / weight_;
}

double DimensionSummary::uOfMeanMm() const {
  if (values.count() == 0) return 0;
  const double profiles = withoutCalibration(uMm, uCalibrationMm);
  const double ofMean = radius.empty() ? profiles / std::sqrt(static_cast<double>(values.count())) : radius.uMm();
  return uCalibrationMm > 0 ? std::sqrt(ofMean * ofMean + uCalibrationMm * uCalibrationMm) : ofMean;
}

RailSummariser::RailSummariser(const RailBegin& rail, const Recipe& recipe, const std::string& calibrationId,
                               const RailSummarySettings& settings)
    : settings_(settings) {
  settings_.trackBins = std::max<std::size_t>(settings_.trackBins, 2);
  settings_.minExceptionProfiles = std::max(settings_.minExceptionProfiles, 1);
  settings_.maxExceptions = std::max<std::size_t>(settings_.maxExceptions, 1);
  summary_.rail = rail;
  summary_.recipe = recipe.name + " v" + std::to_string(recipe.version);
  summary_.calibrationId = calibrationId;
  const auto nominals = nominalDimensions(recipe.section, recipe.parameters);
  for (const Dimension d : kDimensions) {
    DimensionSummary& dimension = summary_.dimensions[index(d)];
    dimension.dimension = d;
    if (!nominals) continue;
    const std::optional<double>& nominal = (*nominals)[index(d)];
    if (!nominal) continue;
    dimension.nominalMm = *nominal;
    const ToleranceLimits& limits = recipe.limits[index(d)];
    if (limits.lowerMm) dimension.lowerMm = *nominal + *limits.lowerMm;
    if (limits.upperMm) dimension.upperMm = *nominal + *limits.upperMm;
  }
  // A known length fills the bins at once; an unknown one starts with a bin a profile.
  const double spacingM = rail.spacingMm / 1000;
  binWidthM_ = std::max(spacingM, rail.lengthMm / 1000 / static_cast<double>(settings_.trackBins));
  if (!(binWidthM_ > 0)) binWidthM_ = 0.001;
}

void RailSummariser::widenBins() {
  binWidthM_ *= 2;
  for (DimensionSummary& dimension : summary_.dimensions) {
    auto& track = dimension.track;
    for (std::size_t i = 0; i < track.size(); ++i) {
      const TrackBin bin = track[i];
      if (i % 2 == 0) {
        track[i / 2] = bin;
      } else {
        merge(track[i / 2], bin);
      }
    }
    track.resize((track.size() + 1) / 2);
    for (std::size_t i = 0; i < track.size(); ++i) track[i].positionM = (static_cast<double>(i) + 0.5) * binWidthM_;
  }
}

std::size_t RailSummariser::binAt(double positionM) const {
  // Positions are multiples of the spacing and so are the bins' edges: rounding must not put one into the bin before.
  return static_cast<std::size_t>(positionM / binWidthM_ + 1e-6);
}

void RailSummariser::addToTrack(DimensionSummary& dimension, double positionM, double valueMm) const {
  const std::size_t bin = binAt(positionM);
  auto& track = dimension.track;
  while (track.size() <= bin) {
    TrackBin empty;
    empty.positionM = (static_cast<double>(track.size()) + 0.5) * binWidthM_;
    track.push_back(empty);
  }
  TrackBin one;
  one.positionM = track[bin].positionM;
  one.meanMm = one.minMm = one.maxMm = valueMm;
  one.count = 1;
  merge(track[bin], one);
}

void RailSummariser::appendException(DimensionSummary& dimension, const Run& run) const {
  if (run.profiles < static_cast<std::uint64_t>(settings_.minExceptionProfiles)) return;
  auto& exceptions = dimension.exceptions;
  if (exceptions.size() < settings_.maxExceptions) {
    exceptions.push_back({run.fromM, run.toM, run.worstMm});
    return;
  }
  const auto distance = [&](double value) {
    double by = 0;
    if (dimension.upperMm) by = std::max(by, value - *dimension.upperMm);
    if (dimension.lowerMm) by = std::max(by, *dimension.lowerMm - value);
    return by;
  };
  DimensionException& last = exceptions.back();
  last.toM = run.toM;
  if (run.worstBy > distance(last.worstMm)) last.worstMm = run.worstMm;
}

void RailSummariser::addToRuns(std::size_t dimension, double positionM, const DimensionResult& result) {
  const bool fails = result.verdict == Verdict::Fail;
  const bool near = result.verdict == Verdict::Near;
  notPassing_[dimension] = fails || near ? notPassing_[dimension] + 1 : 0;
  longestNotPassing_[dimension] = std::max(longestNotPassing_[dimension], notPassing_[dimension]);
  Run& run = failing_[dimension];
  if (!fails) {
    appendException(summary_.dimensions[dimension], run);
    run = {};
    return;
  }
  ++failed_[dimension];
  const Excess excess = excessOf(kDimensions[dimension], result);
  if (run.profiles == 0) run.fromM = positionM;
  if (run.profiles == 0 || excess.byMm > run.worstBy) {
    run.worstBy = excess.byMm;
    run.worstMm = excess.valueMm;
  }
  run.toM = positionM;
  ++run.profiles;
}

void RailSummariser::addToOthers(const OtherSection& other) {
  OtherRail& rail = others_[other.name];
  rail.section = other.name;
  ++rail.profiles;
  const auto n = static_cast<double>(rail.profiles);
  rail.chi2 += (other.chi2 - rail.chi2) / n;
  rail.chi2OfRecipe += (other.chi2OfExpected - rail.chi2OfRecipe) / n;
}

std::optional<OtherRail> RailSummariser::otherRail() const {
  for (const auto& [section, rail] : others_)
    if (2 * rail.profiles >= summary_.profiles) return rail;
  return {};
}

void RailSummariser::add(const ProfileResult& result) {
  ++summary_.profiles;
  if (result.registration.looksLike) addToOthers(*result.registration.looksLike);
  const double positionM = result.profile.positionMm / 1000;
  summary_.lengthM = std::max(summary_.lengthM, positionM + summary_.rail.spacingMm / 1000);
  while (binAt(positionM) >= settings_.trackBins) widenBins();
  for (std::size_t d = 0; d < kDimensionCount; ++d) {
    const DimensionResult& measured = result.measurement.dimensions[d];
    DimensionSummary& dimension = summary_.dimensions[d];
    if (!measured.valueMm) {
      ++dimension.notMeasured;
      // Without a registration nothing was measured, for its reason.
      dimension.reason = !result.registration.valid ? result.registration.reason : measured.reason;
      continue;
    }
    dimension.values.add(*measured.valueMm);
    if (dimension.dimension == Dimension::HR)
      dimension.radius.add(*measured.valueMm, withoutCalibration(measured.uMm, measured.uCalibrationMm));
    dimension.uCalibrationMm = measured.uCalibrationMm;
    dimension.uMm += (measured.uMm - dimension.uMm) / static_cast<double>(dimension.values.count());
    addToTrack(dimension, positionM, *measured.valueMm);
    addToRuns(d, positionM, measured);
  }
}

Verdict RailSummariser::verdictOf(std::size_t d, const DimensionSummary& dimension) const {
  if (!dimension.lowerMm && !dimension.upperMm) return Verdict::NoLimit;
  const std::uint64_t count = dimension.values.count();
  if (count == 0) return Verdict::NotMeasured;
  if (!dimension.exceptions.empty() || 2 * failed_[d] >= count) return Verdict::Fail;
  const double mean = dimension.meanMm(), guard = 2 * dimension.uMm;
  const bool meanNear = (dimension.upperMm && mean + guard > *dimension.upperMm) ||
                        (dimension.lowerMm && mean - guard < *dimension.lowerMm);
  const bool persists = longestNotPassing_[d] >= static_cast<std::uint64_t>(settings_.minExceptionProfiles);
  return meanNear || persists ? Verdict::Near : Verdict::Pass;
}

RailSummary RailSummariser::summary(const TriggerLedger& triggers) const {
  RailSummary all = summary_;
  all.triggers = triggers;
  all.looksLike = otherRail();
  // Triggers without a profile are travelled metres too.
  all.lengthM = std::max(all.lengthM, static_cast<double>(triggers.seen) * all.rail.spacingMm / 1000);
  all.verdict = Verdict::NoLimit;
  for (std::size_t d = 0; d < kDimensionCount; ++d) {
    DimensionSummary& dimension = all.dimensions[d];
    appendException(dimension, failing_[d]);
    dimension.verdict = verdictOf(d, dimension);
    if (dimension.verdict == Verdict::NoLimit) continue;
    if (all.verdict == Verdict::NoLimit || badness(dimension.verdict) > badness(all.verdict))
      all.verdict = dimension.verdict;
  }
  // What little of another rail was measured is no verdict on it.
  if (all.looksLike && badness(Verdict::NotMeasured) > badness(all.verdict)) all.verdict = Verdict::NotMeasured;
  return all;
}

}  // namespace vignole
