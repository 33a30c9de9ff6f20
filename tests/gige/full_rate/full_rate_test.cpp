// The mill's rate: 66 Hz, four cameras. Prints what the reception costs; wants two cores for itself.

#include <chrono>

#include "tests/gige/served_line.h"

namespace vignole {
namespace {

using namespace testing;

TEST(GigeFullRate, SixtySixHertzOverTenMetresLosesNothingThatWasServed) {
  ServedCameras cameras("127.0.70.11", {"--rate", "66", "--exposure", "10"});
  LiveInspection live(cameras.address(), {"--length", "10"});
  const json run = live.wait();
  const json served = cameras.stop();
  ASSERT_TRUE(run.is_object()) << live.result.err;
  expectAccounted(run, 666);
  std::printf("served at %.1f Hz (late ticks %d), %.1f profiles/s, triggers %s\n",
              served["encoder"]["rate_hz"].get<double>(), served["encoder"]["late_ticks"].get<int>(),
              run["profiles_per_s"].get<double>(), run["triggers"].dump().c_str());
  std::printf("client %.3f ms CPU a frame and camera, of which %.3f reception\n",
              run["cpu"]["ms_per_frame"].get<double>(), run["cpu"]["reception_ms_per_frame"].get<double>());
  EXPECT_GE(run["triggers"]["measured"].get<double>(), 0.95 * 666) << "two cores for server and client";
}

}  // namespace
}  // namespace vignole
