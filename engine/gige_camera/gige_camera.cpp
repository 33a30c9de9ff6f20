#include "engine/gige_camera/gige_camera.h"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cstdlib>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

#include "engine/gige_camera/camera_features.h"
#include "engine/gige_camera/control_probe.h"

namespace vignole::gige {

namespace {

constexpr std::uint16_t kControlPort = 3956;

/// The own address from which that address is reached; empty if it is not.
std::string ownAddressTowards(const std::string& address) {
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(kControlPort);
  if (inet_pton(AF_INET, address.c_str(), &to.sin_addr) != 1) return {};
  const int probe = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (probe < 0) return {};
  std::string own;
  sockaddr_in from{};
  socklen_t size = sizeof from;
  if (connect(probe, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0 &&
      getsockname(probe, reinterpret_cast<sockaddr*>(&from), &size) == 0) {
    std::array<char, INET_ADDRSTRLEN> text{};
    if (inet_ntop(AF_INET, &from.sin_addr, text.data(), text.size()) != nullptr) own = text.data();
  }
  ::close(probe);
  // From 127.0.0.11 to itself the kernel would take that very address; the device listens on it.
  if (own.starts_with("127.")) own = "127.0.0.1";
  return own;
}

/// What Aravis has to say comes in our errors. It names no domain, and says every time that a stream is let go of whose
/// thread was ended before.
void silenceAravis() {
  static const guint once = g_log_set_handler(
      nullptr, static_cast<GLogLevelFlags>(G_LOG_LEVEL_MASK),
      [](const gchar*, GLogLevelFlags, const gchar*, gpointer) {}, nullptr);
  static const gboolean quiet = arv_debug_enable("all:0");
  (void)once;
  (void)quiet;
}

/// Aravis reads descriptions of devices with tables that are shared and not protected.
std::mutex& descriptionMutex() {
  static std::mutex one;
  return one;
}

}  // namespace

GigeCamera::GigeCamera(int index, GigeCameraSettings settings, std::shared_ptr<CameraInbox> inbox)
    : index_(index),
      settings_(std::move(settings)),
      where_("camera " + std::to_string(index + 1) + " (" + settings_.address + ")"),
      inbox_(std::move(inbox)) {}

GigeCamera::~GigeCamera() { close(!controlLost()); }

void GigeCamera::controlWasLost(ArvGvDevice* /*device*/, void* self) {
  static_cast<GigeCamera*>(self)->controlLost_.store(true);
}

Expected<void> GigeCamera::open() {
  silenceAravis();
  const std::scoped_lock lock(deviceMutex_);
  denied_.store(false);
  auto opened = openDevice();
  if (opened) opened = writeSettings();
  if (!opened) closeLocked(!controlLost());
  return opened;
}

bool GigeCamera::answers() const {
  constexpr auto kPatience = std::chrono::milliseconds(300);
  return gige::answers(settings_.address, kPatience) || gige::answers(settings_.address, kPatience);
}

Expected<void> GigeCamera::openDevice() {
  const std::string own = ownAddressTowards(settings_.address);
  if (own.empty())
    return worldError(where_, "cannot be reached from this computer; look at the address and the network adapter");
  if (!answers()) return worldError(where_, "does not answer; look at its power, its cable and the address");
  const Owned<GInetAddress> from(g_inet_address_new_from_string(own.c_str()));
  const Owned<GInetAddress> to(g_inet_address_new_from_string(settings_.address.c_str()));
  Failure failure;
  controlLost_.store(false);
  {
    const std::scoped_lock alone(descriptionMutex());
    device_.reset(arv_gv_device_new(from.get(), to.get(), failure));
  }
  if (failure.any() || !device_) {
    device_.reset();
    return worldError(where_, "answers, but is no usable GigE Vision device (" + failure.message() + ")");
  }
  lostSignal_ = g_signal_connect(device_.get(), "control-lost", G_CALLBACK(&GigeCamera::controlWasLost), this);
  if (!arv_gv_device_is_controller(ARV_GV_DEVICE(device_.get()))) {
    denied_.store(true);
    return worldError(where_, "is controlled by another program; close that one");
  }
  camera_.reset(arv_camera_new_with_device(device_.get(), failure));
  if (failure.any() || !camera_) return worldError(where_, "cannot be used (" + failure.message() + ")");

  GigeIdentity found;
  found.address = settings_.address;
  found.serial = readText(device_.get(), settings_.features.serial);
  found.vendor = readText(device_.get(), {"DeviceVendorName"});
  found.model = readText(device_.get(), {"DeviceModelName"});
  found.userName = readText(device_.get(), {"DeviceUserID", "DeviceUserDefinedName"});
  found.manufacturerInfo = readText(device_.get(), {"DeviceManufacturerInfo"});
  {
    const std::scoped_lock lock(reportMutex_);
    identity_ = found;
  }
  if (!settings_.serial.empty() && found.serial != settings_.serial)
    return worldError(where_, "is " + found.serial + ", not " + settings_.serial +
                                  "; are the cables swapped? Swap them back or assign the cameras anew");
  return {};
}

Expected<void> GigeCamera::writeSettings() {
  ArvDevice* device = device_.get();
  Failure failure;
  // A client that died may have left it running.
  arv_camera_stop_acquisition(camera_.get(), failure);
  const auto region = [&] {
    arv_camera_set_region(camera_.get(), settings_.xPx, settings_.yPx, settings_.widthPx, settings_.heightPx, failure);
  };
  region();
  if (failure.any()) return worldError(where_, "refuses its region (" + failure.message() + ")");
  gint x = 0, y = 0, width = 0, height = 0;
  arv_camera_get_region(camera_.get(), &x, &y, &width, &height, failure);
  if (failure.any() || x != settings_.xPx || y != settings_.yPx || width != settings_.widthPx ||
      height != settings_.heightPx)
    return worldError(where_, "cannot show " + std::to_string(settings_.widthPx) + " x " +
                                  std::to_string(settings_.heightPx) + " pixels from " + std::to_string(settings_.xPx) +
                                  ", " + std::to_string(settings_.yPx) + " (it shows " + std::to_string(width) + " x " +
                                  std::to_string(height) + ")");
  arv_camera_set_pixel_format(camera_.get(), ARV_PIXEL_FORMAT_MONO_8, failure);
  if (failure.any()) return worldError(where_, "refuses Mono8 (" + failure.message() + ")");
  arv_camera_set_acquisition_mode(camera_.get(), ARV_ACQUISITION_MODE_CONTINUOUS, failure);

  const FeatureNames& names = settings_.features;
  const auto writeIf = [&](const FeatureNames::Names& candidates, const std::optional<double>& value,
                           const char* what) -> Expected<void> {
    if (!value) return {};
    const auto feature = firstPresent(device, candidates);
    if (!feature)
      return worldError(where_, std::string("has no feature for its ") + what +
                                    " by the names known; name it in the site file, or leave the value out");
    return writeNumber(device, *feature, *value, where_);
  };
  std::optional<double> exposureUs;
  if (settings_.exposureMs) exposureUs = 1000 * *settings_.exposureMs;
  if (auto written = writeIf(names.exposure, exposureUs, "exposure"); !written) return written;
  if (auto written = writeIf(names.gain, settings_.gain, "gain"); !written) return written;
  if (const auto heartbeat = firstPresent(device, names.heartbeat))
    if (auto written = writeNumber(device, *heartbeat, settings_.heartbeatMs, where_); !written) return written;
  if (auto chosen = chooseCount(); !chosen) return chosen;
  for (const std::string& assignment : settings_.extra) {
    const std::size_t equals = assignment.find('=');
    if (auto written = write(device, assignment.substr(0, equals),
                             equals == std::string::npos ? std::string() : assignment.substr(equals + 1), where_);
        !written)
      return written;
  }
  if (settings_.triggerLine.empty()) {
    arv_camera_clear_triggers(camera_.get(), failure);
  } else {
    arv_camera_set_trigger(camera_.get(), settings_.triggerLine.c_str(), failure);
    if (failure.any())
      return worldError(where_, "cannot be triggered by " + settings_.triggerLine + " (" + failure.message() + ")");
  }
  return choosePackets();
}

Expected<void> GigeCamera::chooseCount() {
  ArvDevice* device = device_.get();
  const FeatureNames& names = settings_.features;
  const auto counter = firstPresent(device, names.timestampCounter);
  const bool canTimestamp =
      !settings_.triggerLine.empty() && counter && hasEntry(device, *counter, settings_.triggerLine);
  const bool canChunk = !names.countChunk.empty() && hasEntry(device, "ChunkSelector", names.countChunk) &&
                        arv_device_get_feature(device, names.countChunkValue.c_str()) != nullptr;
  CountSource count = settings_.count;
  if (count == CountSource::Auto)
    count = canTimestamp ? CountSource::Timestamp : canChunk ? CountSource::Chunk : CountSource::FrameId;
  if (count == CountSource::Timestamp && !canTimestamp)
    return worldError(where_, "cannot count " + settings_.triggerLine +
                                  " in its timestamp; let the trigger be counted another way (count = \"auto\")");
  if (count == CountSource::Chunk && !canChunk)
    return worldError(
        where_, "has no chunk " + names.countChunk + "; let the trigger be counted another way (count = \"auto\")");
  Failure failure;
  if (count == CountSource::Timestamp) {
    if (auto written = write(device, *counter, settings_.triggerLine, where_); !written) return written;
    streamSettings_.tickHz = arv_gv_device_get_timestamp_tick_frequency(ARV_GV_DEVICE(device), failure);
    if (failure.any() || streamSettings_.tickHz == 0)
      return worldError(where_, "does not tell the frequency of its timestamp");
  } else if (counter && hasEntry(device, *counter, "InternalClock")) {
    if (auto written = write(device, *counter, "InternalClock", where_); !written) return written;
  }
  streamSettings_.railLineFromChunk = settings_.railLine.has_value();
  std::string chunks = count == CountSource::Chunk ? names.countChunk : std::string();
  if (settings_.railLine) {
    if (!hasEntry(device, "ChunkSelector", names.lineChunk))
      return worldError(where_, "has no chunk " + names.lineChunk + "; tell head and tail from the pictures instead");
    chunks += (chunks.empty() ? "" : ",") + names.lineChunk;
  }
  if (!chunks.empty()) {
    arv_camera_set_chunks(camera_.get(), chunks.c_str(), failure);
    if (failure.any()) return worldError(where_, "refuses the chunks " + chunks + " (" + failure.message() + ")");
  } else if (arv_device_get_feature(device, "ChunkModeActive") != nullptr) {
    arv_camera_set_chunk_mode(camera_.get(), FALSE, failure);
  }
  latch_ = firstPresent(device, names.timestampLatch).value_or("");
  latchValue_ = firstPresent(device, names.timestampValue).value_or("");
  streamSettings_.count = count;
  const std::scoped_lock lock(reportMutex_);
  count_ = count;
  return {};
}

Expected<void> GigeCamera::choosePackets() {
  Failure failure;
  ArvGvDevice* device = ARV_GV_DEVICE(device_.get());
  arv_gv_device_set_stream_options(
      device, settings_.packetSocket ? ARV_GV_STREAM_OPTION_NONE : ARV_GV_STREAM_OPTION_PACKET_SOCKET_DISABLED);
  if (settings_.packetBytes > 0) {
    arv_gv_device_set_packet_size(device, settings_.packetBytes, failure);
    if (failure.any())
      return worldError(where_, "refuses packets of " + std::to_string(settings_.packetBytes) + " bytes");
    arv_gv_device_set_packet_size_adjustment(device, ARV_GV_PACKET_SIZE_ADJUSTMENT_ON_FAILURE);
  } else {
    arv_gv_device_set_packet_size_adjustment(device, ARV_GV_PACKET_SIZE_ADJUSTMENT_ALWAYS);
  }
  return {};
}

Expected<void> GigeCamera::prepareStream(std::uint64_t epoch) {
  const std::scoped_lock lock(deviceMutex_);
  if (!camera_) return worldError(where_, "is not open");
  streamSettings_.epoch = epoch;
  streamSettings_.where = where_;
  const std::scoped_lock alone(descriptionMutex());
  auto stream = CameraStream::open(camera_.get(), settings_, streamSettings_, inbox_);
  if (!stream) return tl::unexpected(stream.error());
  Failure failure;
  const guint packet = arv_gv_device_get_packet_size(ARV_GV_DEVICE(device_.get()), failure);
  const std::scoped_lock reportLock(reportMutex_);
  packetBytes_ = static_cast<int>(packet);
  stream_ = std::move(*stream);
  retentionMs_ = 0;
  return {};
}

Expected<void> GigeCamera::startAcquisition() {
  const std::scoped_lock lock(deviceMutex_);
  if (!camera_) return worldError(where_, "is not open");
  Failure failure;
  arv_camera_start_acquisition(camera_.get(), failure);
  if (failure.any()) return worldError(where_, "does not start (" + failure.message() + ")");
  return {};
}

void GigeCamera::close(bool answers) {
  const std::scoped_lock lock(deviceMutex_);
  closeLocked(answers);
}

void GigeCamera::closeLocked(bool answers) {
  Failure failure;
  if (camera_ && answers && !denied_.load()) arv_camera_stop_acquisition(camera_.get(), failure);
  std::shared_ptr<CameraStream> going;
  {
    const std::scoped_lock lock(reportMutex_);
    going = stream_;
  }
  if (going) {
    going->close();
    const std::scoped_lock lock(reportMutex_);
    going->addTo(earlier_);
    stream_.reset();
  }
  if (device_) {
    g_signal_handler_disconnect(device_.get(), lostSignal_);
    // Frames that are out keep the stream, and that the device: it would go on to hold the camera.
    if (!denied_.load()) arv_gv_device_leave_control(ARV_GV_DEVICE(device_.get()), failure);
  }
  camera_.reset();
  device_.reset();
}

void GigeCamera::adaptRetention(double triggersPerS) {
  constexpr double kPeriods = 2.3;
  constexpr int kLongestMs = 250;
  if (!(triggersPerS > 0)) return;
  const int wanted = std::clamp(static_cast<int>(1000 * kPeriods / triggersPerS), settings_.frameRetentionMs,
                                std::max(kLongestMs, settings_.frameRetentionMs));
  const std::scoped_lock lock(reportMutex_);
  if (!stream_ || std::abs(wanted - retentionMs_) * 10 < retentionMs_) return;
  retentionMs_ = wanted;
  stream_->setRetention(wanted);
}

Expected<void> GigeCamera::resetCount() {
  const std::scoped_lock lock(deviceMutex_);
  if (!device_) return worldError(where_, "is not open");
  if (streamSettings_.count != CountSource::Timestamp) return {};
  const auto reset = firstPresent(device_.get(), settings_.features.timestampReset);
  if (!reset) return worldError(where_, "has no command that resets its count; name it in the site file");
  return execute(device_.get(), *reset, where_);
}

Expected<std::int64_t> GigeCamera::count() {
  const std::scoped_lock lock(deviceMutex_);
  if (!device_) return worldError(where_, "is not open");
  if (streamSettings_.count != CountSource::Timestamp || latch_.empty() || latchValue_.empty())
    return worldError(where_, "does not tell its count");
  if (auto latched = execute(device_.get(), latch_, where_); !latched) return tl::unexpected(latched.error());
  return readInteger(device_.get(), latchValue_, where_);
}

bool GigeCamera::countIsCommon() const {
  const std::scoped_lock lock(reportMutex_);
  return count_ == CountSource::Chunk;
}

void GigeCamera::report(CameraReport& report) const {
  const std::scoped_lock lock(reportMutex_);
  report.camera = index_;
  report.identity = identity_;
  if (report.identity.address.empty()) report.identity.address = settings_.address;
  if (report.identity.serial.empty()) report.identity.serial = settings_.serial;
  report.countSource = count_;
  report.packetBytes = packetBytes_;
  report.counters = earlier_;
  if (!stream_) return;
  stream_->addTo(report.counters);
  if (const double last = stream_->lastFrameS(); last >= 0) report.lastFrameAgeS = nowS() - last;
}

}  // namespace vignole::gige
