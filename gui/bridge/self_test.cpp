#include "gui/bridge/self_test.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <time.h>
#include <unistd.h>

namespace vignole {

namespace {

double seconds(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double residentMb() {
  std::ifstream file("/proc/self/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576;
}

double rounded(double value) { return std::round(value * 1000) / 1000; }

}  // namespace

ProcessUse processUse() {
  return {seconds(CLOCK_MONOTONIC), seconds(CLOCK_PROCESS_CPUTIME_ID), seconds(CLOCK_THREAD_CPUTIME_ID), residentMb()};
}

std::string selfTestJson(const LineSnapshot& line, const EventLoopWatchdog& watchdog, const ProcessUse& start,
                         const ProcessUse& end) {
  const double wallS = end.wallS - start.wallS;
  const double guiS = end.threadCpuS - start.threadCpuS;
  const double restS = end.processCpuS - start.processCpuS - guiS;
  const TriggerLedger& t = line.triggers;
  nlohmann::ordered_json document;
  document["triggers"] = {{"seen", t.seen},
                          {"measured", t.measured},
                          {"incomplete", t.incomplete},
                          {"lost", t.lost},
                          {"reasons", t.reasons}};
  document["event_loop_ms"] = {{"p50", rounded(watchdog.quantileMs(0.5))},
                               {"p99", rounded(watchdog.quantileMs(0.99))},
                               {"max", rounded(watchdog.maxMs())},
                               {"turns", watchdog.turns()}};
  document["gui_cpu_share"] = rounded(wallS > 0 ? guiS / wallS : 0);
  document["engine_cpu_share"] = rounded(wallS > 0 ? restS / wallS : 0);
  document["rss_mb"] = {{"start", rounded(start.rssMb)}, {"end", rounded(end.rssMb)}};
  document["profiles_per_s"] = rounded(line.profilesPerS);
  document["wall_s"] = rounded(wallS);
  return document.dump(2);
}

}  // namespace vignole
