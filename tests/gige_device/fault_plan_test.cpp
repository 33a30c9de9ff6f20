// What faults take is a matter of seed, camera and trigger.

#include "engine/gige_device/fault_plan.h"

#include <gtest/gtest.h>

namespace vignole::gige_device {
namespace {

std::vector<Fault> faults(std::initializer_list<const char*> texts) {
  std::vector<Fault> out;
  for (const char* text : texts) out.push_back(parseDeviceFault(text).value());
  return out;
}

TEST(FaultPlan, DrawsTheSameForTheSameAndAtTheRate) {
  const FaultPlan plan(7, faults({"missed-trigger=0.1", "packet-loss=0.02@2"})),
      same(7, faults({"missed-trigger=0.1"})), other(8, faults({"missed-trigger=0.1"}));
  int drawn = 0, differentSeed = 0, differentCamera = 0, packets = 0, secondTime = 0;
  for (std::uint64_t t = 0; t < 10000; ++t) {
    const bool taken = plan.drawn("missed-trigger", 0, t);
    EXPECT_EQ(taken, same.drawn("missed-trigger", 0, t));
    drawn += taken;
    differentSeed += taken != other.drawn("missed-trigger", 0, t);
    differentCamera += taken != plan.drawn("missed-trigger", 1, t);
    const double rate = plan.packetLoss(1, t);
    packets += plan.packetLost(rate, 1, t, 5, 0);
    secondTime += plan.packetLost(rate, 1, t, 5, 0) && plan.packetLost(rate, 1, t, 5, 1);
  }
  EXPECT_NEAR(drawn, 1000, 120);
  EXPECT_GT(differentSeed, 1000);
  EXPECT_GT(differentCamera, 1000);
  EXPECT_NEAR(packets, 200, 60);
  EXPECT_LT(secondTime, 20);  // to be lost again is a new draw
  EXPECT_EQ(plan.packetLoss(0, 3), 0);
}

TEST(FaultPlan, FaultsMayComeLaterAndEnd) {
  FaultPlan plan(1, {});
  EXPECT_FALSE(plan.on("mute-control", 2, 50));
  plan.add(faults({"mute-control@3:50-60", "die@1:10-", "revive@1:20", "slow=40:0-"}));
  EXPECT_TRUE(plan.on("mute-control", 2, 50));
  EXPECT_FALSE(plan.on("mute-control", 2, 61));
  EXPECT_FALSE(plan.on("mute-control", 1, 55));
  EXPECT_FALSE(plan.dead(0, 9));
  EXPECT_TRUE(plan.dead(0, 10));
  EXPECT_FALSE(plan.dead(0, 20));
  EXPECT_FALSE(plan.dead(1, 15));
  plan.add(faults({"slow=off:30-"}));
  EXPECT_EQ(plan.value("slow", 3, 29, 0), 40);
  EXPECT_EQ(plan.value("slow", 3, 30, 0), 0);
}

}  // namespace
}  // namespace vignole::gige_device
