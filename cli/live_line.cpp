#include "cli/live_line.h"

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <sys/resource.h>
#include <unistd.h>

#include "engine/recipe/recipe.h"
#include "engine/simulator/virtual_rig.h"

namespace vignole::cli {

namespace {

using Json = nlohmann::ordered_json;
using Serials = std::array<std::string, kCameraCount>;

/// Cameras of the virtual rig say so in their serial numbers: VIRTUAL-SEED-CAMERA.
std::optional<std::uint64_t> rigSeedOf(const Serials& serials) {
  std::optional<std::uint64_t> seed;
  for (std::size_t c = 0; c < serials.size(); ++c) {
    constexpr std::string_view kPrefix = "VIRTUAL-";
    const std::string& serial = serials[c];
    const std::string suffix = "-" + std::to_string(c + 1);
    if (!serial.starts_with(kPrefix) || !serial.ends_with(suffix)) return {};
    const char* begin = serial.data() + kPrefix.size();
    const char* end = serial.data() + serial.size() - suffix.size();
    std::uint64_t value = 0;
    if (begin >= end) return {};
    const auto [stop, failed] = std::from_chars(begin, end, value);
    if (failed != std::errc() || stop != end || (seed && *seed != value)) return {};
    seed = value;
  }
  return seed;
}

Expected<RigCalibration> exactCalibration(std::uint64_t rigSeed) {
  VirtualRigSettings settings;
  const auto recipe = findRecipe("60E1 X/A");  // any rail: only the rig is asked for
  if (!recipe) return tl::unexpected(recipe.error());
  settings.section = recipe->section;
  settings.parameters = recipe->parameters;
  settings.rigSeed = rigSeed;
  const auto rig = VirtualRig::create(std::move(settings));
  if (!rig) return tl::unexpected(rig.error());
  return (*rig)->calibration();
}

/// Names of rails from the time and a number: RAIL-20261125-105930-1.
std::function<std::string(std::uint64_t)> railIds() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> stamp{};
  std::strftime(stamp.data(), stamp.size(), "%Y%m%d-%H%M%S", &utc);
  return [begin = "RAIL-" + std::string(stamp.data()) + "-"](std::uint64_t n) { return begin + std::to_string(n); };
}

Serials serialsOf(const GigeSource& source) {
  Serials serials;
  for (const CameraReport& report : source.cameras())
    serials[static_cast<std::size_t>(report.camera)] = report.identity.serial;
  return serials;
}

Expected<void> chooseCalibration(LiveLine& line, const LiveLineOptions& options, const Site& site) {
  const Serials serials = serialsOf(*line.source);
  const std::filesystem::path file =
      options.calibration.empty() ? site.calibration : std::filesystem::path(options.calibration);
  if (!file.empty()) {
    auto loaded = loadCalibration(file);
    if (!loaded) return tl::unexpected(loaded.error());
    line.calibrationName = file.string();
    if (auto belongs = checkBelongs(*loaded, serials, line.calibrationName); !belongs) return belongs;
    line.calibration = *std::move(loaded);
  } else if (const auto seed = rigSeedOf(serials)) {
    auto exact = exactCalibration(*seed);
    if (!exact) return tl::unexpected(exact.error());
    line.calibration = *std::move(exact);
    line.calibrationName = "virtual rig " + std::to_string(*seed);
  } else {
    return inputError("--calibration", "is needed: the site names none, and the cameras are not of the virtual rig");
  }
  for (std::size_t c = 0; c < site.cameras.size(); ++c) {
    const Intrinsics& in = line.calibration.rangeFinders[c].intrinsics;
    const GigeCameraSettings& camera = site.cameras[c];
    if (in.widthPx != camera.widthPx || in.heightPx != camera.heightPx)
      return inputError(line.calibrationName,
                        "camera " + std::to_string(c + 1) + " shows " + std::to_string(camera.widthPx) + " x " +
                            std::to_string(camera.heightPx) + " pixels but the calibration is for " +
                            std::to_string(in.widthPx) + " x " + std::to_string(in.heightPx));
  }
  return {};
}

}  // namespace

Expected<Site> chosenSite(const LiveLineOptions& options) {
  if (!options.address.empty() && options.site.empty()) return siteFrom(options.address);
  std::filesystem::path file = options.site.empty() ? defaultSiteFile() : std::filesystem::path(options.site);
  std::error_code failed;
  if (options.site.empty() && !std::filesystem::exists(file, failed))
    return inputError("--source gige", "needs to know the cameras; give --address, --site FILE, or write " +
                                           file.string() + " (vignole-cli site new)");
  auto site = loadSite(file);
  if (!site || options.address.empty()) return site;
  // The site's serial numbers and settings at other addresses.
  const auto elsewhere = siteFrom(options.address);
  if (!elsewhere) return tl::unexpected(elsewhere.error());
  for (std::size_t c = 0; c < site->cameras.size(); ++c) site->cameras[c].address = elsewhere->cameras[c].address;
  return site;
}

Expected<LiveLine> openLiveLine(const LiveLineOptions& options) {
  auto site = chosenSite(options);
  if (!site) return tl::unexpected(site.error());
  if (auto found = findAddresses(*site); !found) return tl::unexpected(found.error());
  GigeSourceSettings settings = sourceSettings(*site);
  settings.line.rails = options.rails;
  settings.line.lengthMm = 1000 * options.lengthM;
  settings.line.railId = railIds();
  if (options.spacingMm) settings.line.spacingMm = *options.spacingMm;
  if (options.temperatureC) settings.line.temperatureC = *options.temperatureC;
  LiveLine line;
  line.spacingMm = settings.line.spacingMm;
  auto source = GigeSource::open(std::move(settings));
  if (!source) return tl::unexpected(source.error());
  line.source = std::move(*source);
  if (auto chosen = chooseCalibration(line, options, *site); !chosen) return tl::unexpected(chosen.error());
  return line;
}

ReceptionCost receptionCost() {
  ReceptionCost cost;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  cost.processS = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  // Aravis' threads have names; what each has used stands behind its name in brackets.
  std::error_code failed;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", failed)) {
    std::ifstream file(task.path() / "stat");
    std::string text;
    std::getline(file, text);
    const std::size_t end = text.rfind(')');
    if (end == std::string::npos || text.find("(arv_gv_stream") == std::string::npos) continue;
    std::istringstream rest(text.substr(end + 2));
    std::string skipped;
    constexpr int kBeforeUserTime = 11;
    for (int i = 0; i < kBeforeUserTime; ++i) rest >> skipped;
    double user = 0, system = 0;
    rest >> user >> system;
    cost.receptionS += (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
  }
  return cost;
}

Json toJson(const ReceptionCost& cost, const std::vector<CameraReport>& reports) {
  std::uint64_t frames = 0;
  for (const CameraReport& r : reports) frames += r.counters.framesOk;
  const auto perFrame = [&](double s) {
    return frames > 0 ? Json(1000 * s / static_cast<double>(frames)) : Json(nullptr);
  };
  return {{"process_s", cost.processS},
          {"reception_s", cost.receptionS},
          {"ms_per_frame", perFrame(cost.processS)},
          {"reception_ms_per_frame", perFrame(cost.receptionS)}};
}

Json toJson(const CameraReport& r) {
  const CameraCounters& n = r.counters;
  Json failed = Json::object();
  for (const auto& [word, frames] : n.failed) failed[word] = frames;
  const auto wordsOrNull = [](const std::string& words) { return words.empty() ? Json(nullptr) : Json(words); };
  return {{"camera", r.camera + 1},
          {"address", r.identity.address},
          {"serial", r.identity.serial},
          {"vendor", r.identity.vendor},
          {"model", r.identity.model},
          {"state", name(r.state)},
          {"why", wordsOrNull(r.why)},
          {"trigger_count", name(r.countSource)},
          {"cannot_tell", wordsOrNull(r.cannotTell)},
          {"packet_bytes", r.packetBytes},
          {"frames_ok", n.framesOk},
          {"frames_failed", failed},
          {"frames_lost", n.framesLost},
          {"triggers_missed", n.missedTriggers},
          {"frames_repeated", n.repeated},
          {"frames_implausible", n.implausible},
          {"frames_unaligned", n.unaligned},
          {"overflow", n.overflow},
          {"count_restarts", n.restarts},
          {"resend_requests", n.resendRequests},
          {"packets_resent", n.resentPackets},
          {"packets_missing", n.missingPackets},
          {"packets_underrun", n.underrunPackets},
          {"reconnections", n.reconnections},
          {"failed_openings", n.failedOpenings}};
}

Json toJson(const TriggerLineCounts& n) {
  return {{"in_rails", n.inRails},
          {"outside_rails", n.outsideRails},
          {"seen_by_none", n.seenByNone},
          {"rails", n.rails},
          {"late_frames", n.lateFrames},
          {"repeated_frames", n.repeatedFrames},
          {"frames_of_lost_counts", n.framesOfLostCounts}};
}

std::string toTable(const std::vector<CameraReport>& reports) {
  std::string text;
  for (const CameraReport& r : reports) {
    std::uint64_t damaged = 0;
    for (const auto& [word, frames] : r.counters.failed) damaged += frames;
    std::array<char, 256> line{};
    std::snprintf(
        line.data(), line.size(),
        "camera %d  %-12s %-10s counts by %-9s  ok %llu  damaged %llu  lost %llu  missed %llu  overflow %llu  "
        "resent %llu  reconnected %llu\n",
        r.camera + 1, r.identity.serial.c_str(), name(r.state), name(r.countSource),
        static_cast<unsigned long long>(r.counters.framesOk), static_cast<unsigned long long>(damaged),
        static_cast<unsigned long long>(r.counters.framesLost),
        static_cast<unsigned long long>(r.counters.missedTriggers),
        static_cast<unsigned long long>(r.counters.overflow), static_cast<unsigned long long>(r.counters.resentPackets),
        static_cast<unsigned long long>(r.counters.reconnections));
    text += line.data();
    if (!r.why.empty()) text += "          " + r.why + "\n";
  }
  if (!reports.empty() && !reports.front().cannotTell.empty())
    text += "Not detected: " + reports.front().cannotTell + "\n";
  return text;
}

}  // namespace vignole::cli
