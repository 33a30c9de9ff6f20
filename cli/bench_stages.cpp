// The stages one by one, each on one thread.

#include "cli/bench_material.h"
#include "engine/inspection/stage_meter.h"
#include "engine/profile/assembler.h"
#include "engine/profile/translate.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole::cli {

namespace {

/// Reads every byte once, as a sum: what a pass over the picture costs at least.
std::uint64_t readOnce(const ImageView& image) {
  std::uint64_t sum = 0;
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* row = image.row(y);
    std::uint32_t ofRow = 0;
    for (int x = 0; x < image.width; ++x) ofRow += row[x];
    sum += ofRow;
  }
  return sum;
}

}  // namespace

void benchExtract(const BenchMaterial& material, std::vector<BenchSeries>& results) {
  BenchSeries cold{"extract.cold", "ms", {}}, hot{"extract.hot", "ms", {}}, read{"extract.read", "ms", {}};
  StripeExtractor extractor(material.recipe.stripe);
  StripeResult stripe;
  // Once before the clock runs: the extractor's own buffers come into being.
  for (const ImageView& image : material.sets.front()) extractor.extract(image, stripe);
  for (const FrameSet& set : material.sets)
    for (const ImageView& image : set) {
      const StopWatch watch;
      extractor.extract(image, stripe);
      cold.values.push_back(watch.ms());
    }
  std::uint64_t sum = 0;
  for (const FrameSet& set : material.sets)
    for (const ImageView& image : set) {
      const StopWatch watch;
      sum += readOnce(image);
      read.values.push_back(watch.ms());
    }
  // Keeps the reading from being optimised away.
  if (sum == 0) read.values.clear();
  for (const FrameSet& set : material.sets)
    for (const ImageView& image : set) {
      extractor.extract(image, stripe);
      const StopWatch watch;
      extractor.extract(image, stripe);
      hot.values.push_back(watch.ms());
    }
  results.insert(results.end(), {std::move(cold), std::move(hot), std::move(read)});
}

void benchTranslate(const BenchMaterial& material, std::vector<BenchSeries>& results) {
  BenchSeries series{"translate", "ms", {}};
  PartialContour contour;
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    const Translator translator(static_cast<int>(c), material.rig->calibration().rangeFinders[c]);
    for (const auto& stripes : material.stripes) {
      const StopWatch watch;
      translator.translate(0, stripes[c], contour);
      series.values.push_back(watch.ms());
    }
  }
  results.push_back(std::move(series));
}

void benchAssemble(const BenchMaterial& material, std::vector<BenchSeries>& results) {
  BenchSeries series{"assemble", "ms", {}};
  ProfileAssembler assembler;
  for (int c = 0; c < kCameraCount; ++c) assembler.add(c, RailBegin{});
  Assembly assembly;
  for (std::uint64_t s = 0; s < material.stripes.size(); ++s) {
    std::array<PartialContour, kCameraCount> contours;
    for (std::size_t c = 0; c < kCameraCount; ++c)
      Translator(static_cast<int>(c), material.rig->calibration().rangeFinders[c])
          .translate(s, material.stripes[s][c], contours[c]);
    const StopWatch watch;
    for (PartialContour& contour : contours) assembler.add(contour);
    while (assembler.next(assembly)) {
    }
    series.values.push_back(watch.ms());
  }
  results.push_back(std::move(series));
}

void benchMeasure(const BenchMaterial& material, std::vector<BenchSeries>& results) {
  constexpr int kRounds = 20;
  BenchSeries series{"measure", "us", {}};
  Registrar registrar(material.recipe.section, material.recipe.registration);
  Measurer measurer(material.recipe.section, material.recipe.parameters, material.recipe.limits,
                    material.recipe.measurement);
  Registration registration;
  Measurement measurement;
  for (const Profile& profile : material.profiles) {
    registrar.registerProfile(profile.points, registration, {}, static_cast<double>(profile.correlatedPoints));
    measurer.measure(profile, registration, {}, measurement);
    for (int round = 0; round < kRounds; ++round) {
      const StopWatch watch;
      measurer.measure(profile, registration, {}, measurement);
      series.values.push_back(1000 * watch.ms());
    }
  }
  results.push_back(std::move(series));
}

}  // namespace vignole::cli
