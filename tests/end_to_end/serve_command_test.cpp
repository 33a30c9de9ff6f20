// vignole-cli simulate serve as a process: its cameras by our raw client and by Aravis' own tools.

#include <algorithm>
#include <bit>
#include <chrono>
#include <csignal>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <sys/stat.h>
#include <thread>

#include "engine/recipe/recipe.h"
#include "engine/simulator/virtual_rig.h"
#include "tests/end_to_end/program.h"
#include "tests/gige_device/raw_client.h"

namespace vignole {
namespace {

using gige_device::raw::addressPlus;
using gige_device::raw::Client;
using gige_device::raw::freeAddress;
using nlohmann::json;
using testing::Folder;
using testing::Program;
using testing::ProgramResult;

/// A server that is stopped politely, and told apart from others by its address.
class Server {
 public:
  explicit Server(std::vector<std::string> options, const std::string& input = {}) {
    options.insert(options.begin(), {"simulate", "serve", "--address", address(), "--json", folder_.file("n.json")});
    program_ = std::make_unique<Program>(options, VIGNOLE_CLI, input);
    for (int i = 0; i < 2000 && program_->out().rfind("ready\n", 0) != 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(program_->out(), "ready\n");
  }
  ~Server() {
    if (!stopped_) stop();
  }
  [[nodiscard]] static std::string address() { return freeAddress(); }
  /// Its counters.
  json stop() {
    stopped_ = true;
    program_->signal(SIGINT);
    result = program_->wait();
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return json::parse(testing::contents(folder_.file("n.json")), nullptr, false);
  }
  ProgramResult result;

 private:
  Folder folder_;
  std::unique_ptr<Program> program_;
  bool stopped_ = false;
};

void armWithLine1(Client& client) {
  ASSERT_TRUE(client.takeControl());
  client.openStream(8192);
  EXPECT_EQ(client.write(0xa064, 1), 0);                                      // TriggerMode On
  EXPECT_EQ(client.write(0xa054, std::bit_cast<std::uint32_t>(5000.0f)), 0);  // ExposureTime
  EXPECT_EQ(client.write(0xa080, 1), 0);                                      // TimestampCounter Line1
  EXPECT_EQ(client.write(0x0944, 1), 0);                                      // reset
}

TEST(ServeCommand, ServesThePicturesOfTheVirtualRig) {
  Server server({"--rate", "5", "--recipe", "54E1", "--seed", "5", "--deviation", "HW=0.5"});
  const auto recipe = findRecipe("54E1");
  ASSERT_TRUE(recipe);
  VirtualRigSettings settings;
  settings.section = recipe->section;
  settings.parameters = recipe->parameters;
  settings.seed = 5;
  ASSERT_TRUE(applyWords(settings, {}, {"HW=0.5"}, {}));
  const auto rig = VirtualRig::create(settings);
  ASSERT_TRUE(rig);
  std::vector<std::unique_ptr<Client>> clients;
  for (int c = 0; c < 4; ++c) {
    clients.push_back(std::make_unique<Client>(addressPlus(Server::address(), c)));
    armWithLine1(*clients.back());
  }
  for (auto& client : clients) EXPECT_EQ(client->write(0xa044, 1), 0);
  // Rendered for comparison when all have come: this one thread has four streams to empty.
  std::vector<std::pair<int, gige_device::raw::RawFrame>> frames;
  for (std::uint64_t t = 0; t < 4; ++t)
    for (int c = 0; c < 4; ++c) {
      auto frame = clients[static_cast<std::size_t>(c)]->nextFrame();
      ASSERT_TRUE(frame);
      ASSERT_TRUE(frame->complete());
      EXPECT_EQ(frame->timestamp, t);
      frames.emplace_back(c, std::move(*frame));
    }
  for (const auto& [camera, frame] : frames) {
    std::vector<std::uint8_t> pixels(1400 * 1024);
    (*rig)->render(camera, frame.timestamp, {pixels.data(), 1400, 1024, 1400});
    EXPECT_TRUE(frame.pixels() == pixels) << "camera " << camera + 1 << " trigger " << frame.timestamp;
  }
  const json counters = server.stop();
  ASSERT_TRUE(counters.contains("cameras"));
  for (const json& camera : counters["cameras"]) {
    EXPECT_GE(camera["frames_sent"].get<int>(), 4);
    EXPECT_EQ(camera["frames_taken"], camera["pulses"]);
    EXPECT_EQ(camera["triggers_missed"], 0);
  }
  EXPECT_EQ(counters["encoder"]["runs"], 1);
  EXPECT_NE(server.result.out.find("camera 4:"), std::string::npos) << server.result.out;
}

TEST(ServeCommand, ObeysAScriptFromAFileAndFromStdin) {
  Folder folder;
  std::ofstream(folder.file("script.txt")) << "# one lost trigger\n3: missed-trigger=1\n4: missed-trigger=off\n";
  {
    Server server({"--cameras", "1", "--rate", "50", "--script", folder.file("script.txt")});
    Client client(Server::address());
    armWithLine1(client);
    EXPECT_EQ(client.write(0xa044, 1), 0);
    for (const std::uint64_t expected : {0u, 1u, 2u, 4u, 5u}) EXPECT_EQ(client.nextFrame()->timestamp, expected);
    EXPECT_EQ(server.stop()["cameras"][0]["triggers_missed"], 1);
  }
  ASSERT_EQ(::mkfifo(folder.file("fifo").c_str(), 0600), 0);
  Server server({"--cameras", "1", "--rate", "50", "--script", "-"}, folder.file("fifo"));
  Client client(Server::address());
  armWithLine1(client);
  EXPECT_EQ(client.write(0xa044, 1), 0);
  ASSERT_TRUE(client.nextFrame());
  std::ofstream(folder.file("fifo")) << "nonsense\nmove=2\nmissed-trigger=1\n";
  while (client.nextFrame(std::chrono::milliseconds(500))) {
  }
  std::ofstream(folder.file("fifo")) << "missed-trigger=off\n";
  EXPECT_TRUE(client.nextFrame());
  EXPECT_GT(server.stop()["cameras"][0]["triggers_missed"].get<int>(), 5);
  EXPECT_NE(server.result.err.find("script, line 1"), std::string::npos) << server.result.err;
  EXPECT_NE(server.result.err.find("move"), std::string::npos) << server.result.err;
}

TEST(ServeCommand, RefusesWhatItCannotDo) {
  Folder folder;
  std::ofstream(folder.file("bad.txt")) << "5: die@3\nfive: revive@3\n";
  const auto refused = [&](std::vector<std::string> options, int exitCode, const std::string& says) {
    if (std::find(options.begin(), options.end(), "--address") == options.end())
      options.insert(options.end(), {"--address", freeAddress()});
    options.insert(options.begin(), {"simulate", "serve", "--seconds", "0"});
    const ProgramResult result = testing::run(options);
    EXPECT_EQ(result.exitCode, exitCode) << says;
    EXPECT_NE(result.err.find(says), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(result.out, "");
  };
  refused({"--fault", "packet-loss=2"}, 2, "0 to 1");
  refused({"--fault", "frob"}, 2, "packet-loss");
  refused({"--script", folder.file("bad.txt")}, 2, "bad.txt:2");
  refused({"--script", folder.file("none.txt")}, 2, "none.txt");
  refused({"--cameras", "5"}, 2, "--cameras");
  refused({"--rails", "2"}, 2, "--length");
  refused({"--address", "10.0.0.1"}, 2, "10.0.0.1");
  refused({"--recipe", "99X9"}, 2, "99X9");
  Server server({"--cameras", "1"});
  refused({}, 3, "taken");
}

// ------------------------------------------------------------------------------------------- other people's clients

ProgramResult runTool(const std::string& tool, const std::vector<std::string>& arguments) {
  return Program(arguments, tool).wait();
}

bool installed(const std::string& tool) { return std::filesystem::exists("/usr/bin/" + tool); }

int numberAfter(const std::string& text, const std::string& name) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(name + "\\s*=\\s*(\\d+)")) ? std::stoi(match[1]) : -1;
}

TEST(ServeCommand, ArvToolReadsAndWritesFeatures) {
  if (!installed("arv-tool-0.8")) GTEST_SKIP() << "arv-tool-0.8 is not installed (Debian: aravis-tools-cli)";
  Server server({"--cameras", "2"});
  const std::string second = addressPlus(Server::address(), 1);
  const auto control = [&](std::vector<std::string> features) {
    features.insert(features.begin(), {"-a", second, "control"});
    return runTool("arv-tool-0.8", features).out;
  };
  const std::string read = control({"DeviceVendorName", "DeviceModelName", "Width", "Height", "PixelFormat",
                                    "PayloadSize", "GevHeartbeatTimeout", "GevTimestampTickFrequency"});
  for (const char* line : {"DeviceVendorName = DALSA\n", "DeviceModelName = Genie HM1400\n", "Width = 1400",
                           "Height = 1024", "PixelFormat = Mono8", "PayloadSize = 1433600",
                           "GevHeartbeatTimeout = 3000", "GevTimestampTickFrequency = 1000000000"})
    EXPECT_NE(read.find(line), std::string::npos) << line << "\n" << read;
  const std::string written =
      control({"TriggerMode=On", "TriggerSource=Line1", "TimestampCounter=Line1", "ExposureTime=15000", "Gain=2",
               "Width=800", "OffsetX=600", "ChunkModeActive=true", "ChunkSelector=EncoderValue", "ChunkEnable=true",
               "DeviceUserID=north", "PayloadSize", "ExposureTime", "TimestampReset", "TriggerSource"});
  for (const char* line : {"PayloadSize = 819224", "ExposureTime = 15000", "TriggerSource = Line1"})
    EXPECT_NE(written.find(line), std::string::npos) << line << "\n" << written;
  // Whatever is named in the description can be read: no feature hangs in the air.
  const std::string values = runTool("arv-tool-0.8", {"-a", second, "values"}).out;
  EXPECT_NE(values.find("DeviceUserID"), std::string::npos) << values;
  EXPECT_EQ(values.find("rror"), std::string::npos) << values;
}

TEST(ServeCommand, ArvToolFindsTheCamerasByBroadcast) {
  if (!installed("arv-tool-0.8")) GTEST_SKIP() << "arv-tool-0.8 is not installed (Debian: aravis-tools-cli)";
  std::ifstream routes("/proc/net/route");
  std::string line;
  bool anywhere = false;
  while (std::getline(routes, line)) anywhere = anywhere || line.find("\t00000000\t") != std::string::npos;
  if (!anywhere) GTEST_SKIP() << "no default route: a broadcast leads nowhere here";
  Server server({"--broadcast"});
  const std::string list = runTool("arv-tool-0.8", {}).out;
  for (int c = 0; c < 4; ++c)
    EXPECT_NE(list.find("VIRTUAL-1-" + std::to_string(c + 1) + " (" + addressPlus(Server::address(), c) + ")"),
              std::string::npos)
        << list;
}

TEST(ServeCommand, ArvCameraTestStreamsFreelyAndUnderTriggers) {
  if (!installed("arv-camera-test-0.8")) GTEST_SKIP() << "arv-camera-test-0.8 is not installed (Debian: aravis-tools)";
  // Slow and patient: what a busy machine loses in the client's socket is asked for again too.
  Server server({"--cameras", "1", "--rate", "5", "--fault", "packet-loss=0.005"});
  const auto streamed = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"-n", Server::address(), "--duration", "4", "-i", "8192", "-m", "1200"});
    const std::string out = runTool("arv-camera-test-0.8", options).out;
    EXPECT_GE(numberAfter(out, "n_completed_buffers"), 12) << out;
    EXPECT_EQ(numberAfter(out, "n_failures"), 0) << out;
    EXPECT_EQ(numberAfter(out, "n_missing_frames"), 0) << out;
    return out;
  };
  streamed({});
  const std::string triggered = streamed({"-t", "Line1", "-u", "CounterValue,LineStatusAll"});
  EXPECT_NE(triggered.find("ChunkCounterValue = 10\n"), std::string::npos) << triggered;
  EXPECT_NE(triggered.find("ChunkLineStatusAll = 3\n"), std::string::npos) << triggered;
  streamed({"-o", "5"});
  const json camera = server.stop()["cameras"][0];
  EXPECT_GT(camera["packets_dropped"].get<int>(), 10);
  EXPECT_GE(camera["packets_resent"], camera["packets_dropped"].get<int>() / 2);
}

}  // namespace
}  // namespace vignole
