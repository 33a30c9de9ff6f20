// simulate plate, target and campaign as commands: the files of the contract, the truth in them, bad input in one line.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>

#include "engine/acquisition/picture_file.h"
#include "engine/optics/intrinsics_toml.h"
#include "engine/optics/plane_map.h"
#include "engine/simulator/virtual_rig.h"
#include "engine/target/pin_plate.h"
#include "tests/end_to_end/program.h"

namespace vignole {
namespace {

namespace fs = std::filesystem;
using testing::contents;
using testing::Folder;
using testing::run;
using Json = nlohmann::json;

Json jsonOf(const fs::path& file) { return Json::parse(contents(file), nullptr, false); }

/// Every file below, by its relative name, with what is in it.
std::map<std::string, std::string> filesBelow(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).string()] = contents(entry.path());
  return files;
}

TEST(SimulatePlate, WritesThePlateAsStatedThePicturesAndTheTruth) {
  const Folder folder;
  const std::vector<std::string> command = {"simulate",   "plate", "--placements", "2", "--plate-error-um", "50",
                                            "--noise-px", "0.1",   "--rig-seed",   "7", "--seed",           "3"};
  for (const char* name : {"one", "two"}) {
    std::vector<std::string> all = command;
    all.insert(all.end(), {"--out", folder.file(name)});
    const auto done = run(all);
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_EQ(done.out, "");
    EXPECT_EQ(done.err, "");
  }
  const auto files = filesBelow(folder.path() / "one");
  EXPECT_TRUE(files == filesBelow(folder.path() / "two")) << "the same seed, the same bytes";
  ASSERT_EQ(files.size(), 15U);  // 2 x 4 pictures, 4 intrinsics, plate, calibration, truth

  const fs::path out = folder.path() / "one";
  const auto stated = loadPinPlate(out / "plate.toml");
  ASSERT_TRUE(stated.has_value()) << stated.error().message();
  const auto calibration = loadCalibration(out / "true_calibration.toml");
  ASSERT_TRUE(calibration.has_value()) << calibration.error().message();
  const Json truth = jsonOf(out / "truth.json");
  ASSERT_TRUE(truth.is_object());
  EXPECT_EQ(truth["rig_seed"], 7);
  EXPECT_GT(truth["plate"]["noise_factor"].get<double>(), 0.3);
  EXPECT_LT(truth["plate"]["noise_factor"].get<double>(), 1);
  ASSERT_EQ(truth["plate"]["pins"].size(), 13U);
  bool differs = false;
  for (std::size_t i = 0; i < 13; ++i) {
    const Pin& pin = stated->pins[i];
    const Json& made = truth["plate"]["pins"][i];
    EXPECT_NEAR(pin.uCentreMm, 0.05 / std::sqrt(3), 1e-12);
    EXPECT_NEAR(pin.uRadiusMm, 0.01 / std::sqrt(3), 1e-12);
    EXPECT_NEAR(made["x_mm"].get<double>(), pin.centreMm.x(), 0.05);
    EXPECT_NEAR(made["radius_mm"].get<double>(), pin.radiusMm, 0.01);
    differs = differs || std::abs(made["x_mm"].get<double>() - pin.centreMm.x()) > 0.03;
  }
  EXPECT_TRUE(differs);
  // The arcs of the truth, brought into the world by the true calibration, lie on the true pins of their placement.
  ASSERT_EQ(truth["plate"]["placements"].size(), 2U);
  int points = 0;
  for (const Json& placement : truth["plate"]["placements"]) {
    const Json& pose = placement["world_from_plate"];
    const Transform2 worldFromPlate{pose["x_mm"].get<double>(), pose["y_mm"].get<double>(),
                                    pose["angle_deg"].get<double>() * 3.14159265358979323846 / 180};
    for (std::size_t camera = 0; camera < kCameraCount; ++camera) {
      const PlaneMap map(calibration->rangeFinders[camera]);
      for (const Json& arc : placement["cameras"][camera]["visible_arcs"]) {
        const Json& pin = truth["plate"]["pins"][arc["pin"].get<std::size_t>() - 1];
        const Point2 centre = worldFromPlate * Point2(pin["x_mm"].get<double>(), pin["y_mm"].get<double>());
        for (const Json& px : arc["px"]) {
          const PlanePoint p = map(px[0].get<double>(), px[1].get<double>());
          EXPECT_NEAR((Point2(p.x, p.y) - centre).norm(), pin["radius_mm"].get<double>(), 1e-4);
          ++points;
        }
      }
    }
  }
  EXPECT_GT(points, 3000);
  const auto picture = readPicture(out / "placement2" / "camera3.png");
  ASSERT_TRUE(picture.has_value()) << picture.error().message();
}

TEST(SimulatePlate, IntrinsicsErrByWhatTheirFilesSay) {
  const Folder folder;
  // Errors over their standard uncertainties, over some seeds: chi-squared.
  double chi2 = 0;
  int n = 0;
  for (int seed = 1; seed <= 6; ++seed) {
    const fs::path out = folder.path() / std::to_string(seed);
    const auto done = run({"simulate", "plate", "--out", out.string(), "--placements", "1", "--rig-seed", "7", "--seed",
                           std::to_string(seed)});
    ASSERT_EQ(done.exitCode, 0) << done.err;
    const auto truth = loadCalibration(out / "true_calibration.toml");
    ASSERT_TRUE(truth.has_value());
    for (std::size_t camera = 0; camera < kCameraCount; ++camera) {
      auto toml = TomlReader::load(out / "intrinsics" / ("camera" + std::to_string(camera + 1) + ".toml"));
      ASSERT_TRUE(toml.has_value()) << toml.error().message();
      const Intrinsics found = readIntrinsics(*toml, "intrinsics."), in = truth->rangeFinders[camera].intrinsics;
      EXPECT_EQ(found.model, in.model);
      EXPECT_EQ(found.pixelHeightMm, in.pixelHeightMm);
      chi2 += std::pow((found.focalMm - in.focalMm) / (5e-4 * in.focalMm), 2);
      chi2 += std::pow((found.cxPx - in.cxPx) / 1.5, 2) + std::pow((found.cyPx - in.cyPx) / 1.5, 2);
      const double sd = 3e-3 / (in.focalMm * in.focalMm);
      chi2 += std::pow((found.kappa + found.k1 - in.kappa - in.k1) / sd, 2);
      n += 4;
    }
  }
  // 96 degrees of freedom: 96 +- 14.
  EXPECT_NEAR(chi2, n, 4 * std::sqrt(2.0 * n));

  const auto done = run({"simulate", "plate", "--out", folder.file("exact"), "--placements", "1", "--rig-seed", "7",
                         "--exact-intrinsics"});
  ASSERT_EQ(done.exitCode, 0) << done.err;
  const auto truth = loadCalibration(folder.path() / "exact" / "true_calibration.toml");
  auto toml = TomlReader::load(folder.path() / "exact" / "intrinsics" / "camera2.toml");
  ASSERT_TRUE(truth.has_value() && toml.has_value());
  EXPECT_EQ(readIntrinsics(*toml, "intrinsics.").k1, truth->rangeFinders[1].intrinsics.k1);
  EXPECT_FALSE(toml->has("uncertainty"));
}

TEST(SimulatePlate, OptionsChangeWhatTheySay) {
  const Folder folder;
  const auto made = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> command = {"simulate", "plate", "--out", folder.file(name), "--placements", "1"};
    command.insert(command.end(), more.begin(), more.end());
    const auto done = run(command);
    EXPECT_EQ(done.exitCode, 0) << done.err;
    return folder.path() / name;
  };
  const fs::path exposures = made("exposures", {"--exposure", "5", "--exposure", "15", "--exposure", "2.5"});
  for (const char* at : {"exposure2.5ms", "exposure5ms", "exposure15ms"})
    EXPECT_TRUE(fs::exists(exposures / at / "placement1" / "camera4.png")) << at;
  EXPECT_FALSE(fs::exists(exposures / "placement1"));
  EXPECT_TRUE(fs::exists(exposures / "plate.toml"));
  EXPECT_EQ(jsonOf(exposures / "truth.json")["plate"]["placements"][0]["folders"].size(), 3U);

  const fs::path turned = made("turned", {"--turn", "3", "--tilt", "0.5", "--missing-pin", "4", "--missing-pin", "9"});
  const Json plate = jsonOf(turned / "truth.json")["plate"];
  EXPECT_NEAR(plate["placements"][0]["world_from_plate"]["angle_deg"].get<double>(), 3, 1e-9);
  EXPECT_NEAR(plate["placements"][0]["world_from_plate"]["tilt_x_deg"].get<double>(), 0.5, 1e-9);
  EXPECT_TRUE(plate["pins"][3]["missing"].get<bool>());
  EXPECT_EQ(plate["placements"][0]["cameras"][0]["visible_arcs"].size(), 11U);

  const fs::path mirrored = made("mirrored", {"--mirror"});
  EXPECT_NEAR(jsonOf(mirrored / "truth.json")["plate"]["pins"][1]["x_mm"].get<double>(), 40, 1e-9);
  const auto stated = loadPinPlate(mirrored / "plate.toml");
  ASSERT_TRUE(stated.has_value());
  EXPECT_EQ(stated->pins[1].centreMm.x(), -40);
  EXPECT_GT(stated->pins[1].uCentreMm, 0) << "never without any doubt";
}

TEST(SimulateTarget, WritesViewsWithTheirTruth) {
  const Folder folder;
  const auto done = run({"simulate", "target", "--out", folder.file("t"), "--target", "chessboard:9x6:15", "--views",
                         "2", "--camera", "2", "--laser"});
  ASSERT_EQ(done.exitCode, 0) << done.err;
  for (const char* name : {"view01.png", "view01_laser.png", "view02.png", "view02_laser.png"})
    EXPECT_TRUE(readPicture(folder.path() / "t" / name).has_value()) << name;
  const Json truth = jsonOf(folder.path() / "t" / "truth.json");
  EXPECT_EQ(truth["target"], "chessboard:9x6:15");
  EXPECT_EQ(truth["intrinsics"]["model"], "polynomial");
  ASSERT_EQ(truth["views"].size(), 2U);
  EXPECT_EQ(truth["views"][1]["points_px"].size(), 54U);
  EXPECT_EQ(truth["views"][1]["laser_image"], "view02_laser.png");
}

TEST(SimulateCampaign, WritesAllOfOneCalibrationAndItsCommands) {
  const Folder folder;
  const auto done = run({"simulate", "campaign", "--out", folder.file("c"), "--views", "1", "--placements", "2",
                         "--plate-error-um", "3", "--target-error-um", "20", "--rig-seed", "9"});
  ASSERT_EQ(done.exitCode, 0) << done.err;
  const fs::path out = folder.path() / "c";
  for (const char* name : {"camera1/view01.png", "camera4/view01.png", "plate.toml", "placement1/camera1.png",
                           "placement2/camera4.png", "true_calibration.toml"})
    EXPECT_TRUE(fs::exists(out / name)) << name;
  const Json truth = jsonOf(out / "truth.json");
  EXPECT_EQ(truth["target"]["cameras"].size(), 4U);
  EXPECT_EQ(truth["rig"]["cameras"].size(), 4U);
  const std::string commands = contents(out / "commands.txt");
  for (const char* part :
       {"calibrate intrinsics camera1/view*.png --target circles:13x9:12:6 --target-tolerance-um 20 --serial "
        "VIRTUAL-9-1 --out camera1.toml",
        "calibrate rig --plate plate.toml --placement placement1 placement2 --intrinsics camera1.toml",
        "inspect --rig-seed 9 --calibration rig.toml"})
    EXPECT_NE(commands.find(part), std::string::npos) << part;
}

TEST(SimulatePlate, BadInputIsOneLineAndLeavesNothing) {
  const Folder folder;
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"plate", "--plate", "nowhere.toml"}, "nowhere.toml"},
      {{"plate", "--missing-pin", "77"}, "77"},
      {{"plate", "--effect", "fog=on"}, "fog"},
      {{"plate", "--fault", "frame-loss=0.1"}, "frame-loss"},
      {{"plate", "--noise-px", "7"}, "noise-px"},
      {{"plate", "--exposure", "0"}, "exposure"},
      {{"plate", "--exposure", "5", "--exposure", "5"}, "exposure"},
      {{"plate", "--plate-error-um", "-3"}, "plate-error-um"},
      {{"target", "--target", "stripes:3x3:4"}, "stripes"},
      {{"target", "--target-error-um", "1e9"}, "target-error-um"},
      {{"target", "--camera", "5"}, "--camera"},
      {{"campaign", "--target", "circles:2"}, "circles:2"}};
  for (const auto& [arguments, said] : cases) {
    std::vector<std::string> command = {"simulate"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    command.insert(command.end(), {"--out", folder.file("out")});
    const auto done = run(command);
    EXPECT_EQ(done.exitCode, 2) << said;
    EXPECT_NE(done.err.find(said), std::string::npos) << done.err;
    EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    EXPECT_FALSE(fs::exists(folder.path() / "out")) << said;
  }
}

}  // namespace
}  // namespace vignole
