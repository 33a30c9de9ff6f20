#include "engine/synchronisation/camera_watch.h"

#include <gtest/gtest.h>

namespace vignole {
namespace {

CameraWatchSettings settings() { return {8, 0.25, 16, 1}; }

TEST(CameraWatch, BeginsConnectingAndIsNotWaitedFor) {
  CameraWatch watch(settings());
  EXPECT_EQ(watch.state(), CameraState::Connecting);
  EXPECT_TRUE(watch.silent());
  watch.look(100, 50);
  EXPECT_EQ(watch.state(), CameraState::Connecting);
  EXPECT_FALSE(watch.toBeOpenedAgain(false));
  watch.opened(100);
  EXPECT_EQ(watch.state(), CameraState::Connected);
  EXPECT_FALSE(watch.silent());
}

TEST(CameraWatch, IsSilentWhenOthersHaveAnsweredSomeTriggersMore) {
  CameraWatch watch(settings());
  watch.opened(0);
  watch.frame(1);
  watch.look(1.5, 7);
  EXPECT_EQ(watch.state(), CameraState::Connected) << "too few triggers";
  watch.look(1.1, 8);
  EXPECT_EQ(watch.state(), CameraState::Connected) << "too short a time";
  watch.look(1.3, 8);
  EXPECT_EQ(watch.state(), CameraState::Degraded);
  EXPECT_EQ(watch.why(), "no frames for 8 triggers");
  EXPECT_TRUE(watch.silent());
  EXPECT_FALSE(watch.toBeOpenedAgain(false)) << "it may come back by itself";
  watch.frame(1.4);
  EXPECT_EQ(watch.state(), CameraState::Connected);
  EXPECT_TRUE(watch.why().empty());
}

TEST(CameraWatch, StaysConnectedWhileNothingIsTriggered) {
  CameraWatch watch(settings());
  watch.opened(0);
  watch.frame(1);
  watch.look(3600, 0);
  EXPECT_EQ(watch.state(), CameraState::Connected);
}

TEST(CameraWatch, IsLostAndOpenedAgainWhenItStaysSilent) {
  CameraWatch watch(settings());
  watch.opened(0);
  watch.frame(1);
  watch.look(1.5, 10);
  watch.look(2.1, 20);
  EXPECT_EQ(watch.state(), CameraState::Lost);
  EXPECT_TRUE(watch.toBeOpenedAgain(true));
  watch.frame(2.2);
  EXPECT_EQ(watch.state(), CameraState::Lost) << "until it has been opened again";
  watch.opened(3);
  EXPECT_EQ(watch.state(), CameraState::Connected);
}

TEST(CameraWatch, WithoutControlButWithFramesItIsOpenedAgainBetweenRails) {
  CameraWatch watch(settings());
  watch.opened(0);
  watch.frame(1);
  watch.controlLost();
  watch.frame(1.1);
  watch.look(1.2, 0);
  EXPECT_EQ(watch.state(), CameraState::Degraded);
  EXPECT_FALSE(watch.silent());
  EXPECT_FALSE(watch.toBeOpenedAgain(true));
  EXPECT_TRUE(watch.toBeOpenedAgain(false));
}

TEST(CameraWatch, WithoutControlAndWithoutFramesItIsLost) {
  CameraWatch watch(settings());
  watch.opened(0);
  watch.frame(1);
  watch.controlLost();
  watch.look(2.5, 0);
  EXPECT_EQ(watch.state(), CameraState::Lost) << "also while nothing is triggered";
}

TEST(CameraWatch, FramesAfterASilenceDoNotHideThatControlIsGone) {
  CameraWatch watch(settings());
  watch.opened(0);
  watch.frame(1);
  watch.controlLost();
  watch.look(1.5, 9);
  EXPECT_TRUE(watch.silent());
  watch.frame(1.6);
  EXPECT_EQ(watch.state(), CameraState::Degraded);
  EXPECT_FALSE(watch.silent());
}

TEST(CameraWatch, SaysWhyItCannotBeOpened) {
  CameraWatch watch(settings());
  watch.failed("is S2, not S1");
  EXPECT_EQ(watch.state(), CameraState::Lost);
  EXPECT_EQ(watch.why(), "is S2, not S1");
  watch.doesNotAnswer();
  EXPECT_NE(watch.why().find("does not answer"), std::string::npos);
}

}  // namespace
}  // namespace vignole
