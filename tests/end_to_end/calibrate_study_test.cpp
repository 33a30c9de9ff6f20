// calibrate study as a process: rendered placements at three exposures through the paper's method.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace vignole {
namespace {

using testing::contents;
using testing::Folder;
using ::testing::HasSubstr;
using testing::run;

class CalibrateStudy : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    const auto made = run({"simulate", "plate", "--out", plate(), "--placements", "1", "--seed", "21", "--exposure",
                           "5", "--exposure", "10", "--exposure", "15", "--plate-error-um", "50", "--quiet"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
  }
  static void TearDownTestSuite() { delete folder_; }
  static std::string plate() { return folder_->file("plate"); }
  static std::string factors(const std::string& text) {
    const std::string file = folder_->file("factors.toml");
    std::ofstream(file) << "format = 1\n" << text;
    return file;
  }
  static Folder* folder_;
};
Folder* CalibrateStudy::folder_ = nullptr;

TEST_F(CalibrateStudy, RunsEveryCombinationAndTellsWhatMatters) {
  const std::string file = factors(
      "[fixed]\nmethod = 'paper'\nassociation = 'robust'\n[[factor]]\nname = 'exposure_ms'\nlevels = [5, 10, 15]\n"
      "[[factor]]\nname = 'sigma_px'\nlevels = [2, 3]\n[[factor]]\nname = 'fit'\nlevels = ['stable', 'direct']\n");
  const std::string csv = folder_->file("runs.csv");
  const auto result =
      run({"calibrate", "study", "--factors", file, "--placement", plate(), "--csv", csv, "--json", "-"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["design"]["runs"], 12);
  EXPECT_EQ(json["cameras_tried"], 48);
  EXPECT_EQ(json["runs"].size(), 12U);
  int failed = 0;
  for (const auto& row : json["runs"]) failed += static_cast<int>(row["failures"].size());
  EXPECT_EQ(json["cameras_failed"], failed);
  const std::string table = contents(csv);
  EXPECT_GE(std::count(table.begin(), table.end(), '\n'), 1 + 48);
  bool cd = false;
  for (const auto& response : json["responses"]) {
    if (response["name"] != "cd_mm") continue;
    cd = true;
    EXPECT_EQ(response["observations"], 48 - failed);
    ASSERT_EQ(response["main_effects"].size(), 3U);
    EXPECT_EQ(response["main_effects"][0]["means"].size(), 3U);
    EXPECT_EQ(response["ranking"].size(), 6U);
    for (const auto& mean : response["main_effects"][0]["means"]) {
      EXPECT_GT(mean["mean"], 0.005);
      EXPECT_LT(mean["mean"], 5);
    }
    EXPECT_TRUE(response["best"]["setting"].contains("sigma_px"));
  }
  EXPECT_TRUE(cd);
}

TEST_F(CalibrateStudy, SaysWhatIsWrongInOneLine) {
  const std::string sigma = "[[factor]]\nname = 'sigma_px'\nlevels = [2, 3]\n";
  const auto expectRefused = [&](const std::string& factorsFile, const std::vector<std::string>& more,
                                 const std::string& said) {
    std::vector<std::string> all{"calibrate", "study", "--factors", factorsFile, "--csv", folder_->file("none.csv")};
    all.insert(all.end(), more.begin(), more.end());
    const auto result = run(all);
    EXPECT_EQ(result.exitCode, 2) << said;
    EXPECT_THAT(result.err, HasSubstr(said));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_FALSE(std::filesystem::exists(folder_->file("none.csv")));
  };
  expectRefused(factors("[[factor]]\nname = 'speed'\nlevels = [1, 2]\n"), {"--placement", plate()}, "names no factor");
  expectRefused(factors(sigma), {"--placement", plate()}, "several exposures (5, 10, 15 ms)");
  expectRefused(factors("[[factor]]\nname = 'exposure_ms'\nlevels = [5, 20]\n"), {"--placement", plate()},
                "no placements at 20 ms");
  expectRefused(factors(sigma), {}, "--placement");
  expectRefused(factors(sigma), {"--placement", plate() + "/intrinsics"}, "holds no placement");
  expectRefused(factors(sigma), {"--placement", plate() + "/exposure5ms", "--plate", plate() + "/none.toml"},
                "none.toml");
  expectRefused(factors(sigma), {"--placement", plate() + "/exposure5ms", "--intrinsics", "a", "b"}, "four files");
  expectRefused(folder_->file("nothing.toml"), {"--placement", plate()}, "nothing.toml");
}

TEST_F(CalibrateStudy, NamesTheFactorsThereAre) {
  const auto result = run({"calibrate", "study", "--list"});
  EXPECT_EQ(result.exitCode, 0);
  for (const char* name : {"exposure_ms", "sigma_px", "t_ec", "max_ellipses", "fit", "method"})
    EXPECT_THAT(result.out, HasSubstr(name));
}

}  // namespace
}  // namespace vignole
