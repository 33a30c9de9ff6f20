#include "gui/bridge/virtual_line.h"

#include <future>
#include <limits>
#include <mutex>
#include <utility>

#include "engine/acquisition/rail_gate.h"
#include "gui/bridge/rail_recorder.h"
#include "gui/bridge/rail_watch.h"
#include "gui/bridge/seam_watch.h"

namespace vignole {

namespace {
/// Without a profile for so long, with a rail in the gauge, the line is silent: the threshold of a stale value.
constexpr double kSilentS = 1.0;

/// The rig, and beside it the same with one other exposure at a time.
class PicturesOfRig {
 public:
  explicit PicturesOfRig(std::shared_ptr<const VirtualRig> rig) : rig_(std::move(rig)) {}

  [[nodiscard]] std::optional<Frame> picture(int camera, std::uint64_t trigger, double exposureMs) {
    const std::shared_ptr<const VirtualRig> rig = exposed(exposureMs);
    if (!rig) return {};
    const Intrinsics& in = rig->calibration().rangeFinders[static_cast<std::size_t>(camera)].intrinsics;
    const auto pixels = std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(in.widthPx) *
                                                                    static_cast<std::size_t>(in.heightPx));
    const MutableImageView image{pixels->data(), in.widthPx, in.heightPx, in.widthPx};
    rig->render(camera, trigger, image);
    return Frame{camera, trigger, image, pixels};
  }

 private:
  std::shared_ptr<const VirtualRig> exposed(double exposureMs) {
    VirtualRigSettings settings = rig_->settings();
    if (exposureMs <= 0 || exposureMs == settings.exposureMs) return rig_;
    const std::lock_guard lock(mutex_);
    if (!other_ || other_->settings().exposureMs != exposureMs) {
      settings.exposureMs = exposureMs;
      auto made = VirtualRig::create(settings);
      other_ = made ? *std::move(made) : nullptr;
    }
    return other_;
  }

  std::shared_ptr<const VirtualRig> rig_, other_;
  std::mutex mutex_;
};
}  // namespace

struct VirtualLine::Impl {
  /// What the next rail is measured with.
  struct Change {
    Recipe recipe;
    std::shared_ptr<const RigCalibration> calibration;
    std::optional<VirtualRigSettings> rig;      ///< the rail that is rendered is another: its settings,
    std::shared_ptr<const VirtualRig> nextRig;  ///< and it itself
  };

  VirtualLineSettings settings;
  std::shared_ptr<const VirtualRig> rig;
  std::shared_ptr<const RigCalibration> calibration;
  RailWatch watch;
  SeamWatch seams;
  RailAnnouncements announcements;
  // The inspection uses source and watch: it is declared behind them and goes first.
  std::shared_ptr<LatestFrames> frames = std::make_shared<LatestFrames>();
  std::unique_ptr<FrameSource> source;
  std::unique_ptr<RailGate> gate;
  std::unique_ptr<Inspection> inspection;
  std::optional<Change> next;
  /// Of the rail behind the gate, made while the running one goes on: between two rails there is no time for it. Null
  /// where another rail is rendered: that begins anew.
  std::future<std::unique_ptr<Inspection>> ready;
  RailWriter* writer = nullptr;
  std::uint64_t starts = 0;
  bool stopAsked = false;
  LineSnapshot snapshot;

  Impl(VirtualLineSettings s, std::shared_ptr<const VirtualRig> r)
      : settings(std::move(s)),
        rig(std::move(r)),
        calibration(std::make_shared<const RigCalibration>(rig->calibration())),
        watch(settings.recipe, calibration->id),
        seams(settings.recipe.section) {
    snapshot.recipe = &settings.recipe;
    snapshot.calibrationMethod = calibration->method;
    snapshot.expectedPerS = settings.rig.speedMmPerS / settings.rig.spacingMm;
  }

  [[nodiscard]] Change change() const { return next ? *next : Change{settings.recipe, calibration, {}, nullptr}; }
  void ask(Change wanted);
  /// `next` comes into force: between two inspections.
  void changeOver();
  void takeTurns();
  void begin();
  [[nodiscard]] VirtualRigSettings rigOfThisStart() const;
  [[nodiscard]] InspectionObserver observer(const Recipe& recipe, const RigCalibration& calibration);

  /// A change waits for the end of the running rail, or has just met it.
  [[nodiscard]] bool changing() const { return ready.valid() && !stopAsked && watch.ended().value_or("").empty(); }
  [[nodiscard]] bool running() const { return inspection && (inspection->running() || changing()); }

  [[nodiscard]] LineState state() const {
    if (starts == 0) return LineState::Idle;
    if (const auto end = watch.ended(); end && !end->empty() && !stopAsked) return LineState::Fault;
    if (!inspection->running() && !changing()) return LineState::Stopped;
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

/// The same rig sees another rail after each start, as a mill would: only the seed of the rail moves on.
VirtualRigSettings VirtualLine::Impl::rigOfThisStart() const {
  VirtualRigSettings now = settings.rig;
  now.rigSeed = settings.rig.rigSeed.value_or(settings.rig.seed);
  now.seed = settings.rig.seed + starts;
  return now;
}

void VirtualLine::start() {
  Impl& i = *impl_;
  if (running()) return;
  i.ready = {};
  i.inspection.reset();  // joins what has ended; before its source goes
  const bool rendersOther =
      i.starts > 0 || (i.next && i.next->rig) || i.rig->settings().exposureMs != i.settings.rig.exposureMs;
  i.changeOver();
  if (rendersOther)
    if (auto rig = VirtualRig::create(i.rigOfThisStart())) i.rig = *std::move(rig);
  i.stopAsked = false;
  i.begin();
}

void VirtualLine::Impl::changeOver() {
  if (!next) return watch.restart(calibration->id);
  const Change now = *std::exchange(next, std::nullopt);
  const bool otherSection = settings.recipe.section.name != now.recipe.section.name;
  if (now.recipe.name != settings.recipe.name || otherSection) {
    // What was measured against another recipe is no longer shown.
    watch.forget();
    snapshot.latest.reset();
    snapshot.rail.reset();
  }
  const bool seamsAnew = now.calibration != calibration || otherSection;
  settings.recipe = now.recipe;  // in place: who draws the section refers to it
  if (now.rig) {
    settings.rig = *now.rig;
    rig = now.nextRig;
  }
  calibration = now.calibration;
  if (seamsAnew) seams.restart(settings.recipe.section);
  watch.restart(calibration->id);
  snapshot.calibrationMethod = calibration->method;
  snapshot.nextStripe.reset();
  snapshot.nextRecipe.clear();
}

void VirtualLine::Impl::begin() {
  VirtualSourceSettings rails;
  rails.rails = std::numeric_limits<int>::max();
  rails.lengthMm = settings.railLengthMm;
  rails.paced = true;
  announcements.restart();
  source = announced(makeVirtualSource(rig, rails), announcements);
  gate = std::make_unique<RailGate>(*source);
  frames->restart();
  ++starts;
  inspection =
      std::make_unique<Inspection>(*gate, settings.recipe, *calibration, observer(settings.recipe, *calibration));
  inspection->start();
}

InspectionObserver VirtualLine::Impl::observer(const Recipe& recipe, const RigCalibration& measuresWith) {
  InspectionObserver told = tapped(seams.watched(watch.observer()), frames);
  if (writer == nullptr) return told;
  auto setup = std::make_shared<MeasuringSetup>(MeasuringSetup{recipe, measuresWith});
  const auto papersOf = [this](const RailBegin& rail) {
    const RailAnnouncement known = announcements.taken(rail.firstTrigger);
    RailPapers papers;
    papers.strand = known.strand;
    papers.orderNumber = known.order;
    return papers;
  };
  return recorded(std::move(told), *writer, std::move(setup), papersOf, [this] { return inspection->stages(); });
}

void VirtualLine::Impl::ask(Change wanted) {
  next = std::move(wanted);
  if (!running() || stopAsked) return;
  if (next->nextRig) {
    std::promise<std::unique_ptr<Inspection>> none;
    none.set_value(nullptr);
    ready = none.get_future();
  } else {
    ready = std::async(std::launch::async, [from = gate.get(), recipe = next->recipe, with = *next->calibration,
                                            told = observer(next->recipe, *next->calibration)]() mutable {
      return std::make_unique<Inspection>(*from, std::move(recipe), std::move(with), std::move(told));
    });
  }
  gate->close();
}

void VirtualLine::Impl::takeTurns() {
  if (!changing() || inspection->running()) return;
  if (ready.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  inspection.reset();
  auto behindTheGate = ready.get();
  changeOver();
  if (behindTheGate) {
    inspection = std::move(behindTheGate);
    gate->open();
    inspection->start();
  } else {
    begin();
  }
}

void VirtualLine::useStripeSettings(const StripeSettings& settings) {
  Impl::Change wanted = impl_->change();
  wanted.recipe.stripe = settings;
  impl_->snapshot.nextStripe = settings;
  impl_->ask(std::move(wanted));
}

void VirtualLine::useCalibration(const RigCalibration& calibration) {
  Impl::Change wanted = impl_->change();
  wanted.calibration = std::make_shared<const RigCalibration>(calibration);
  impl_->ask(std::move(wanted));
}

Expected<void> VirtualLine::useRecipe(const Recipe& recipe) {
  Impl& i = *impl_;
  Impl::Change wanted = i.change();
  VirtualRigSettings rig = wanted.rig.value_or(i.settings.rig);
  rig.rigSeed = rig.rigSeed.value_or(rig.seed);
  // A rail that is rendered wrong on purpose stays wrong.
  const bool right = rig.section.name == wanted.recipe.section.name;
  if (right && toJson(recipe.section) != toJson(rig.section)) {
    rig.section = recipe.section;
    rig.parameters = recipe.parameters;
    VirtualRigSettings next = rig;
    next.seed += i.starts;
    auto made = VirtualRig::create(std::move(next));
    if (!made) return tl::unexpected(made.error());
    wanted.nextRig = *std::move(made);
    wanted.rig = std::move(rig);
  }
  wanted.recipe = recipe;
  i.snapshot.nextStripe.reset();
  i.snapshot.nextRecipe = recipe.name + " v" + std::to_string(recipe.version);
  i.ask(std::move(wanted));
  return {};
}

PictureAgain VirtualLine::pictureAgain() {
  return
      [pictures = std::make_shared<PicturesOfRig>(impl_->rig)](int camera, std::uint64_t trigger, double exposureMs) {
        return pictures->picture(camera, trigger, exposureMs);
      };
}

std::optional<double> VirtualLine::exposureMs() const { return impl_->rig->settings().exposureMs; }
void VirtualLine::useExposure(double exposureMs) {
  impl_->settings.rig.exposureMs = exposureMs;
  if (impl_->next && impl_->next->rig) impl_->next->rig->exposureMs = exposureMs;
}

std::shared_ptr<LatestFrames> VirtualLine::frames() { return impl_->frames; }
RigCalibration VirtualLine::calibration() { return impl_->next ? *impl_->next->calibration : *impl_->calibration; }

void VirtualLine::record(RailWriter* writer) { impl_->writer = writer; }

RailAnnouncements* VirtualLine::announcements() { return &impl_->announcements; }

void VirtualLine::stop() {
  impl_->stopAsked = true;
  if (impl_->inspection) impl_->inspection->stop();
}

bool VirtualLine::running() const { return impl_->running(); }

std::optional<std::uint64_t> VirtualLine::virtualRigSeed() const {
  return impl_->settings.rig.rigSeed.value_or(impl_->settings.rig.seed);
}

const LineSnapshot& VirtualLine::pull(PullDetail detail) {
  Impl& i = *impl_;
  if (i.inspection) i.takeTurns();
  i.watch.fill(i.snapshot, detail, RailWatch::Clock::now());
  i.snapshot.state = i.state();
  if (detail == PullDetail::Everything && i.inspection) {
    i.snapshot.stages = i.inspection->stages();
    i.snapshot.triggers = i.inspection->triggers();
    i.snapshot.error = i.watch.ended().value_or("");
    i.snapshot.drift = i.seams.track();
  }
  return i.snapshot;
}

}  // namespace vignole
