#include "calibration/encoder/encoder_calibration.h"

#include <algorithm>
#include <cmath>

namespace vignole {

namespace {

constexpr double kFewestCounts = 100;            // two readings rounded to a pulse: 0.41 pulses, a part in 250
const double kRounding = std::sqrt(2.0 / 12.0);  // of a difference of two whole counts, pulses

using Counts = std::vector<double>;

/// Refuses a counter that turns round.
Expected<void> oneWay(const Counts& counts, const std::string& column) {
  const bool falling = counts.back() < counts.front();
  for (std::size_t i = 1; i < counts.size(); ++i)
    if (falling ? counts[i] > counts[i - 1] : counts[i] < counts[i - 1])
      return inputError(column, "turns round at reading " + std::to_string(i + 1) + " (from " +
                                    std::to_string(static_cast<long long>(counts[i - 1])) + " to " +
                                    std::to_string(static_cast<long long>(counts[i])) +
                                    "); the body moved back, or the counter overflowed: travel once, one way");
  const double all = std::abs(counts.back() - counts.front());
  if (all < kFewestCounts)
    return inputError(column, "grows by " + std::to_string(static_cast<long long>(all)) +
                                  " over the length; at least " + std::to_string(static_cast<int>(kFewestCounts)) +
                                  " are needed, travel further");
  return {};
}

/// Straight line through y over the counts: its slope with the standard uncertainty that the scatter gives it.
PerPulse slopeOf(const Counts& counts, const std::vector<double>& y) {
  const auto n = static_cast<double>(counts.size());
  double meanX = 0, meanY = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    meanX += counts[i] / n;
    meanY += y[i] / n;
  }
  double sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    sxx += (counts[i] - meanX) * (counts[i] - meanX);
    sxy += (counts[i] - meanX) * (y[i] - meanY);
  }
  PerPulse slope{sxy / sxx, {}};
  if (counts.size() < 3) return slope;
  double squares = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double r = y[i] - meanY - slope.mm * (counts[i] - meanX);
    squares += r * r;
  }
  slope.uMm = std::sqrt(squares / (n - 2) / sxx);
  return slope;
}

/// The ratio that was built: a whole number or one over it.
std::optional<double> usualRatio(double seen) {
  constexpr double kNear = 0.02;
  const double whole = seen >= 1 ? std::round(seen) : 1 / std::round(1 / seen);
  return std::abs(seen / whole - 1) < kNear ? std::optional(whole) : std::nullopt;
}

double uOfPulse(const EncoderSettings& settings, double mmPerPulse, double counts) {
  return std::hypot(settings.uLengthMm, kRounding * mmPerPulse) / counts;
}

Expected<EncoderSlip> slipOf(const Counts& first, const Counts& second, const EncoderSettings& settings) {
  if (auto fine = oneWay(second, "count2"); !fine) return tl::unexpected(fine.error());
  const double n1 = std::abs(first.back() - first.front()), n2 = std::abs(second.back() - second.front());
  const auto ratio = settings.ratio ? settings.ratio : usualRatio(n2 / n1);
  if (!ratio)
    return inputError("count2", "grows " + std::to_string(n2 / n1) +
                                    " times as fast as count, which is near no whole number; give --ratio");
  EncoderSlip slip;
  slip.ratio = *ratio;
  slip.mmPerPulse = settings.lengthMm / n2;
  slip.uMmPerPulse = uOfPulse(settings, slip.mmPerPulse, n2);
  slip.ppm = 1e6 * (n2 / n1 / *ratio - 1);
  slip.uPpm = 1e6 * kRounding * std::hypot(1 / n1, 1 / n2);
  for (std::size_t i = 1; i < first.size(); ++i) {
    const double jump = std::abs(std::abs(second[i] - second[i - 1]) * (n1 / n2) - std::abs(first[i] - first[i - 1]));
    if (jump > slip.worstJump) {
      slip.worstJump = jump;
      slip.worstRow = i;
    }
  }
  return slip;
}

}  // namespace

Expected<EncoderCalibration> calibrateEncoder(const std::vector<EncoderReading>& readings,
                                              const EncoderSettings& settings) {
  if (!(settings.lengthMm > 0) || !std::isfinite(settings.lengthMm))
    return inputError("--length", "is not positive; give the length of the travel in mm");
  if (!(settings.uLengthMm >= 0) || !std::isfinite(settings.uLengthMm))
    return inputError("--length-u", "is negative; give a standard uncertainty in mm");
  if (settings.ratio && !(*settings.ratio > 0)) return inputError("--ratio", "is not positive");
  if (readings.size() < 2)
    return inputError("", std::to_string(readings.size()) +
                              " readings; at least two are needed, at the start and at the end of the length");
  Counts counts, second;
  std::vector<double> x, y;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const EncoderReading& r = readings[i];
    if (!std::isfinite(r.count) || !std::isfinite(r.xMm) || !std::isfinite(r.yMm) ||
        (r.count2 && !std::isfinite(*r.count2)))
      return inputError("reading " + std::to_string(i + 1), "has a value that is no number; remove it");
    counts.push_back(r.count);
    x.push_back(r.xMm);
    y.push_back(r.yMm);
    if (r.count2) second.push_back(*r.count2);
  }
  if (auto fine = oneWay(counts, "count"); !fine) return tl::unexpected(fine.error());
  EncoderCalibration result;
  result.counts = std::abs(counts.back() - counts.front());
  result.falling = counts.back() < counts.front();
  result.vz.mm = settings.lengthMm / result.counts;
  result.vz.uMm = uOfPulse(settings, result.vz.mm, result.counts);
  if (result.falling)
    for (double& c : counts) c = -c;  // drift along the travel, whichever way it is counted
  result.vx = slopeOf(counts, x);
  result.vy = slopeOf(counts, y);
  if (second.size() == readings.size()) {
    const auto slip = slipOf(counts, second, settings);
    if (!slip) return tl::unexpected(slip.error());
    result.slip = *slip;
  }
  return result;
}

}  // namespace vignole
