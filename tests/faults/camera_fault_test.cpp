// The words for faults, on the command line and in a script.

#include "engine/faults/camera_fault.h"

#include <gtest/gtest.h>

namespace vignole {
namespace {

TEST(CameraFault, WordsOfANetworkAreForDevices) {
  for (const char* text : {"packet-loss=0.002", "no-resend@1", "ignore-resend", "mute-control:5-9", "start-id=65500",
                           "ids-64", "reset-ids", "corrupt-leader", "corrupt-leader=0.5@3", "frame-loss=off:7-",
                           "die@3", "slow=20", "black", "move=2@2"}) {
    EXPECT_TRUE(parseDeviceFault(text)) << text;
  }
  const auto refused = parseFault("packet-loss=0.002");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("simulate serve"), std::string::npos) << refused.error().message();
  for (const char* text : {"packet-loss", "packet-loss=2", "start-id=0", "start-id=1.5", "mute-control=1", "frob",
                           "die@5", "die@3:9-5", "corrupt-leader=2", ""})
    EXPECT_FALSE(parseDeviceFault(text)) << text;
  EXPECT_EQ(parseDeviceFault("start-id=65500").value().value, 65500);
  EXPECT_EQ(parseDeviceFault("corrupt-leader").value().value, 1);
}

TEST(CameraFault, OffEndsWhatBegan) {
  const std::vector<Fault> faults = {*parseFault("frame-loss=0.5"), *parseFault("frame-loss=off@2:100-")};
  EXPECT_NE(activeFault(faults, "frame-loss", 1, 99), nullptr);
  EXPECT_EQ(activeFault(faults, "frame-loss", 1, 100), nullptr);
  EXPECT_NE(activeFault(faults, "frame-loss", 0, 100), nullptr);
}

TEST(CameraFault, AScriptIsReadLineByLine) {
  const auto faults = parseFaultScript(
      "# a bad day\n"
      "100-160: die@3   # no power\n"
      "\n"
      "  200 : packet-loss=0.01\r\n"
      "300: packet-loss=off",
      "day.txt");
  ASSERT_TRUE(faults) << faults.error().message();
  ASSERT_EQ(faults->size(), 3u);
  EXPECT_EQ((*faults)[0].kind, "die");
  EXPECT_EQ((*faults)[0].camera, 2);
  EXPECT_EQ((*faults)[0].from, 100u);
  EXPECT_EQ((*faults)[0].to, 160u);
  EXPECT_EQ((*faults)[1].from, 200u);
  EXPECT_EQ((*faults)[1].to, ~std::uint64_t{0});
  EXPECT_NE(activeFault(*faults, "packet-loss", 0, 299), nullptr);
  EXPECT_EQ(activeFault(*faults, "packet-loss", 0, 300), nullptr);
}

TEST(CameraFault, ABadLineIsNamed) {
  for (const char* text : {"1: die\nwrong\n", "1: die\ndie@3\n", "1: die\n5: die:7-9\n", "1: die\nx: die\n",
                           "1: die\n9-5: die\n", "1: die\n7:\n"}) {
    const auto faults = parseFaultScript(text, "day.txt");
    ASSERT_FALSE(faults) << text;
    EXPECT_EQ(faults.error().message().rfind("day.txt:2", 0), 0u) << faults.error().message();
  }
}

TEST(CameraFault, ALineWithoutATriggerBeginsNow) {
  const auto now = parseFaultLine("mute-control@2", 42, "stdin");
  ASSERT_TRUE(now);
  ASSERT_EQ(now->size(), 1u);
  EXPECT_EQ(now->front().from, 42u);
  const auto later = parseFaultLine("50-60: mute-control", 42, "stdin");
  ASSERT_TRUE(later);
  EXPECT_EQ(later->front().from, 50u);
  EXPECT_TRUE(parseFaultLine("  # nothing", 42, "stdin").value().empty());
}

}  // namespace
}  // namespace vignole
