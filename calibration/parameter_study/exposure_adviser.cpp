#include "calibration/parameter_study/exposure_adviser.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <set>

#include "engine/acquisition/picture_file.h"
#include "engine/optics/plane_map.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole {
namespace {

constexpr double kWeakShare = 0.05;

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Millimetres in the light plane that one pixel across the line is.
double mmAcross(const PlaneMap& map, const StripePoint& p) {
  const PlanePoint at = map(p.x, p.y);
  return std::hypot(at.dxdc * p.nx + at.dxdr * p.ny, at.dydc * p.nx + at.dydr * p.ny);
}

std::string printed(const char* format, double value) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
}
std::string milliseconds(double ms) { return printed("%g ms", ms); }
std::string percent(double share) { return printed("%.3g %%", 100 * share); }

/// Most points of a camera in a scene over the exposures that are not clipped: light that is makes every end longer.
using Fullest = std::map<std::pair<std::string, int>, int>;

Fullest fullestOf(const std::vector<ExposureReading>& readings, double maxSaturated) {
  std::map<double, double> saturated;
  for (const ExposureReading& r : readings) {
    double& most = saturated[r.exposureMs];
    most = std::max(most, r.saturated);
  }
  const bool all = std::none_of(saturated.begin(), saturated.end(),
                                [&](const auto& exposure) { return exposure.second <= maxSaturated; });
  Fullest fullest;
  for (const ExposureReading& r : readings) {
    int& most = fullest[{r.scene, r.camera}];
    if (all || saturated.at(r.exposureMs) <= maxSaturated) most = std::max(most, r.points);
  }
  return fullest;
}

class Sum {
 public:
  void add(double value) {
    sum_ += value;
    ++count_;
  }
  [[nodiscard]] double mean() const { return count_ == 0 ? 0 : sum_ / count_; }

 private:
  double sum_ = 0;
  int count_ = 0;
};

/// A line of variance v = width^2 + sigma^2 that a smear b widens is located sigma' = sigma ((v + b^2) / v)^1.5: its
/// light stays, its contrast falls (Steger's position noise, sn / A v^1.5 / s, with A s constant).
double widened(double sigmaPx, double widthPx, double filterPx, double blurPx) {
  const double v = widthPx * widthPx + filterPx * filterPx;
  return sigmaPx * std::pow((v + blurPx * blurPx) / v, 1.5);
}

ExposureRow rowOf(double exposureMs, const std::vector<ExposureReading>& readings, const Fullest& fullest,
                  const ExposureSettings& settings) {
  ExposureRow row;
  row.exposureMs = exposureMs;
  row.blurMm = motionBlurMm(settings.motion, exposureMs);
  row.travelMm = settings.motion.speedMPerS * exposureMs;
  row.highestRateHz = highestRateHz(settings.timing, exposureMs);
  const double rate = settings.rateHz ? std::min(*settings.rateHz, row.highestRateHz) : row.highestRateHz;
  row.spacingMm = 1000 * settings.motion.speedMPerS / rate;
  Sum saturated, snr, coverage, sigmaPx, sigmaMm, blurPx;
  row.weakSnr = std::numeric_limits<double>::infinity();
  for (const ExposureReading& r : readings) {
    if (r.exposureMs != exposureMs) continue;
    ++row.pictures;
    const int most = fullest.at({r.scene, r.camera});
    if (most > 0) coverage.add(std::min(1.0, static_cast<double>(r.points) / most));
    if (r.points == 0) {
      ++row.empty;
      row.weakSnr = 0;
      continue;
    }
    saturated.add(r.saturated);
    row.saturatedMax = std::max(row.saturatedMax, r.saturated);
    const double noise = std::max(r.noiseDn, 1 / std::sqrt(12.0));  // no less than that of whole grey values
    snr.add(r.contrastDn / noise);
    row.weakSnr = std::min(row.weakSnr, r.weakDn / noise);
    const double mmPerPx = r.mmPerPx > 0 ? r.mmPerPx : settings.mmPerPx.value_or(0);
    const double smear = mmPerPx > 0 ? row.blurMm / mmPerPx : 0;
    const double sigma = settings.takenAtRest ? widened(r.sigmaPx, r.widthPx, settings.stripe.sigma, smear) : r.sigmaPx;
    sigmaPx.add(sigma * sigma);
    sigmaMm.add(sigma * sigma * mmPerPx * mmPerPx);
    blurPx.add(smear);
  }
  row.saturated = saturated.mean();
  row.snr = snr.mean();
  row.coverage = coverage.mean();
  row.sigmaPx = std::sqrt(sigmaPx.mean());
  row.sigmaMm = std::sqrt(sigmaMm.mean());
  row.blurPx = blurPx.mean();
  row.sigmaPerMetreMm = row.sigmaMm / std::sqrt(std::max(1.0, 1000 / row.spacingMm));
  return row;
}

void findLimits(ExposureRow& row, const ExposureSettings& s) {
  const auto broken = [&row](std::string what) { row.limits.push_back(std::move(what)); };
  if (row.empty > 0)
    broken("no line in " + std::to_string(row.empty) + " of " + std::to_string(row.pictures) + " pictures");
  if (row.saturatedMax > s.maxSaturated)
    broken("saturated: " + percent(row.saturatedMax) + " of a line is clipped, at most " + percent(s.maxSaturated));
  if (row.empty < row.pictures && row.weakSnr < s.minWeakSnr)
    broken("too dark: the weakest 5 % of a line stand " + printed("%.1f", row.weakSnr) +
           " times above the noise, at least " + printed("%g", s.minWeakSnr));
  if (row.empty < row.pictures && row.coverage < s.minCoverage)
    broken("line lost: " + percent(row.coverage) + " of its points are found, at least " + percent(s.minCoverage));
  if (row.blurPx > s.maxBlurPx)
    broken("motion: smeared by " + printed("%.2f", row.blurPx) + " px, at most " + printed("%g", s.maxBlurPx));
  if (s.rateHz && row.highestRateHz < *s.rateHz * (1 - 1e-9))
    broken("too slow: " + printed("%.1f", row.highestRateHz) + " triggers a second, " + printed("%g", *s.rateHz) +
           " are wanted");
}

bool breaks(const ExposureRow& row, std::string_view beginning) {
  return std::any_of(row.limits.begin(), row.limits.end(),
                     [&](const std::string& limit) { return limit.starts_with(beginning); });
}

std::string remedy(const std::vector<ExposureRow>& rows) {
  const auto any = [&](std::string_view beginning) {
    return std::any_of(rows.begin(), rows.end(), [&](const ExposureRow& row) { return breaks(row, beginning); });
  };
  const bool dark = any("too dark") || any("line lost") || any("no line");
  if (dark && any("saturated"))
    return "dark and clipped parts in the same pictures: take exposures in between, even the light, or polarise it";
  if (dark) return "more light: open the lens, more laser power, or longer exposures";
  if (any("saturated")) return "less light: close the lens, less laser power, or shorter exposures";
  return "take shorter exposures, or ask for less speed or rate";
}

void recommend(ExposureAdvice& advice) {
  const ExposureRow* best = nullptr;
  const auto sigma = [](const ExposureRow& row) { return row.sigmaMm > 0 ? row.sigmaMm : row.sigmaPx; };
  for (const ExposureRow& row : advice.rows)
    if (row.limits.empty() && (best == nullptr || sigma(row) < sigma(*best))) best = &row;
  if (best == nullptr) {
    advice.reasons.push_back("every exposure breaks a limit; " + remedy(advice.rows));
  } else {
    advice.bestMs = best->exposureMs;
    const auto chosen = std::find_if(advice.rows.begin(), advice.rows.end(), [&](const ExposureRow& row) {
      return row.limits.empty() && sigma(row) <= (1 + advice.settings.tolerance) * sigma(*best);
    });
    advice.exposureMs = chosen->exposureMs;
    advice.reasons.push_back(milliseconds(chosen->exposureMs) +
                             (chosen->exposureMs == best->exposureMs
                                  ? " has the least uncertainty of the line among those that break no limit"
                                  : " is the shortest exposure whose uncertainty of the line is within " +
                                        percent(advice.settings.tolerance) + " of the best (" +
                                        milliseconds(best->exposureMs) + ")"));
    advice.reasons.push_back("up to " + printed("%.1f", chosen->highestRateHz) +
                             " triggers a second: a profile every " + printed("%.1f", chosen->spacingMm) + " mm at " +
                             printed("%g", advice.settings.motion.speedMPerS) + " m/s");
  }
  for (const ExposureRow& row : advice.rows)
    for (const std::string& limit : row.limits) advice.reasons.push_back(milliseconds(row.exposureMs) + ": " + limit);
  if (best != nullptr && best->sigmaMm == 0)
    advice.reasons.emplace_back("without a calibration or a scale mm are not known, nor the smear by motion in pixels");
}

}  // namespace

double motionBlurMm(const RailMotionModel& motion, double exposureMs) {
  const double t = exposureMs / 1000;
  const double way = motion.speedMPerS * motion.slopeMmPerM * t;
  const double phase = std::numbers::pi * motion.vibrationHz * t;
  const double sinc = phase > 0 ? std::sin(phase) / phase : 1;
  return std::sqrt(way * way / 12 + motion.vibrationMm * motion.vibrationMm * (1 - sinc * sinc));
}

double highestRateHz(const CameraTiming& timing, double exposureMs) {
  const double exposure = exposureMs + timing.deadMs;
  return 1000 / (timing.overlap ? std::max(exposure, timing.readoutMs) : exposure + timing.readoutMs);
}

ExposureReading readExposure(const StripeResult& lines, const RangeFinderCalibration* calibration) {
  ExposureReading reading;
  reading.noiseDn = lines.noiseDn;
  std::optional<PlaneMap> map;
  if (calibration != nullptr) map.emplace(*calibration);
  std::vector<double> contrast, sigma, width, scale;
  int saturated = 0;
  for (const StripeLine& line : lines.lines) {
    if (line.rejected()) continue;
    for (std::uint32_t i = line.first; i < line.first + line.count; ++i) {
      const StripePoint& p = lines.points[i];
      saturated += (p.flags & kSaturated) != 0 ? 1 : 0;
      contrast.push_back(p.strength);
      sigma.push_back(p.sigmaPx);
      width.push_back(p.widthPx);
      if (map) scale.push_back(mmAcross(*map, p));
    }
  }
  reading.points = static_cast<int>(contrast.size());
  if (reading.points == 0) return reading;
  reading.saturated = static_cast<double>(saturated) / reading.points;
  reading.weakDn = quantile(contrast, kWeakShare);
  reading.contrastDn = quantile(contrast, 0.5);
  reading.sigmaPx = quantile(sigma, 0.5);
  reading.widthPx = quantile(width, 0.5);
  reading.mmPerPx = quantile(scale, 0.5);
  return reading;
}

Expected<ExposureAdvice> adviseExposure(std::vector<ExposureReading> readings, const ExposureSettings& settings) {
  std::set<double> exposures;
  for (const ExposureReading& r : readings) exposures.insert(r.exposureMs);
  if (exposures.size() < 2)
    return inputError("exposure", "needs pictures at two exposures or more; there are pictures at " +
                                      std::to_string(exposures.size()));
  ExposureAdvice advice;
  advice.settings = settings;
  const Fullest fullest = fullestOf(readings, settings.maxSaturated);
  for (const double exposureMs : exposures) {
    advice.rows.push_back(rowOf(exposureMs, readings, fullest, settings));
    findLimits(advice.rows.back(), settings);
  }
  advice.readings = std::move(readings);
  recommend(advice);
  return advice;
}

Expected<ExposureAdvice> adviseExposure(const std::vector<ExposedPicture>& pictures, const RigCalibration* rig,
                                        const ExposureSettings& settings, const Job& job) {
  const auto stripe = checked(settings.stripe);
  if (!stripe) return tl::unexpected(stripe.error());
  StripeExtractor extractor(*stripe);
  StripeResult lines;
  std::vector<ExposureReading> readings;
  for (const ExposedPicture& picture : pictures) {
    if (job.cancelled()) return cancelledError();
    job.report(static_cast<double>(readings.size()) / static_cast<double>(pictures.size()), picture.file.string());
    const auto read = readPicture(picture.file);
    if (!read) return tl::unexpected(read.error());
    if (read->width < 32 || read->height < 32) return inputError(picture.file.string(), "is smaller than 32 x 32 px");
    extractor.extract(read->view(), lines);
    const auto camera = static_cast<std::size_t>(picture.camera);
    ExposureReading reading = readExposure(lines, rig == nullptr ? nullptr : &rig->rangeFinders[camera]);
    reading.exposureMs = picture.exposureMs;
    reading.scene = picture.scene;
    reading.camera = picture.camera;
    readings.push_back(std::move(reading));
  }
  return adviseExposure(std::move(readings), settings);
}

}  // namespace vignole
