#include "engine/gige_device/fault_plan.h"

#include <initializer_list>
#include <string_view>

namespace vignole::gige_device {

namespace {

/// SplitMix64's finaliser (Steele, Lea, Flood 2014).
std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

std::uint64_t hash(std::uint64_t seed, std::initializer_list<std::uint64_t> keys) {
  std::uint64_t h = mix(seed);
  for (const std::uint64_t key : keys) h = mix(h ^ key);
  return h;
}

double uniform(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

std::uint64_t keyOf(std::string_view kind) {
  std::uint64_t key = 0;
  for (const char c : kind) key = mix(key ^ static_cast<unsigned char>(c));
  return key;
}

constexpr std::uint64_t kPacketKey = 0x7061636b6574ULL, kBitsKey = 0x62697473ULL;

}  // namespace

FaultPlan::FaultPlan(std::uint64_t seed, std::vector<Fault> faults)
    : seed_(seed), faults_(std::make_shared<const std::vector<Fault>>(std::move(faults))) {}

void FaultPlan::add(std::vector<Fault> faults) {
  const std::lock_guard lock(mutex_);
  auto all = std::make_shared<std::vector<Fault>>(*faults_);
  all->insert(all->end(), faults.begin(), faults.end());
  faults_ = std::move(all);
}

std::shared_ptr<const std::vector<Fault>> FaultPlan::faults() const {
  const std::lock_guard lock(mutex_);
  return faults_;
}

bool FaultPlan::on(const char* kind, int camera, std::uint64_t trigger) const {
  return activeFault(*faults(), kind, camera, trigger) != nullptr;
}

double FaultPlan::value(const char* kind, int camera, std::uint64_t trigger, double otherwise) const {
  const auto all = faults();
  const Fault* fault = activeFault(*all, kind, camera, trigger);
  return fault == nullptr ? otherwise : fault->value;
}

bool FaultPlan::drawn(const char* kind, int camera, std::uint64_t trigger) const {
  const double rate = value(kind, camera, trigger, 0);
  return rate > 0 && uniform(hash(seed_, {keyOf(kind), static_cast<std::uint64_t>(camera), trigger})) < rate;
}

bool FaultPlan::dead(int camera, std::uint64_t trigger) const { return cameraDead(*faults(), camera, trigger); }

bool FaultPlan::packetLost(double rate, int camera, std::uint64_t trigger, std::uint32_t packet,
                           std::uint32_t attempt) const {
  return rate > 0 &&
         uniform(hash(seed_, {kPacketKey, static_cast<std::uint64_t>(camera), trigger, packet, attempt})) < rate;
}

std::uint64_t FaultPlan::bits(int camera, std::uint64_t trigger, std::uint64_t which) const {
  return hash(seed_, {kBitsKey, static_cast<std::uint64_t>(camera), trigger, which});
}

}  // namespace vignole::gige_device
