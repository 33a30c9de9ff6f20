// What goes wrong between cameras and computer, one fault a test: the rows of the table in
// engine/gige_camera/README.md.

#include <fstream>

#include "tests/gige/served_line.h"

namespace vignole {
namespace {

using namespace testing;

TEST(GigeFaults, None_TheSameNumbersAsWithoutANetwork) {
  ServedCameras cameras("127.0.40.11", twoRails());
  LiveInspection live(cameras.address(), {"--rails", "2"});
  const json run = live.wait();
  EXPECT_EQ(live.result.exitCode, 0) << live.result.err;
  expectAccounted(run, 2 * kRailTriggers);
  EXPECT_GE(run["triggers"]["measured"], 2 * kRailTriggers - 12) << "a busy machine: " << run["triggers"].dump();
  EXPECT_EQ(run["line"]["rails"], 2);
  for (const json& camera : run["cameras"]) {
    EXPECT_EQ(camera["state"], "connected");
    EXPECT_EQ(camera["trigger_count"], "timestamp");
    EXPECT_TRUE(camera["cannot_tell"].is_null());
  }
  Folder folder;
  const ProgramResult plain =
      testing::run({"inspect", "--length", "0.9", "--csv", folder.file("plain.csv"), "--quiet"});
  ASSERT_EQ(plain.exitCode, 0) << plain.err;
  std::istringstream csv(contents(folder.file("plain.csv")));
  Arguments rows;
  for (std::string line; std::getline(csv, line);) rows.push_back(line);
  const auto expected = byTrigger(rows), measured = byTrigger(live.rows);
  ASSERT_EQ(expected.size(), kRailTriggers);
  for (const auto& [trigger, row] : expected) {
    if (!measured.contains(trigger) || measured.at(trigger).find("camera ") != std::string::npos) continue;
    EXPECT_EQ(measured.at(trigger), row) << "trigger " << trigger << ": to the last bit";
  }
}

TEST(GigeFaults, PacketLoss_IsMadeGoodByAskingAgain) {
  ServedCameras cameras("127.0.41.11", twoRails({"packet-loss=0.002"}));
  LiveInspection live(cameras.address(), {"--rails", "2"});
  const json run = live.wait();
  const json served = cameras.stop();
  expectAccounted(run, 2 * kRailTriggers);
  EXPECT_EQ(run["triggers"]["measured"], 2 * kRailTriggers) << run["triggers"].dump();
  std::uint64_t dropped = 0, resent = 0;
  for (const json& camera : served["cameras"]) dropped += camera["packets_dropped"].get<std::uint64_t>();
  for (const json& camera : run["cameras"]) resent += camera["packets_resent"].get<std::uint64_t>();
  EXPECT_GT(dropped, 20u);
  EXPECT_GE(resent, dropped / 2);
}

TEST(GigeFaults, PacketLossWithoutResend_MakesIncompleteFramesThatAreNeverBelieved) {
  ServedCameras cameras("127.0.42.11", twoRails({"packet-loss=0.002@2", "ignore-resend"}));
  LiveInspection live(cameras.address(), {"--rails", "2"});
  const json run = live.wait();
  expectAccounted(run, 2 * kRailTriggers);
  EXPECT_GT(reason(run, "camera 2: incomplete frame"), 10u);
  EXPECT_GT(run["cameras"][1]["frames_failed"].value("timeout", 0), 10);
  EXPECT_EQ(run["triggers"]["lost"], 0);
}

TEST(GigeFaults, LostFrame_IsToldByItsGap) {
  ServedCameras cameras("127.0.43.11", twoRails({"frame-loss=0.1@2"}));
  LiveInspection live(cameras.address(), {"--rails", "2"});
  const json run = live.wait();
  const json served = cameras.stop();
  expectAccounted(run, 2 * kRailTriggers);
  const std::uint64_t lost = reason(run, "camera 2: frame lost") + reason(run, "camera 2: no frame");
  EXPECT_GT(lost, 2u);
  EXPECT_EQ(run["triggers"]["incomplete"], lost) << run["triggers"].dump();
  EXPECT_LE(run["cameras"][1]["frames_lost"], served["cameras"][1]["frames_lost"]);
  EXPECT_EQ(run["cameras"][1]["triggers_missed"], 0);
}

TEST(GigeFaults, MissedTrigger_IsToldByTheCountAlone) {
  ServedCameras cameras("127.0.44.11", twoRails({"missed-trigger=0.1@1"}));
  LiveInspection live(cameras.address(), {"--rails", "2"});
  const json run = live.wait();
  expectAccounted(run, 2 * kRailTriggers);
  const std::uint64_t missed = reason(run, "camera 1: missed trigger") + reason(run, "camera 1: no frame");
  EXPECT_GT(missed, 2u);
  EXPECT_EQ(run["triggers"]["incomplete"], missed) << run["triggers"].dump();
  EXPECT_EQ(run["cameras"][0]["frames_lost"], 0);
}

void expectRecovery(const json& run, const Arguments& rows, std::uint64_t revived) {
  expectAccounted(run, 2 * 2 * kRailTriggers);
  EXPECT_EQ(run["cameras"][2]["reconnections"], 1);
  EXPECT_EQ(run["cameras"][2]["state"], "connected");
  EXPECT_EQ(run["triggers"]["lost"], 0);
  EXPECT_EQ(run["triggers"]["incomplete"], reason(run, "camera 3: camera lost")) << run["triggers"].dump();
  const Arguments head = fields(rows.front());
  std::uint64_t last = 0, without = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].find("camera 3: camera lost") == std::string::npos) continue;
    const Arguments row = fields(rows[i]);
    last = std::max<std::uint64_t>(last, std::stoull(row[3]));
    std::size_t measured = 0, dimensions = 0;
    for (std::size_t f = 4; f < head.size() && head[f].rfind("u_", 0) != 0; ++f, ++dimensions)
      measured += row[f].empty() ? 0U : 1U;
    EXPECT_LT(measured, dimensions) << "what needs camera 3 is not measured: " << rows[i];
    ++without;
  }
  EXPECT_GT(without, 10u);
  EXPECT_LE(last, revived + 60) << "back within 3 s at 20 Hz";
}

TEST(GigeFaults, CameraDiesAndComesBack_WhileTheOthersGoOn) {
  ServedCameras cameras("127.0.45.11", {"--rate", "20", "--length", "1.8", "--gap", "0.3", "--fault", "die@3:30-70"});
  LiveInspection live(cameras.address(), {"--rails", "2"});
  const json run = live.wait();
  expectRecovery(run, live.rows, 71);
}

TEST(GigeFaults, CameraDiesAndComesBack_CountedByAChunk) {
  ServedCameras cameras("127.0.46.11", {"--rate", "20", "--length", "1.8", "--gap", "0.3", "--fault", "die@3:30-70"});
  Folder folder;
  ASSERT_EQ(testing::run({"site", "new", "--address", cameras.address(), "--out", folder.file("site.toml")}).exitCode,
            0);
  std::string text = contents(folder.file("site.toml"));
  text.replace(text.find("\"auto\""), 6, "\"chunk\"");
  std::ofstream(folder.file("site.toml")) << text;
  LiveInspection live(cameras.address(), {"--rails", "2", "--site", folder.file("site.toml")});
  const json run = live.wait();
  EXPECT_EQ(run["cameras"][2]["trigger_count"], "chunk");
  expectRecovery(run, live.rows, 71);
}

TEST(GigeFaults, AllCamerasDie_TheRailEndsAndTheNextIsMeasured) {
  auto cameras = std::make_unique<ServedCameras>("127.0.47.11", Arguments{"--rate", "20"});
  LiveInspection live(cameras->address(), {"--rails", "2", "--length", "4.5"});
  std::this_thread::sleep_for(std::chrono::seconds(4));
  cameras->kill();
  ServedCameras again("127.0.47.11", {"--rate", "20"});
  const json run = live.wait();
  ASSERT_TRUE(run.is_object()) << live.result.err;
  const json& t = run["triggers"];
  EXPECT_EQ(t["seen"].get<std::uint64_t>(),
            t["measured"].get<std::uint64_t>() + t["incomplete"].get<std::uint64_t>() + t["lost"].get<std::uint64_t>());
  ASSERT_EQ(run["rails"].size(), 2u);
  EXPECT_LT(run["rails"][0]["triggers"]["seen"], 200);
  EXPECT_EQ(run["rails"][1]["triggers"]["seen"], 300);
  EXPECT_GE(run["rails"][1]["triggers"]["measured"], 298) << run["rails"][1]["triggers"].dump();
  for (const json& camera : run["cameras"]) EXPECT_EQ(camera["reconnections"], 1);
}

TEST(GigeFaults, ShortIdsWrap_WithoutALoss) {
  ServedCameras cameras("127.0.48.11", twoRails({"start-id=65480"}));
  LiveInspection live(cameras.address(), {"--rails", "2"});
  const json run = live.wait();
  expectAccounted(run, 2 * kRailTriggers);
  EXPECT_EQ(run["triggers"]["measured"], 2 * kRailTriggers) << run["triggers"].dump();
  for (const json& camera : run["cameras"]) EXPECT_EQ(camera["frames_lost"], 0);
}

TEST(GigeFaults, RestartWithIdsFromOne_LosesNothing) {
  ServedCameras cameras("127.0.49.11", twoRails({"reset-ids"}));
  for (int start = 0; start < 2; ++start) {
    LiveInspection live(cameras.address(), {"--rails", "1"});
    const json run = live.wait();
    expectAccounted(run, kRailTriggers);
    EXPECT_EQ(run["triggers"]["measured"], kRailTriggers) << run["triggers"].dump();
  }
}

TEST(GigeFaults, MutedControlChannel_FramesGoOnAndTheCameraIsDegraded) {
  ServedCameras cameras("127.0.50.11", {"--rate", "20", "--fault", "mute-control@2:20-100000"});
  LiveInspection live(cameras.address(), {"--length", "3.9"});  // 13 s: control is given up after 5.7 s
  const json run = live.wait();
  expectAccounted(run, 260);
  EXPECT_EQ(run["triggers"]["measured"], 260) << run["triggers"].dump();
  EXPECT_EQ(run["cameras"][1]["state"], "degraded");
  EXPECT_NE(run["cameras"][1]["why"].get<std::string>().find("control channel"), std::string::npos);
}

TEST(GigeFaults, SecondController_IsRefusedAndDisturbsNothing) {
  ServedCameras cameras("127.0.51.11", twoRails());
  LiveInspection live(cameras.address(), {"--rails", "2"});
  std::this_thread::sleep_for(std::chrono::seconds(1));
  const ProgramResult second = testing::run({"site", "check", "--address", cameras.address()});
  EXPECT_EQ(second.exitCode, 3);
  EXPECT_NE(second.err.find("is controlled by another program"), std::string::npos) << second.err;
  const json run = live.wait();
  expectAccounted(run, 2 * kRailTriggers);
  EXPECT_EQ(run["triggers"]["measured"], 2 * kRailTriggers) << run["triggers"].dump();
}

TEST(GigeFaults, KilledClient_TheNextOneWaitsForTheHeartbeatAndMeasures) {
  ServedCameras cameras("127.0.52.11", twoRails());
  {
    LiveInspection killed(cameras.address(), {"--rails", "2"});
    std::this_thread::sleep_for(std::chrono::seconds(2));
    killed.kill();
    killed.wait();
  }
  const auto start = std::chrono::steady_clock::now();
  LiveInspection live(cameras.address(), {"--rails", "1"});
  const json run = live.wait();
  EXPECT_EQ(live.result.exitCode, 0) << live.result.err;
  expectAccounted(run, kRailTriggers);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(13)) << "3 s of heartbeat, 4 s of rail";
}

TEST(GigeFaults, CorruptLeader_IsNeverBelieved) {
  ServedCameras cameras("127.0.53.11", twoRails({"corrupt-leader=0.1@4"}));
  LiveInspection live(cameras.address(), {"--rails", "2"});
  const json run = live.wait();
  expectAccounted(run, 2 * kRailTriggers);
  EXPECT_EQ(run["triggers"]["lost"], 0);
  EXPECT_GT(run["triggers"]["incomplete"], 2);
  for (const auto& [words, count] : run["triggers"]["reasons"].items())
    EXPECT_EQ(words.rfind("camera 4: ", 0), 0u) << words;
  // What was measured completely is what the rig showed at that very trigger.
  Folder folder;
  ASSERT_EQ(testing::run({"inspect", "--length", "0.9", "--csv", folder.file("plain.csv"), "--quiet"}).exitCode, 0);
  std::istringstream csv(contents(folder.file("plain.csv")));
  Arguments rows;
  for (std::string line; std::getline(csv, line);) rows.push_back(line);
  const auto expected = byTrigger(rows);
  for (const auto& [trigger, row] : byTrigger(live.rows)) {
    if (trigger >= kRailTriggers || row.find("camera 4") != std::string::npos) continue;
    EXPECT_EQ(row, expected.at(trigger)) << trigger;
  }
}

TEST(GigeFaults, EveryLeaderCorrupt_TheBuffersDoNotRunOut) {
  ServedCameras cameras("127.0.54.11", twoRails({"corrupt-leader@4:0-110"}));
  LiveInspection live(cameras.address(), {"--rails", "2"});
  const json run = live.wait();
  expectAccounted(run, 2 * kRailTriggers);
  EXPECT_GE(run["rails"][1]["triggers"]["measured"], 10) << run["rails"][1]["triggers"].dump();
}

TEST(GigeFaults, SwappedCables_AreToldInOneLine) {
  ServedCameras cameras("127.0.55.11", twoRails());
  Folder folder;
  ASSERT_EQ(testing::run({"site", "new", "--address", cameras.address(), "--out", folder.file("site.toml")}).exitCode,
            0);
  std::string text = contents(folder.file("site.toml"));
  const std::size_t two = text.find("VIRTUAL-1-2"), three = text.find("VIRTUAL-1-3");
  text[two + 10] = '3';
  text[three + 10] = '2';
  std::ofstream(folder.file("site.toml")) << text;
  const ProgramResult refused = testing::run({"inspect", "--source", "gige", "--site", folder.file("site.toml")});
  EXPECT_EQ(refused.exitCode, 3);
  EXPECT_NE(refused.err.find("camera 2 (127.0.55.12): is VIRTUAL-1-2, not VIRTUAL-1-3; are the cables swapped?"),
            std::string::npos)
      << refused.err;
  EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
}

TEST(GigeFaults, CameraThatIsTooSlow_MissesTriggersAndIsTold) {
  ServedCameras cameras("127.0.56.11", twoRails({"slow=60@4"}));
  LiveInspection live(cameras.address(), {"--rails", "2"});
  const json run = live.wait();
  expectAccounted(run, 2 * kRailTriggers);
  EXPECT_GT(reason(run, "camera 4: missed trigger"), 10u);
}

TEST(GigeLine, TellsRailsByTheSignalOfALine) {
  ServedCameras cameras("127.0.57.11", twoRails());
  Folder folder;
  ASSERT_EQ(testing::run({"site", "new", "--address", cameras.address(), "--out", folder.file("site.toml")}).exitCode,
            0);
  std::string text = contents(folder.file("site.toml"));
  text.replace(text.find("\"pictures\""), 10, "\"line\"\nline_bit = 1");
  std::ofstream(folder.file("site.toml")) << text;
  LiveInspection live(cameras.address(), {"--rails", "2", "--site", folder.file("site.toml")});
  const json run = live.wait();
  EXPECT_EQ(live.result.exitCode, 0) << live.result.err;
  expectAccounted(run, 2 * kRailTriggers);
  EXPECT_EQ(run["triggers"]["measured"], 2 * kRailTriggers) << run["triggers"].dump();
}

TEST(GigeLine, CountsFramesWhereTheCamerasDoNotCountAndSaysWhatThatCannotTell) {
  ServedCameras cameras("127.0.58.11", {"--rate", "20"});
  Folder folder;
  ASSERT_EQ(testing::run({"site", "new", "--address", cameras.address(), "--out", folder.file("site.toml")}).exitCode,
            0);
  std::string text = contents(folder.file("site.toml"));
  text.replace(text.find("\"auto\""), 6, "\"frame-id\"");
  std::ofstream(folder.file("site.toml")) << text;
  LiveInspection live(cameras.address(), {"--length", "1.5", "--site", folder.file("site.toml")});
  const json run = live.wait();
  expectAccounted(run, 100);
  EXPECT_GE(run["triggers"]["measured"], 80) << "the first are lost until the cameras are in step";
  EXPECT_NE(run["cameras"][0]["cannot_tell"].get<std::string>().find("misses"), std::string::npos);
}

}  // namespace
}  // namespace vignole
