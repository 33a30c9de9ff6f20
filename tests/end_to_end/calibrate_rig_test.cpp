// What a technician does wrong with the pin plate, through the command line: the reason and the remedy, and no file.

#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace vignole {
namespace {

using namespace vignole::testing;

struct Mishap {
  std::string name;
  std::vector<std::string> simulated;  ///< words for `simulate plate`
  std::vector<std::string> said;
  bool accepted = false;
};

void PrintTo(const Mishap& m, std::ostream* out) { *out << m.name; }

class CalibrateRig : public ::testing::TestWithParam<Mishap> {};

TEST_P(CalibrateRig, SaysWhatIsWrongAndWhatToDo) {
  const Mishap& mishap = GetParam();
  const Folder folder;
  const std::string plate = folder.file("plate");
  std::vector<std::string> simulate = {"simulate",   "plate", "--out",        plate, "--rig-seed",       "17",
                                       "--seed",     "3",     "--placements", "2",   "--plate-error-um", "3",
                                       "--noise-px", "0.1",   "--quiet"};
  simulate.insert(simulate.end(), mishap.simulated.begin(), mishap.simulated.end());
  ASSERT_EQ(run(simulate).exitCode, 0);
  std::vector<std::string> calibrate = {"calibrate", "rig", "--plate", plate + "/plate.toml", "--quiet"};
  for (const char* placement : {"/placement1", "/placement2"})
    calibrate.insert(calibrate.end(), {"--placement", plate + placement});
  for (int c = 1; c <= 4; ++c)
    calibrate.insert(calibrate.end(), {"--intrinsics", plate + "/intrinsics/camera" + std::to_string(c) + ".toml"});
  calibrate.insert(calibrate.end(), {"--out", folder.file("rig")});
  const ProgramResult result = run(calibrate);
  EXPECT_EQ(result.exitCode, mishap.accepted ? 0 : 1) << result.out << result.err;
  EXPECT_EQ(std::filesystem::exists(folder.file("rig.toml")) || std::filesystem::exists(folder.file("rig")),
            mishap.accepted);
  for (const std::string& words : mishap.said)
    EXPECT_NE((result.out + result.err).find(words), std::string::npos) << words << "\n" << result.out << result.err;
}

INSTANTIATE_TEST_SUITE_P(
    Mishaps, CalibrateRig,
    ::testing::Values(
        Mishap{"None", {}, {"Table IV", "chi2 per degree of freedom"}, true},
        Mishap{"SaturatedPins",
               {"--fault", "saturated@2"},
               {"placement1/camera2.png", "most of the pins are saturated", "shorten the exposure"}},
        Mishap{"LaserOff", {"--fault", "black@3"}, {"placement2/camera3.png", "no laser line is seen", "camera 3"}},
        Mishap{"MissingPin", {"--missing-pin", "7"}, {"pin 7 is used in no picture"}, true},
        Mishap{"PlateMoved", {"--fault", "move=0.2@1:2-2"}, {"refused, because", "stand still"}},
        Mishap{"LeaningPlate", {"--tilt", "5"}, {"refused, because"}},
        Mishap{"PlateTurnedOver", {"--mirror"}, {"mirror image", "turn the plate over"}}),
    [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace vignole
