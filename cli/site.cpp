// vignole-cli site: which cameras are on the line, and whether they are there.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/live_line.h"

namespace vignole::cli {

namespace {

using Json = nlohmann::ordered_json;

struct SiteOptions {
  std::string file, address, calibration, out, json;
};

Expected<Site> siteOf(const SiteOptions& o) {
  LiveLineOptions live;
  live.site = o.file;
  live.address = o.address;
  return chosenSite(live);
}

Json toJson(const GigeIdentity& camera) {
  return {{"address", camera.address},
          {"serial", camera.serial},
          {"vendor", camera.vendor},
          {"model", camera.model},
          {"information", camera.manufacturerInfo}};
}

std::string lineOf(const GigeIdentity& camera) {
  std::array<char, 256> line{};
  std::snprintf(line.data(), line.size(), "%-15s  %-16s  %s %s\n", camera.address.c_str(), camera.serial.c_str(),
                camera.vendor.c_str(), camera.model.c_str());
  return line.data();
}

int done(const Expected<void>& written) { return written ? static_cast<int>(kDone) : fail(written.error()); }

int show(const SiteOptions& o) {
  const auto site = siteOf(o);
  if (!site) return fail(site.error());
  return done(writeResult("-", toToml(*site)));
}

int find(const SiteOptions& o) {
  Json json = {{"cameras", Json::array()}};
  std::string text;
  for (const GigeIdentity& camera : discover()) {
    json["cameras"].push_back(toJson(camera));
    text += lineOf(camera);
  }
  if (text.empty()) text = "no camera answers; look at power, cables and the network adapter's addresses\n";
  if (!o.json.empty())
    if (const auto written = writeJson(o.json, json); !written) return fail(written.error());
  return o.json == "-" ? static_cast<int>(kDone) : done(writeResult("-", text));
}

int check(const SiteOptions& o) {
  auto site = siteOf(o);
  if (!site) return fail(site.error());
  if (const auto found = findAddresses(*site); !found) return fail(found.error());
  const auto answers = identify(site->cameras);
  int code = kDone;
  std::string text;
  Json json = {{"cameras", Json::array()}};
  std::array<std::string, kCameraCount> serials;
  for (std::size_t c = 0; c < answers.size(); ++c) {
    Json camera = {{"camera", c + 1}};
    if (answers[c]) {
      serials[c] = answers[c]->serial;
      text += "camera " + std::to_string(c + 1) + "  " + lineOf(*answers[c]);
      camera.update(toJson(*answers[c]));
    } else {
      code = fail(answers[c].error());
    }
    camera["error"] = answers[c] ? Json(nullptr) : Json(answers[c].error().message());
    json["cameras"].push_back(camera);
  }
  const std::filesystem::path calibrationFile =
      o.calibration.empty() ? site->calibration : std::filesystem::path(o.calibration);
  if (!calibrationFile.empty()) {
    const auto calibration = loadCalibration(calibrationFile);
    if (!calibration) return fail(calibration.error());
    if (const auto belongs = checkBelongs(*calibration, serials, calibrationFile.string()); !belongs)
      return fail(belongs.error());
    text += "calibration  " + calibration->id + "\n";
    json["calibration"] = calibration->id;
  }
  if (!o.json.empty())
    if (const auto written = writeJson(o.json, json); !written) return fail(written.error());
  if (o.json != "-")
    if (const auto written = writeResult("-", text); !written) return fail(written.error());
  return code;
}

int make(const SiteOptions& o) {
  auto site = siteFrom(o.address);
  if (!site) return fail(site.error());
  const auto answers = identify(site->cameras);
  for (std::size_t c = 0; c < answers.size(); ++c) {
    if (!answers[c]) return fail(answers[c].error());
    site->cameras[c].serial = answers[c]->serial;
  }
  site->file = o.out;
  if (!o.calibration.empty()) {
    const auto calibration = loadCalibration(o.calibration);
    if (!calibration) return fail(calibration.error());
    std::error_code failed;
    site->calibration = std::filesystem::absolute(o.calibration, failed);
  }
  std::error_code failed;
  if (const auto folder = std::filesystem::path(o.out).parent_path(); !folder.empty())
    std::filesystem::create_directories(folder, failed);
  return done(saveSite(*site, o.out));
}

}  // namespace

void addSite(CLI::App& app, int& exitCode) {
  CLI::App* site = app.add_subcommand("site", "The cameras of the line: which they are and whether they are there");
  site->require_subcommand(1);
  const auto o = std::make_shared<SiteOptions>();
  const auto withFile = [&](CLI::App* command) {
    command->add_option("file", o->file, "site file; default: " + defaultSiteFile().string());
    command->add_option("--address", o->address, "the cameras at four consecutive addresses instead");
  };
  CLI::App* showing = site->add_subcommand("show", "Print the site with every setting");
  withFile(showing);
  showing->footer("Example: vignole-cli site show line1.toml");
  showing->callback([o, &exitCode] { exitCode = show(*o); });

  CLI::App* finding = site->add_subcommand("find", "Ask all networks which cameras there are (a broadcast, 1 s)");
  finding->add_option("--json", o->json, "file, or - for stdout");
  finding->footer("Example: vignole-cli site find");
  finding->callback([o, &exitCode] { exitCode = find(*o); });

  CLI::App* checking = site->add_subcommand("check", "Open the four cameras; check serial numbers and calibration");
  withFile(checking);
  checking->add_option("--calibration", o->calibration, "calibration file; default: the site's");
  checking->add_option("--json", o->json, "file, or - for stdout");
  checking->footer(
      "Exit code 3 if a camera does not answer, is another one or refuses its settings.\n"
      "Example: vignole-cli site check line1.toml");
  checking->callback([o, &exitCode] { exitCode = check(*o); });

  CLI::App* making = site->add_subcommand("new", "Write a site file for the cameras at four consecutive addresses");
  making->add_option("--address", o->address, "of range finder 1; the others follow")->required();
  making->add_option("--calibration", o->calibration, "calibration file of these cameras");
  making->add_option("--out", o->out, "site file to write")->required();
  making->footer(
      "The file is TOML (format = 1). Its tables: [trigger] line, count (auto, timestamp, chunk, frame-id),\n"
      "mm_per_encoder_count, encoder_divider; [camera] exposure_ms, gain, x_px, y_px, width_px, height_px,\n"
      "packet_bytes (0: the largest that passes), socket_buffer_bytes, frame_retention_ms, resend, buffers,\n"
      "packet_socket, heartbeat_ms, extra (a list of \"Feature=Value\"); [features] exposure, gain, "
      "timestamp_counter,\n"
      "timestamp_reset, timestamp_latch, timestamp_value, serial, heartbeat, count_chunk, count_chunk_value,\n"
      "line_chunk, line_chunk_value; [rails] told_by (pictures, line), line_bit, begin_after, end_after, contrast_dn,\n"
      "pixels; [watch] silent_triggers, silent_s, lost_triggers, lost_s; four [[range_finder]] with serial, address\n"
      "(without: looked for), exposure_ms, gain.\n"
      "Example: vignole-cli site new --address 192.168.1.11 --calibration rig.toml --out line1.toml");
  making->callback([o, &exitCode] { exitCode = make(*o); });
}

}  // namespace vignole::cli
