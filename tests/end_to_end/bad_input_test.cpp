// Bad input through the command line: one line that says what, where and what to do, the right exit code, nothing
// half-written. One case a row.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "tests/end_to_end/program.h"

namespace vignole {
namespace {

using testing::Folder;
using testing::ProgramResult;
using testing::run;

struct Case {
  std::string name;
  std::string file;  ///< written before, its content below; empty: none
  std::string content;
  std::vector<std::string> arguments;  ///< FILE and OUT stand for the file and for an output that must not appear
  std::vector<std::string> said;       ///< what the line must hold
  int exitCode = 2;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

const std::string kSquare =
    R"({"format": 1, "name": "SQUARE", "standard": "none", "standing": "invented", "note": "a test", "primitives": [
  {"name": "SBB", "type": "segment", "p0": [-50, 0], "p1": [50, 0]},
  {"name": "SBR", "type": "segment", "p0": [50, 0], "p1": [50, 100]},
  {"name": "AHT", "type": "segment", "p0": [50, 100], "p1": [-50, 100.5]},
  {"name": "SBL", "type": "segment", "p0": [-50, 100], "p1": [-50, 0]}]})";

std::vector<Case> cases() {
  const std::vector<std::string> measure = {"measure", "FILE", "--rail", "60E1", "--json", "OUT"};
  const std::vector<std::string> inspect = {"inspect", "--length", "0.1", "--recipe", "FILE", "--json", "OUT"};
  const std::vector<std::string> calibrated = {"inspect", "--length", "0.1", "--calibration", "FILE", "--json", "OUT"};
  return {
      {"ColumnMissing", "p.csv", "x\n1\n2\n", measure, {"p.csv:1", "two numeric columns"}},
      {"Text", "p.csv", "x,y\n1,2\n3,abc\n", measure, {"p.csv:3", "column 2", "abc"}},
      {"NotANumber", "p.csv", "x,y\n1,2\nnan,3\n", measure, {"p.csv:3", "column 1", "nan"}},
      {"ZeroPoints", "p.csv", "x,y\n", measure, {"p.csv", "no points"}},
      {"MissingFile", "", "", {"measure", "nowhere.csv", "--rail", "60E1"}, {"nowhere.csv"}},
      {"UnknownRail", "p.csv", "1,2\n3,4\n", {"measure", "FILE", "--rail", "61E9"}, {"61E9", "60E1"}},
      {"TruncatedPicture",
       "p.png",
       std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16),
       {"extract", "FILE", "--csv", "OUT"},
       {"p.png", "cut off"}},
      {"EmptyPicture", "p.png", "", {"extract", "FILE", "--csv", "OUT"}, {"p.png", "empty"}},
      {"TextAsPicture", "p.png", "hello", {"extract", "FILE", "--csv", "OUT"}, {"p.png", "not a picture"}},
      {"SectionThatDoesNotClose", "s.json", kSquare, {"rails", "check", "FILE"}, {"s.json"}},
      {"TruncatedSection", "s.json", kSquare.substr(0, 200), {"rails", "check", "FILE"}, {"s.json"}},
      {"UnknownRecipeKey",
       "r.toml",
       "format = 1\nname = \"t\"\nsection = \"60E1\"\n[stripe]\nsigma = 3\n",
       inspect,
       {"r.toml:5", "sigma"}},
      {"SwappedLimits",
       "r.toml",
       "format = 1\nname = \"t\"\nsection = \"60E1\"\n[tolerance.RH]\nlower_mm = 0.6\nupper_mm = -0.6\n",
       inspect,
       {"r.toml:", "RH"}},
      {"RecipeThatIsNoToml", "r.toml", "format = = 1\n", inspect, {"r.toml:1"}},
      {"CalibrationThatIsNone", "c.toml", "format = 1\nid = \"x\"\n", calibrated, {"c.toml"}},
      {"UnknownOption", "", "", {"inspect", "--nonsense"}, {"--nonsense", "--help"}},
      {"UnknownEffect", "", "", {"inspect", "--effect", "fog=1"}, {"fog", "speckle"}},
      {"UnknownFault", "", "", {"inspect", "--fault", "fire"}, {"fire", "frame-loss"}},
      {"UnknownDimension", "", "", {"inspect", "--deviation", "XY=1"}, {"XY", "RH"}},
      {"FolderThatIsNotThere", "", "", {"inspect", "--length", "0.1", "--csv", "nowhere/x.csv"}, {"nowhere/x.csv"}},
  };
}

class BadInput : public ::testing::TestWithParam<Case> {};

TEST_P(BadInput, IsOneLineAndLeavesNothing) {
  const Case& c = GetParam();
  const Folder folder;
  if (!c.file.empty()) std::ofstream(folder.file(c.file), std::ios::binary) << c.content;
  const std::string output = folder.file("out");
  std::vector<std::string> arguments = c.arguments;
  for (std::string& a : arguments) {
    if (a == "FILE") a = folder.file(c.file);
    if (a == "OUT") a = output;
  }
  const ProgramResult result = run(arguments);
  EXPECT_EQ(result.exitCode, c.exitCode) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  for (const std::string& part : c.said)
    EXPECT_NE(result.err.find(part), std::string::npos) << part << ": " << result.err;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    EXPECT_EQ(entry.path().filename().string(), c.file) << "left behind";
}

INSTANTIATE_TEST_SUITE_P(CommandLine, BadInput, ::testing::ValuesIn(cases()),
                         [](const auto& test) { return test.param.name; });

TEST(SeveralInputs, TheGoodOnesAreStillDone) {
  const Folder folder;
  std::ofstream(folder.file("bad.csv")) << "x,y\n1,two\n";
  std::ofstream good(folder.file("good.csv"));
  good << "x,y\n";
  for (int i = -70; i <= 70; ++i) good << i << ",0\n";  // a foot bottom alone: no rail, but a profile
  good.close();
  const ProgramResult result = run({"measure", folder.file("bad.csv"), folder.file("good.csv"), "--rail", "60E1"});
  EXPECT_EQ(result.exitCode, 2) << result.err;
  EXPECT_NE(result.out.find("good.csv"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace vignole
