// All fourteen elements at once: rate, CPU time a profile, latency.

#include <atomic>
#include <chrono>
#include <map>

#include "cli/bench_material.h"
#include "engine/inspection/inspection.h"

namespace vignole::cli {

namespace {

using Clock = std::chrono::steady_clock;

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

void runOnce(const BenchMaterial& material, std::uint64_t profiles, BenchSeries& rate,
             std::map<std::string, BenchSeries>& cpu) {
  MemorySource source(material.sets, nullptr, railOf(material, profiles, 0));
  Clock::time_point ended;
  std::uint64_t complete = 0;
  InspectionObserver observer;
  observer.profileMeasured = [&](const ProfileResult& r) { complete += r.profile.complete() && r.registration.valid; };
  observer.ended = [&](const std::string&) { ended = Clock::now(); };
  Inspection inspection(source, material.recipe, material.rig->calibration(), observer);
  const auto start = Clock::now();
  inspection.start();
  inspection.wait();
  rate.values.push_back(static_cast<double>(complete) / std::chrono::duration<double>(ended - start).count());
  std::map<std::string, double> sums;
  for (const StageStatistics& stage : inspection.stages())
    sums[stage.name.substr(0, stage.name.find('.'))] += stage.cpuMs;
  for (const auto& [stage, ms] : sums) {
    BenchSeries& series = cpu[stage];
    series.name = "pipeline.cpu." + stage;
    series.unit = "ms";
    series.values.push_back(ms / static_cast<double>(profiles));
  }
}

}  // namespace

void benchPipeline(const BenchMaterial& material, std::vector<BenchSeries>& results) {
  constexpr int kRuns = 7;
  constexpr std::uint64_t kProfiles = 500;
  BenchSeries rate{"pipeline.rate", "profiles/s", {}};
  std::map<std::string, BenchSeries> cpu;
  for (int run = 0; run < kRuns; ++run) runOnce(material, kProfiles, rate, cpu);
  results.push_back(std::move(rate));
  for (auto& [stage, series] : cpu) results.push_back(std::move(series));

  // At the paper's rate, from the last camera's frame to the measured dimensions.
  constexpr double kRateHz = 66;
  constexpr std::uint64_t kPaced = 300;
  BenchSeries latency{"pipeline.latency", "ms", {}};
  MemorySource paced(material.sets, nullptr, railOf(material, kPaced, kRateHz));
  TimedSource timed(paced, kPaced);
  InspectionObserver observer;
  observer.profileMeasured = [&](const ProfileResult& r) {
    latency.values.push_back(timed.msSince(r.profile.trigger));
  };
  Inspection inspection(timed, material.recipe, material.rig->calibration(), observer);
  inspection.start();
  inspection.wait();
  results.push_back(std::move(latency));
}

}  // namespace vignole::cli
