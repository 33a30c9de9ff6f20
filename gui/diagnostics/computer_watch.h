#pragma once
// Disk, archive file, memory and temperature of the computer, looked at once a second by a thread of its own: a disk
// that does not answer must not stop the window.

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "gui/bridge/latest_value.h"

namespace vignole {

struct ComputerState {
  std::string disk;  ///< where it is mounted; empty: the system does not tell
  std::uint64_t diskBytes = 0, diskFreeBytes = 0;
  std::uint64_t archiveBytes = 0, walBytes = 0;
  double memoryMb = 0;                 ///< of the computer; 0: not told
  std::optional<double> temperatureC;  ///< the hottest the system tells of
  std::string sensor;                  ///< which
};

/// Where Linux tells of its sensors; a test puts a folder of its own in.
struct SensorFolders {
  std::filesystem::path thermal = "/sys/class/thermal", hwmon = "/sys/class/hwmon";
};

/// `archiveFile`: empty if there is none.
[[nodiscard]] ComputerState lookAtComputer(const std::filesystem::path& folder,
                                           const std::filesystem::path& archiveFile, const SensorFolders& sensors = {});

class ComputerWatch {
 public:
  ComputerWatch(std::filesystem::path folder, std::filesystem::path archiveFile);
  ~ComputerWatch();
  ComputerWatch(const ComputerWatch&) = delete;
  ComputerWatch& operator=(const ComputerWatch&) = delete;
  void setLooking(bool looking);
  [[nodiscard]] std::shared_ptr<const ComputerState> takeNew() { return latest_.takeNew(); }

 private:
  void run(const std::stop_token& stop);

  std::filesystem::path folder_, archiveFile_;
  LatestValue<ComputerState> latest_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  bool looking_ = false;
  std::jthread thread_;
};

}  // namespace vignole
