#include <gtest/gtest.h>
#include <thread>

#include "engine/inspection/pipeline.h"
#include "tests/inspection/scripted_source.h"

namespace vignole {
namespace {

using namespace vignole::testing;

void expectSums(const TriggerLedger& ledger) {
  EXPECT_EQ(ledger.seen, ledger.measured + ledger.incomplete + ledger.lost);
}

TEST(PipelineStop, NeverStarted) {
  ScriptedSource source(wholeRail(0, 10));
  Told told;
  Pipeline pipeline(source, simpleWork(), told.observer(), {});
  pipeline.wait();
  EXPECT_FALSE(pipeline.running());
  EXPECT_FALSE(told.ended);
}

TEST(PipelineStop, BeforeTheStart) {
  ScriptedSource source(wholeRail(0, 10));
  Told told;
  Pipeline pipeline(source, simpleWork(), told.observer(), {});
  pipeline.stop();
  pipeline.stop();
  pipeline.start();
  pipeline.wait();
  EXPECT_TRUE(told.ended);
  EXPECT_EQ(told.error, "");
  EXPECT_EQ(pipeline.triggers().seen, 0U);
}

TEST(PipelineStop, DuringARailEndsTheRailAndAccountsForWhatWasUnderWay) {
  ScriptedSource source(wholeRail(0, 50));
  for (int round = 0; round < 20; ++round) {
    Scripts scripts;
    for (int c = 0; c < 4; ++c) {
      auto& script = scripts[static_cast<std::size_t>(c)];
      script.emplace_back(rail(0));
      for (std::uint64_t t = 0; t < 5000; ++t) script.emplace_back(frame(c, t));
    }
    ScriptedSource endless(scripts);
    endless.endless = true;
    Told told;
    InspectionObserver observer = told.observer();
    Gate some;
    observer.profileMeasured = [&, inner = observer.profileMeasured](const ProfileResult& p) {
      inner(p);
      if (p.profile.trigger == 40) some.open();
    };
    Pipeline pipeline(endless, simpleWork(), observer, {3, 5});
    pipeline.start();
    EXPECT_TRUE(pipeline.running());
    some.pass();
    pipeline.stop();
    pipeline.stop();
    pipeline.wait();
    EXPECT_FALSE(pipeline.running());
    ASSERT_TRUE(told.ended);
    ASSERT_EQ(told.ledgers.size(), 1U) << "the rail ends as well";
    EXPECT_GE(told.triggers.size(), 41U);
    const TriggerLedger ledger = pipeline.triggers();
    expectSums(ledger);
    EXPECT_EQ(ledger.measured, told.triggers.size()) << "a profile that the stop cut through must not come out";
    EXPECT_EQ(ledger.incomplete, 0U);
  }
}

TEST(PipelineStop, WhileTheSourceHasNothing) {
  ScriptedSource source({});
  source.endless = true;
  Told told;
  Pipeline pipeline(source, simpleWork(), told.observer(), {});
  pipeline.start();
  pipeline.stop();
  pipeline.wait();
  EXPECT_TRUE(told.ended);
}

TEST(PipelineStop, AfterTheEndAndTwice) {
  ScriptedSource source(wholeRail(0, 10));
  Told told;
  Pipeline pipeline(source, simpleWork(), told.observer(), {});
  pipeline.start();
  pipeline.start();
  pipeline.wait();
  pipeline.wait();
  pipeline.stop();
  pipeline.stop();
  EXPECT_EQ(told.triggers.size(), 10U);
  EXPECT_EQ(pipeline.triggers().measured, 10U);
}

TEST(PipelineStop, FromTheObserversThreadDoesNotDeadlock) {
  Scripts scripts;
  for (int c = 0; c < 4; ++c) {
    auto& script = scripts[static_cast<std::size_t>(c)];
    script.emplace_back(rail(0));
    for (std::uint64_t t = 0; t < 5000; ++t) script.emplace_back(frame(c, t));
  }
  ScriptedSource source(scripts);
  source.endless = true;
  Told told;
  InspectionObserver observer = told.observer();
  Pipeline* self = nullptr;
  observer.profileMeasured = [&, inner = observer.profileMeasured](const ProfileResult& p) {
    inner(p);
    if (p.profile.trigger == 5) {
      self->stop();
      self->wait();  // returns at once on this thread
      EXPECT_TRUE(self->running());
    }
  };
  Pipeline pipeline(source, simpleWork(), observer, {2, 4});
  self = &pipeline;
  pipeline.start();
  pipeline.wait();
  EXPECT_TRUE(told.ended);
  EXPECT_LT(told.triggers.size(), 5000U);
}

TEST(PipelineStop, TheDestructorStopsAndJoins) {
  Told told;
  {
    Scripts scripts = wholeRail(0, 5000);
    ScriptedSource source(scripts);
    source.endless = true;
    Gate one;
    InspectionObserver observer = told.observer();
    observer.profileMeasured = [&](const ProfileResult&) { one.open(); };
    Pipeline pipeline(source, simpleWork(), observer, {2, 4});
    pipeline.start();
    one.pass();
  }
  EXPECT_TRUE(told.ended);
}

TEST(PipelineStop, FromManyThreadsAtOnceWhileOthersLook) {
  Scripts scripts = wholeRail(0, 3000);
  ScriptedSource source(scripts);
  Told told;
  Pipeline pipeline(source, simpleWork(), told.observer(), {4, 8});
  pipeline.start();
  {
    std::vector<std::jthread> people;
    for (int i = 0; i < 3; ++i)
      people.emplace_back([&pipeline] {
        for (int k = 0; k < 50; ++k) {
          expectSums(pipeline.triggers());
          EXPECT_EQ(pipeline.stages().size(), 14U);
        }
        pipeline.stop();
        pipeline.wait();
      });
  }
  EXPECT_TRUE(told.ended);
  expectSums(pipeline.triggers());
}

}  // namespace
}  // namespace vignole
