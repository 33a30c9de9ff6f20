#pragma once
// Which cores the threads of a benchmark may use.

#include <sched.h>

#include "engine/geometry/expected.h"

namespace vignole::cli {

/// While it lives, this thread and those that it starts share the first `cores` of the cores that it had.
class CoreLimit {
 public:
  /// 0: all that it has. Refused if there are fewer.
  [[nodiscard]] static Expected<CoreLimit> to(int cores);
  CoreLimit(CoreLimit&& other) noexcept;
  CoreLimit& operator=(CoreLimit&&) = delete;
  ~CoreLimit();
  [[nodiscard]] int cores() const { return cores_; }

 private:
  CoreLimit(const cpu_set_t& before, int cores) : before_(before), cores_(cores) {}
  cpu_set_t before_;
  int cores_;
  bool active_ = true;
};

}  // namespace vignole::cli
