#include <arpa/inet.h>
#include <array>
#include <charconv>
#include <set>
#include <sstream>

#include "engine/files/toml_reader.h"
#include "engine/site/site.h"

namespace vignole {

namespace {

constexpr double kLongestExposureMs = 1000, kHighestGain = 1000;
constexpr int kLargestSensorPx = 16384, kLargestPacket = 16000, kSmallestPacket = 576;

/// Every name of a feature that a site may change.
struct NamedFeature {
  const char* key;
  FeatureNames::Names FeatureNames::*names;
};
constexpr NamedFeature kLists[] = {{"exposure", &FeatureNames::exposure},
                                   {"gain", &FeatureNames::gain},
                                   {"timestamp_counter", &FeatureNames::timestampCounter},
                                   {"timestamp_reset", &FeatureNames::timestampReset},
                                   {"timestamp_latch", &FeatureNames::timestampLatch},
                                   {"timestamp_value", &FeatureNames::timestampValue},
                                   {"serial", &FeatureNames::serial},
                                   {"heartbeat", &FeatureNames::heartbeat}};
struct NamedText {
  const char* key;
  std::string FeatureNames::*text;
};
constexpr NamedText kTexts[] = {{"count_chunk", &FeatureNames::countChunk},
                                {"count_chunk_value", &FeatureNames::countChunkValue},
                                {"line_chunk", &FeatureNames::lineChunk},
                                {"line_chunk_value", &FeatureNames::lineChunkValue}};

std::optional<double> optionalNumber(TomlReader& toml, const std::string& key, double min, double max) {
  if (!toml.has(key)) return {};
  return toml.number(key, min, max);
}

void readFeatures(TomlReader& toml, FeatureNames& features) {
  for (const NamedFeature& f : kLists) {
    const std::string key = std::string("features.") + f.key;
    if (toml.has(key)) features.*f.names = {toml.text(key)};
  }
  for (const NamedText& f : kTexts) features.*f.text = toml.text(std::string("features.") + f.key, features.*f.text);
}

GigeCameraSettings readCommon(TomlReader& toml) {
  GigeCameraSettings c;
  c.triggerLine = toml.text("trigger.line", c.triggerLine);
  const std::string count = toml.text("trigger.count", name(c.count));
  bool known = false;
  for (const CountSource source : {CountSource::Auto, CountSource::Timestamp, CountSource::Chunk, CountSource::FrameId})
    if (count == name(source)) {
      c.count = source;
      known = true;
    }
  if (!known) toml.refuse("trigger.count", "is \"" + count + "\"; give auto, timestamp, chunk or frame-id");
  c.exposureMs = optionalNumber(toml, "camera.exposure_ms", 0.001, kLongestExposureMs);
  c.gain = optionalNumber(toml, "camera.gain", 0, kHighestGain);
  c.xPx = toml.integer("camera.x_px", 0, kLargestSensorPx, c.xPx);
  c.yPx = toml.integer("camera.y_px", 0, kLargestSensorPx, c.yPx);
  c.widthPx = toml.integer("camera.width_px", 32, kLargestSensorPx, c.widthPx);
  c.heightPx = toml.integer("camera.height_px", 32, kLargestSensorPx, c.heightPx);
  c.packetBytes = toml.integer("camera.packet_bytes", 0, kLargestPacket, c.packetBytes);
  if (c.packetBytes != 0 && c.packetBytes < kSmallestPacket)
    toml.refuse("camera.packet_bytes",
                "is less than 576, the least of GigE Vision; give 0 for the largest that passes");
  c.socketBufferBytes = toml.integer("camera.socket_buffer_bytes", 65536, 1 << 30, c.socketBufferBytes);
  c.frameRetentionMs = toml.integer("camera.frame_retention_ms", 1, 10000, c.frameRetentionMs);
  c.resend = toml.boolean("camera.resend", c.resend);
  c.buffers = toml.integer("camera.buffers", 8, 4096, c.buffers);
  c.packetSocket = toml.boolean("camera.packet_socket", c.packetSocket);
  c.heartbeatMs = toml.integer("camera.heartbeat_ms", 500, 65000, c.heartbeatMs);
  if (toml.has("camera.extra")) {
    c.extra = toml.texts("camera.extra");
    for (const std::string& assignment : c.extra)
      if (assignment.find('=') == std::string::npos || assignment.front() == '=')
        toml.refuse("camera.extra", "has \"" + assignment + "\"; give texts like \"Feature=Value\"");
  }
  readFeatures(toml, c.features);
  return c;
}

void readRails(TomlReader& toml, Site& site, GigeCameraSettings& common) {
  const std::string by = toml.text("rails.told_by", std::string("pictures"));
  if (by == "line") {
    common.railLine = toml.integer("rails.line_bit", 0, 31, 1);
  } else if (by != "pictures") {
    toml.refuse("rails.told_by", "is \"" + by + "\"; give pictures or line");
  }
  site.line.beginAfter = toml.integer("rails.begin_after", 1, 1000, site.line.beginAfter);
  site.line.endAfter = toml.integer("rails.end_after", 1, 1000, site.line.endAfter);
  site.presence.contrastDn = toml.integer("rails.contrast_dn", 1, 254, site.presence.contrastDn);
  site.presence.pixels = toml.integer("rails.pixels", 1, 1'000'000, site.presence.pixels);
}

void readRangeFinders(TomlReader& toml, Site& site, const GigeCameraSettings& common) {
  const std::size_t count = toml.size("range_finder");
  if (count != site.cameras.size()) {
    toml.refuse("range_finder",
                "is there " + std::to_string(count) + " times; give it four times, range finder 1 first");
    return;
  }
  std::set<std::string> serials, addresses;
  for (std::size_t c = 0; c < count; ++c) {
    const std::string at = "range_finder." + std::to_string(c) + ".";
    GigeCameraSettings& camera = site.cameras[c] = common;
    camera.serial = toml.text(at + "serial");
    camera.address = toml.text(at + "address", std::string());
    if (auto own = optionalNumber(toml, at + "exposure_ms", 0.001, kLongestExposureMs)) camera.exposureMs = own;
    if (auto own = optionalNumber(toml, at + "gain", 0, kHighestGain)) camera.gain = own;
    if (camera.serial.empty()) toml.refuse(at + "serial", "is empty; give the camera's serial number");
    if (!serials.insert(camera.serial).second)
      toml.refuse(at + "serial",
                  "\"" + camera.serial + "\" is given twice; every range finder has a camera of its own");
    in_addr parsed{};
    if (!camera.address.empty() && inet_pton(AF_INET, camera.address.c_str(), &parsed) != 1)
      toml.refuse(at + "address", "\"" + camera.address + "\" is no IPv4 address; give one like 192.168.1.11");
    if (!camera.address.empty() && !addresses.insert(camera.address).second)
      toml.refuse(at + "address", camera.address + " is given twice");
  }
}

/// The shortest that reads back as the same.
std::string printed(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) out += c;
  }
  return out + "\"";
}

}  // namespace

Expected<Site> parseSite(std::string_view text, const std::filesystem::path& nameInErrors) {
  auto reader = TomlReader::parse(text, nameInErrors.string());
  if (!reader) return tl::unexpected(reader.error());
  TomlReader& toml = *reader;
  Site site;
  site.file = nameInErrors;
  site.name = toml.text("name", site.name);
  if (const std::string calibration = toml.text("calibration", std::string()); !calibration.empty())
    site.calibration = nameInErrors.parent_path() / calibration;
  site.mmPerEncoderCount = toml.number("trigger.mm_per_encoder_count", 1e-6, 1000, site.mmPerEncoderCount);
  site.encoderDivider = toml.integer("trigger.encoder_divider", 1, 1'000'000'000, site.encoderDivider);
  GigeCameraSettings common = readCommon(toml);
  readRails(toml, site, common);
  site.watch.silentTriggers = static_cast<std::uint64_t>(
      toml.integer("watch.silent_triggers", 1, 10000, static_cast<int>(site.watch.silentTriggers)));
  site.watch.silentS = toml.number("watch.silent_s", 0, 3600, site.watch.silentS);
  site.watch.lostTriggers = static_cast<std::uint64_t>(
      toml.integer("watch.lost_triggers", 1, 10000, static_cast<int>(site.watch.lostTriggers)));
  site.watch.lostS = toml.number("watch.lost_s", 0, 3600, site.watch.lostS);
  readRangeFinders(toml, site, common);
  if (auto finished = toml.finish(); !finished) return tl::unexpected(finished.error());
  return site;
}

std::string toToml(const Site& site) {
  const GigeCameraSettings& c = site.cameras[0];
  const GigeCameraSettings plain;
  std::ostringstream s;
  s << "format = 1\nname = " << quoted(site.name) << "\n";
  if (!site.calibration.empty()) {
    const auto folder = site.file.parent_path();
    std::filesystem::path calibration = site.calibration;
    if (!folder.empty() && calibration.parent_path() == folder) calibration = calibration.filename();
    s << "calibration = " << quoted(calibration.string()) << "\n";
  }
  s << "\n[trigger]\nline = " << quoted(c.triggerLine) << "\ncount = " << quoted(name(c.count))
    << "\nmm_per_encoder_count = " << printed(site.mmPerEncoderCount) << "\nencoder_divider = " << site.encoderDivider
    << "\n";
  s << "\n[camera]\n";
  if (c.exposureMs) s << "exposure_ms = " << printed(*c.exposureMs) << "\n";
  if (c.gain) s << "gain = " << printed(*c.gain) << "\n";
  s << "x_px = " << c.xPx << "\ny_px = " << c.yPx << "\nwidth_px = " << c.widthPx << "\nheight_px = " << c.heightPx
    << "\npacket_bytes = " << c.packetBytes << "\nsocket_buffer_bytes = " << c.socketBufferBytes
    << "\nframe_retention_ms = " << c.frameRetentionMs << "\nresend = " << (c.resend ? "true" : "false")
    << "\nbuffers = " << c.buffers << "\npacket_socket = " << (c.packetSocket ? "true" : "false")
    << "\nheartbeat_ms = " << c.heartbeatMs << "\n";
  if (!c.extra.empty()) {
    s << "extra = [";
    for (std::size_t i = 0; i < c.extra.size(); ++i) s << (i == 0 ? "" : ", ") << quoted(c.extra[i]);
    s << "]\n";
  }
  std::string features;
  for (const NamedFeature& f : kLists)
    if (c.features.*f.names != plain.features.*f.names)
      features +=
          std::string(f.key) + " = " + quoted((c.features.*f.names).empty() ? "" : (c.features.*f.names)[0]) + "\n";
  for (const NamedText& f : kTexts)
    if (c.features.*f.text != plain.features.*f.text)
      features += std::string(f.key) + " = " + quoted(c.features.*f.text) + "\n";
  if (!features.empty()) s << "\n[features]\n" << features;
  s << "\n[rails]\ntold_by = " << (c.railLine ? "\"line\"" : "\"pictures\"") << "\n";
  if (c.railLine) s << "line_bit = " << *c.railLine << "\n";
  s << "begin_after = " << site.line.beginAfter << "\nend_after = " << site.line.endAfter
    << "\ncontrast_dn = " << site.presence.contrastDn << "\npixels = " << site.presence.pixels << "\n";
  s << "\n[watch]\nsilent_triggers = " << site.watch.silentTriggers << "\nsilent_s = " << site.watch.silentS
    << "\nlost_triggers = " << site.watch.lostTriggers << "\nlost_s = " << printed(site.watch.lostS) << "\n";
  for (const GigeCameraSettings& camera : site.cameras) {
    s << "\n[[range_finder]]\nserial = " << quoted(camera.serial) << "\n";
    if (!camera.address.empty()) s << "address = " << quoted(camera.address) << "\n";
    if (camera.exposureMs && camera.exposureMs != c.exposureMs)
      s << "exposure_ms = " << printed(*camera.exposureMs) << "\n";
    if (camera.gain && camera.gain != c.gain) s << "gain = " << printed(*camera.gain) << "\n";
  }
  return s.str();
}

}  // namespace vignole
