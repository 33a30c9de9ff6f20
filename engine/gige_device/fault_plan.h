#pragma once
// Which triggers, frames and packets the faults of one camera take: a matter of seed, camera and trigger, never of
// time.

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/faults/camera_fault.h"

namespace vignole::gige_device {

/// Thread-safe; faults may be added while it is asked. Cameras are 0..3.
class FaultPlan {
 public:
  FaultPlan(std::uint64_t seed, std::vector<Fault> faults);
  void add(std::vector<Fault> faults);

  [[nodiscard]] bool on(const char* kind, int camera, std::uint64_t trigger) const;
  /// The fault's number; `otherwise` if it is off.
  [[nodiscard]] double value(const char* kind, int camera, std::uint64_t trigger, double otherwise) const;
  /// Drawn with the fault's rate.
  [[nodiscard]] bool drawn(const char* kind, int camera, std::uint64_t trigger) const;
  [[nodiscard]] bool dead(int camera, std::uint64_t trigger) const;
  [[nodiscard]] double packetLoss(int camera, std::uint64_t trigger) const {
    return value("packet-loss", camera, trigger, 0);
  }
  /// `attempt` 0: the first sending, then one by one.
  [[nodiscard]] bool packetLost(double rate, int camera, std::uint64_t trigger, std::uint32_t packet,
                                std::uint32_t attempt) const;
  /// Any bits, always the same for these.
  [[nodiscard]] std::uint64_t bits(int camera, std::uint64_t trigger, std::uint64_t which) const;

 private:
  [[nodiscard]] std::shared_ptr<const std::vector<Fault>> faults() const;

  std::uint64_t seed_;
  mutable std::mutex mutex_;
  std::shared_ptr<const std::vector<Fault>> faults_;
};

}  // namespace vignole::gige_device
