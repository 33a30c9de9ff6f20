// Recordings through the command line: measured again they give the live run's numbers to the last bit.

#include <algorithm>
#include <csignal>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <thread>

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

/// All but times and what was recorded meanwhile.
json numbersOf(const std::string& text) {
  json document = json::parse(text);
  for (const char* key : {"stages", "profiles_per_s", "wall_s", "recorded"}) document.erase(key);
  document["calibration"].erase("age_days");
  return document;
}

std::vector<std::string> replayed(const Folder& folder, const std::string& recording, const std::string& csv,
                                  std::vector<std::string> more = {}) {
  more.insert(more.begin(),
              {"inspect", "--source", "recording", "--recording", folder.file(recording), "--csv", folder.file(csv)});
  return more;
}

class Recorded : public ::testing::TestWithParam<bool> {};

TEST_P(Recorded, GivesTheLiveRunsNumbersToTheLastBit) {
  const Folder folder;
  std::vector<std::string> live = {"inspect",
                                   "--length",
                                   "0.3",
                                   "--rails",
                                   "2",
                                   "--deviation",
                                   "HW=0.4",
                                   "--fault",
                                   "frame-loss=0.1@2",
                                   "--fault",
                                   "missed-trigger=0.1@4",
                                   "--seed",
                                   "9",
                                   "--rig-seed",
                                   "4",
                                   "--recipe",
                                   "54E3",
                                   "--record",
                                   folder.file("rail.vgr"),
                                   "--csv",
                                   folder.file("live.csv"),
                                   "--json",
                                   "-"};
  if (GetParam()) live.insert(live.end(), {"--record-full"});
  const ProgramResult first = run(live);
  ASSERT_LE(first.exitCode, 1) << first.err;
  EXPECT_EQ(first.err, "");
  const json recorded = json::parse(first.out)["recorded"];
  EXPECT_EQ(recorded["triggers"], 40);
  EXPECT_EQ(recorded["dropped_triggers"], 0);
  EXPECT_EQ(recorded["whole_frames"], GetParam() ? recorded["frames"] : json(0));
  if (!GetParam()) {
    EXPECT_LT(recorded["kept_share"], 0.08);
  }

  const ProgramResult again = run(replayed(folder, "rail.vgr", "again.csv", {"--json", "-"}));
  EXPECT_EQ(again.exitCode, first.exitCode) << again.err;
  EXPECT_EQ(again.err, "");
  EXPECT_EQ(contents(folder.file("again.csv")), contents(folder.file("live.csv")));
  EXPECT_EQ(numbersOf(again.out), numbersOf(first.out));

  const ProgramResult verified = run({"recording", "verify", folder.file("rail.vgr"), "--json", "-"});
  EXPECT_EQ(verified.exitCode, 0) << verified.err;
  const json check = json::parse(verified.out);
  EXPECT_EQ(check["good"], true);
  EXPECT_EQ(check["compared"], check["frames"]);
  EXPECT_EQ(check["frames"], recorded["frames"]);

  const json info = json::parse(run({"recording", "info", folder.file("rail.vgr"), "--json", "-"}).out);
  EXPECT_EQ(info["closed"], true);
  EXPECT_EQ(info["setup"]["section"], "54E3");
  ASSERT_EQ(info["rails"].size(), 2U);
  EXPECT_EQ(info["rails"][1]["id"], "V9-2");
  EXPECT_EQ(info["rails"][1]["first_trigger"], 20);
  EXPECT_EQ(info["rails"][1]["end_trigger"], 40);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    EXPECT_EQ(entry.path().extension() == ".part", false);
}

INSTANTIATE_TEST_SUITE_P(Frames, Recorded, ::testing::Bool(),
                         [](const auto& which) { return which.param ? "Whole" : "Sparse"; });

TEST(RecordingCommand, AnotherRecipeOrCalibrationIsAppliedAsToTheLiveFrames) {
  const Folder folder;
  const std::string length = "0.2";
  ASSERT_EQ(run({"inspect", "--length", length, "--record", folder.file("rail.vgr")}).exitCode, 0);
  ASSERT_EQ(run({"recipes", "new", "--rail", "60E1", "--class", "X", "--straightness", "A", "--out",
                 folder.file("other.toml")})
                .exitCode,
            0);
  std::string recipe = contents(folder.file("other.toml"));
  const auto at = recipe.find("sigma_px = ");
  ASSERT_NE(at, std::string::npos) << recipe;
  recipe.replace(at, recipe.find_first_of(" \n", at + 11) - at, "sigma_px = 3.7");
  std::ofstream(folder.file("other.toml")) << recipe;
  ASSERT_EQ(
      run({"inspect", "--length", length, "--recipe", folder.file("other.toml"), "--csv", folder.file("live.csv")})
          .exitCode,
      0);
  const ProgramResult again = run(replayed(folder, "rail.vgr", "again.csv", {"--recipe", folder.file("other.toml")}));
  EXPECT_EQ(again.exitCode, 0) << again.err;
  EXPECT_EQ(contents(folder.file("again.csv")), contents(folder.file("live.csv")));

  recipe.replace(recipe.find("sigma_px = 3.7"), 14, "sigma_px = 4.5");
  std::ofstream(folder.file("broad.toml")) << recipe;
  expectOneLineError(run(replayed(folder, "rail.vgr", "x.csv", {"--recipe", folder.file("broad.toml")})), 2,
                     "sigma up to 4");

  // The calibration of other cameras is refused, as for a live run.
  ASSERT_EQ(run({"simulate", "rail", "--out", folder.file("other"), "--rig-seed", "8"}).exitCode, 0);
  expectOneLineError(
      run(replayed(folder, "rail.vgr", "x.csv", {"--calibration", folder.file("other/calibration.toml")})), 2,
      "camera 1");
}

TEST(RecordingCommand, PicturesGoInAndComeOut) {
  const Folder folder;
  ASSERT_EQ(run({"simulate", "rail", "--out", folder.file("frames"), "--frames", "3", "--rail", "54E1"}).exitCode, 0);
  const ProgramResult imported =
      run({"recording", "import", folder.file("frames"), "--out", folder.file("frames.vgr"), "--full"});
  EXPECT_EQ(imported.exitCode, 0) << imported.err;
  EXPECT_EQ(run({"recording", "verify", folder.file("frames.vgr")}).exitCode, 0);
  const ProgramResult measured = run(replayed(folder, "frames.vgr", "a.csv", {"--json", "-"}));
  EXPECT_EQ(measured.exitCode, 0) << measured.err;
  const json document = json::parse(measured.out);
  EXPECT_EQ(document["triggers"]["measured"], 3);
  EXPECT_EQ(document["rails"][0]["section"], "54E1");
  EXPECT_FALSE(document.contains("truth"));
  ASSERT_EQ(run({"recording", "export", folder.file("frames.vgr"), "--out", folder.file("out")}).exitCode, 0);
  ASSERT_EQ(
      run({"recording", "import", folder.file("out"), "--out", folder.file("again.vgr"), "--recipe", "54E1"}).exitCode,
      0);
  run(replayed(folder, "again.vgr", "b.csv", {"--quiet"}));
  // The rail's name is the folder's.
  std::string expected = contents(folder.file("a.csv"));
  for (std::size_t i = 0; (i = expected.find("\nframes,", i)) != std::string::npos;) expected.replace(i, 8, "\nout,");
  EXPECT_EQ(contents(folder.file("b.csv")), expected);
  std::filesystem::remove(folder.path() / "out/trigger1/camera2.png");
  expectOneLineError(run({"recording", "import", folder.file("out"), "--out", folder.file("x.vgr")}), 2,
                     "camera 2 at trigger 1");
  EXPECT_FALSE(std::filesystem::exists(folder.file("x.vgr")));
}

TEST(RecordingCommand, RailsOfAFolderAreKeptByTheirVerdict) {
  const Folder folder;
  const Folder kept;
  EXPECT_EQ(run({"inspect", "--length", "0.1", "--deviation", "HW=0.9", "--record", kept.path().string(),
                 "--record-keep", "rejected"})
                .exitCode,
            1);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(kept.path()), {}), 1);
  EXPECT_EQ(
      run({"inspect", "--length", "0.1", "--record", folder.path().string(), "--record-keep", "rejected"}).exitCode, 0);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(RecordingCommand, AnInterruptedRunLeavesAClosedRecordingAKilledOneAReadablePart) {
  const Folder folder;
  for (const int signal : {SIGINT, SIGKILL}) {
    const std::string name = signal == SIGINT ? "a.vgr" : "b.vgr";
    Program program({"inspect", "--length", "600", "--record", folder.file(name)});
    const std::string part = folder.file(name + ".part");
    std::error_code missing;
    for (int i = 0; i < 2000; ++i) {
      const auto size = std::filesystem::file_size(part, missing);
      if (!missing && size > 24'000'000) break;  // more than the cameras may be apart
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    program.signal(signal);
    const ProgramResult result = program.wait();
    if (signal == SIGINT) {
      EXPECT_EQ(result.exitCode, 0) << result.err;
      EXPECT_EQ(run({"recording", "verify", folder.file(name)}).exitCode, 0);
    } else {
      const json info = json::parse(run({"recording", "info", part, "--json", "-"}).out);
      EXPECT_EQ(info["closed"], false);
      EXPECT_GT(info["frames"], 40);
      const ProgramResult again = run(replayed(folder, name + ".part", "b.csv", {"--json", "-"}));
      EXPECT_EQ(again.exitCode, 0) << again.err;
      EXPECT_GT(json::parse(again.out)["triggers"]["measured"], 0);
    }
  }
}

TEST(RecordingCommand, WhatCannotBeIsRefusedInOneLine) {
  const Folder folder;
  std::ofstream(folder.file("text")) << "no recording";
  expectOneLineError(run({"inspect", "--source", "recording"}), 2, "--recording");
  expectOneLineError(run({"inspect", "--recording", "x"}), 2, "--source recording");
  expectOneLineError(run({"inspect", "--source", "recording", "--recording", folder.file("none")}), 2,
                     "does not exist");
  for (const char* command : {"info", "verify"}) {
    expectOneLineError(run({"recording", command, folder.file("none")}), 2, "does not exist");
    expectOneLineError(run({"recording", command, folder.file("text")}), 2, "is no recording");
    expectOneLineError(run({"recording", command, folder.path().string()}), 2, "is no file");
  }
  expectOneLineError(run({"recording", "export", folder.file("text"), "--out", folder.file("o")}), 2,
                     "is no recording");
  expectOneLineError(run({"recording", "import", folder.path().string(), "--out", folder.file("o")}), 2, "no pictures");
  expectOneLineError(run({"inspect", "--source", "recording", "--recording", "x", "--effect", "all=off"}), 2,
                     "--effect");
  expectOneLineError(run({"inspect", "--length", "0.1", "--record", folder.file("no/a.vgr")}), 2, "folder");
  expectOneLineError(run({"inspect", "--record", folder.file("a.vgr"), "--record-keep", "rejected"}), 2, "folder");
  expectOneLineError(run({"inspect", "--record", folder.file("a.vgr"), "--record-keep", "some"}), 2, "rejected|N");
  expectOneLineError(run({"inspect", "--record-full"}), 2, "--record FILE");
}

}  // namespace
}  // namespace vignole
