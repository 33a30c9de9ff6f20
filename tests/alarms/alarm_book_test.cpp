#include "engine/alarms/alarm_book.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace vignole {
namespace {

AlarmTime at(double seconds) {
  return AlarmTime(AlarmDuration(std::llround(1000 * seconds))) + std::chrono::hours(24 * 20000);
}

const AlarmKey kRail{"rail.out-of-tolerance", "R-1"};
const AlarmKey kCamera{"camera.lost", "camera 3"};
const AlarmKey kDisk{"disk.low", ""};

AlarmBook book(const AlarmBookSettings& settings = {}) {
  auto made = AlarmBook::create(standardAlarmRules(), settings);
  EXPECT_TRUE(made);
  return std::move(*made);
}

std::vector<AlarmEventKind> kinds(const std::vector<AlarmEvent>& events) {
  std::vector<AlarmEventKind> list;
  for (const AlarmEvent& e : events) list.push_back(e.kind);
  return list;
}

TEST(AlarmBook, OneBadRailIsOneAlarmHoweverManyDimensions) {
  AlarmBook b = book();
  int profile = 0;
  for (const char* dimension : {"HW", "RH", "FT_l", "HW", "WT"}) b.set(kRail, true, at(0.015 * ++profile), dimension);
  ASSERT_EQ(b.active().size(), 1U);
  EXPECT_EQ(b.active()[0].details, (std::vector<std::string>{"HW", "RH", "FT_l", "WT"}));
  EXPECT_EQ(b.rates(at(1)).tenMinutes, 1U);
  EXPECT_EQ(kinds(b.takeEvents()), std::vector<AlarmEventKind>{AlarmEventKind::Raised});
  b.set(kRail, false, at(60));
  b.set({"rail.out-of-tolerance", "R-2"}, true, at(61), "HW");
  EXPECT_EQ(b.active().size(), 2U) << "the next bad rail is another";
}

TEST(AlarmBook, GoesThroughTheStatesOfIsa182) {
  AlarmBook b = book();
  const auto state = [&] { return b.active().empty() ? AlarmState::Normal : b.active()[0].state; };
  b.set(kRail, true, at(0), "HW");
  EXPECT_EQ(state(), AlarmState::Unacknowledged);
  ASSERT_TRUE(b.acknowledge(b.active()[0].id, "anna", at(5)));
  EXPECT_EQ(state(), AlarmState::Acknowledged);
  EXPECT_EQ(b.active()[0].acknowledgedBy, "anna");
  b.set(kRail, false, at(10));
  EXPECT_EQ(state(), AlarmState::Normal);

  b.set(kRail, true, at(20), "RH");
  EXPECT_EQ(b.active()[0].details, std::vector<std::string>{"RH"}) << "a new occurrence begins anew";
  EXPECT_TRUE(b.active()[0].acknowledgedBy.empty());
  b.set(kRail, false, at(30));
  EXPECT_EQ(state(), AlarmState::ReturnedUnacknowledged);
  b.set(kRail, true, at(40));
  EXPECT_EQ(state(), AlarmState::Unacknowledged) << "again, unseen";
  b.set(kRail, false, at(50));
  const auto id = b.active()[0].id;
  ASSERT_TRUE(b.acknowledge(id, "anna", at(60)));
  EXPECT_EQ(state(), AlarmState::Normal);
  EXPECT_FALSE(b.acknowledge(id, "anna", at(61))) << "there is nothing to acknowledge any more";
  EXPECT_FALSE(b.acknowledge(0, "anna", at(61)));
  EXPECT_EQ(kinds(b.takeEvents()),
            (std::vector<AlarmEventKind>{AlarmEventKind::Raised, AlarmEventKind::Acknowledged, AlarmEventKind::Cleared,
                                         AlarmEventKind::Raised, AlarmEventKind::Cleared, AlarmEventKind::Raised,
                                         AlarmEventKind::Cleared, AlarmEventKind::Acknowledged}));
}

TEST(AlarmBook, AcknowledgingAPageTakesAllThatNeedIt) {
  AlarmBook b = book();
  std::vector<std::uint64_t> page;
  for (int i = 0; i < 4; ++i) b.set({"rail.out-of-tolerance", std::to_string(i)}, true, at(i));
  for (const Alarm& a : b.active()) page.push_back(a.id);
  ASSERT_TRUE(b.acknowledge(page[0], "anna", at(5)));
  b.acknowledge(page, "bert", at(6));
  for (const Alarm& a : b.active()) EXPECT_EQ(a.state, AlarmState::Acknowledged);
  std::size_t byBert = 0;
  for (const Alarm& a : b.active()) byBert += a.acknowledgedBy == "bert" ? 1 : 0;
  EXPECT_EQ(byBert, 3U);
  EXPECT_FALSE(b.acknowledge(page[0], "", at(7)));
}

TEST(AlarmBook, DelaysRunOutWithTheClock) {
  AlarmBook b = book();
  b.set(kCamera, true, at(0));  // delay 1 s
  b.advance(at(0.9));
  EXPECT_TRUE(b.active().empty());
  b.advance(at(1.5));
  ASSERT_EQ(b.active().size(), 1U);
  EXPECT_EQ(b.active()[0].raised, at(1));
  b.set(kCamera, false, at(2));
  b.advance(at(6.9));
  EXPECT_EQ(b.active()[0].state, AlarmState::Unacknowledged);
  b.advance(at(7));
  EXPECT_EQ(b.active()[0].state, AlarmState::ReturnedUnacknowledged);
  EXPECT_EQ(*b.active()[0].cleared, at(7));
}

TEST(AlarmBook, WhatCameAndWentBetweenTwoLooksIsNotLost) {
  AlarmBook b = book();
  b.set(kCamera, true, at(0));
  b.set(kCamera, false, at(60));  // nobody called in between: it was an alarm from 1 s on
  ASSERT_EQ(b.active().size(), 1U);
  EXPECT_EQ(b.active()[0].raised, at(1));
}

TEST(AlarmBook, DetailsOfWhatNeverBecameAnAlarmAreForgotten) {
  AlarmBook b = book();
  b.set(kCamera, true, at(0), "no answer");
  b.set(kCamera, false, at(0.5));
  b.advance(at(10));
  b.set(kCamera, true, at(20), "timeout");
  b.advance(at(22));
  ASSERT_EQ(b.active().size(), 1U);
  EXPECT_EQ(b.active()[0].details, std::vector<std::string>{"timeout"});
}

TEST(AlarmBook, ShelvingHidesAndRunsOut) {
  AlarmBook b = book();
  b.set(kRail, true, at(0), "HW");
  ASSERT_TRUE(b.shelve(kRail, "anna", "rail is being cut", std::chrono::minutes(30), at(10)));
  EXPECT_TRUE(b.active().empty());
  EXPECT_FALSE(b.mostUrgent());
  ASSERT_EQ(b.shelved().size(), 1U);
  EXPECT_EQ(b.shelved()[0].shelf->reason, "rail is being cut");
  b.advance(at(10 + 1799));
  EXPECT_TRUE(b.active().empty());
  static_cast<void>(b.takeEvents());
  b.advance(at(10 + 1801));
  ASSERT_EQ(b.active().size(), 1U) << "still wrong: raised anew";
  EXPECT_EQ(b.active()[0].state, AlarmState::Unacknowledged);
  EXPECT_EQ(b.active()[0].details, std::vector<std::string>{"HW"});
  EXPECT_TRUE(b.shelved().empty());
  const auto events = b.takeEvents();
  EXPECT_EQ(kinds(events), (std::vector<AlarmEventKind>{AlarmEventKind::ShelfRanOut, AlarmEventKind::Raised}));
  EXPECT_EQ(events[0].time, at(10 + 1800)) << "when the time was up";
}

TEST(AlarmBook, WhatComesAndGoesWhileShelvedIsNotRaised) {
  AlarmBook b = book();
  ASSERT_TRUE(b.shelve(kDisk, "anna", "disk is on order", std::chrono::hours(1), at(0)));
  b.observe(kDisk, 5, at(1));
  b.advance(at(100));
  EXPECT_TRUE(b.active().empty());
  EXPECT_EQ(b.rates(at(100)).hour, 0U);
  b.observe(kDisk, 50, at(200));
  b.advance(at(400));
  b.advance(at(3601));
  EXPECT_TRUE(b.active().empty()) << "over before the shelf was";
  EXPECT_EQ(kinds(b.takeEvents()), (std::vector<AlarmEventKind>{AlarmEventKind::Shelved, AlarmEventKind::ShelfRanOut}));
}

TEST(AlarmBook, UnshelvingBringsItBack) {
  AlarmBook b = book();
  b.set(kRail, true, at(0));
  ASSERT_TRUE(b.shelve(kRail, "anna", "seen", std::chrono::hours(1), at(1)));
  ASSERT_TRUE(b.unshelve(kRail, "bert", at(2)));
  EXPECT_EQ(b.active().size(), 1U);
  EXPECT_FALSE(b.unshelve(kRail, "bert", at(3)));
}

TEST(AlarmBook, NothingIsSwitchedOffWithoutReasonOrEnd) {
  AlarmBook b = book();
  EXPECT_FALSE(b.shelve(kRail, "anna", " \n", std::chrono::hours(1), at(0)));
  EXPECT_FALSE(b.shelve(kRail, "", "why not", std::chrono::hours(1), at(0)));
  EXPECT_FALSE(b.shelve(kRail, "anna", "for ever", std::chrono::hours(9), at(0)));
  EXPECT_FALSE(b.shelve(kRail, "anna", "for ever", AlarmDuration(0), at(0)));
  EXPECT_FALSE(b.shelve({"nothing", ""}, "anna", "reason", std::chrono::hours(1), at(0)));
  EXPECT_NE(b.shelve(kRail, "anna", "for ever", std::chrono::hours(9), at(0)).error().message().find("8 h"),
            std::string::npos);
  EXPECT_TRUE(b.shelved().empty());
}

TEST(AlarmBook, ListIsInTheOrderInWhichThingsAreUrgent) {
  AlarmBook b = book();
  b.observe(kDisk, 1, at(0));
  b.set(kRail, true, at(11));
  b.set({"rail.out-of-tolerance", "R-2"}, true, at(12));
  b.set(kCamera, true, at(13));
  b.advance(at(20));
  ASSERT_EQ(b.active().size(), 4U);
  EXPECT_EQ(b.active()[0].key, kCamera);
  EXPECT_EQ(b.active()[1].key.source, "R-2") << "of one priority the newest";
  EXPECT_EQ(b.active()[3].key, kDisk);
  EXPECT_EQ(b.mostUrgent(), AlarmPriority::Invalid);
  ASSERT_TRUE(b.acknowledge(b.active()[0].id, "anna", at(21)));
  EXPECT_EQ(b.active()[3].key, kCamera) << "seen: behind what nobody has seen";
}

TEST(AlarmBook, RatesAndFlood) {
  AlarmBook b = book();
  for (int i = 0; i < 11; ++i) b.set({"rail.out-of-tolerance", std::to_string(i)}, true, at(50.0 * i));
  b.set(kCamera, true, at(500));
  b.advance(at(505));
  EXPECT_EQ(b.rates(at(505)).tenMinutes, 12U);
  EXPECT_TRUE(b.rates(at(505)).flood);
  const auto groups = b.groups();
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].rule, "camera.lost");
  EXPECT_EQ(groups[1].alarms.size(), 11U);
  EXPECT_EQ(groups[1].unacknowledged, 11U);
  b.advance(at(505 + 400));
  EXPECT_TRUE(b.rates(at(905)).flood) << "not over before it is well over";
  b.advance(at(1095));
  EXPECT_FALSE(b.rates(at(1095)).flood);
  EXPECT_EQ(b.rates(at(1095)).hour, 12U);
  const auto events = b.takeEvents();
  EXPECT_EQ(events.back().kind, AlarmEventKind::FloodEnded);
  b.advance(at(200000));
  EXPECT_EQ(b.rates(at(200000)).day, 0U);
}

TEST(AlarmBook, ChatteringAndStale) {
  AlarmBook b = book();
  for (int i = 0; i < 3; ++i) {
    b.set(kRail, true, at(10.0 * i));
    b.set(kRail, false, at(10.0 * i + 5));
  }
  b.advance(at(30));
  ASSERT_EQ(b.active().size(), 1U) << "one alarm that comes and goes";
  EXPECT_TRUE(b.active()[0].chattering);
  b.advance(at(100));
  EXPECT_FALSE(b.active()[0].chattering);
  b.set(kRail, true, at(200));
  b.advance(at(200 + 24 * 3600 + 1));
  EXPECT_TRUE(b.active()[0].stale);
}

TEST(AlarmBook, DoesNotGrowWithTheRails) {
  AlarmBook b = book();
  for (int i = 0; i < 5000; ++i) {
    const AlarmKey rail{"rail.out-of-tolerance", "R" + std::to_string(i)};
    const AlarmTime begin = at(120.0 * i);
    b.set(rail, i % 50 == 0, begin, "HW");
    b.set(rail, false, begin + std::chrono::seconds(60));
    for (const Alarm& a : b.active()) ASSERT_TRUE(b.acknowledge(a.id, "anna", begin + std::chrono::seconds(61)));
    b.advance(begin + std::chrono::seconds(119));
    static_cast<void>(b.takeEvents());
  }
  EXPECT_TRUE(b.active().empty());
  EXPECT_LE(b.tracked(), 1U);
  EXPECT_LE(b.rates(at(120.0 * 5000)).day, 16U);
}

TEST(AlarmBook, SameCallsSameStory) {
  const auto story = [] {
    AlarmBook b = book();
    std::mt19937 random(7);
    std::string text;
    for (int i = 0; i < 3000; ++i) {
      const AlarmTime now = at(0.7 * i);
      b.observe({"camera.frame-loss", "camera " + std::to_string(random() % 4 + 1)},
                static_cast<double>(random() % 300) / 100, now);
      b.set({"rail.out-of-tolerance", std::to_string(i / 100)}, random() % 200 == 0, now, std::to_string(random() % 5));
      if (random() % 50 == 0 && !b.active().empty()) static_cast<void>(b.acknowledge(b.active()[0].id, "x", now));
      if (random() % 300 == 0)
        static_cast<void>(b.shelve({"camera.frame-loss", "camera 1"}, "x", "y", std::chrono::minutes(3), now));
      b.advance(now);
      for (const AlarmEvent& e : b.takeEvents())
        text += std::to_string(e.time.time_since_epoch().count()) + std::string(name(e.kind)) + e.key.rule +
                e.key.source + e.text + "\n";
    }
    return text;
  };
  const std::string first = story();
  EXPECT_EQ(first, story());
  EXPECT_GT(std::count(first.begin(), first.end(), '\n'), 30);
}

}  // namespace
}  // namespace vignole
