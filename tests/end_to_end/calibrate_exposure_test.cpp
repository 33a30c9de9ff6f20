// calibrate exposure as a process: from rendered pictures to a recommendation.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace vignole {
namespace {

using testing::Folder;
using ::testing::HasSubstr;
using testing::run;

class CalibrateExposure : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    const auto made = run({"simulate", "plate", "--out", pictures(), "--placements", "1", "--seed", "11", "--exposure",
                           "2", "--exposure", "8", "--exposure", "15", "--exposure", "40", "--quiet"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
  }
  static void TearDownTestSuite() { delete folder_; }
  static std::string pictures() { return folder_->file("plate"); }
  static Folder* folder_;
};
Folder* CalibrateExposure::folder_ = nullptr;

TEST_F(CalibrateExposure, WeighsLightNoiseAndRate) {
  const std::string calibration = pictures() + "/true_calibration.toml";
  const auto result = run({"calibrate", "exposure", pictures(), "--calibration", calibration, "--rate", "60", "--speed",
                           "1.2", "--at-rest", "--json", "-"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const auto json = nlohmann::json::parse(result.out);
  const auto& rows = json["exposures"];
  ASSERT_EQ(rows.size(), 4U);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_GT(rows[i]["blur_mm"], rows[i - 1]["blur_mm"]);
    EXPECT_GE(rows[i]["saturated_max"], rows[i - 1]["saturated_max"]);
    EXPECT_EQ(rows[i]["pictures"], 4);
  }
  // Four times the light of 2 ms; noise of reading and light between once and four times as much.
  EXPECT_GT(rows[1]["snr"], 2 * rows[0]["snr"].get<double>());
  EXPECT_LT(rows[1]["snr"], 4.4 * rows[0]["snr"].get<double>());
  EXPECT_NEAR(rows[2]["highest_rate_hz"], 1000 / 15.0, 1e-9);
  EXPECT_NEAR(rows[2]["spacing_mm"], 20, 1e-9);
  EXPECT_THAT(rows[3]["limits_broken"].dump(), ::testing::AllOf(HasSubstr("saturated"), HasSubstr("too slow")));
  const double recommended = json["recommended_ms"];
  EXPECT_TRUE(recommended == 8 || recommended == 15) << recommended;
}

TEST_F(CalibrateExposure, SaysWhatIsWrongInOneLine) {
  for (const auto& [arguments, said] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{pictures() + "/exposure8ms"}, "two exposures"},
           {{pictures() + "/nothing"}, "does not exist"},
           {{pictures() + "/plate.toml"}, "exposure<NUMBER>ms"},
           {{pictures(), "--report", "report.txt"}, ".pdf"},
           {{pictures(), "--sigma", "40"}, "sigma"},
           {{pictures(), "--calibration", pictures() + "/plate.toml"}, "plate.toml"}}) {
    std::vector<std::string> all{"calibrate", "exposure"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const auto result = run(all);
    EXPECT_EQ(result.exitCode, 2) << said;
    EXPECT_THAT(result.err, HasSubstr(said));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(result.out, "");
  }
}

TEST_F(CalibrateExposure, NoExposureThatDoesIsAVerdict) {
  const auto result = run({"calibrate", "exposure", pictures(), "--rate", "200"});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.out, ::testing::AllOf(HasSubstr("no exposure can be recommended"), HasSubstr("too slow")));
}

}  // namespace
}  // namespace vignole
