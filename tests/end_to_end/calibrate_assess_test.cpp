// A rig calibrated on pictures of the plate, the calibration judged on placements that it has not seen.

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace vignole {
namespace {

using namespace vignole::testing;
using nlohmann::json;

/// Pictures of rig 7's plate in a folder of their own.
std::string pictures(const Folder& folder, const std::string& name, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"simulate",   "plate",  "--out",  folder.file(name),  "--rig-seed",
                                        "7",          "--seed", "7",      "--plate-error-um", "3",
                                        "--noise-px", "0.1",    "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProgramResult result = run(arguments);
  EXPECT_EQ(result.exitCode, 0) << result.err;
  return folder.file(name);
}

const json& check(const json& document, const std::string& name) {
  for (const json& c : document["checks"])
    if (c["name"] == name) return c;
  ADD_FAILURE() << "no check " << name;
  return document["checks"].at(0);
}

TEST(CalibrateAssess, JudgesACalibrationOnPlacementsThatItHasNotSeen) {
  const Folder folder;
  const std::string plate = pictures(folder, "plate", {"--placements", "3"});
  std::vector<std::string> calibrate = {"calibrate",       "rig", "--plate", plate + "/plate.toml",
                                        "--interval-days", "90",  "--quiet"};
  for (const char* placement : {"/placement1", "/placement2"})
    calibrate.insert(calibrate.end(), {"--placement", plate + placement});
  for (int c = 1; c <= 4; ++c)
    calibrate.insert(calibrate.end(), {"--intrinsics", plate + "/intrinsics/camera" + std::to_string(c) + ".toml"});
  calibrate.insert(calibrate.end(), {"--out", folder.file("rig.toml")});
  const ProgramResult calibrated = run(calibrate);
  ASSERT_EQ(calibrated.exitCode, 0) << calibrated.out << calibrated.err;

  const ProgramResult good = run({"calibrate", "assess", "--calibration", folder.file("rig.toml"), "--placement",
                                  plate + "/placement3", "--json", "-"});
  EXPECT_EQ(good.exitCode, 0) << good.err;
  const json document = json::parse(good.out);
  EXPECT_EQ(document["valid"], true);
  EXPECT_EQ(document["calibration"]["interval_days"], 90);
  ASSERT_EQ(document["cameras"].size(), 4U);
  for (const json& camera : document["cameras"]) EXPECT_LT(camera["cd"]["mean"].get<double>(), 0.09);
  EXPECT_EQ(document["dimension_uncertainty"].size(), 13U);
  for (const json& d : document["dimension_uncertainty"]) EXPECT_GT(d["u_mm"].get<double>(), 0) << d;

  // The same rig after camera 3 was pushed.
  const std::string later = pictures(folder, "later", {"--placements", "1", "--fault", "move=0.1@3"});
  const ProgramResult bad = run({"calibrate", "assess", "--calibration", folder.file("rig.toml"), "--placement",
                                 later + "/placement1", "--json", "-"});
  EXPECT_EQ(bad.exitCode, 1) << bad.err;
  const json refused = json::parse(bad.out);
  EXPECT_EQ(refused["valid"], false);
  EXPECT_EQ(check(refused, "seam shift")["pass"], false) << refused["checks"];
  EXPECT_NE(bad.err.find("refused, because"), std::string::npos) << bad.err;
}

TEST(CalibrateAssess, BadInputGetsOneLine) {
  const Folder folder;
  const auto refused = [](const std::vector<std::string>& arguments, const std::string& about) {
    const ProgramResult r = run(arguments);
    EXPECT_EQ(r.exitCode, 2) << r.err;
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
    EXPECT_NE(r.err.find(about), std::string::npos) << r.err;
  };
  refused({"calibrate", "assess", "--calibration", folder.file("absent.toml"), "--placement", "x"}, "absent.toml");
  refused({"calibrate", "assess", "--placement", "x"}, "--calibration");
}

}  // namespace
}  // namespace vignole
