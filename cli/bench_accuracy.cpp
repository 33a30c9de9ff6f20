#include "cli/bench_accuracy.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/inspection/inspection.h"
#include "engine/profile/translate.h"
#include "engine/registration/registration.h"

namespace vignole::cli {

namespace {

// Profiles whose bound is computed, spread over the run: it varies little between them.
constexpr std::uint64_t kBoundProfiles = 40;

VirtualRigSettings rigSettings(const AccuracySettings& s, const Recipe& recipe) {
  VirtualRigSettings rig;
  rig.section = recipe.section;
  rig.parameters = recipe.parameters;
  rig.seed = s.seed;
  rig.rigSeed = s.rigSeed;
  return rig;
}

Expected<DimensionBound> boundOfRun(const AccuracySettings& s, const VirtualRigSettings& rig, const Recipe& recipe,
                                    const std::function<void(double)>& progress) {
  const auto bound = BoundOfDimensions::create(rig, recipe);
  if (!bound) return tl::unexpected<Error>(bound.error());
  PerDimension<double> squares{};
  PerDimension<int> counts{};
  const std::uint64_t count = std::min(kBoundProfiles, s.profiles);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto uMm = bound->of((2 * i + 1) * s.profiles / (2 * count), s.linePx);
    for (std::size_t d = 0; d < kDimensionCount; ++d)
      if (uMm[d]) {
        squares[d] += *uMm[d] * *uMm[d];
        ++counts[d];
      }
    progress(static_cast<double>(i + 1) / static_cast<double>(count));
  }
  DimensionBound result;
  for (std::size_t d = 0; d < kDimensionCount; ++d)
    if (counts[d] > 0) result[d] = std::sqrt(squares[d] / counts[d]);
  return result;
}

Expected<void> measureRun(const AccuracySettings& s, const VirtualRigSettings& settings, const Recipe& recipe,
                          AccuracyRun& run, const std::function<void(double)>& progress) {
  const auto rig = VirtualRig::create(settings);
  if (!rig) return tl::unexpected<Error>(rig.error());
  const auto source = makeVirtualSource(*rig, {1, static_cast<double>(s.profiles) * settings.spacingMm, false});
  std::string failure;
  InspectionObserver observer;
  observer.profileMeasured = [&](const ProfileResult& result) {
    ++run.profiles;
    if (result.registration.valid) {
      ++run.registered;
      run.measured.add(result.measurement, (*rig)->truth(result.profile.trigger));
    }
    progress(static_cast<double>(run.profiles) / static_cast<double>(s.profiles));
  };
  observer.ended = [&](const std::string& error) { failure = error; };
  Inspection inspection(*source, recipe, (*rig)->calibration(), observer);
  inspection.start();
  inspection.wait();
  if (!failure.empty()) return worldError("bench accuracy", failure);
  return {};
}

}  // namespace

BoundOfDimensions::BoundOfDimensions(simulator::RenderedLines lines, RigCalibration calibration,
                                     simulator::PictureNoise noise, double temperatureC, const Recipe& recipe)
    : lines_(std::move(lines)),
      calibration_(std::move(calibration)),
      noise_(noise),
      temperatureC_(temperatureC),
      recipe_(recipe) {
  recipe_.measurement.trimMm = 0;
}

Expected<BoundOfDimensions> BoundOfDimensions::create(const VirtualRigSettings& settings, const Recipe& recipe) {
  auto lines = simulator::RenderedLines::create(settings);
  if (!lines) return tl::unexpected<Error>(lines.error());
  const RigCalibration calibration = lines->calibration();
  return BoundOfDimensions(*std::move(lines), calibration, simulator::pictureNoise(settings.effects),
                           settings.temperatureC, recipe);
}

DimensionBound BoundOfDimensions::of(std::uint64_t trigger, std::optional<double> fixedPx) const {
  Profile profile;
  profile.trigger = trigger;
  for (int camera = 0; camera < kCameraCount; ++camera) {
    StripeResult stripe;
    for (const auto& line : lines_.at(camera, trigger)) {
      StripeLine drawn{static_cast<std::uint32_t>(stripe.points.size()), 0};
      for (const simulator::LinePlace& place : line) {
        const double perPx = fixedPx ? 1 / (*fixedPx * *fixedPx) : informationPerPx(place.light, noise_);
        if (!(perPx > 0)) continue;
        StripePoint& point = stripe.points.emplace_back();
        point.x = static_cast<float>(place.px.x());
        point.y = static_cast<float>(place.px.y());
        point.nx = static_cast<float>(place.normal.x());
        point.ny = static_cast<float>(place.normal.y());
        point.sigmaPx = static_cast<float>(1 / std::sqrt(perPx * place.lengthPx));
        point.strength = static_cast<float>(place.light.contrastDn);
        ++drawn.count;
      }
      stripe.lines.push_back(drawn);
    }
    PartialContour contour;
    Translator(camera, calibration_.rangeFinders[static_cast<std::size_t>(camera)]).translate(trigger, stripe, contour);
    profile.points.insert(profile.points.end(), contour.points.begin(), contour.points.end());
  }
  Registration registration;
  Registrar(recipe_.section, recipe_.registration).registerProfile(profile.points, registration);
  Measurement measurement;
  Measurer(recipe_.section, recipe_.parameters, recipe_.limits, recipe_.measurement)
      .measure(profile, registration, {temperatureC_, 0}, measurement);
  DimensionBound bound;
  for (std::size_t d = 0; d < kDimensionCount; ++d)
    if (measurement.dimensions[d].valueMm) bound[d] = measurement.dimensions[d].uMm;
  return bound;
}

Expected<std::vector<AccuracyRun>> benchAccuracy(const AccuracySettings& s, Progress& progress) {
  const auto recipe = findRecipe(s.recipe);
  if (!recipe) return tl::unexpected<Error>(recipe.error());
  std::vector<AccuracyRun> runs;
  for (const bool speckle : {true, false}) {
    AccuracyRun run;
    run.name = speckle ? "accuracy" : "accuracy.nospeckle";
    VirtualRigSettings rig = rigSettings(s, *recipe);
    if (const auto applied = applyWords(rig, s.effects, {}, {}); !applied)
      return tl::unexpected<Error>(applied.error());
    if (!speckle) rig.effects.speckle = 0;
    const double before = speckle ? 0 : 0.5;
    const auto measuring = [&](double share) { progress.update(before + 0.4 * share, run.name + ", measuring"); };
    if (const auto done = measureRun(s, rig, *recipe, run, measuring); !done)
      return tl::unexpected<Error>(done.error());
    const auto bounding = [&](double share) { progress.update(before + 0.4 + 0.1 * share, run.name + ", bound"); };
    auto bound = boundOfRun(s, rig, *recipe, bounding);
    if (!bound) return tl::unexpected<Error>(bound.error());
    run.boundMm = *bound;
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace vignole::cli
