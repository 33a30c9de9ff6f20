#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace vignole {
namespace {

using namespace vignole::testing;

std::string travel(const Folder& folder, const std::string& text) {
  std::ofstream(folder.file("travel.csv")) << text;
  return folder.file("travel.csv");
}

TEST(CalibrateEncoder, GivesJsonAndNothingElseOnStdout) {
  const Folder folder;
  const std::string file =
      travel(folder, "count,x_mm,y_mm,count2\n100,1,80,10\n20100,1.1,80,20014\n40100,1.2,80,40018\n");
  const ProgramResult result =
      run({"calibrate", "encoder", file, "--length", "2000", "--length-u", "0.1", "--json", "-"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_DOUBLE_EQ(json["vz_mm_per_pulse"].get<double>(), 0.05);
  EXPECT_NEAR(json["u_vz_mm_per_pulse"].get<double>(), 2.5e-6, 1e-7);
  EXPECT_NEAR(json["vx_mm_per_pulse"].get<double>(), 5e-6, 1e-12);
  EXPECT_NEAR(json["slip"]["ppm"].get<double>(), 200, 1e-6);
  EXPECT_NEAR(json["slip"]["u_ppm"].get<double>(), 14.4, 0.1);
  EXPECT_NE(run({"calibrate", "encoder", file, "--length", "2000"}).out.find("V^z"), std::string::npos);
}

TEST(CalibrateEncoder, BadInputGetsOneLine) {
  const Folder folder;
  const auto refused = [&](const std::string& text, const std::string& length, const std::string& about) {
    const ProgramResult r = run({"calibrate", "encoder", travel(folder, text), "--length", length, "--json", "-"});
    EXPECT_EQ(r.exitCode, 2) << text;
    EXPECT_EQ(r.out, "");
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
    EXPECT_NE(r.err.find(about), std::string::npos) << r.err;
  };
  refused("count,x_mm,y_mm\n0,0,0\n900,0,0\n", "0", "--length");
  refused("count,x_mm,y_mm\n0,0,0\n900,0,0\n800,0,0\n", "5", "turns round");
  refused("count,x_mm,y_mm\n0,0,0\n9,0,0\n", "5", "travel.csv");
  refused("count,x_mm,y_mm\n0,0,0\n900,nan,0\n", "5", ":3: x_mm");
  EXPECT_EQ(run({"calibrate", "encoder", folder.file("absent.csv"), "--length", "5"}).exitCode, 2);
  EXPECT_EQ(run({"calibrate", "encoder", folder.file("travel.csv")}).exitCode, 2);
}

}  // namespace
}  // namespace vignole
