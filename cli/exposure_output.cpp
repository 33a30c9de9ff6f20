#include "cli/exposure_output.h"

#include <array>
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace vignole::cli {
namespace {

using Json = nlohmann::ordered_json;

[[gnu::format(printf, 1, 2)]] std::string printed(const char* format, ...) {
  std::array<char, 512> buffer{};
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer.data(), buffer.size(), format, arguments);
  va_end(arguments);
  return buffer.data();
}

Json rowJson(const ExposureRow& row) {
  return {{"exposure_ms", row.exposureMs},
          {"pictures", row.pictures},
          {"empty", row.empty},
          {"saturated", row.saturated},
          {"saturated_max", row.saturatedMax},
          {"snr", row.snr},
          {"weak_snr", row.weakSnr},
          {"coverage", row.coverage},
          {"sigma_px", row.sigmaPx},
          {"sigma_mm", row.sigmaMm > 0 ? Json(row.sigmaMm) : Json(nullptr)},
          {"blur_mm", row.blurMm},
          {"blur_px", row.sigmaMm > 0 ? Json(row.blurPx) : Json(nullptr)},
          {"travel_mm", row.travelMm},
          {"highest_rate_hz", row.highestRateHz},
          {"spacing_mm", row.spacingMm},
          {"sigma_per_metre_mm", row.sigmaMm > 0 ? Json(row.sigmaPerMetreMm) : Json(nullptr)},
          {"limits_broken", row.limits}};
}

}  // namespace

Json toJson(const ExposureAdvice& advice) {
  Json rows = Json::array(), readings = Json::array();
  for (const ExposureRow& row : advice.rows) rows.push_back(rowJson(row));
  for (const ExposureReading& r : advice.readings)
    readings.push_back({{"exposure_ms", r.exposureMs},
                        {"scene", r.scene},
                        {"camera", r.camera + 1},
                        {"points", r.points},
                        {"saturated", r.saturated},
                        {"contrast_dn", r.contrastDn},
                        {"weak_dn", r.weakDn},
                        {"noise_dn", r.noiseDn},
                        {"sigma_px", r.sigmaPx},
                        {"width_px", r.widthPx},
                        {"mm_per_px", r.mmPerPx}});
  const ExposureSettings& s = advice.settings;
  return {{"version", VIGNOLE_VERSION},
          {"recommended_ms", advice.exposureMs ? Json(*advice.exposureMs) : Json(nullptr)},
          {"best_ms", advice.bestMs > 0 ? Json(advice.bestMs) : Json(nullptr)},
          {"reasons", advice.reasons},
          {"exposures", rows},
          {"model",
           {{"speed_m_per_s", s.motion.speedMPerS},
            {"vibration_mm", s.motion.vibrationMm},
            {"vibration_hz", s.motion.vibrationHz},
            {"slope_mm_per_m", s.motion.slopeMmPerM},
            {"readout_ms", s.timing.readoutMs},
            {"dead_ms", s.timing.deadMs},
            {"overlap", s.timing.overlap},
            {"rate_hz", s.rateHz ? Json(*s.rateHz) : Json(nullptr)},
            {"taken_at_rest", s.takenAtRest}}},
          {"limits",
           {{"saturated", s.maxSaturated},
            {"weak_snr", s.minWeakSnr},
            {"blur_px", s.maxBlurPx},
            {"coverage", s.minCoverage},
            {"tolerance", s.tolerance}}},
          {"pictures", readings}};
}

std::string toTable(const ExposureAdvice& advice) {
  std::string text = printed("%9s %9s %7s %7s %8s %9s %9s %8s %8s %8s %8s %9s\n", "t (ms)", "clipped", "S/N", "weak",
                             "found", "u (px)", "u (mm)", "blur mm", "blur px", "max Hz", "mm/prof", "u/m (mm)");
  for (const ExposureRow& r : advice.rows) {
    const bool known = r.sigmaMm > 0;
    text += printed("%8g%s %8.2f%% %7.1f %7.1f %7.1f%% %9.4f %9s %8.4f %8s %8.1f %8.1f %9s\n", r.exposureMs,
                    r.limits.empty() ? " " : "!", 100 * r.saturatedMax, r.snr, r.weakSnr, 100 * r.coverage, r.sigmaPx,
                    known ? printed("%.5f", r.sigmaMm).c_str() : "-", r.blurMm,
                    known ? printed("%.3f", r.blurPx).c_str() : "-", r.highestRateHz, r.spacingMm,
                    known ? printed("%.5f", r.sigmaPerMetreMm).c_str() : "-");
  }
  text += advice.exposureMs ? printed("\nrecommended: %g ms\n", *advice.exposureMs)
                            : std::string("\nno exposure can be recommended\n");
  for (const std::string& reason : advice.reasons) text += "  " + reason + "\n";
  return text;
}

}  // namespace vignole::cli
