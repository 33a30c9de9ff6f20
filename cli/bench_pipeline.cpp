// All fourteen elements at once: rate, CPU time a profile, what more cores would give; latency and queues at 66 Hz.

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <ctime>
#include <map>
#include <numeric>

#include "cli/bench_material.h"
#include "cli/core_limit.h"
#include "engine/inspection/inspection.h"

namespace vignole::cli {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int kElements = 3 * kCameraCount + 2;  // each one thread

/// Notes when the last camera's frame of each trigger was handed over.
class TimedSource : public FrameSource {
 public:
  TimedSource(FrameSource& source, std::size_t triggers) : source_(source), handedOver_(triggers) {}
  FrameMessage next(int camera, std::stop_token stop) override {
    FrameMessage message = source_.next(camera, std::move(stop));
    if (const Frame* frame = std::get_if<Frame>(&message)) {
      std::atomic<Clock::rep>& latest = handedOver_[frame->trigger];
      const Clock::rep now = Clock::now().time_since_epoch().count();
      for (Clock::rep seen = latest; seen < now && !latest.compare_exchange_weak(seen, now);) {
      }
    }
    return message;
  }
  [[nodiscard]] bool live() const override { return source_.live(); }
  [[nodiscard]] double msSince(std::uint64_t trigger) const {
    return std::chrono::duration<double, std::milli>(Clock::now() -
                                                     Clock::time_point(Clock::duration(handedOver_[trigger])))
        .count();
  }

 private:
  FrameSource& source_;
  std::vector<std::atomic<Clock::rep>> handedOver_;
};

MemorySourceSettings railOf(const BenchMaterial& material, std::uint64_t profiles, double rateHz) {
  MemorySourceSettings settings;
  settings.rail.id = "bench";
  settings.rail.sectionName = material.recipe.section.name;
  settings.profiles = profiles;
  settings.rateHz = rateHz;
  return settings;
}

/// "extract.3" is one of the threads of "extract".
std::string kindOf(const StageStatistics& stage) { return stage.name.substr(0, stage.name.find('.')); }

/// Of all threads, with what the system did for them, ms.
double processCpuMs() {
  timespec now{};
  if (clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now) != 0) return 0;
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// One run as fast as the machine goes.
struct Run {
  double rate = 0;                            ///< complete profiles a second
  double cpuMs = 0;                           ///< of the whole process, a profile
  std::map<std::string, double> stageCpuMs;   ///< of all threads of a stage, a profile
  std::map<std::string, double> threadCpuMs;  ///< of its busiest thread
};

Run runOnce(const BenchMaterial& material, std::uint64_t profiles) {
  MemorySource source(material.sets, nullptr, railOf(material, profiles, 0));
  Clock::time_point ended;
  std::uint64_t complete = 0;
  InspectionObserver observer;
  observer.profileMeasured = [&](const ProfileResult& r) { complete += r.profile.complete() && r.registration.valid; };
  observer.ended = [&](const std::string&) { ended = Clock::now(); };
  Inspection inspection(source, material.recipe, material.rig->calibration(), observer);
  const double cpuBefore = processCpuMs();
  const auto start = Clock::now();
  inspection.start();
  inspection.wait();
  const auto n = static_cast<double>(profiles);
  Run run;
  run.cpuMs = (processCpuMs() - cpuBefore) / n;
  run.rate = static_cast<double>(complete) / std::chrono::duration<double>(ended - start).count();
  for (const StageStatistics& stage : inspection.stages()) {
    run.stageCpuMs[kindOf(stage)] += stage.cpuMs / n;
    double& busiest = run.threadCpuMs[kindOf(stage)];
    busiest = std::max(busiest, stage.cpuMs / n);
  }
  return run;
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What more cores would give: all of them busy, but no element of the pipeline on more than one, and CPU times as here
/// (so memory must give every core what it gives here).
void addModel(const std::vector<Run>& runs, std::vector<BenchSeries>& results) {
  std::vector<double> cpu;
  std::map<std::string, std::vector<double>> threads;
  for (const Run& run : runs) {
    cpu.push_back(run.cpuMs);
    for (const auto& [stage, ms] : run.threadCpuMs) threads[stage].push_back(ms);
  }
  double slowest = 0;
  for (const auto& [stage, ms] : threads) {
    const double mine = medianOf(ms);
    slowest = std::max(slowest, mine);
    results.push_back({"pipeline.limit." + stage, "profiles/s", {1000 / mine}});
  }
  for (const int cores : {4, 8, 16})
    results.push_back({"pipeline.model." + std::to_string(cores) + "cores",
                       "profiles/s",
                       {std::min(1000 * std::min(cores, kElements) / medianOf(cpu), 1000 / slowest)}});
}

void benchThroughput(const BenchMaterial& material, int cores, std::vector<BenchSeries>& results) {
  constexpr int kRuns = 7, kRunsOnOne = 3;
  constexpr std::uint64_t kProfiles = 500;
  BenchSeries rate{"pipeline.rate", "profiles/s", {}}, total{"pipeline.cpu_total", "ms", {}},
      efficiency{"pipeline.efficiency", "share", {}}, other{"pipeline.share.other", "share", {}},
      onOne{"pipeline.rate.1core", "profiles/s", {}};
  std::map<std::string, BenchSeries> stages;
  std::vector<Run> runs;
  for (int i = 0; i < kRuns; ++i) {
    const Run& run = runs.emplace_back(runOnce(material, kProfiles));
    rate.values.push_back(run.rate);
    total.values.push_back(run.cpuMs);
    efficiency.values.push_back(run.rate * run.cpuMs / (1000 * cores));
    other.values.push_back(1 - run.stageCpuMs.at("extract") / run.cpuMs);
    for (const auto& [stage, ms] : run.stageCpuMs) stages[stage].values.push_back(ms);
  }
  results.push_back(std::move(rate));
  if (const auto one = CoreLimit::to(1)) {
    for (int i = 0; i < kRunsOnOne; ++i) onOne.values.push_back(runOnce(material, kProfiles).rate);
    results.push_back(std::move(onOne));
  }
  for (auto& [stage, series] : stages) results.push_back({"pipeline.cpu." + stage, "ms", std::move(series.values)});
  results.insert(results.end(), {std::move(total), std::move(other), std::move(efficiency)});
  addModel(runs, results);
}

/// At the paper's rate: from the last camera's frame to the measured dimensions; how full the queues are meanwhile.
void benchPaced(const BenchMaterial& material, std::vector<BenchSeries>& results) {
  constexpr double kRateHz = 66;
  constexpr std::uint64_t kPaced = 300;
  BenchSeries latency{"pipeline.latency", "ms", {}}, growth{"pipeline.queue.growth", "share", {}};
  std::map<std::string, std::vector<double>> fill;  // of the stage's fullest queue, at each profile
  MemorySource paced(material.sets, nullptr, railOf(material, kPaced, kRateHz));
  TimedSource timed(paced, kPaced);
  const Inspection* running = nullptr;
  InspectionObserver observer;
  observer.profileMeasured = [&](const ProfileResult& r) {
    latency.values.push_back(timed.msSince(r.profile.trigger));
    std::map<std::string, double> now;
    for (const StageStatistics& stage : running->stages()) {
      if (stage.queueCapacity == 0) continue;
      double& fullest = now[kindOf(stage)];
      fullest = std::max(fullest, static_cast<double>(stage.queueDepth) / static_cast<double>(stage.queueCapacity));
    }
    for (const auto& [stage, share] : now) fill[stage].push_back(share);
  };
  Inspection inspection(timed, material.recipe, material.rig->calibration(), observer);
  running = &inspection;
  BenchSeries highWater{"pipeline.queue.highwater", "share", {}};
  inspection.start();
  inspection.wait();
  for (const StageStatistics& stage : inspection.stages())
    if (stage.queueCapacity > 0)
      highWater.values.push_back(static_cast<double>(stage.queueHighWater) / static_cast<double>(stage.queueCapacity));
  results.push_back(std::move(latency));
  for (auto& [stage, shares] : fill) {
    const auto half = static_cast<std::ptrdiff_t>(shares.size() / 2);
    const double first = std::accumulate(shares.begin(), shares.begin() + half, 0.0),
                 second = std::accumulate(shares.end() - half, shares.end(), 0.0);
    growth.values.push_back((second - first) / static_cast<double>(std::max<std::ptrdiff_t>(half, 1)));
    results.push_back({"pipeline.queue." + stage, "share", std::move(shares)});
  }
  results.insert(results.end(), {std::move(highWater), std::move(growth)});
}

}  // namespace

void benchPipeline(const BenchMaterial& material, int cores, std::vector<BenchSeries>& results) {
  benchThroughput(material, cores, results);
  benchPaced(material, results);
}

}  // namespace vignole::cli
