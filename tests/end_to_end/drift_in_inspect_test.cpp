// A camera that moves while rails are inspected is named in what `inspect` tells.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace vignole {
namespace {

using namespace vignole::testing;
using nlohmann::json;

TEST(DriftInInspect, NamesTheCameraThatMovesMidSeries) {
  // Fourteen rails of ten profiles; from the ninth on camera 3 stands 0.05 mm aside.
  const ProgramResult result = run({"inspect", "--rails", "14", "--length", "0.15", "--seed", "3", "--fault",
                                    "move=0.05@3:80-100000", "--json", "-"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  const json drift = json::parse(result.out)["drift"];
  EXPECT_EQ(drift["rails"], 14);
  EXPECT_EQ(drift["learning"], false);
  EXPECT_EQ(drift["alarm"], true);
  EXPECT_GT(drift["first_alarm_rail"].get<int>(), 8);
  for (const json& camera : drift["cameras"]) EXPECT_EQ(camera["alarm"].get<bool>(), camera["camera"] == 3) << camera;
  EXPECT_GT(drift["cameras"][2]["value_mm"].get<double>(), drift["cameras"][2]["limit_mm"].get<double>());
  EXPECT_NE(result.err.find("camera 3"), std::string::npos) << result.err;
}

TEST(DriftInInspect, AFewRailsAreLearntFrom) {
  const ProgramResult result = run({"inspect", "--rails", "2", "--length", "0.03", "--json", "-"});
  const json drift = json::parse(result.out)["drift"];
  EXPECT_EQ(drift["learning"], true);
  EXPECT_EQ(drift["alarm"], false);
  EXPECT_TRUE(drift["cameras"][0]["value_mm"].is_null());
  EXPECT_EQ(result.err, "");
}

}  // namespace
}  // namespace vignole
