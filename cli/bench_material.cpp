#include "cli/bench_material.h"

#include <algorithm>

#include "engine/inspection/stage_meter.h"
#include "engine/profile/assembler.h"
#include "engine/profile/translate.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole::cli {

namespace {
// Pictures so far apart on the rail that neither its shape nor its pose is the same.
constexpr std::uint64_t kTriggersApart = 97;
}  // namespace

Expected<BenchMaterial> renderMaterial(std::size_t frames) {
  BenchMaterial material;
  auto recipe = findRecipe("60E1 X/A");
  if (!recipe) return tl::unexpected(recipe.error());
  material.recipe = std::move(*recipe);
  VirtualRigSettings settings;
  settings.section = material.recipe.section;
  settings.parameters = material.recipe.parameters;
  auto rig = VirtualRig::create(std::move(settings));
  if (!rig) return tl::unexpected(rig.error());
  material.rig = *rig;
  const std::size_t sets = (frames + kCameraCount - 1) / kCameraCount;
  for (std::size_t s = 0; s < sets; ++s) {
    FrameSet& set = material.sets.emplace_back();
    for (std::size_t c = 0; c < kCameraCount; ++c) {
      const Intrinsics& in = material.rig->calibration().rangeFinders[c].intrinsics;
      const auto bytes = static_cast<std::size_t>(in.widthPx) * static_cast<std::size_t>(in.heightPx);
      material.buffers.push_back(makeFrameMemory(bytes));
      // A camera's buffers are used again and again: that the system first has to make them is no one's rendering.
      std::fill_n(material.buffers.back().get(), bytes, std::uint8_t{0});
      const MutableImageView image{material.buffers.back().get(), in.widthPx, in.heightPx, in.widthPx};
      const StopWatch watch;
      material.rig->render(static_cast<int>(c), s * kTriggersApart, image);
      material.renderMs.push_back(watch.ms());
      set[c] = image;
    }
  }
  return material;
}

void extractAll(BenchMaterial& material) {
  StripeExtractor extractor(material.recipe.stripe);
  material.stripes.resize(material.sets.size());
  ProfileAssembler assembler;
  RailBegin rail;
  for (int c = 0; c < kCameraCount; ++c) assembler.add(c, rail);
  Assembly assembly;
  for (std::size_t s = 0; s < material.sets.size(); ++s) {
    for (std::size_t c = 0; c < kCameraCount; ++c) {
      extractor.extract(material.sets[s][c], material.stripes[s][c]);
      const Translator translator(static_cast<int>(c), material.rig->calibration().rangeFinders[c]);
      PartialContour contour;
      translator.translate(s, material.stripes[s][c], contour);
      assembler.add(contour);
    }
    while (assembler.next(assembly))
      if (assembly.kind == Assembly::Kind::Profile) material.profiles.push_back(assembly.profile);
  }
}

}  // namespace vignole::cli
