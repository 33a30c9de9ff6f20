#include "engine/inspection/inspection.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/inspection/pipeline.h"
#include "engine/inspection/profile_measurement.h"
#include "engine/profile/stripe_optics.h"
#include "engine/profile/translate.h"
#include "engine/stripe/stripe_extractor.h"

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

}  // namespace

StripeOptics extractionOptics(const RigCalibration& calibration, const Section& section, int camera) {
  return stripeOptics(calibration.rangeFinders[static_cast<std::size_t>(camera)], fieldAround(section));
}

struct Inspection::Impl {
  Impl(FrameSource& source, Recipe chosenRecipe, RigCalibration rig, InspectionObserver observer,
       const InspectionSettings& settings)
      : recipe(std::move(chosenRecipe)), calibration(std::move(rig)), profileMeasurement(recipe, calibration) {
    for (std::size_t c = 0; c < kCameraCount; ++c) {
      extractors.emplace_back(recipe.stripe, extractionOptics(calibration, recipe.section, static_cast<int>(c)));
      translators.emplace_back(static_cast<int>(c), calibration.rangeFinders[c]);
    }
    pipeline = std::make_unique<Pipeline>(source, work(), std::move(observer), settings);
  }

  PipelineWork work() {
    return {[this](int camera, const ImageView& image, StripeResult& result) {
              extractors[static_cast<std::size_t>(camera)].extract(image, result);
            },
            [this](int camera, std::uint64_t trigger, const StripeResult& stripe, PartialContour& result) {
              translators[static_cast<std::size_t>(camera)].translate(trigger, stripe, result);
            },
            [this](const RailBegin& rail, const Profile& profile, Registration& registration,
                   Measurement& measurement) { profileMeasurement.measure(rail, profile, registration, measurement); }};
  }

  Recipe recipe;
  RigCalibration calibration;
  std::vector<StripeExtractor> extractors;
  std::vector<Translator> translators;
  ProfileMeasurement profileMeasurement;
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
