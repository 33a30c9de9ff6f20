// The stages one by one, each on one thread.

#include "cli/bench_material.h"
#include "engine/inspection/stage_meter.h"
#include "engine/profile/assembler.h"
#include "engine/profile/translate.h"

namespace vignole::cli {

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
