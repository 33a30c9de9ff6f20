#include "engine/inspection/inspection.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/inspection/pipeline.h"
#include "engine/profile/stripe_optics.h"
#include "engine/profile/translate.h"
#include "engine/rail/catalogue.h"
#include "engine/registration/rail_matcher.h"
#include "engine/stripe/stripe_extractor.h"
#include "engine/systematic/calibration_error.h"

namespace vignole {

namespace {

/// A rail wanders by some millimetres and a degree; light further away is not its line.
MeasuringField fieldAround(const Section& section) {
  constexpr double kMarginMm = 25;
  double reach = 0;
  for (const NamedPrimitive& p : section.primitives)
    reach = std::max({reach, std::abs(startPoint(p.shape).x()), std::abs(endPoint(p.shape).x())});
  return {{-reach - kMarginMm, -kMarginMm}, {reach + kMarginMm, section.heightMm() + kMarginMm}};
}

/// Through such a calibration that the rail cannot be found nothing is measured, so its uncertainty does not matter.
PerDimension<double> uncertaintyBy(const RigCalibration& calibration, const Recipe& recipe) {
  return calibrationUncertainty(recipe.section, recipe.parameters, calibration).value_or(PerDimension<double>{});
}

}  // namespace

StripeOptics extractionOptics(const RigCalibration& calibration, const Section& section, int camera) {
  return stripeOptics(calibration.rangeFinders[static_cast<std::size_t>(camera)], fieldAround(section));
}

struct Inspection::Impl {
  Impl(FrameSource& source, Recipe chosenRecipe, RigCalibration rig, InspectionObserver observer,
       const InspectionSettings& settings)
      : recipe(std::move(chosenRecipe)),
        calibration(std::move(rig)),
        registrar(recipe.section, recipe.registration),
        matcher(recipe.section, catalogueSections(), recipe.registration),
        measurer(recipe.section, recipe.parameters, recipe.limits, recipe.measurement,
                 uncertaintyBy(calibration, recipe)) {
    for (std::size_t c = 0; c < kCameraCount; ++c) {
      extractors.emplace_back(recipe.stripe, extractionOptics(calibration, recipe.section, static_cast<int>(c)));
      translators.emplace_back(static_cast<int>(c), calibration.rangeFinders[c]);
    }
    pipeline = std::make_unique<Pipeline>(source, work(), std::move(observer), settings);
  }

  PipelineWork work() {
    return {
        [this](int camera, const ImageView& image, StripeResult& result) {
          extractors[static_cast<std::size_t>(camera)].extract(image, result);
        },
        [this](int camera, std::uint64_t trigger, const StripeResult& stripe, PartialContour& result) {
          translators[static_cast<std::size_t>(camera)].translate(trigger, stripe, result);
        },
        // No start from an earlier profile: what is lost or late must not change what is measured next.
        [this](const RailBegin& rail, const Profile& profile, Registration& registration, Measurement& measurement) {
          const auto correlated = static_cast<double>(profile.correlatedPoints);
          registrar.registerProfile(profile.points, registration, {}, correlated);
          matcher.check(profile.points, correlated, registration);
          measurer.measure(profile, registration, {rail.temperatureC, rail.temperatureUncertaintyC}, measurement);
        }};
  }

  Recipe recipe;
  RigCalibration calibration;
  std::vector<StripeExtractor> extractors;
  std::vector<Translator> translators;
  Registrar registrar;
  RailMatcher matcher;
  Measurer measurer;
  std::unique_ptr<Pipeline> pipeline;  // last: its threads end before what they use
};

Inspection::Inspection(FrameSource& source, Recipe recipe, RigCalibration calibration, InspectionObserver observer,
                       InspectionSettings settings)
    : impl_(std::make_unique<Impl>(source, std::move(recipe), std::move(calibration), std::move(observer), settings)) {}

Inspection::~Inspection() = default;

void Inspection::start() { impl_->pipeline->start(); }
void Inspection::stop() { impl_->pipeline->stop(); }
void Inspection::wait() { impl_->pipeline->wait(); }
bool Inspection::running() const { return impl_->pipeline->running(); }
std::vector<StageStatistics> Inspection::stages() const { return impl_->pipeline->stages(); }
TriggerLedger Inspection::triggers() const { return impl_->pipeline->triggers(); }

}  // namespace vignole
