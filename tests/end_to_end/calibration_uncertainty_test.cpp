// The calibration's uncertainty in what `inspect` reports, and its age.

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/optics/rig_uncertainty.h"
#include "engine/rail/catalogue.h"
#include "engine/simulator/virtual_rig.h"
#include "engine/systematic/calibration_error.h"
#include "tests/end_to_end/program.h"

namespace vignole {
namespace {

using namespace vignole::testing;
using nlohmann::json;

RigCalibration exactRig() {
  VirtualRigSettings settings;
  settings.section = *findSection("60E1");
  return (*VirtualRig::create(settings))->calibration();
}

/// Every camera a little uncertain by itself.
RigCalibration uncertainRig() {
  RigCalibration rig = exactRig();
  rig.id = "joint-1";
  rig.method = "joint";
  rig.plate = "plate 13";
  RigChange sd = RigChange::Zero();
  for (int c = 0; c < kCameraCount; ++c) {
    sd[c * kCameraParameters + static_cast<int>(CameraParameter::F)] = 2e-4;
    for (int k = 0; k < 3; ++k) sd[c * kCameraParameters + static_cast<int>(CameraParameter::T1) + k] = 0.005;
  }
  rig.covariance = sd.cwiseAbs2().asDiagonal();
  return rig;
}

json inspected(const std::vector<std::string>& more, std::string* err = nullptr) {
  std::vector<std::string> arguments = {"inspect", "--length", "0.15", "--json", "-"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProgramResult result = run(arguments);
  EXPECT_EQ(result.exitCode, 0) << result.err;
  if (err != nullptr) *err = result.err;
  return json::parse(result.out);
}

TEST(CalibrationUncertaintyInInspect, JoinsThatOfTheProfiles) {
  const Folder folder;
  const RigCalibration rig = uncertainRig();
  ASSERT_TRUE(saveCalibration(rig, folder.file("rig.toml")));
  const json exact = inspected({}), uncertain = inspected({"--calibration", folder.file("rig.toml")});
  const Section section = *findSection("60E1");
  const auto u = calibrationUncertainty(section, section.parameters, rig);
  ASSERT_TRUE(u) << u.error().message();
  for (std::size_t d = 0; d < kDimensionCount; ++d) {
    const json &a = exact["rails"][0]["dimensions"][d], &b = uncertain["rails"][0]["dimensions"][d];
    EXPECT_EQ(a["mean_mm"], b["mean_mm"]) << a["name"];
    EXPECT_EQ(a["u_calibration_mm"], 0) << a["name"];
    const double calibration = (*u)[d], total = b["u_mm"].get<double>();
    EXPECT_GT(calibration, 0);
    EXPECT_NEAR(b["u_calibration_mm"].get<double>(), calibration, 1e-6 * calibration) << a["name"];
    EXPECT_NEAR(total, std::hypot(a["u_mm"].get<double>(), calibration), 0.02 * total) << a["name"];
    EXPECT_NEAR(b["u_mean_mm"].get<double>(), std::hypot(a["u_mean_mm"].get<double>(), calibration), 0.02 * total)
        << a["name"];
  }
  EXPECT_EQ(uncertain["calibration"]["id"], "joint-1");
  EXPECT_EQ(uncertain["calibration"]["plate"], "plate 13");
  EXPECT_EQ(uncertain["calibration"]["overdue"], false);
  EXPECT_TRUE(exact["calibration"]["plate"].is_null());
  EXPECT_TRUE(exact["calibration"]["interval_days"].is_null());
}

TEST(CalibrationUncertaintyInInspect, ACalibrationOlderThanItsIntervalIsFlagged) {
  const Folder folder;
  RigCalibration rig = exactRig();
  rig.created = "2020-05-01T00:00:00Z";
  rig.intervalDays = 90;
  ASSERT_TRUE(saveCalibration(rig, folder.file("rig.toml")));
  std::string err;
  const json document = inspected({"--calibration", folder.file("rig.toml")}, &err);
  EXPECT_EQ(document["calibration"]["overdue"], true);
  EXPECT_EQ(document["calibration"]["interval_days"], 90);
  EXPECT_GT(document["calibration"]["age_days"].get<double>(), 2000);
  EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
  EXPECT_NE(err.find("days old, its interval is 90"), std::string::npos) << err;
}

}  // namespace
}  // namespace vignole
