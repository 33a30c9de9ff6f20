#pragma once
// `vignole --self-test SECONDS`: what the running program says of itself, as one JSON document (hmi.md).

#include <cstdint>
#include <string>

#include "gui/bridge/event_loop_watchdog.h"
#include "gui/bridge/line.h"

namespace vignole {

/// CPU and memory of this process so far.
struct ProcessUse {
  double wallS = 0;
  double processCpuS = 0;
  double threadCpuS = 0;  ///< of the calling thread
  double rssMb = 0;
};
[[nodiscard]] ProcessUse processUse();

/// `start` and `end` were both taken in the window's thread. Shares are of one core.
[[nodiscard]] std::string selfTestJson(const LineSnapshot& line, const EventLoopWatchdog& watchdog,
                                       const ProcessUse& start, const ProcessUse& end);

}  // namespace vignole
