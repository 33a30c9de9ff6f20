#pragma once
// What is known of the next rail beside its frames, entered by a person or handed in by the line: id, heat, strand,
// order, temperature.

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "engine/acquisition/frame.h"

namespace vignole {

/// What is empty stays as the source says.
struct RailAnnouncement {
  std::string id, heat, strand, order;
  std::optional<double> temperatureC;
};

/// Thread-safe. One announcement waits for the next rail that begins; a later one replaces it.
class RailAnnouncements {
 public:
  void announce(RailAnnouncement next);
  void withdraw();
  [[nodiscard]] std::optional<RailAnnouncement> waiting() const;
  /// What the rail that begins at this trigger was announced as; the first to ask takes what waits.
  [[nodiscard]] RailAnnouncement taken(std::uint64_t firstTrigger);
  void restart();  ///< before another source, whose triggers count from 0 again; what waits stays

 private:
  mutable std::mutex mutex_;
  std::optional<RailAnnouncement> waiting_;
  std::map<std::uint64_t, RailAnnouncement> taken_;  ///< of the latest rails
};

/// `source` with its rails named as announced, the same in all four streams. The announcements outlive it.
[[nodiscard]] std::unique_ptr<FrameSource> announced(std::unique_ptr<FrameSource> source, RailAnnouncements& rails);

}  // namespace vignole
