#include "gui/quality/rig_experiment.h"

#include <cmath>

#include "engine/inspection/inspection.h"

namespace vignole {

namespace {

constexpr int kTickMs = 100;
constexpr std::uint64_t kFirstPassSeed = 1001;
/// The rig's truth is computed, not measured: what it lacks is rounding.
constexpr double kTruthUMm = 1e-6;

}  // namespace

RigExperiment::RigExperiment(QObject* parent) : QObject(parent) {
  ticks_.setInterval(kTickMs);
  connect(&ticks_, &QTimer::timeout, this, [this] { emit progressed(static_cast<int>(100 * done_ / all_)); });
}

RigExperiment::~RigExperiment() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

void RigExperiment::start(VirtualRigSettings rig, Recipe recipe, double lengthMm, int runs) {
  if (running_) return;
  running_ = true;
  done_ = 0;
  all_ = static_cast<std::uint64_t>(std::max(1.0, runs * lengthMm / rig.spacingMm));
  ticks_.start();
  thread_ = std::jthread(
      [this, rig = std::move(rig), recipe = std::move(recipe), lengthMm, runs](const std::stop_token& stop) {
        work(stop, rig, recipe, lengthMm, runs);
        QMetaObject::invokeMethod(
            this,
            [this] {
              {
                const std::lock_guard lock(mutex_);
                result_ = std::move(made_);
                made_ = {};
              }
              running_ = false;
              ticks_.stop();
              emit progressed(100);
              emit finished();
            },
            Qt::QueuedConnection);
      });
}

void RigExperiment::cancel() { thread_.request_stop(); }

void RigExperiment::work(const std::stop_token& stop, VirtualRigSettings settings, const Recipe& recipe,
                         double lengthMm, int runs) {
  RigExperimentResult made;
  settings.rigSeed = settings.rigSeed.value_or(settings.seed);
  for (int run = 0; run < runs && made.problem.empty(); ++run) {
    settings.passSeed = kFirstPassSeed + static_cast<std::uint64_t>(run);
    const auto rig = VirtualRig::create(settings);
    if (!rig) {
      made.problem = rig.error().message();
      break;
    }
    VirtualSourceSettings source;
    source.lengthMm = lengthMm;
    const auto frames = makeVirtualSource(*rig, source);
    std::vector<ProfileRecord> profiles;
    std::string ended;
    InspectionObserver observer;
    observer.profileMeasured = [&](const ProfileResult& profile) {
      profiles.push_back(recordOf(profile.profile, profile.registration, profile.measurement));
      ++done_;
    };
    observer.ended = [&](const std::string& error) { ended = error; };
    Inspection inspection(*frames, recipe, (*rig)->calibration(), std::move(observer));
    {
      const std::stop_callback cancelled(stop, [&] { inspection.stop(); });
      inspection.start();
      inspection.wait();
    }
    if (stop.stop_requested()) {
      made.problem = "cancelled";
      break;
    }
    if (!ended.empty()) made.problem = ended;
    made.runs.push_back(runOf(std::to_string(run + 1), profiles));
    if (run > 0) continue;  // the rail is the same in every run, and with it the truth
    for (const ProfileRecord& profile : profiles) {
      const Truth truth = (*rig)->truth(profile.trigger);
      for (std::size_t d = 0; d < kDimensionCount; ++d)
        if (std::isfinite(truth.valueMm[d]))
          made.truth.points[d].push_back({profile.positionMm / 1000, truth.valueMm[d], kTruthUMm});
    }
  }
  const std::lock_guard lock(mutex_);
  made_ = std::move(made);
}

}  // namespace vignole
