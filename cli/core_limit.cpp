#include "cli/core_limit.h"

#include <string>
#include <utility>

namespace vignole::cli {

Expected<CoreLimit> CoreLimit::to(int cores) {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return worldError("cores", "the system names none");
  const int available = CPU_COUNT(&allowed);
  if (cores == 0) cores = available;
  if (cores > available)
    return inputError("--threads",
                      std::to_string(cores) + " cores wanted, " + std::to_string(available) + " available");
  cpu_set_t chosen;
  CPU_ZERO(&chosen);
  for (std::size_t cpu = 0, taken = 0; taken < static_cast<std::size_t>(cores); ++cpu)
    if (CPU_ISSET(cpu, &allowed)) {
      CPU_SET(cpu, &chosen);
      ++taken;
    }
  if (sched_setaffinity(0, sizeof chosen, &chosen) != 0) return worldError("cores", "the system refuses the choice");
  return CoreLimit(allowed, cores);
}

CoreLimit::CoreLimit(CoreLimit&& other) noexcept
    : before_(other.before_), cores_(other.cores_), active_(std::exchange(other.active_, false)) {}

CoreLimit::~CoreLimit() {
  if (active_) sched_setaffinity(0, sizeof before_, &before_);
}

}  // namespace vignole::cli
