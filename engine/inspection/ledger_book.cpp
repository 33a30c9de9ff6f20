#include "engine/inspection/ledger_book.h"

#include "engine/profile/assembler.h"

namespace vignole {

std::string shortReason(const std::string& reason) {
  std::string word = reason.substr(0, reason.find_first_of("0123456789(,:;"));
  while (!word.empty() && word.back() == ' ') word.pop_back();
  return word;
}

void LedgerBook::beginRail() {
  const std::scoped_lock lock(mutex_);
  rail_ = {};
}

void LedgerBook::enter(std::uint64_t TriggerLedger::*column, std::uint64_t triggers,
                       const std::vector<std::string>& reasons) {
  // A superfluous frame is told with 0 triggers; it still counts once under its reason.
  const std::uint64_t times = triggers == 0 ? 1 : triggers;
  const std::scoped_lock lock(mutex_);
  for (TriggerLedger* ledger : {&total_, &rail_}) {
    ledger->seen += triggers;
    ledger->*column += triggers;
    for (const std::string& reason : reasons) ledger->reasons[reason] += times;
  }
}

void LedgerBook::enterLost(std::uint64_t triggers, const std::vector<std::string>& reasons) {
  enter(&TriggerLedger::lost, triggers, reasons);
}

void LedgerBook::enterProfile(const Profile& profile, const Registration& registration) {
  std::vector<std::string> reasons;
  for (int c = 0; c < kCameraCount; ++c) {
    const std::string& missing = profile.missing[static_cast<std::size_t>(c)];
    if (!missing.empty()) reasons.push_back(cameraReason(c, missing));
  }
  if (registration.looksLike) {
    reasons.push_back("wrong section: looks like " + registration.looksLike->name);
  } else if (!registration.valid) {
    const std::string word = shortReason(registration.reason);
    reasons.push_back(word.empty() ? "not registered" : "not registered: " + word);
  }
  enter(reasons.empty() ? &TriggerLedger::measured : &TriggerLedger::incomplete, 1, reasons);
}

TriggerLedger LedgerBook::total() const {
  const std::scoped_lock lock(mutex_);
  return total_;
}

TriggerLedger LedgerBook::ofThisRail() const {
  const std::scoped_lock lock(mutex_);
  return rail_;
}

}  // namespace vignole
