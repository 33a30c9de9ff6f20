#include "engine/synchronisation/arrival_alignment.h"

#include <cmath>

namespace vignole {

namespace {
constexpr std::size_t kRemembered = 64;
constexpr std::size_t kFewest = 4;
}  // namespace

void ArrivalAlignment::addReference(std::uint64_t trigger, double arrivedS) {
  if (!references_.empty() && trigger <= references_.back().trigger) return;
  references_.push_back({trigger, arrivedS});
  if (references_.size() > kRemembered) references_.pop_front();
}

std::optional<double> ArrivalAlignment::periodS() const {
  if (references_.size() < kFewest) return {};
  const Arrival &a = references_.front(), &b = references_.back();
  return (b.s - a.s) / static_cast<double>(b.trigger - a.trigger);
}

std::optional<std::int64_t> ArrivalAlignment::add(std::int64_t place, double arrivedS) {
  const auto period = periodS();
  if (!period || !(*period > 0)) return {};
  // A trigger that the others have not shown yet, or one that all of them lost, lies on the line through the latest.
  const Arrival& last = references_.back();
  const Arrival* nearest = &last;
  for (const Arrival& r : references_)
    if (std::abs(r.s - arrivedS) < std::abs(nearest->s - arrivedS)) nearest = &r;
  const double steps = (arrivedS - nearest->s) / *period;
  const double whole = std::round(steps);
  if (std::abs(steps - whole) > settings_.nearestShare || std::abs(whole) > 3) {
    agreed_ = 0;
    return {};
  }
  const std::int64_t offset = static_cast<std::int64_t>(nearest->trigger) + static_cast<std::int64_t>(whole) - place;
  agreed_ = agreed_ > 0 && offset == offset_ ? agreed_ + 1 : 1;
  offset_ = offset;
  if (agreed_ < settings_.agreeing) return {};
  return offset_;
}

}  // namespace vignole
