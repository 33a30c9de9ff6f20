#include "engine/archive/generated_rails.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <map>
#include <mutex>
#include <numbers>
#include <optional>
#include <thread>

#include "engine/archive/archive.h"
#include "engine/archive/passing_rail.h"
#include "engine/measurement/verdict.h"

namespace vignole {

namespace {

constexpr double kUMm = 0.005;
constexpr std::size_t kRailsAtOnce = 32;
const MeasuringPlace kPlace{"generated", "generated", "", ""};

/// Half of what is allowed, or a twentieth of a mm where nothing is judged.
double halfTolerance(const ToleranceLimits& limits) {
  const double lower = limits.lowerMm ? -*limits.lowerMm : limits.upperMm.value_or(0.05);
  const double upper = limits.upperMm ? *limits.upperMm : lower;
  return std::max(0.01, std::min(lower, upper));
}

}  // namespace

RailGenerator::RailGenerator(const Recipe& recipe, const GeneratedRails& settings)
    : recipe_(recipe),
      settings_(settings),
      profiles_(static_cast<std::size_t>(std::max(1.0, std::floor(1000 * settings.lengthM / settings.spacingMm)))) {
  const auto nominals = nominalDimensions(recipe.section, recipe.parameters);
  for (std::size_t d = 0; d < kDimensionCount; ++d) {
    courses_[d].defined = nominals && (*nominals)[d].has_value();
    if (courses_[d].defined) courses_[d].nominalMm = *(*nominals)[d];
  }
}

RailBegin RailGenerator::begin(std::size_t rail) {
  std::seed_seq seeds{settings_.seed, settings_.seed >> 32U, static_cast<std::uint64_t>(rail)};
  random_.seed(seeds);
  normal_.reset();
  const auto uniform = [this] { return std::uniform_real_distribution<double>(0, 1)(random_); };
  for (std::size_t d = 0; d < kDimensionCount; ++d) {
    Course& c = courses_[d];
    const double half = halfTolerance(recipe_.limits[d]);
    c.uMm = kUMm * (0.8 + 0.4 * uniform());
    c.offsetMm = 0.12 * half * normal_(random_);
    c.waveMm = 0.05 * half * uniform();
    c.wavePhase = 2 * std::numbers::pi * uniform();
    c.bumpMm = 0;
  }
  bumpFrom_ = bumpTo_ = 0;
  if (uniform() < settings_.failingShare) {
    const std::size_t d = random_() % kDimensionCount;
    courses_[d].bumpMm = (uniform() < 0.5 ? -1 : 1) * (1.1 + uniform()) * halfTolerance(recipe_.limits[d]);
    bumpFrom_ = random_() % profiles_;
    bumpTo_ = bumpFrom_ + std::max<std::size_t>(5, profiles_ / 20);
  }
  RailBegin begin;
  begin.id = "G" + std::to_string(100000 + rail);
  begin.heat = "H" + std::to_string(5000 + rail / std::max<std::size_t>(settings_.railsPerHeat, 1));
  begin.sectionName = recipe_.section.name;
  begin.spacingMm = settings_.spacingMm;
  begin.lengthMm = 1000 * settings_.lengthM;
  begin.speedMmPerS = 1000;
  return begin;
}

void RailGenerator::measure(std::size_t profile, ProfileResult& result) {
  result.profile.trigger = profile;
  result.profile.positionMm = settings_.spacingMm * static_cast<double>(profile);
  Registration& r = result.registration;
  r.valid = true;
  r.rmsMm = 0.02 + 0.001 * normal_(random_);
  r.points = 2100;
  r.inliers = 2050 + static_cast<int>(random_() % 40);
  r.worldFromSection = {0.5 * std::sin(0.001 * static_cast<double>(profile)), 0.1 * normal_(random_),
                        1e-4 * normal_(random_)};
  const bool bump = profile >= bumpFrom_ && profile < bumpTo_;
  const double along = 2 * std::numbers::pi * static_cast<double>(profile) / 700;
  for (std::size_t d = 0; d < kDimensionCount; ++d) {
    const Course& c = courses_[d];
    DimensionResult& m = result.measurement.dimensions[d];
    m.nominalMm = c.nominalMm;
    if (!c.defined) {
      m.reason = "not defined on this section";
      continue;
    }
    m.uMm = c.uMm * (1 + 0.02 * normal_(random_));
    const double deviation =
        c.offsetMm + c.waveMm * std::sin(along + c.wavePhase) + (bump ? c.bumpMm : 0) + m.uMm * normal_(random_);
    m.valueMm = c.nominalMm + deviation;
    m.points = 300;
    if (kDimensions[d] == Dimension::HF) {
      m.secondMm = c.nominalMm + deviation - 0.01;
      m.secondUMm = m.uMm;
    }
    judge(kDimensions[d], recipe_.limits[d], m);
  }
  result.measurement.verdict = worstOf(result.measurement.dimensions);
}

TriggerLedger RailGenerator::ledger() const {
  TriggerLedger ledger;
  ledger.seen = ledger.measured = profiles_;
  return ledger;
}

namespace {

/// Rails made on several threads, handed out in their order.
class RailMakers {
 public:
  RailMakers(const Recipe& recipe, const GeneratedRails& settings, std::shared_ptr<const MeasuringSetup> setup)
      : recipe_(recipe), settings_(settings), setup_(std::move(setup)) {
    const std::size_t makers = std::max(1U, std::thread::hardware_concurrency());
    for (std::size_t i = 0; i < makers; ++i) makers_.emplace_back([this](const std::stop_token& stop) { make(stop); });
  }
  ~RailMakers() {
    for (std::jthread& maker : makers_) maker.request_stop();
    changed_.notify_all();
  }
  RailMakers(const RailMakers&) = delete;
  RailMakers& operator=(const RailMakers&) = delete;

  [[nodiscard]] std::unique_ptr<PassingRail> take(std::size_t rail) {
    std::unique_lock held(mutex_);
    changed_.wait(held, [&] { return made_.count(rail) > 0; });
    auto taken = std::move(made_.extract(rail).mapped());
    wanted_ = rail + 1 + kMadeAhead;
    changed_.notify_all();
    return taken;
  }

 private:
  static constexpr std::size_t kMadeAhead = 16;

  void make(const std::stop_token& stop) {
    RailGenerator generator(recipe_, settings_);
    ProfileResult result;
    for (;;) {
      std::size_t rail = 0;
      {
        std::unique_lock held(mutex_);
        if (!changed_.wait(held, stop, [&] { return next_ < std::min(wanted_, settings_.rails); })) return;
        rail = next_++;
      }
      const TimeUs began = settings_.firstUs + static_cast<TimeUs>(1e6 * settings_.everyS * static_cast<double>(rail));
      const auto took = static_cast<TimeUs>(1e6 * settings_.lengthM);  // at 1 m/s
      auto passing = std::make_unique<PassingRail>(generator.begin(rail), RailPapers{}, setup_, kPlace,
                                                   settings_.points, 0, began);
      for (std::size_t p = 0; p < generator.profiles(); ++p) {
        generator.measure(p, result);
        passing->add(result, false);
      }
      passing->end(generator.ledger(), {}, RailState::Finished, began + took);
      passing->pack();
      const std::scoped_lock held(mutex_);
      made_.emplace(rail, std::move(passing));
      changed_.notify_all();
    }
  }

  const Recipe& recipe_;
  const GeneratedRails& settings_;
  const std::shared_ptr<const MeasuringSetup> setup_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::size_t next_ = 0, wanted_ = kMadeAhead;
  std::map<std::size_t, std::unique_ptr<PassingRail>> made_;
  std::vector<std::jthread> makers_;  ///< joined first
};

}  // namespace

Expected<void> generateRails(std::string_view url, const Recipe& recipe, const GeneratedRails& settings,
                             const std::function<bool(std::size_t)>& progress) {
  auto archive = Archive::open(url, Archive::Missing::Create);
  if (!archive) return tl::unexpected(archive.error());
  Database& database = *archive->database();
  MeasuringSetup setup{recipe, {}};
  setup.calibration.id = "generated";
  setup.calibration.method = "none (generated numbers)";
  RailMakers makers(recipe, settings, std::make_shared<const MeasuringSetup>(std::move(setup)));
  std::optional<Transaction> batch;  // the disk is waited for once in many rails
  for (std::size_t i = 0; i < settings.rails; ++i) {
    const auto rail = makers.take(i);
    const auto stored = guarded([&] {
      if (!batch) batch.emplace(database);
      rail->store(database, settings.firstUs);
      if ((i + 1) % kRailsAtOnce == 0) {
        batch->commit();
        batch.reset();
      }
    });
    if (!stored) return stored;
    if (progress && !progress(i + 1)) break;
  }
  return guarded([&] {
    if (batch) batch->commit();
  });
}

}  // namespace vignole
