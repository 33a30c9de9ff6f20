#pragma once
// The books of the triggers: every one is entered once, as measured, incomplete or lost.

#include <mutex>
#include <string>
#include <vector>

#include "engine/inspection/inspection.h"

namespace vignole {

/// Written by the last stage, read by anyone. The sums hold at any time.
class LedgerBook {
 public:
  void beginRail();
  void enterLost(std::uint64_t triggers, const std::vector<std::string>& reasons);
  /// Measured if complete and registered to the right section, else incomplete with the reasons.
  void enterProfile(const Profile& profile, const Registration& registration);

  [[nodiscard]] TriggerLedger total() const;
  [[nodiscard]] TriggerLedger ofThisRail() const;

 private:
  void enter(std::uint64_t TriggerLedger::*column, std::uint64_t triggers, const std::vector<std::string>& reasons);

  mutable std::mutex mutex_;
  TriggerLedger total_, rail_;
};

/// The short word of a reason that may carry numbers: what stands before the first digit, bracket, comma or colon.
[[nodiscard]] std::string shortReason(const std::string& reason);

}  // namespace vignole
