// What a frame costs. Printed, never asserted: machines differ and are busy.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <gtest/gtest.h>

#include "engine/stripe/stripe_extractor.h"
#include "tests/synthetic/stripe_scene.h"

namespace vignole {
namespace {

double cpuMs() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

TEST(FrameTime, ColdFramesOneAfterTheOther) {
  // Sixty frames are 86 MB: none is in a cache when its turn comes again.
  std::vector<synthetic::StripeScene> scenes;
  for (const char* name : synthetic::kSceneNames)
    for (std::uint64_t seed = 1; seed <= 2; ++seed) scenes.push_back(synthetic::stripeScene(name, seed));
  std::vector<std::vector<std::uint8_t>> frames;
  for (int copy = 0; copy < 5; ++copy)
    for (const auto& scene : scenes) frames.push_back(scene.pixels);
  StripeExtractor extractor({});
  StripeResult result;
  std::vector<std::vector<double>> times(scenes.size());
  for (int round = 0; round < 6; ++round)
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const double start = cpuMs();
      extractor.extract({frames[i].data(), 1400, 1024, 1400}, result);
      times[i % scenes.size()].push_back(cpuMs() - start);
      EXPECT_GT(result.points.size(), 500U);
    }
  std::vector<double> all, best;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    std::sort(times[i].begin(), times[i].end());
    all.insert(all.end(), times[i].begin(), times[i].end());
    best.push_back(times[i].front());
    std::printf("%-6s min %.3f median %.3f ms\n", scenes[i].name.c_str(), times[i].front(),
                times[i][times[i].size() / 2]);
  }
  std::sort(all.begin(), all.end());
  std::sort(best.begin(), best.end());
  std::printf("cold frame on %s: median %.3f, median of the best %.3f ms\n", stripeSimdTarget(), all[all.size() / 2],
              best[best.size() / 2]);
}

}  // namespace
}  // namespace vignole
