#include "gui/bridge/virtual_line.h"

#include <limits>
#include <utility>

#include "gui/bridge/rail_recorder.h"
#include "gui/bridge/rail_watch.h"

namespace vignole {

namespace {
/// Without a profile for so long, with a rail in the gauge, the line is silent: the threshold of a stale value.
constexpr double kSilentS = 1.0;
}  // namespace

struct VirtualLine::Impl {
  VirtualLineSettings settings;
  std::shared_ptr<const VirtualRig> rig;
  RailWatch watch;
  RailAnnouncements announcements;
  // The inspection uses source and watch: it is declared last and goes first.
  std::shared_ptr<LatestFrames> frames = std::make_shared<LatestFrames>();
  std::optional<StripeSettings> nextStripe;
  std::optional<Recipe> nextRecipe;
  std::optional<VirtualRigSettings> nextRig;  ///< of nextRecipe
  std::unique_ptr<FrameSource> source, tap;
  std::unique_ptr<Inspection> inspection;
  RailWriter* writer = nullptr;
  std::uint64_t starts = 0;
  bool stopAsked = false;
  LineSnapshot snapshot;

  Impl(VirtualLineSettings s, std::shared_ptr<const VirtualRig> r)
      : settings(std::move(s)), rig(std::move(r)), watch(settings.recipe, rig->calibration().id) {
    snapshot.recipe = &settings.recipe;
    snapshot.calibrationMethod = rig->calibration().method;
    snapshot.expectedPerS = settings.rig.speedMmPerS / settings.rig.spacingMm;
  }

  [[nodiscard]] LineState state() const {
    if (starts == 0) return LineState::Idle;
    if (const auto end = watch.ended(); end && !end->empty() && !stopAsked) return LineState::Fault;
    if (!inspection->running()) return LineState::Stopped;
    if (!watch.railUnderWay() || !snapshot.latest) return LineState::Armed;
    return snapshot.ageS > kSilentS ? LineState::Silent : LineState::Measuring;
  }
};

Expected<std::unique_ptr<VirtualLine>> VirtualLine::create(const VirtualLineSettings& settings) {
  auto rig = VirtualRig::create(settings.rig);
  if (!rig) return tl::unexpected(rig.error());
  return std::unique_ptr<VirtualLine>(new VirtualLine(std::make_unique<Impl>(settings, *std::move(rig))));
}

VirtualLine::VirtualLine(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VirtualLine::~VirtualLine() = default;

void VirtualLine::start() {
  Impl& i = *impl_;
  if (running()) return;
  i.inspection.reset();  // joins what has ended; before its source goes
  if (i.nextRecipe) {
    // In place: who draws the section refers to it. What was measured against another one is no longer shown.
    i.settings.recipe = *std::exchange(i.nextRecipe, std::nullopt);
    i.settings.rig = *std::exchange(i.nextRig, std::nullopt);
    if (auto rig = VirtualRig::create(i.settings.rig)) i.rig = *std::move(rig);
    i.watch.forget();
    i.snapshot.latest.reset();
    i.snapshot.rail.reset();
    i.snapshot.nextRecipe.clear();
  }
  if (i.starts > 0) {
    // The same rig sees another rail, as a mill would: only the seed of the rail moves on.
    VirtualRigSettings next = i.settings.rig;
    next.rigSeed = i.settings.rig.rigSeed.value_or(i.settings.rig.seed);
    next.seed = i.settings.rig.seed + i.starts;
    if (auto rig = VirtualRig::create(next)) i.rig = *std::move(rig);
  }
  VirtualSourceSettings source;
  source.rails = std::numeric_limits<int>::max();
  source.lengthMm = i.settings.railLengthMm;
  source.paced = true;
  i.announcements.restart();
  i.source = announced(makeVirtualSource(i.rig, source), i.announcements);
  i.tap = std::make_unique<FrameTap>(*i.source, i.frames);
  if (i.nextStripe) i.settings.recipe.stripe = *std::exchange(i.nextStripe, std::nullopt);
  i.watch.restart();
  i.stopAsked = false;
  ++i.starts;
  InspectionObserver observer = i.watch.observer();
  if (i.writer != nullptr) {
    auto setup = std::make_shared<MeasuringSetup>(MeasuringSetup{i.settings.recipe, i.rig->calibration()});
    const auto papersOf = [&i](const RailBegin& rail) {
      const RailAnnouncement known = i.announcements.taken(rail.firstTrigger);
      RailPapers papers;
      papers.strand = known.strand;
      papers.orderNumber = known.order;
      return papers;
    };
    observer =
        recorded(std::move(observer), *i.writer, std::move(setup), papersOf, [&i] { return i.inspection->stages(); });
  }
  i.inspection = std::make_unique<Inspection>(*i.tap, i.settings.recipe, i.rig->calibration(), std::move(observer));
  i.inspection->start();
}

std::shared_ptr<LatestFrames> VirtualLine::frames() { return impl_->frames; }
RigCalibration VirtualLine::calibration() { return impl_->rig->calibration(); }
void VirtualLine::useStripeSettings(const StripeSettings& settings) { impl_->nextStripe = settings; }

Expected<void> VirtualLine::useRecipe(const Recipe& recipe) {
  Impl& i = *impl_;
  VirtualRigSettings rig = i.settings.rig;
  rig.rigSeed = rig.rigSeed.value_or(rig.seed);
  if (rig.section.name == i.settings.recipe.section.name) {
    rig.section = recipe.section;
    rig.parameters = recipe.parameters;
  }
  if (const auto possible = VirtualRig::create(rig); !possible) return tl::unexpected(possible.error());
  i.nextRecipe = recipe;
  i.nextRig = std::move(rig);
  i.nextStripe.reset();
  i.snapshot.nextRecipe = recipe.name + " v" + std::to_string(recipe.version);
  return {};
}

void VirtualLine::record(RailWriter* writer) { impl_->writer = writer; }

RailAnnouncements* VirtualLine::announcements() { return &impl_->announcements; }

void VirtualLine::stop() {
  impl_->stopAsked = true;
  if (impl_->inspection) impl_->inspection->stop();
}

bool VirtualLine::running() const { return impl_->inspection && impl_->inspection->running(); }

const LineSnapshot& VirtualLine::pull(PullDetail detail) {
  Impl& i = *impl_;
  i.watch.fill(i.snapshot, detail, RailWatch::Clock::now());
  i.snapshot.state = i.state();
  if (detail == PullDetail::Everything && i.inspection) {
    i.snapshot.stages = i.inspection->stages();
    i.snapshot.triggers = i.inspection->triggers();
    i.snapshot.error = i.watch.ended().value_or("");
  }
  return i.snapshot;
}

}  // namespace vignole
