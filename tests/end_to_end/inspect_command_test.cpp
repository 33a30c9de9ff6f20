#include <algorithm>
#include <csignal>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/recipe/recipe.h"
#include "engine/simulator/virtual_rig.h"
#include "tests/end_to_end/program.h"

namespace vignole {
namespace {

using namespace vignole::testing;
using nlohmann::json;

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

void expectOneLineError(const ProgramResult& result, int exitCode, const std::string& about) {
  EXPECT_EQ(result.exitCode, exitCode) << result.err;
  EXPECT_EQ(lines(result.err), 1U) << result.err;
  EXPECT_NE(result.err.find(about), std::string::npos) << result.err;
}

TEST(InspectCommand, JsonHasTheKeysOfTheContractAndNothingElseIsOnStdout) {
  const ProgramResult result = run({"inspect", "--length", "0.3", "--json", "-"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const json document = json::parse(result.out);
  for (const char* key :
       {"version", "rails", "triggers", "stages", "profiles_per_s", "wall_s", "calibration", "effects", "truth"})
    EXPECT_TRUE(document.contains(key)) << key;
  const json& rail = document["rails"].at(0);
  for (const char* key : {"id", "heat", "section", "recipe", "length_m", "profiles", "verdict", "dimensions"})
    EXPECT_TRUE(rail.contains(key)) << key;
  EXPECT_EQ(rail["section"], "60E1");
  EXPECT_EQ(rail["profiles"], 20);
  EXPECT_NEAR(rail["length_m"].get<double>(), 0.3, 1e-9);
  ASSERT_EQ(rail["dimensions"].size(), 13U);
  for (const json& d : rail["dimensions"])
    for (const char* key : {"name", "nominal_mm", "mean_mm", "min_mm", "max_mm", "s_mm", "u_mm", "lower_mm", "upper_mm",
                            "verdict", "exceptions"})
      EXPECT_TRUE(d.contains(key)) << key;
  EXPECT_EQ(rail["dimensions"][0]["name"], "RH");
  EXPECT_NEAR(rail["dimensions"][0]["nominal_mm"].get<double>(), 172, 1e-6);
  EXPECT_NEAR(rail["dimensions"][4]["nominal_mm"].get<double>(), 71.963, 1e-3);
  EXPECT_EQ(document["triggers"]["seen"], 20);
  EXPECT_EQ(document["triggers"]["measured"], 20);
  ASSERT_EQ(document["stages"].size(), 14U);
  EXPECT_EQ(document["stages"][4]["name"], "extract.1");
  for (const char* key :
       {"name", "count", "mean_ms", "sd_ms", "ucl99_ms", "max_ms", "queue_capacity", "queue_high_water", "overflows"})
    EXPECT_TRUE(document["stages"][4].contains(key)) << key;
  EXPECT_EQ(document["effects"]["read-noise"], 3);
  ASSERT_EQ(document["truth"]["dimensions"].size(), 13U);
  for (const char* key : {"name", "bias_mm", "rms_mm", "max_mm", "mean_sq_error_over_u"})
    EXPECT_TRUE(document["truth"]["dimensions"][0].contains(key)) << key;
}

TEST(InspectCommand, CsvHasTheColumnsOfTheContractAndOneRowAProfile) {
  const Folder folder;
  const std::string file = folder.file("rail.csv");
  const ProgramResult result = run({"inspect", "--length", "0.15", "--csv", file, "--fault", "frame-loss=1@2:4-4"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  const std::string csv = contents(file);
  EXPECT_EQ(
      csv.substr(0, csv.find('\n')),
      "rail,profile,position_m,trigger,RH,RFH,FW,HF,HW,HWA,FT_l,FT_r,RAS_l,RAS_r,WT,HR,FC,u_RH,u_RFH,u_FW,u_HF,u_HW,"
      "u_HWA,u_FT_l,u_FT_r,u_RAS_l,u_RAS_r,u_WT,u_HR,u_FC,rms_mm,inliers,flags");
  EXPECT_EQ(lines(csv), 11U);
  EXPECT_NE(csv.find("camera 2: frame lost"), std::string::npos);
  EXPECT_NE(result.out.find("verdict"), std::string::npos);
  EXPECT_NE(result.out.find("measure"), std::string::npos);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    EXPECT_EQ(entry.path().filename(), "rail.csv") << "nothing else is left behind";
}

TEST(InspectCommand, TheSameSeedGivesTheSameFileAnotherSeedAnother) {
  const Folder folder;
  for (const auto& [name, seed] : {std::pair{"a", "7"}, {"b", "7"}, {"c", "8"}})
    EXPECT_EQ(run({"inspect", "--length", "0.15", "--seed", seed, "--csv", folder.file(name)}).exitCode, 0);
  EXPECT_EQ(contents(folder.file("a")), contents(folder.file("b")));
  EXPECT_NE(contents(folder.file("a")), contents(folder.file("c")));
}

TEST(InspectCommand, ARailOutOfToleranceEndsWithOne) {
  const ProgramResult result = run({"inspect", "--length", "0.1", "--deviation", "HW=0.8", "--json", "-"});
  EXPECT_EQ(result.exitCode, 1) << result.err;
  const json document = json::parse(result.out);
  const json& hw = document["rails"][0]["dimensions"][4];
  EXPECT_EQ(hw["verdict"], "fail");
  EXPECT_EQ(hw["exceptions"].size(), 1U);
  EXPECT_EQ(document["rails"][0]["verdict"], "fail");
}

TEST(InspectCommand, WhatCannotBeIsRefusedInOneLine) {
  expectOneLineError(run({"inspect", "--source", "gige", "--site", "/nowhere/site.toml"}), 2, "/nowhere/site.toml");
  expectOneLineError(run({"inspect", "--archive", "postgresql://127.0.0.1:1/rails"}), 3, "cannot be reached");
  expectOneLineError(run({"inspect", "--address", "127.0.0.11"}), 2, "--address");
  expectOneLineError(run({"inspect", "--source", "film"}), 2, "--source");
  expectOneLineError(run({"inspect", "--recipe", "61E9"}), 2, "61E9");
  expectOneLineError(run({"inspect", "--effect", "magic=on"}), 2, "magic");
  expectOneLineError(run({"inspect", "--fault", "flood@2"}), 2, "flood");
  expectOneLineError(run({"inspect", "--deviation", "XX=1"}), 2, "XX");
  expectOneLineError(run({"inspect", "--deviation", "HW=wide"}), 2, "HW=wide");
  expectOneLineError(run({"inspect", "--length", "-1"}), 2, "--length");
  expectOneLineError(run({"inspect", "--rails", "0"}), 2, "--rails");
  expectOneLineError(run({"inspect", "--report", "rail.doc"}), 2, "rail.doc");
  expectOneLineError(run({"inspect", "--calibration", "/nowhere/rig.toml"}), 2, "/nowhere/rig.toml");
  const ProgramResult nowhere = run({"inspect", "--length", "0.1", "--csv", "/nowhere/rail.csv"});
  EXPECT_GE(nowhere.exitCode, 2);
  EXPECT_EQ(lines(nowhere.err), 1U) << nowhere.err;
}

TEST(InspectCommand, TheCalibrationOfAnotherRigIsRefusedItsOwnGivesTheSameNumbers) {
  const Folder folder;
  const auto save = [&](std::uint64_t rigSeed, const std::string& name) {
    VirtualRigSettings settings;
    settings.section = findRecipe("60E1 X/A")->section;
    settings.rigSeed = rigSeed;
    const auto rig = VirtualRig::create(std::move(settings)).value();
    ASSERT_TRUE(saveCalibration(rig->calibration(), folder.file(name)));
  };
  save(7, "own.toml");
  save(8, "other.toml");
  const std::vector<std::string> common = {"inspect", "--length", "0.1", "--rig-seed", "7", "--json", "-"};
  const auto with = [&](const std::string& name) {
    auto arguments = common;
    arguments.insert(arguments.end(), {"--calibration", folder.file(name)});
    return run(arguments);
  };
  const ProgramResult exact = run(common), own = with("own.toml");
  EXPECT_EQ(own.exitCode, 0) << own.err;
  const json a = json::parse(exact.out), b = json::parse(own.out);
  for (std::size_t d = 0; d < 13; ++d)
    EXPECT_NEAR(a["rails"][0]["dimensions"][d]["mean_mm"].get<double>(),
                b["rails"][0]["dimensions"][d]["mean_mm"].get<double>(), 1e-6);
  const ProgramResult other = with("other.toml");
  EXPECT_EQ(other.exitCode, 2) << other.err;
  EXPECT_EQ(lines(other.err), 1U) << other.err;
}

TEST(InspectCommand, AnotherRailThanTheRecipesIsNamedAndNotMeasured) {
  for (const std::string rail : {"54E1", "60E2"}) {
    const ProgramResult result = run({"inspect", "--length", "0.1", "--fault", "wrong-rail=" + rail, "--json", "-"});
    EXPECT_EQ(result.exitCode, 1) << result.err;
    const json document = json::parse(result.out);
    ASSERT_TRUE(document["rails"][0].contains("looks_like")) << rail;
    EXPECT_EQ(document["rails"][0]["looks_like"]["section"], rail);
    EXPECT_EQ(document["rails"][0]["verdict"], "not measured");
    EXPECT_EQ(document["triggers"]["incomplete"], 6);
    EXPECT_EQ(document["triggers"]["reasons"]["wrong section: looks like " + rail], 6);
    for (const json& dimension : document["rails"][0]["dimensions"]) EXPECT_TRUE(dimension["mean_mm"].is_null());
  }
  // A defect of the right rail is no other rail.
  for (const char* deviation : {"HW=0.8", "RH=1", "RH=-2", "FW=1"}) {
    const json document = json::parse(run({"inspect", "--length", "0.1", "--deviation", deviation, "--json", "-"}).out);
    EXPECT_FALSE(document["rails"][0].contains("looks_like")) << deviation;
    EXPECT_EQ(document["triggers"]["measured"], 6) << deviation;
  }
}

TEST(InspectCommand, CamerasThatSeeNothingAreTheWorldsFault) {
  const ProgramResult result = run({"inspect", "--length", "0.1", "--fault", "black"});
  expectOneLineError(result, 3, "camera");
}

TEST(InspectCommand, OneBlackCameraIsNamedAndTheOthersAreStillMeasured) {
  const Folder folder;
  const std::string file = folder.file("rail.json");
  const ProgramResult result = run({"inspect", "--length", "0.1", "--fault", "black@2", "--json", file});
  expectOneLineError(result, 3, "camera 2: no stripe (black?) in all of 6 profiles");
  const auto document = json::parse(contents(file));
  EXPECT_EQ(document["triggers"]["incomplete"], 6);
  EXPECT_EQ(document["rails"][0]["verdict"], "not measured");
}

TEST(InspectCommand, OneSaturatedCameraIsNamed) {
  const ProgramResult result = run({"inspect", "--length", "0.1", "--fault", "saturated@1"});
  expectOneLineError(result, 0, "camera 1: ");
  EXPECT_NE(result.err.find("is saturated; shorten its exposure"), std::string::npos) << result.err;
}

TEST(InspectCommand, WhatWasNotMeasuredIsNoPass) {
  const ProgramResult result = run({"inspect", "--length", "0.1", "--temperature", "200"});
  EXPECT_EQ(result.exitCode, 1) << result.err;
  EXPECT_NE(result.out.find("above 150 C no cold size is given"), std::string::npos) << result.out;
}

TEST(InspectCommand, SecondsEndsTheRunAndTheRailIsStillTold) {
  const ProgramResult result = run({"inspect", "--length", "5000", "--seconds", "1", "--json", "-"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  const json document = json::parse(result.out);
  ASSERT_EQ(document["rails"].size(), 1U);
  EXPECT_GT(document["rails"][0]["profiles"], 0);
  const json& t = document["triggers"];
  EXPECT_EQ(t["seen"].get<int>(), t["measured"].get<int>() + t["incomplete"].get<int>() + t["lost"].get<int>());
}

TEST(InspectCommand, ControlCEndsItCleanly) {
  const Folder folder;
  Program program({"inspect", "--length", "5000", "--csv", folder.file("rail.csv"), "--json", "-"});
  // Its temporary file says that it is past its preparations.
  while (std::filesystem::is_empty(folder.path())) std::this_thread::yield();
  program.signal(SIGINT);
  const ProgramResult result = program.wait();
  // Nothing at all may have been measured yet; what was is written.
  EXPECT_TRUE(result.exitCode == 0 || result.exitCode == 3) << result.exitCode << result.err;
  EXPECT_TRUE(json::parse(result.out).contains("triggers"));
  EXPECT_TRUE(std::filesystem::exists(folder.file("rail.csv")));
}

TEST(InspectCommand, PacedIsLiveAndAccountsForEverything) {
  const ProgramResult result = run({"inspect", "--length", "0.6", "--speed", "0.5", "--paced", "--json", "-"});
  const json document = json::parse(result.out);
  const json& t = document["triggers"];
  EXPECT_EQ(t["seen"], 40);
  EXPECT_EQ(t["seen"].get<int>(), t["measured"].get<int>() + t["incomplete"].get<int>() + t["lost"].get<int>());
  EXPECT_GE(document["wall_s"].get<double>(), 0.6 / 0.5 - 0.1);
}

TEST(InspectCommand, ReportsAreWrittenOrRefusedByAProgramWithoutThem) {
  const Folder folder;
  const ProgramResult result =
      run({"inspect", "--length", "0.1", "--report", folder.file("rail.pdf"), "--report", folder.file("rail.png")});
#ifdef VIGNOLE_REPORT
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(contents(folder.file("rail.pdf")).substr(0, 5), "%PDF-");
  EXPECT_EQ(contents(folder.file("rail.png")).substr(1, 3), "PNG");
#else
  expectOneLineError(result, 2, "without reports");
#endif
}

TEST(BenchCommand, GivesTheNamesAndUnitsOfTheContract) {
  const ProgramResult result =
      run({"bench", "simulate", "extract", "translate", "register", "measure", "--frames", "8", "--json", "-"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const json document = json::parse(result.out);
  EXPECT_TRUE(document["machine"].is_string());
  std::map<std::string, std::string> units;
  for (const json& r : document["results"]) {
    units[r["name"]] = r["unit"];
    EXPECT_GT(r["n"], 0) << r["name"];
    EXPECT_LE(r["min"], r["median"]);
    EXPECT_LE(r["median"], r["p99"]);
  }
  const std::map<std::string, std::string> contract = {
      {"extract.cold", "ms"},         {"extract.hot", "ms"},
      {"extract.read", "ms"},         {"translate", "ms"},
      {"simulate.frame", "ms"},       {"register", "us"},
      {"register.outliers", "us"},    {"measure", "us"},
      {"register.search.grid", "us"}, {"register.search.rtree", "us"},
      {"register.search.all", "us"},  {"register.search.cached", "us"}};
  for (const auto& [name, unit] : contract) EXPECT_EQ(units[name], unit) << name;
  expectOneLineError(run({"bench", "extract", "--threads", "1000"}), 2, "--threads");
}

}  // namespace
}  // namespace vignole
