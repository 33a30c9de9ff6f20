#pragma once
// What the benchmarks work on: frames of the virtual rig in memory, independent of each other, and what the stages make
// of them.

#include <memory>
#include <string>
#include <vector>

#include "engine/acquisition/frame_memory.h"
#include "engine/acquisition/memory_source.h"
#include "engine/profile/profile.h"
#include "engine/recipe/recipe.h"
#include "engine/simulator/virtual_rig.h"
#include "engine/stripe/stripe.h"

namespace vignole::cli {

/// One figure: every single time (or rate) that was taken.
struct BenchSeries {
  std::string name, unit;
  std::vector<double> values;
};

struct BenchMaterial {
  Recipe recipe;
  std::shared_ptr<const VirtualRig> rig;
  std::vector<FrameMemory> buffers;
  std::vector<FrameSet> sets;    ///< one a profile
  std::vector<double> renderMs;  ///< one a frame
  /// Made by extractAll(): one a profile.
  std::vector<std::array<StripeResult, kCameraCount>> stripes;
  std::vector<Profile> profiles;

  [[nodiscard]] std::size_t frames() const { return kCameraCount * sets.size(); }
};

/// `frames` is rounded up to whole profiles. Default effects, seed 1.
[[nodiscard]] Expected<BenchMaterial> renderMaterial(std::size_t frames);
/// Centre lines and profiles of every set, for the benchmarks of the later stages.
void extractAll(BenchMaterial& material);

void benchExtract(const BenchMaterial& material, std::vector<BenchSeries>& results);
void benchTranslate(const BenchMaterial& material, std::vector<BenchSeries>& results);
void benchAssemble(const BenchMaterial& material, std::vector<BenchSeries>& results);
void benchRegister(const BenchMaterial& material, std::vector<BenchSeries>& results);
void benchRecord(const BenchMaterial& material, std::vector<BenchSeries>& results);
void benchMeasure(const BenchMaterial& material, std::vector<BenchSeries>& results);
/// `cores` that the program may use.
void benchPipeline(const BenchMaterial& material, int cores, std::vector<BenchSeries>& results);

}  // namespace vignole::cli
