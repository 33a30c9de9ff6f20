// The plate's file: what is written comes back, the drawing's plate is the one of the design, bad ones are refused.

#include "engine/target/pin_plate.h"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

namespace vignole {
namespace {

namespace fs = std::filesystem;

class PinPlateFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("pin_plate_" + std::string(info()->name()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  static const testing::TestInfo* info() { return testing::UnitTest::GetInstance()->current_test_info(); }
  [[nodiscard]] fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  fs::path folder_;
};

std::string pinText(int number, double x, double y, double radius, const std::string& more = {}) {
  return "[[pin]]\nnumber = " + std::to_string(number) + "\nx_mm = " + std::to_string(x) +
         "\ny_mm = " + std::to_string(y) + "\nradius_mm = " + std::to_string(radius) + "\n" + more;
}

TEST_F(PinPlateFile, WhatIsSavedIsLoadedToTheLastBit) {
  PinPlate plate = plate13();
  plate.id = "of the \"first\" line";
  plate.measured = true;
  plate.surfaceMm = 17.25;
  for (Pin& pin : plate.pins) {
    pin.centreMm += Point2(1.0 / 3, -1.0 / 7) * 1e-3 * pin.number;
    pin.radiusMm += 1e-4 / 3;
    pin.uCentreMm = 0.003 / pin.number;
    pin.uRadiusMm = 0.002 / pin.number;
  }
  ASSERT_TRUE(savePinPlate(plate, folder_ / "plate.toml").has_value());
  const auto back = loadPinPlate(folder_ / "plate.toml");
  ASSERT_TRUE(back.has_value()) << back.error().message();
  EXPECT_EQ(back->id, plate.id);
  EXPECT_TRUE(back->measured);
  EXPECT_EQ(back->surfaceMm, plate.surfaceMm);
  EXPECT_EQ(back->protrusionMm, plate.protrusionMm);
  ASSERT_EQ(back->pins.size(), plate.pins.size());
  for (std::size_t i = 0; i < plate.pins.size(); ++i) {
    EXPECT_EQ(back->pins[i].number, plate.pins[i].number);
    EXPECT_EQ(back->pins[i].centreMm, plate.pins[i].centreMm);
    EXPECT_EQ(back->pins[i].radiusMm, plate.pins[i].radiusMm);
    EXPECT_EQ(back->pins[i].uCentreMm, plate.pins[i].uCentreMm);
    EXPECT_EQ(back->pins[i].uRadiusMm, plate.pins[i].uRadiusMm);
  }
}

TEST_F(PinPlateFile, TheResourceIsTheDrawingWithItsTolerance) {
  const auto plate = loadPinPlate(fs::path(VIGNOLE_SOURCE_DIR) / "resources/plates/plate13.toml");
  ASSERT_TRUE(plate.has_value()) << plate.error().message();
  const PinPlate drawn = plate13();
  ASSERT_EQ(plate->pins.size(), drawn.pins.size());
  for (std::size_t i = 0; i < drawn.pins.size(); ++i) {
    EXPECT_EQ(plate->pins[i].number, drawn.pins[i].number);
    EXPECT_EQ(plate->pins[i].centreMm, drawn.pins[i].centreMm);
    EXPECT_EQ(plate->pins[i].radiusMm, drawn.pins[i].radiusMm);
    EXPECT_NEAR(plate->pins[i].uCentreMm, 0.05 / std::sqrt(3), 1e-12);
    EXPECT_NEAR(plate->pins[i].uRadiusMm, 0.01 / std::sqrt(3), 1e-12);
  }
}

TEST_F(PinPlateFile, TheSharedListIsTheSamePlate) {
  const fs::path file = fs::path(VIGNOLE_SHARED_DATA) / "plates/plate13.json";
  if (!fs::exists(file)) GTEST_SKIP() << file << " is absent";
  const auto plate = loadPinPlate(file);
  ASSERT_TRUE(plate.has_value()) << plate.error().message();
  const PinPlate drawn = plate13();
  ASSERT_EQ(plate->pins.size(), drawn.pins.size());
  for (std::size_t i = 0; i < drawn.pins.size(); ++i) {
    EXPECT_EQ(plate->pins[i].centreMm, drawn.pins[i].centreMm);
    EXPECT_EQ(plate->pins[i].radiusMm, drawn.pins[i].radiusMm);
  }
}

TEST_F(PinPlateFile, APinsOwnUncertaintyGoesBeforeTheToleranceOfAll) {
  const auto plate =
      loadPinPlate(write("plate.toml", "format = 1\ntolerance_mm = 0.03\n" + pinText(1, 0, 0, 4, "u_mm = 0.001\n") +
                                           pinText(2, 50, 0, 4) + pinText(3, 0, 50, 4) + pinText(4, 50, 50, 4)));
  ASSERT_TRUE(plate.has_value()) << plate.error().message();
  EXPECT_EQ(plate->id, "plate");
  EXPECT_EQ(plate->pins[0].uCentreMm, 0.001);
  EXPECT_NEAR(plate->pins[1].uCentreMm, 0.03 / std::sqrt(3), 1e-12);
  EXPECT_EQ(plate->pins[1].uRadiusMm, 0);
}

TEST_F(PinPlateFile, BadPlatesAreRefusedInOneLine) {
  const std::string head = "format = 1\n", three = pinText(1, 0, 0, 4) + pinText(2, 50, 0, 4) + pinText(3, 0, 50, 4);
  const std::vector<std::pair<std::string, std::string>> bad = {
      {head + three, "at least 4"},
      {head + three + pinText(3, 50, 50, 4), "twice"},
      {head + three + pinText(4, 5, 50, 4), "overlapping"},
      {head + pinText(1, 0, 0, 4) + pinText(2, 20, 20, 4) + pinText(3, 40, 40, 4) + pinText(4, 80, 80, 4), "one line"},
      {head + three + pinText(4, 50, 50, -4), "radius_mm"},
      {head + three + pinText(4, 50, 50, 4, "colour = 3\n"), "colour"},
      {head + "pins = [[0, 0, 4]]\n", "pin"},
      {three, "format"}};
  for (const auto& [text, why] : bad) {
    const auto plate = loadPinPlate(write("bad.toml", text));
    ASSERT_FALSE(plate.has_value()) << text;
    EXPECT_NE(plate.error().message().find(why), std::string::npos) << plate.error().message();
    EXPECT_NE(plate.error().message().find("bad.toml"), std::string::npos);
    EXPECT_EQ(plate.error().message().find('\n'), std::string::npos);
  }
  for (const char* text : {"{}", "[[0, 0]]", "[[0, 0, 5], [1, 2, \"x\"]]", "[", "[[0,0,5],[50,0,5],[0,50,5]]",
                           "[[0,0,5],[50,0,5],[0,50,5],[1e9,3,5]]", "[[0,0,5],[50,0,5],[0,50,5],[50,50,0]]"}) {
    const auto plate = loadPinPlate(write("bad.json", text));
    ASSERT_FALSE(plate.has_value()) << text;
    EXPECT_NE(plate.error().message().find("bad.json"), std::string::npos);
  }
  EXPECT_FALSE(loadPinPlate(folder_ / "absent.toml").has_value());
}

}  // namespace
}  // namespace vignole
