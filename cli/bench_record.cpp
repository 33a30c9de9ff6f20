// What recording costs: CPU and bytes a frame, and the pipeline with and without it in turns.

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <unistd.h>

#include "cli/bench_material.h"
#include "engine/inspection/inspection.h"
#include "engine/inspection/stage_meter.h"
#include "engine/recording/frame_recorder.h"
#include "engine/recording/sparse_frame.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole::cli {

namespace {

using Clock = std::chrono::steady_clock;

struct RecordedRate {
  double profilesPerS = 0;
  RecorderState state;
};

/// `file` empty: not recorded.
RecordedRate rateOf(const BenchMaterial& material, const std::filesystem::path& file, double rateHz) {
  constexpr std::uint64_t kProfiles = 400;
  MemorySourceSettings settings;
  settings.rail.id = "bench";
  settings.rail.sectionName = material.recipe.section.name;
  settings.profiles = kProfiles;
  settings.rateHz = rateHz;
  // As on a live line: what cannot be recorded in time is not recorded, and measured all the same.
  const auto recorder = std::make_shared<FrameRecorder>(FrameRecorderSettings{.live = true});
  std::unique_ptr<FrameSource> source = std::make_unique<MemorySource>(material.sets, nullptr, settings);
  InspectionObserver observer;
  if (!file.empty()) {
    RecordingOrder order;
    order.path = file;
    order.setup = {VIGNOLE_VERSION, stripeSimdTarget(),         "bench", {}, false,
                   material.recipe, material.rig->calibration()};
    if (!recorder->start(std::move(order))) return {};
    source = tapped(std::move(source), recorder);
    observer = tapped(std::move(observer), recorder);
  }
  std::uint64_t complete = 0;
  Clock::time_point ended;
  observer.profileMeasured = [&](const ProfileResult& r) { complete += r.profile.complete() && r.registration.valid; };
  observer.ended = [&](const std::string&) { ended = Clock::now(); };
  Inspection inspection(*source, material.recipe, material.rig->calibration(), std::move(observer));
  const auto start = Clock::now();
  inspection.start();
  inspection.wait();
  (void)recorder->stop();
  RecordedRate rate;
  rate.profilesPerS = static_cast<double>(complete) / std::chrono::duration<double>(ended - start).count();
  rate.state = recorder->state();
  return rate;
}

void benchPacking(const BenchMaterial& material, std::vector<BenchSeries>& results) {
  BenchSeries pack{"record.pack", "ms", {}}, unpack{"record.unpack", "ms", {}},
      bytes{"record.bytes", "bytes/frame", {}}, share{"record.share", "share", {}};
  FramePacker packer;
  FrameUnpacker unpacker;
  PackedBytes packed;
  const ImageView& first = material.sets.front().front();
  const FrameMemory memory =
      makeFrameMemory(static_cast<std::size_t>(first.width) * static_cast<std::size_t>(first.height));
  for (int round = 0; round < 2; ++round)  // once before the clock runs
    for (const FrameSet& set : material.sets)
      for (const ImageView& image : set) {
        const StopWatch packing;
        packer.pack(image, FrameKind::Sparse, packed);
        const double packMs = packing.ms();
        const StopWatch unpacking;
        const bool good = unpacker.unpack(packed, {memory.get(), image.width, image.height, image.width}).has_value();
        if (round == 0 || !good) continue;
        pack.values.push_back(packMs);
        unpack.values.push_back(unpacking.ms());
        bytes.values.push_back(static_cast<double>(packed.size()));
        share.values.push_back(packer.keptShare());
      }
  results.insert(results.end(), {std::move(pack), std::move(unpack), std::move(bytes), std::move(share)});
}

}  // namespace

void benchRecord(const BenchMaterial& material, std::vector<BenchSeries>& results) {
  benchPacking(material, results);
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("vignole-bench-" + std::to_string(::getpid()) + ".vgr");
  BenchSeries without{"record.rate.without", "profiles/s", {}}, with{"record.rate.with", "profiles/s", {}},
      ratio{"record.rate.ratio", "share", {}}, recorded{"record.rate.recorded", "share", {}},
      paced{"record.66hz.recorded", "share", {}}, pacedRate{"record.66hz.rate", "profiles/s", {}},
      cpu{"record.66hz.cpu", "ms/frame", {}};
  const auto shareOf = [](const RecorderState& s) {
    const auto all = static_cast<double>(s.triggers + s.dropped);
    return all > 0 ? static_cast<double>(s.triggers) / all : 0;
  };
  constexpr int kRuns = 7;
  for (int i = 0; i < kRuns; ++i) {  // in turns, so that what else the machine does meets both
    const double plain = rateOf(material, {}, 0).profilesPerS;
    const RecordedRate run = rateOf(material, file, 0);
    without.values.push_back(plain);
    with.values.push_back(run.profilesPerS);
    ratio.values.push_back(run.profilesPerS / plain);
    recorded.values.push_back(shareOf(run.state));
  }
  const RecordedRate run = rateOf(material, file, 66);
  paced.values.push_back(shareOf(run.state));
  pacedRate.values.push_back(run.profilesPerS);
  cpu.values.push_back(run.state.packCpuMs);
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  for (BenchSeries* series : {&without, &with, &ratio, &recorded, &paced, &pacedRate, &cpu})
    results.push_back(std::move(*series));
}

}  // namespace vignole::cli
