// vignole-cli calibrate encoder: mm a pulse from counts over a known length.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "calibration/encoder/encoder_calibration.h"
#include "cli/calibrate.h"
#include "cli/console.h"

namespace vignole::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string file, json;
  EncoderSettings settings;
  bool quiet = false;
};

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json toJson(const Options& o, const EncoderCalibration& c) {
  Json json = {{"file", o.file},
               {"length_mm", o.settings.lengthMm},
               {"u_length_mm", o.settings.uLengthMm},
               {"counts", c.counts},
               {"falling", c.falling},
               {"vz_mm_per_pulse", c.vz.mm},
               {"u_vz_mm_per_pulse", orNull(c.vz.uMm)},
               {"vx_mm_per_pulse", c.vx.mm},
               {"u_vx_mm_per_pulse", orNull(c.vx.uMm)},
               {"vy_mm_per_pulse", c.vy.mm},
               {"u_vy_mm_per_pulse", orNull(c.vy.uMm)},
               {"slip", nullptr}};
  if (c.slip)
    json["slip"] = {{"ppm", c.slip->ppm},
                    {"u_ppm", c.slip->uPpm},
                    {"ratio", c.slip->ratio},
                    {"vz2_mm_per_pulse", c.slip->mmPerPulse},
                    {"u_vz2_mm_per_pulse", c.slip->uMmPerPulse},
                    {"worst_jump_pulses", c.slip->worstJump},
                    {"worst_jump_reading", c.slip->worstRow + 1}};
  return json;
}

std::string line(const char* what, double value, const std::optional<double>& u, const char* unit) {
  char text[160];
  if (u)
    std::snprintf(text, sizeof text, "%-24s %14.9g  u = %.2g %s\n", what, value, *u, unit);
  else
    std::snprintf(text, sizeof text, "%-24s %14.9g  u unknown (fewer than three readings) %s\n", what, value, unit);
  return text;
}

std::string toText(const Options& o, const EncoderCalibration& c) {
  char head[200];
  std::snprintf(head, sizeof head, "%.0f pulses%s over %.3f mm (u = %.3f mm)\n", c.counts,
                c.falling ? ", counted backwards," : "", o.settings.lengthMm, o.settings.uLengthMm);
  std::string text = head;
  text += line("V^z", c.vz.mm, c.vz.uMm, "mm a pulse");
  text += line("V^x", c.vx.mm, c.vx.uMm, "mm a pulse");
  text += line("V^y", c.vy.mm, c.vy.uMm, "mm a pulse");
  if (c.slip) {
    text += line("V^z, second encoder", c.slip->mmPerPulse, c.slip->uMmPerPulse, "mm a pulse");
    char slip[240];
    std::snprintf(slip, sizeof slip,
                  "slip of the second       %14.1f  u = %.1f ppm, expected ratio %g; largest jump %.1f pulses, before "
                  "reading %zu\n",
                  c.slip->ppm, c.slip->uPpm, c.slip->ratio, c.slip->worstJump, c.slip->worstRow + 1);
    text += slip;
  }
  return text;
}

int run(const Options& o) {
  const auto readings = loadEncoderReadings(o.file);
  if (!readings) return fail(readings.error());
  const auto calibrated = calibrateEncoder(*readings, o.settings);
  if (!calibrated) {
    Error error = calibrated.error();
    if (!error.where.starts_with("--")) error.where = error.where.empty() ? o.file : o.file + ": " + error.where;
    return fail(error);
  }
  if (!o.json.empty())
    if (const auto written = writeJson(o.json, toJson(o, *calibrated)); !written) return fail(written.error());
  if (o.json != "-")
    if (const auto written = writeResult("-", toText(o, *calibrated)); !written) return fail(written.error());
  return kDone;
}

}  // namespace

void addCalibrateEncoder(CLI::App& calibrate, int& exitCode) {
  auto o = std::make_shared<Options>();
  CLI::App* command = calibrate.add_subcommand("encoder", "mm a pulse of the rotary encoder, from a known length");
  command->footer(
      "The file has columns count,x_mm,y_mm (and count2 of a second encoder): the counter and where the body was\n"
      "seen, first at the start and last at the end of the known length.\n"
      "Example: vignole-cli calibrate encoder travel.csv --length 2000 --length-u 0.05 --json -");
  command->add_option("FILE", o->file, "CSV: count,x_mm,y_mm[,count2]")->required();
  command->add_option("--length", o->settings.lengthMm, "travel from the first to the last row, mm")->required();
  command->add_option("--length-u", o->settings.uLengthMm, "its standard uncertainty, mm")->capture_default_str();
  command->add_option("--ratio", o->settings.ratio,
                      "pulses of the second encoder for one of the first; default: the whole number that is near");
  command->add_option("--json", o->json, "file, or - for stdout");
  command->add_flag("--quiet", o->quiet, "no progress on the terminal (there is none)");
  command->callback([o, &exitCode] { exitCode = run(*o); });
}

}  // namespace vignole::cli
