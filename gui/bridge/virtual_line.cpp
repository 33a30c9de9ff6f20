#include "gui/bridge/virtual_line.h"

#include <future>
#include <limits>
#include <mutex>
#include <utility>

#include "engine/acquisition/rail_gate.h"
#include "gui/bridge/rail_recorder.h"
#include "gui/bridge/rail_watch.h"

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
  VirtualLineSettings settings;
  std::shared_ptr<const VirtualRig> rig;
  RailWatch watch;
  RailAnnouncements announcements;
  // The inspection uses source and watch: it is declared last and goes first.
  std::shared_ptr<LatestFrames> frames = std::make_shared<LatestFrames>();
  std::optional<StripeSettings> nextStripe;
  std::unique_ptr<FrameSource> source;
  std::unique_ptr<RailGate> gate;
  std::unique_ptr<Inspection> inspection;
  std::future<std::unique_ptr<Inspection>> nextInspection;  ///< of the rail behind the gate
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

  [[nodiscard]] InspectionObserver observer(const Recipe& recipe);
  /// A change waits for the end of the running rail, or has just met it.
  [[nodiscard]] bool changing() const {
    return nextInspection.valid() && !stopAsked && watch.ended().value_or("").empty();
  }
  void takeTurns();

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

void VirtualLine::start() {
  Impl& i = *impl_;
  if (running()) return;
  i.nextInspection = {};
  i.inspection.reset();  // joins what has ended; before its source goes
  if (i.starts > 0 || i.rig->settings().exposureMs != i.settings.rig.exposureMs) {
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
  i.gate = std::make_unique<RailGate>(*i.source);
  i.frames->restart();
  if (i.nextStripe) i.settings.recipe.stripe = *std::exchange(i.nextStripe, std::nullopt);
  i.watch.restart();
  i.stopAsked = false;
  ++i.starts;
  i.inspection =
      std::make_unique<Inspection>(*i.gate, i.settings.recipe, i.rig->calibration(), i.observer(i.settings.recipe));
  i.inspection->start();
}

InspectionObserver VirtualLine::Impl::observer(const Recipe& recipe) {
  InspectionObserver told = tapped(watch.observer(), frames);
  if (writer == nullptr) return told;
  auto setup = std::make_shared<MeasuringSetup>(MeasuringSetup{recipe, rig->calibration()});
  const auto papersOf = [this](const RailBegin& rail) {
    const RailAnnouncement known = announcements.taken(rail.firstTrigger);
    RailPapers papers;
    papers.strand = known.strand;
    papers.orderNumber = known.order;
    return papers;
  };
  return recorded(std::move(told), *writer, std::move(setup), papersOf, [this] { return inspection->stages(); });
}

void VirtualLine::useStripeSettings(const StripeSettings& settings) {
  Impl& i = *impl_;
  i.nextStripe = settings;
  if (!running()) return;
  Recipe next = i.settings.recipe;
  next.stripe = settings;
  // Made ready while the rail still runs: between two rails there is no time for it.
  i.nextInspection = std::async(std::launch::async, [gate = i.gate.get(), next, calibration = i.rig->calibration(),
                                                     observer = i.observer(next)]() mutable {
    return std::make_unique<Inspection>(*gate, std::move(next), std::move(calibration), std::move(observer));
  });
  i.gate->close();
}

void VirtualLine::Impl::takeTurns() {
  if (!changing() || inspection->running()) return;
  if (nextInspection.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  inspection.reset();
  inspection = nextInspection.get();
  settings.recipe.stripe = *std::exchange(nextStripe, std::nullopt);
  watch.restart();
  gate->open();
  inspection->start();
}

PictureAgain VirtualLine::pictureAgain() {
  return
      [pictures = std::make_shared<PicturesOfRig>(impl_->rig)](int camera, std::uint64_t trigger, double exposureMs) {
        return pictures->picture(camera, trigger, exposureMs);
      };
}

std::optional<double> VirtualLine::exposureMs() const { return impl_->rig->settings().exposureMs; }
void VirtualLine::useExposure(double exposureMs) { impl_->settings.rig.exposureMs = exposureMs; }

std::shared_ptr<LatestFrames> VirtualLine::frames() { return impl_->frames; }
RigCalibration VirtualLine::calibration() { return impl_->rig->calibration(); }

void VirtualLine::record(RailWriter* writer) { impl_->writer = writer; }

RailAnnouncements* VirtualLine::announcements() { return &impl_->announcements; }

void VirtualLine::stop() {
  impl_->stopAsked = true;
  if (impl_->inspection) impl_->inspection->stop();
}

bool VirtualLine::running() const { return impl_->inspection && (impl_->inspection->running() || impl_->changing()); }

const LineSnapshot& VirtualLine::pull(PullDetail detail) {
  Impl& i = *impl_;
  if (i.inspection) i.takeTurns();
  i.watch.fill(i.snapshot, detail, RailWatch::Clock::now());
  i.snapshot.state = i.state();
  if (detail == PullDetail::Everything && i.inspection) {
    i.snapshot.stages = i.inspection->stages();
    i.snapshot.triggers = i.inspection->triggers();
    i.snapshot.nextStripe = i.nextStripe;
    i.snapshot.error = i.watch.ended().value_or("");
  }
  return i.snapshot;
}

}  // namespace vignole
