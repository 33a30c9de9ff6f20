// The extraction beside what the memory allows and beside the method as the paper writes it.

#include <algorithm>
#include <span>

#include "cli/bench_material.h"
#include "cli/memory_speed.h"
#include "engine/inspection/stage_meter.h"
#include "engine/stripe/stripe_extractor.h"
#ifdef VIGNOLE_REFERENCE
#include "tests/synthetic/reference_steger.h"
#endif

namespace vignole::cli {

namespace {

std::span<const std::uint8_t> bytesOf(const ImageView& image) {
  return {image.row(0), static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)};
}

/// Extracts every frame once and reads every frame once, in turns, so that both see the same machine. All are out of
/// the caches when a round begins (a server's last level may hold more than all of them), and far more pages lie
/// between than the processor remembers; a round touches a frame once, the next the other way.
void timeCold(const std::vector<ImageView>& images, StripeExtractor& extractor, BenchSeries& cold, BenchSeries& read) {
  StripeResult stripe;
  std::uint64_t sum = 0;
  for (const std::size_t round : {0U, 1U}) {
    for (const ImageView& image : images) evict(bytesOf(image));
    for (std::size_t i = 0; i < images.size(); ++i) {
      const bool extracts = i % 2 == round;
      const StopWatch watch;
      if (extracts)
        extractor.extract(images[i], stripe);
      else
        sum += readOnce(bytesOf(images[i]));
      (extracts ? cold : read).values.push_back(watch.ms());
    }
  }
  if (sum == 0) read.values.clear();  // keeps the reading from being optimised away
}

}  // namespace

void benchExtract(const BenchMaterial& material, std::vector<BenchSeries>& results) {
  BenchSeries cold{"extract.cold", "ms", {}}, hot{"extract.hot", "ms", {}}, read{"extract.read", "ms", {}};
  std::vector<ImageView> images;
  for (const FrameSet& set : material.sets) images.insert(images.end(), set.begin(), set.end());
  StripeExtractor extractor(material.recipe.stripe);
  StripeResult stripe;
  // Once before the clock runs: the buffers come into being, the instruction sets are chosen.
  for (const ImageView& image : material.sets.front()) {
    extractor.extract(image, stripe);
    if (readOnce(bytesOf(image)) == 0) return;
  }
  timeCold(images, extractor, cold, read);
  for (const ImageView& image : images) {
    extractor.extract(image, stripe);
    const StopWatch watch;
    extractor.extract(image, stripe);
    hot.values.push_back(watch.ms());
  }
  results.insert(results.end(), {std::move(cold), std::move(hot), std::move(read)});
#ifdef VIGNOLE_REFERENCE
  BenchSeries reference{"extract.reference", "ms", {}};
  for (const ImageView& image : material.sets.front()) {
    const StopWatch watch;
    if (!synthetic::referenceSteger(image, material.recipe.stripe).empty()) reference.values.push_back(watch.ms());
  }
  results.push_back(std::move(reference));
#endif
}

}  // namespace vignole::cli
