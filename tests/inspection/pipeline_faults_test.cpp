// Random faults of every kind: whatever happens, every trigger is accounted for once, profiles come in order with the
// right pictures, and what comes out depends neither on timing nor on the size of the queues.

#include <gtest/gtest.h>
#include <random>
#include <sstream>
#include <thread>

#include "engine/inspection/pipeline.h"
#include "tests/inspection/scripted_source.h"

namespace vignole {
namespace {

using namespace vignole::testing;

struct Faulty {
  Scripts scripts;
  std::uint64_t triggers = 0;  ///< of all rails
};

Faulty faultyRails(unsigned seed) {
  std::mt19937 random(seed);
  const auto chance = [&](double p) { return std::bernoulli_distribution(p)(random); };
  Faulty all;
  std::uint64_t first = random() % 3;
  const int rails = 1 + static_cast<int>(random() % 3);
  std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges;
  for (int r = 0; r < rails; ++r) {
    const std::uint64_t end = first + random() % 120;
    ranges.emplace_back(first, end);
    all.triggers += end - first;
    first = end + (chance(0.5) ? 0 : random() % 50);
  }
  const bool dies = chance(0.3);
  for (int c = 0; c < 4; ++c) {
    Script& script = all.scripts[static_cast<std::size_t>(c)];
    const bool thisDies = dies && c == static_cast<int>(seed % 4);
    for (const auto& [from, to] : ranges) {
      script.emplace_back(rail(from));
      for (std::uint64_t t = from; t < to; ++t) {
        if (thisDies && t > (ranges.back().first + ranges.back().second) / 2) {
          script.emplace_back(SourceEnd{"camera gone"});
          break;
        }
        if (chance(0.03)) continue;
        if (chance(0.03)) {
          script.emplace_back(FrameLost{c, t, "frame lost"});
          continue;
        }
        script.emplace_back(frame(c, t));
        if (chance(0.02)) script.emplace_back(frame(c, t));
        if (chance(0.02) && t > from + 3) script.emplace_back(frame(c, t - 1 - random() % 3));
      }
      if (!script.empty() && std::holds_alternative<SourceEnd>(script.back())) break;
      script.emplace_back(RailEnd{to});
    }
  }
  return all;
}

/// Everything that was told, the ledgers included, as text.
std::string digest(const Told& told, const TriggerLedger& total) {
  std::ostringstream text;
  for (const std::string& event : told.events) text << event << '\n';
  for (std::size_t i = 0; i < told.values.size(); ++i) {
    text << told.values[i] << ' ' << told.positionsMm[i];
    for (const auto& missing : told.profiles[i].missing) text << ' ' << missing;
    text << '\n';
  }
  auto ledgers = told.ledgers;
  ledgers.push_back(total);
  for (const TriggerLedger& ledger : ledgers) {
    text << ledger.seen << ' ' << ledger.measured << ' ' << ledger.incomplete << ' ' << ledger.lost << '\n';
    for (const auto& [reason, count] : ledger.reasons) text << "  " << reason << ' ' << count << '\n';
  }
  return text.str();
}

class PipelineFaults : public ::testing::TestWithParam<unsigned> {};

TEST_P(PipelineFaults, EveryTriggerIsAccountedForWhateverTheQueuesAndTheTiming) {
  const unsigned seed = GetParam();
  const Faulty faulty = faultyRails(seed);
  std::string reference;
  for (const InspectionSettings settings :
       {InspectionSettings{16, 64}, InspectionSettings{1, 1}, InspectionSettings{64, 500}}) {
    ScriptedSource source(faulty.scripts);
    std::array<std::mt19937, 4> random;
    for (unsigned c = 0; c < 4; ++c) random[c].seed(seed * 77 + c + static_cast<unsigned>(settings.queueCapacity));
    source.before = [&](int camera, std::size_t) {
      for (unsigned spin = random[static_cast<std::size_t>(camera)]() % 4; spin > 0; --spin) std::this_thread::yield();
    };
    Told told;
    Pipeline pipeline(source, simpleWork(), told.observer(), settings);
    pipeline.start();
    pipeline.wait();
    const TriggerLedger ledger = pipeline.triggers();
    EXPECT_EQ(ledger.seen, faulty.triggers);
    EXPECT_EQ(ledger.seen, ledger.measured + ledger.incomplete + ledger.lost);
    EXPECT_EQ(ledger.measured + ledger.incomplete, told.triggers.size());
    TriggerLedger sum;
    for (const TriggerLedger& rail : told.ledgers) {
      sum.seen += rail.seen;
      sum.measured += rail.measured;
      sum.incomplete += rail.incomplete;
      sum.lost += rail.lost;
      EXPECT_EQ(rail.seen, rail.measured + rail.incomplete + rail.lost);
    }
    EXPECT_EQ(sum.seen, ledger.seen);
    for (std::size_t i = 0; i < told.profiles.size(); ++i) {
      const Profile& profile = told.profiles[i];
      if (i > 0) {
        EXPECT_LT(told.triggers[i - 1], told.triggers[i]);
      }
      for (const ProfilePoint& point : profile.points) {
        EXPECT_EQ(point.x, static_cast<double>(profile.trigger));
        EXPECT_EQ(point.y, static_cast<double>(point.camera));
      }
    }
    const std::string told_ = digest(told, ledger);
    if (reference.empty()) reference = told_;
    EXPECT_EQ(told_, reference) << "capacity " << settings.queueCapacity;
  }
}

TEST_P(PipelineFaults, LiveEverySumHoldsToo) {
  const Faulty faulty = faultyRails(GetParam());
  ScriptedSource source(faulty.scripts);
  source.isLive = true;
  Told told;
  Pipeline pipeline(source, simpleWork(), told.observer(), {2, 10});
  pipeline.start();
  pipeline.wait();
  const TriggerLedger ledger = pipeline.triggers();
  EXPECT_EQ(ledger.seen, faulty.triggers);
  EXPECT_EQ(ledger.seen, ledger.measured + ledger.incomplete + ledger.lost);
  EXPECT_EQ(ledger.measured + ledger.incomplete, told.triggers.size());
  for (std::size_t i = 1; i < told.triggers.size(); ++i) EXPECT_LT(told.triggers[i - 1], told.triggers[i]);
  for (const Profile& profile : told.profiles)
    for (const ProfilePoint& point : profile.points) EXPECT_EQ(point.x, static_cast<double>(profile.trigger));
}

INSTANTIATE_TEST_SUITE_P(Seeds, PipelineFaults, ::testing::Range(1U, 41U));

}  // namespace
}  // namespace vignole
