#include "engine/inspection/pipeline.h"

#include <gtest/gtest.h>
#include <numeric>

#include "tests/inspection/scripted_source.h"

namespace vignole {
namespace {

using namespace vignole::testing;

struct Outcome {
  Told told;
  std::vector<StageStatistics> stages;
  TriggerLedger ledger;
};

Outcome run(Scripts scripts, InspectionSettings settings = {}) {
  Outcome r;
  ScriptedSource source(std::move(scripts));
  Pipeline pipeline(source, simpleWork(), r.told.observer(), settings);
  pipeline.start();
  pipeline.wait();
  r.stages = pipeline.stages();
  r.ledger = pipeline.triggers();
  EXPECT_FALSE(pipeline.running());
  return r;
}

void expectSums(const TriggerLedger& ledger) {
  EXPECT_EQ(ledger.seen, ledger.measured + ledger.incomplete + ledger.lost);
}

TEST(Pipeline, EveryTriggerOfARailComesOutOnceInOrderFromItsOwnPictures) {
  const Outcome r = run(wholeRail(100, 350));
  ASSERT_EQ(r.told.triggers.size(), 250U);
  for (std::size_t i = 0; i < 250; ++i) {
    EXPECT_EQ(r.told.triggers[i], 100 + i);
    EXPECT_DOUBLE_EQ(r.told.positionsMm[i], 15.0 * static_cast<double>(i));
    EXPECT_DOUBLE_EQ(r.told.values[i], 4.0 * static_cast<double>(100 + i)) << "pictures of another trigger";
    ASSERT_EQ(r.told.profiles[i].points.size(), 4U);
    for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(r.told.profiles[i].points[c].y, static_cast<double>(c));
    EXPECT_TRUE(r.told.profiles[i].complete());
  }
  EXPECT_EQ(r.told.events.front(), "begin rail at 100");
  EXPECT_EQ(*(r.told.events.end() - 2), "end rail at 100");
  EXPECT_EQ(r.told.events.back(), "ended ");
  EXPECT_EQ(r.ledger.measured, 250U);
  EXPECT_EQ(r.ledger.seen, 250U);
  EXPECT_TRUE(r.ledger.reasons.empty());
}

TEST(Pipeline, HasFourteenStagesByTheirContractNames) {
  const Outcome r = run(wholeRail(0, 20), {4, 64});
  const std::vector<std::string> names = {"acquire.1",   "acquire.2",   "acquire.3", "acquire.4",   "extract.1",
                                          "extract.2",   "extract.3",   "extract.4", "translate.1", "translate.2",
                                          "translate.3", "translate.4", "profile",   "measure"};
  ASSERT_EQ(r.stages.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(r.stages[i].name, names[i]);
    EXPECT_EQ(r.stages[i].count, 20U) << names[i];
    EXPECT_EQ(r.stages[i].queueCapacity, i < 4 ? 0U : 4U);
    EXPECT_LE(r.stages[i].queueHighWater, 4U);
    EXPECT_EQ(r.stages[i].overflows, 0U);
    EXPECT_GE(r.stages[i].ucl99Ms, r.stages[i].meanMs);
    EXPECT_GE(r.stages[i].maxMs, r.stages[i].meanMs);
  }
}

TEST(Pipeline, SeveralRailsEndOneAfterTheOther) {
  Scripts scripts;
  for (int c = 0; c < 4; ++c) {
    appendRail(scripts[static_cast<std::size_t>(c)], c, 0, 30);
    appendRail(scripts[static_cast<std::size_t>(c)], c, 30, 45);
    appendRail(scripts[static_cast<std::size_t>(c)], c, 1000, 1010);
  }
  const Outcome r = run(scripts, {2, 3});
  ASSERT_EQ(r.told.ledgers.size(), 3U);
  EXPECT_EQ(r.told.ledgers[0].measured, 30U);
  EXPECT_EQ(r.told.ledgers[1].measured, 15U);
  EXPECT_EQ(r.told.ledgers[2].measured, 10U);
  EXPECT_EQ(r.ledger.seen, 55U);
  EXPECT_DOUBLE_EQ(r.told.positionsMm[30], 0) << "positions count from the rail's head";
  EXPECT_EQ(r.told.events[31], "end rail at 0");
  EXPECT_EQ(r.told.events[32], "begin rail at 30");
}

TEST(Pipeline, ARailWithoutTriggersBeginsAndEnds) {
  const Outcome r = run(wholeRail(7, 7));
  const std::vector<std::string> events = {"begin rail at 7", "end rail at 7", "ended "};
  EXPECT_EQ(r.told.events, events);
  EXPECT_EQ(r.ledger.seen, 0U);
}

TEST(Pipeline, MissingFramesOfOneCameraMakeIncompleteProfilesThatNameIt) {
  Scripts scripts = wholeRail(0, 50);
  Script& third = scripts[2];
  third[1 + 10] = FrameLost{2, 10, "frame lost"};
  third.erase(third.begin() + 1 + 20);  // never came, nobody said so
  const Outcome r = run(scripts);
  ASSERT_EQ(r.told.triggers.size(), 50U);
  EXPECT_EQ(r.ledger.incomplete, 2U);
  EXPECT_EQ(r.ledger.measured, 48U);
  EXPECT_EQ(r.ledger.reasons.at("camera 3: frame lost"), 1U);
  EXPECT_EQ(r.ledger.reasons.at("camera 3: no frame"), 1U);
  EXPECT_EQ(r.told.profiles[10].missing[2], "frame lost");
  EXPECT_EQ(r.told.profiles[10].pointsOfCamera[2], 0U);
  EXPECT_DOUBLE_EQ(r.told.values[10], 30);
  EXPECT_EQ(r.told.profiles[20].missing[2], "no frame");
  EXPECT_TRUE(r.told.profiles[21].complete());
}

TEST(Pipeline, TriggersMissedByAllAreFoundByTheCounts) {
  Scripts scripts = wholeRail(0, 50);
  for (Script& script : scripts) script.erase(script.begin() + 1 + 5, script.begin() + 1 + 9);
  const Outcome r = run(scripts);
  EXPECT_EQ(r.ledger.seen, 50U);
  EXPECT_EQ(r.ledger.lost, 4U);
  EXPECT_EQ(r.ledger.reasons.at("missed by all cameras"), 4U);
  EXPECT_EQ(r.told.triggers[5], 9U);
  EXPECT_DOUBLE_EQ(r.told.positionsMm[5], 9 * 15.0);
}

TEST(Pipeline, RepeatedAndLateFramesAreLeftOutAndNamed) {
  Scripts scripts = wholeRail(0, 20);
  scripts[0].insert(scripts[0].begin() + 1 + 6, frame(0, 5));   // 5 5
  scripts[1].insert(scripts[1].begin() + 1 + 12, frame(1, 3));  // ... 11 3 12
  const Outcome r = run(scripts);
  EXPECT_EQ(r.ledger.measured, 20U);
  EXPECT_EQ(r.ledger.seen, 20U);
  EXPECT_EQ(r.ledger.reasons.at("camera 1: repeated frame"), 1U);
  EXPECT_EQ(r.ledger.reasons.at("camera 2: late frame"), 1U);
  EXPECT_EQ(r.told.ledgers[0].reasons, r.ledger.reasons) << "told with the rail it happened in";
}

TEST(Pipeline, AProfileThatCannotBeRegisteredIsIncomplete) {
  ScriptedSource source(wholeRail(0, 10));
  PipelineWork work = simpleWork();
  work.measure = [](const RailBegin&, const Profile& profile, Registration& registration, Measurement&) {
    registration.valid = profile.trigger != 4;
    registration.reason = registration.valid ? "" : "rms 1.25 mm above 1 mm";
  };
  Told told;
  Pipeline pipeline(source, work, told.observer(), {});
  pipeline.start();
  pipeline.wait();
  EXPECT_EQ(pipeline.triggers().incomplete, 1U);
  EXPECT_EQ(pipeline.triggers().reasons.at("not registered: rms"), 1U);
}

TEST(Pipeline, AProfileOfAnotherSectionIsIncompleteAndNamesIt) {
  ScriptedSource source(wholeRail(0, 10));
  PipelineWork work = simpleWork();
  work.measure = [](const RailBegin&, const Profile& profile, Registration& registration, Measurement&) {
    registration.valid = profile.trigger % 5 != 4;
    registration.looksLike.reset();
    if (!registration.valid) registration.looksLike = OtherSection{"60E2", 0.4, 3, {}};
  };
  Told told;
  Pipeline pipeline(source, work, told.observer(), {});
  pipeline.start();
  pipeline.wait();
  EXPECT_EQ(pipeline.triggers().measured, 8U);
  EXPECT_EQ(pipeline.triggers().incomplete, 2U);
  EXPECT_EQ(pipeline.triggers().reasons.at("wrong section: looks like 60E2"), 2U);
}

TEST(Pipeline, WorkThatThrowsLosesItsFrameAndNothingElse) {
  ScriptedSource source(wholeRail(0, 10));
  PipelineWork work = simpleWork();
  work.extract = [inner = work.extract](int camera, const ImageView& image, StripeResult& result) {
    inner(camera, image, result);
    if (camera == 1 && result.points[0].x == 3) throw std::bad_alloc();
  };
  Told told;
  Pipeline pipeline(source, work, told.observer(), {});
  pipeline.start();
  pipeline.wait();
  EXPECT_EQ(told.triggers.size(), 10U);
  EXPECT_EQ(pipeline.triggers().reasons.at("camera 2: extraction failed"), 1U);
}

TEST(Pipeline, AnErrorOfTheSourceIsToldAtTheEndAndTheRestIsStillMeasured) {
  Scripts scripts = wholeRail(0, 40);
  scripts[3].resize(1 + 25);
  scripts[3].emplace_back(SourceEnd{"camera 4 (127.0.0.4): gone; check its cable"});
  const Outcome r = run(scripts);
  EXPECT_EQ(r.told.error, "camera 4 (127.0.0.4): gone; check its cable");
  EXPECT_EQ(r.told.events.back(), "ended " + r.told.error);
  EXPECT_EQ(r.ledger.measured, 25U);
  EXPECT_EQ(r.ledger.incomplete, 15U);
  EXPECT_EQ(r.ledger.reasons.at("camera 4: source failed"), 15U);
  expectSums(r.ledger);
}

TEST(Pipeline, OfflineAFastCameraIsHeldBack) {
  // Camera 1 is held at trigger 0 until another camera can go no further; with the queues full there is no more room
  // than: two queues and two threads on each line, the assembler's lead, and its queue.
  Scripts scripts = wholeRail(0, 400);
  ScriptedSource source(scripts);
  std::atomic<std::size_t> furthest{0};
  Gate slow;
  source.before = [&](int camera, std::size_t step) {
    if (camera == 0 && step == 1) slow.pass();
    if (camera == 1) furthest = step;
  };
  Told told;
  Pipeline pipeline(source, simpleWork(), told.observer(), {2, 8});
  pipeline.start();
  // Full when every queue of camera 2's line has reached its capacity: 2 + 2 + 2 and one in each hand, 8 assembled.
  while (furthest < 10) std::this_thread::yield();
  EXPECT_EQ(told.triggers.size(), 0U);
  slow.open();
  pipeline.wait();
  EXPECT_EQ(pipeline.triggers().measured, 400U);
  for (const StageStatistics& stage : pipeline.stages()) {
    EXPECT_LE(stage.queueHighWater, stage.queueCapacity) << stage.name;
    EXPECT_EQ(stage.overflows, 0U) << stage.name;
  }
}

TEST(Pipeline, LiveAFullQueueDropsCountsAndAccounts) {
  constexpr std::uint64_t kFrames = 30;
  ScriptedSource source(wholeRail(0, kFrames));
  source.isLive = true;
  Gate extracting, delivered;
  PipelineWork work = simpleWork();
  work.extract = [&, inner = work.extract](int camera, const ImageView& image, StripeResult& result) {
    if (camera == 0) {
      extracting.open();
      delivered.pass();
    }
    inner(camera, image, result);
  };
  source.before = [&](int camera, std::size_t step) {
    if (camera != 0) delivered.pass();
    if (camera == 0 && step == 2) extracting.pass();           // the first frame is in hand
    if (camera == 0 && step == kFrames + 1) delivered.open();  // all others came meanwhile
  };
  Told told;
  Pipeline pipeline(source, work, told.observer(), {4, 1000});
  pipeline.start();
  pipeline.wait();
  const TriggerLedger ledger = pipeline.triggers();
  // One in hand, four in the queue, the rest dropped. Later queues may drop some too: everything runs as it likes
  // there.
  EXPECT_EQ(pipeline.stages()[4].overflows, kFrames - 5);
  EXPECT_GE(ledger.reasons.at("camera 1: queue overflow"), kFrames - 5);
  EXPECT_EQ(pipeline.stages()[4].queueHighWater, 4U);
  EXPECT_EQ(ledger.seen, kFrames);
  expectSums(ledger);
}

TEST(Pipeline, LiveACameraThatFallsSilentIsGivenUpAfterTheLimit) {
  // Camera 4 sends nothing more until the others' profiles have come out without it.
  ScriptedSource source(wholeRail(0, 100));
  source.isLive = true;
  Gate others;
  source.before = [&](int camera, std::size_t step) {
    if (camera == 3 && step == 1 + 10) others.pass();
  };
  Told told;
  InspectionObserver observer = told.observer();
  observer.profileMeasured = [&, inner = observer.profileMeasured](const ProfileResult& p) {
    inner(p);
    if (p.profile.trigger == 60) others.open();
  };
  Pipeline pipeline(source, simpleWork(), observer, {200, 20});
  pipeline.start();
  pipeline.wait();
  const TriggerLedger ledger = pipeline.triggers();
  EXPECT_EQ(ledger.seen, 100U);
  EXPECT_EQ(ledger.lost, 0U);
  EXPECT_GE(ledger.reasons.at("camera 4: too late"), 51U);
  EXPECT_EQ(ledger.reasons.at("camera 4: late frame"), ledger.reasons.at("camera 4: too late"));
  expectSums(ledger);
  EXPECT_TRUE(std::is_sorted(told.triggers.begin(), told.triggers.end()));
}

TEST(Pipeline, SteadyStateMakesNoNewBuffers) {
  ScriptedSource source(wholeRail(0, 300));
  PipelineWork work = simpleWork();
  std::mutex mutex;
  std::map<const void*, int> stripes;
  work.extract = [&, inner = work.extract](int camera, const ImageView& image, StripeResult& result) {
    inner(camera, image, result);
    const std::scoped_lock lock(mutex);
    ++stripes[&result];
  };
  Told told;
  Pipeline pipeline(source, work, told.observer(), {2, 4});
  pipeline.start();
  pipeline.wait();
  // Per camera at most: queue 2 and one in each of two hands.
  EXPECT_LE(stripes.size(), 16U);
  EXPECT_EQ(told.triggers.size(), 300U);
}

}  // namespace
}  // namespace vignole
