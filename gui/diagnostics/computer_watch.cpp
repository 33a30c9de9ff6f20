#include "gui/diagnostics/computer_watch.h"

#include <QStorageInfo>
#include <chrono>
#include <fstream>
#include <system_error>

namespace vignole {

namespace fs = std::filesystem;

namespace {

using namespace std::chrono_literals;
constexpr auto kEvery = 1000ms;
// What sensors say outside of it is not a temperature.
constexpr double kColdestC = -40, kHottestC = 130;

std::string firstLine(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

void noteTemperature(ComputerState& state, const fs::path& file, const std::string& sensor) {
  std::ifstream in(file);
  double milliC = 0;
  if (!(in >> milliC)) return;
  const double c = milliC / 1000;
  if (c < kColdestC || c > kHottestC || (state.temperatureC && *state.temperatureC >= c)) return;
  state.temperatureC = c;
  state.sensor = sensor;
}

void lookAtSensors(ComputerState& state, const SensorFolders& sensors) {
  std::error_code failed;
  for (const auto& zone : fs::directory_iterator(sensors.thermal, failed))
    if (zone.path().filename().string().starts_with("thermal_zone"))
      noteTemperature(state, zone.path() / "temp", firstLine(zone.path() / "type"));
  for (const auto& chip : fs::directory_iterator(sensors.hwmon, failed)) {
    const std::string name = firstLine(chip.path() / "name");
    std::error_code gone;
    for (const auto& file : fs::directory_iterator(chip.path(), gone)) {
      const std::string what = file.path().filename().string();
      if (what.starts_with("temp") && what.ends_with("_input")) noteTemperature(state, file.path(), name);
    }
  }
}

std::uint64_t sizeOf(const fs::path& file) {
  std::error_code failed;
  const auto size = fs::file_size(file, failed);
  return failed ? 0 : static_cast<std::uint64_t>(size);
}

}  // namespace

ComputerState lookAtComputer(const fs::path& folder, const fs::path& archiveFile, const SensorFolders& sensors) {
  ComputerState state;
  if (const QStorageInfo disk(QString::fromStdString(folder.string())); disk.isValid() && disk.isReady()) {
    state.disk = disk.rootPath().toStdString();
    state.diskBytes = static_cast<std::uint64_t>(disk.bytesTotal());
    state.diskFreeBytes = static_cast<std::uint64_t>(disk.bytesAvailable());
  }
  if (!archiveFile.empty()) {
    state.archiveBytes = sizeOf(archiveFile);
    state.walBytes = sizeOf(archiveFile.string() + "-wal");
  }
  std::ifstream memory("/proc/meminfo");
  std::string word;
  double kb = 0;
  if (memory >> word >> kb && word == "MemTotal:") state.memoryMb = kb / 1024;
  lookAtSensors(state, sensors);
  return state;
}

ComputerWatch::ComputerWatch(fs::path folder, fs::path archiveFile)
    : folder_(std::move(folder)),
      archiveFile_(std::move(archiveFile)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

ComputerWatch::~ComputerWatch() {
  thread_.request_stop();
  thread_.join();
}

void ComputerWatch::setLooking(bool looking) {
  {
    const std::lock_guard lock(mutex_);
    looking_ = looking;
  }
  wake_.notify_one();
}

void ComputerWatch::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, stop, [this] { return looking_; })) return;
    }
    latest_.publish(lookAtComputer(folder_, archiveFile_));
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, stop, kEvery, [] { return false; });
  }
}

}  // namespace vignole
