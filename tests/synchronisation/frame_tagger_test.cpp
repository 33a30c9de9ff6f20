#include "engine/synchronisation/frame_tagger.h"

#include <gtest/gtest.h>

namespace vignole {
namespace {

using Kind = FrameTag::Kind;

TEST(FrameIds, GoOnOverTheEndOfSixteenBits) {
  FrameIds ids;
  EXPECT_EQ(ids.take(65534), 0);
  EXPECT_EQ(ids.take(65535), 1);
  EXPECT_EQ(ids.take(1), 2) << "0 is not used";
  EXPECT_EQ(ids.take(4), 5);
}

TEST(FrameIds, OfSixtyFourBitsDoNotWrap) {
  FrameIds ids;
  ids.take(65534);
  EXPECT_EQ(ids.step(65536), 2);
  EXPECT_EQ(ids.take(65535), 1);
  EXPECT_EQ(ids.take(65536), 2);
  EXPECT_EQ(ids.take(65537), 3);
  EXPECT_EQ(ids.step(1), 1 - 65537);
}

TEST(FrameIds, AnOlderFrameIsAStepBack) {
  FrameIds ids;
  ids.take(3);
  EXPECT_EQ(ids.step(3), 0);
  EXPECT_EQ(ids.step(65534), -4) << "before the wrap";
}

TEST(FrameTagger, CountsByIdsWhereTheCameraDoesNotCountTriggers) {
  FrameTagger tagger;
  EXPECT_EQ(tagger.add(65533, {}).place, 0);
  const FrameTag next = tagger.add(3, {});
  EXPECT_EQ(next.kind, Kind::Frame);
  EXPECT_EQ(next.place, 5);
  EXPECT_EQ(next.lost, 4u);
  EXPECT_EQ(next.missed, 0u);
  EXPECT_EQ(tagger.add(3, {}).kind, Kind::Repeated);
  EXPECT_EQ(tagger.add(2, {}).kind, Kind::Repeated);
  EXPECT_EQ(tagger.add(4, {}).place, 6) << "what came late changes nothing";
}

TEST(FrameTagger, AMissedTriggerLeavesNoGapInTheIds) {
  FrameTagger tagger;
  EXPECT_EQ(tagger.add(10, 100).place, 100);
  const FrameTag tag = tagger.add(11, 103);
  EXPECT_EQ(tag.place, 103);
  EXPECT_EQ(tag.missed, 2u);
  EXPECT_EQ(tag.lost, 0u);
}

TEST(FrameTagger, TellsWhatWasLostFromWhatWasMissedAndWhatCameDamaged) {
  FrameTagger tagger;
  (void)tagger.add(65530, 1000);
  tagger.addDamaged();
  // Ids say 5 frames in between, one of them arrived damaged; the count says 7 triggers.
  const FrameTag tag = tagger.add(1, 1008);
  EXPECT_EQ(tag.missed, 2u);
  EXPECT_EQ(tag.lost, 4u);
  EXPECT_EQ(tag.incomplete, 1u);
  EXPECT_EQ(tag.between(), 7u);
  EXPECT_EQ(tagger.add(2, 1009).between(), 0u) << "what was told is not told again";
}

TEST(FrameTagger, MoreDamagedFramesThanGapsAreNoMoreThanTheGaps) {
  FrameTagger tagger;
  (void)tagger.add(1, 0);
  for (int i = 0; i < 5; ++i) tagger.addDamaged();  // a buffer filled from the middle is damaged without being a frame
  EXPECT_EQ(tagger.add(2, 1).between(), 0u);
  EXPECT_EQ(tagger.add(4, 3).between(), 1u);
}

TEST(FrameTagger, WhatCameDamagedBeforeTheFirstGoodFrameIsOfTheTriggersBefore) {
  FrameTagger tagger;
  tagger.addDamaged();
  tagger.addDamaged();
  EXPECT_EQ(tagger.add(3, 2).incomplete, 2u);
  FrameTagger another;
  another.addDamaged();
  EXPECT_EQ(another.add(1, 0).between(), 0u) << "there is no trigger before the first";
}

TEST(FrameTagger, AStrayCountIsNotBelieved) {
  FrameTagger tagger;
  (void)tagger.add(1, 50);
  EXPECT_EQ(tagger.add(2, 4'000'000).kind, Kind::Implausible);
  const FrameTag tag = tagger.add(3, 52);
  EXPECT_EQ(tag.kind, Kind::Frame);
  EXPECT_EQ(tag.lost, 1u) << "the frame that could not be believed is a lost one";
}

TEST(FrameTagger, ACountThatStaysElsewhereIsACameraThatCountsAnew) {
  FrameTagger tagger;
  (void)tagger.add(100, 5000);
  EXPECT_EQ(tagger.add(101, 0).kind, Kind::Implausible);
  EXPECT_EQ(tagger.add(102, 1).kind, Kind::Implausible);
  const FrameTag tag = tagger.add(103, 2);
  EXPECT_EQ(tag.kind, Kind::Restarted);
  EXPECT_EQ(tag.place, 2);
  EXPECT_EQ(tagger.add(104, 3).kind, Kind::Frame);
}

TEST(FrameTagger, IdsThatBeginAnewDoNotDisturbTheCount) {
  FrameTagger tagger;
  (void)tagger.add(40, 40);
  EXPECT_EQ(tagger.add(41, 41).place, 41);
  const FrameTag tag = tagger.add(1, 42);
  EXPECT_EQ(tag.kind, Kind::Frame);
  EXPECT_EQ(tag.place, 42);
  EXPECT_EQ(tag.between(), 0u);
}

}  // namespace
}  // namespace vignole
