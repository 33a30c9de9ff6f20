#include "engine/optics/calibration_age.h"

#include <gtest/gtest.h>

namespace vignole {
namespace {

using namespace std::chrono_literals;

TEST(CalibrationAge, ReadsDatesAsTheyAreWritten) {
  EXPECT_EQ(secondsSinceEpoch("1970-01-01T00:00:00Z"), std::chrono::sys_seconds(0s));
  EXPECT_EQ(secondsSinceEpoch("2024-02-29T12:34:56Z"), std::chrono::sys_seconds(1709210096s));
}

TEST(CalibrationAge, WhatIsNoDateHasNoAge) {
  for (const char* text : {"", "yesterday", "2024-02-30T00:00:00Z", "2024-13-01T00:00:00Z", "2024-01-01T24:00:00Z",
                           "2024-01-01 00:00:00Z", "2024-01-01T00:00:00", "2o24-01-01T00:00:00Z"})
    EXPECT_FALSE(secondsSinceEpoch(text).has_value()) << text;
  RigCalibration rig;
  rig.created = "yesterday";
  EXPECT_FALSE(ageOf(rig, {}).days.has_value());
}

TEST(CalibrationAge, IsOverdueAfterItsInterval) {
  RigCalibration rig;
  rig.created = "2026-01-01T00:00:00Z";
  const auto made = *secondsSinceEpoch(rig.created);
  EXPECT_FALSE(ageOf(rig, made + 24000h).overdue) << "no interval, never due";
  rig.intervalDays = 30;
  EXPECT_FALSE(ageOf(rig, made + 24h * 30).overdue);
  EXPECT_TRUE(ageOf(rig, made + 24h * 30 + 1s).overdue);
  EXPECT_EQ(warningOf(rig, ageOf(rig, made + 24h * 30)), "");
  EXPECT_EQ(warningOf(rig, ageOf(rig, made + 24h * 41)), "41 days old, its interval is 30 days");
  EXPECT_NE(warningOf(rig, ageOf(rig, made - 240h)).find("clock"), std::string::npos);
  EXPECT_DOUBLE_EQ(*ageOf(rig, made + 36h).days, 1.5);
  EXPECT_FALSE(ageOf(rig, made - 12h).overdue) << "clocks and time zones differ";
  EXPECT_TRUE(ageOf(rig, made - 240h).overdue) << "made in the future: one of the dates is wrong";
}

}  // namespace
}  // namespace vignole
