#pragma once
// The virtual rig's frames, rendered a few triggers before they are needed, for whoever shows them by trigger.

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "engine/acquisition/frame_provider.h"
#include "engine/simulator/virtual_rig.h"

namespace vignole {

/// Rails on a roller table: all of the same virtual rail, one after the other.
struct RailSchedule {
  std::uint64_t railTriggers = 0;  ///< 0: one rail without end
  std::uint64_t gapTriggers = 0;   ///< behind each rail: no rail, the cameras see what is left
  std::uint64_t rails = 0;         ///< 0: without end
  [[nodiscard]] bool present(std::uint64_t trigger) const;
  [[nodiscard]] std::optional<std::uint64_t> triggers() const;
};

struct FramesAheadSettings {
  RailSchedule schedule;
  int cameras = 4;
  std::size_t ahead = 6;  ///< triggers
  int threads = 1;
};

/// Every trigger shows its own pixels: those of VirtualRig::render, whatever the timing.
class FramesAhead final : public FrameProvider {
 public:
  /// Fails if the rig cannot be made without its rail, for the gaps.
  [[nodiscard]] static Expected<std::shared_ptr<FramesAhead>> create(std::shared_ptr<const VirtualRig> rig,
                                                                     const FramesAheadSettings& settings);
  ~FramesAhead() override;

  bool prepare(std::uint64_t trigger, std::stop_token stop) override;
  [[nodiscard]] ProvidedFrame frame(int camera, std::uint64_t trigger, std::stop_token stop) override;
  [[nodiscard]] bool railPresent(std::uint64_t trigger) const override { return settings_.schedule.present(trigger); }
  [[nodiscard]] std::optional<std::uint64_t> triggers() const override { return settings_.schedule.triggers(); }

 private:
  class Buffers;
  struct Shown {
    std::vector<ProvidedFrame> cameras;
    std::size_t rendered = 0;  ///< cameras that are done
    std::size_t begun = 0;
  };

  FramesAhead(std::shared_ptr<const VirtualRig> rig, std::shared_ptr<const VirtualRig> empty,
              const FramesAheadSettings& settings);
  void render(const std::stop_token& stop);
  [[nodiscard]] ProvidedFrame rendered(int camera, std::uint64_t trigger) const;
  void moveTo(std::uint64_t first);

  std::shared_ptr<const VirtualRig> rig_, empty_;
  FramesAheadSettings settings_;
  std::shared_ptr<Buffers> buffers_;
  std::mutex mutex_;
  std::condition_variable_any wanted_, ready_;
  std::uint64_t first_ = 0;  ///< trigger of window_.front()
  std::uint64_t generation_ = 0;
  std::deque<Shown> window_;
  std::vector<std::jthread> threads_;
};

}  // namespace vignole
