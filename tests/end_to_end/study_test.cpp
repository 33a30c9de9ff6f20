// vignole-cli study: the published examples through the program, what it writes, and how it refuses.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/end_to_end/program.h"

namespace vignole {
namespace {

using nlohmann::json;
using testing::Folder;
using testing::ProgramResult;
using testing::run;

const std::string kQuality = std::string(VIGNOLE_SHARED_DATA) + "/quality/";

json study(std::vector<std::string> arguments, int exitCode = 0) {
  arguments.insert(arguments.begin(), "study");
  arguments.insert(arguments.end(), {"--json", "-"});
  const ProgramResult result = run(arguments);
  EXPECT_EQ(result.exitCode, exitCode) << result.err;
  EXPECT_EQ(result.err, "");
  return json::parse(result.out, nullptr, false);
}

void write(const std::string& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

TEST(StudyCommand, AnswersThePublishedExamples) {
  if (!std::filesystem::exists(kQuality + "published.json")) GTEST_SKIP() << "no published examples at " << kQuality;
  std::ifstream in(kQuality + "published.json");
  const json published = json::parse(in);
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
      {"aiag_grr_anova", {"grr", "--tolerance", "-4,4"}},
      {"aiag_grr_average_range", {"grr", "--method", "average-range"}},
      {"type1_cg_cgk", {"type1", "--reference", "-4", "--tolerance", "-11.5,3.5"}},
      {"nist_individuals", {"control-chart", "--method", "i-mr"}},
      {"nist_ewma", {"control-chart", "--method", "ewma", "--lambda", "0.3", "--reference", "50", "--sigma", "2.0539"}},
      {"gum_h1", {"uncertainty", "--trials", "10000"}}};
  for (const auto& [name, options] : cases) {
    std::vector<std::string> arguments = options;
    arguments.insert(arguments.begin() + 1, kQuality + published.at(name).at("file").get<std::string>());
    const json document = study(arguments);
    ASSERT_TRUE(document.contains("results")) << name;
    EXPECT_EQ(document.at("method"), options.front());
    EXPECT_FALSE(document.at("formulas").empty()) << name;
    EXPECT_FALSE(document.at("constants").empty()) << name;
    for (const auto& [key, expected] : published.at(name).at("expected").items()) {
      ASSERT_TRUE(document.at("results").contains(key)) << name << " " << key;
      EXPECT_NEAR(document.at("results").at(key).get<double>(), expected.at("value").get<double>(),
                  expected.at("abs_tol").get<double>() * (1 + 1e-9))
          << name << " " << key;
    }
  }
}

/// Runs of the same made rail, one column, with a position where one run has no value.
std::string madeRuns(int runs, double sigma) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> gauss(0, sigma);
  std::string text = "run,position_m,HW\n";
  for (int r = 1; r <= runs; ++r)
    for (int i = 0; i < 1400; ++i) {
      const double at = 0.015 * i;
      text += std::to_string(r) + "," + std::to_string(at) + ",";
      if (r != 2 || i != 70) text += std::to_string(72 + 0.05 * std::sin(at) + gauss(random));
      text += "\n";
    }
  return text;
}

TEST(StudyCommand, RepeatabilityGivesTableViOverSinglesAndWindows) {
  const Folder folder;
  write(folder.file("runs.csv"), madeRuns(5, 0.01));
  const json document = study({"repeatability", folder.file("runs.csv"), "--plot", folder.file("fig9.svg")});
  const json& d = document.at("results").at("dimensions").at(0);
  EXPECT_EQ(d.at("name"), "HW");
  EXPECT_EQ(d.at("runs"), 5);
  EXPECT_EQ(d.at("positions"), 1399);
  EXPECT_EQ(d.at("positions_dropped"), 1);
  EXPECT_NEAR(d.at("s_r").get<double>(), 0.01, 3e-4);
  ASSERT_EQ(d.at("sections").size(), 3U);
  EXPECT_EQ(d.at("sections").at(2).at("to_m"), 30);
  EXPECT_NEAR(d.at("mean_range").get<double>(), 0.02326, 6e-4);
  EXPECT_LT(d.at("windows").at("mean_range").get<double>(), 0.3 * d.at("mean_range").get<double>());
  EXPECT_EQ(d.at("range").size(), 1399U);
  const std::string svg = testing::contents(folder.file("fig9.svg"));
  EXPECT_TRUE(svg.starts_with("<?xml") && svg.ends_with("</svg>\n"));
}

TEST(StudyCommand, RepeatabilityTakesAFilePerRun) {
  const Folder folder;
  const std::string head = "rail,profile,position_m,trigger,HW,u_HW,rms_mm,inliers,flags\n";
  write(folder.file("a.csv"), head + "R1,0,1,5,72.00,0.01,0.02,1000,\nR1,1,2,6,72.10,0.01,0.02,1000,\n");
  write(folder.file("b.csv"), head + "R1,0,1,5,72.02,0.01,0.02,1000,\nR1,1,2,6,72.14,0.01,0.02,1000,near\n");
  const json document = study({"repeatability", folder.file("a.csv"), folder.file("b.csv")});
  ASSERT_EQ(document.at("results").at("dimensions").size(), 1U) << "the other columns are no dimensions";
  const json& d = document.at("results").at("dimensions").at(0);
  EXPECT_EQ(d.at("runs"), 2);
  EXPECT_NEAR(d.at("mean_range").get<double>(), 0.03, 1e-12);
}

TEST(StudyCommand, AccuracyOfEveryDimension) {
  const Folder folder;
  write(folder.file("a.csv"),
        "dimension,position_m,run,value,reference\nHW,1,1,72.03,72\nHW,1,2,72.01,72\nHW,2,1,71.99,72\nRH,1,1,171.8,"
        "172\n");
  const json document = study({"accuracy", folder.file("a.csv")});
  const json& d = document.at("results").at("dimensions");
  ASSERT_EQ(d.size(), 2U);
  EXPECT_NEAR(d.at(0).at("bias").get<double>(), 0.01, 1e-12);
  EXPECT_NEAR(d.at(0).at("max").get<double>(), 0.03, 1e-12);
  EXPECT_NEAR(d.at(1).at("bias_pct").get<double>(), -100 * 0.2 / 172, 1e-9);
}

TEST(StudyCommand, AgreementOfNumbersAndOfWords) {
  const Folder folder;
  write(folder.file("n.csv"), "a,b\n1,1.1\n2,2.1\n3,2.9\n4,4.2\n");
  EXPECT_NEAR(study({"agreement", folder.file("n.csv")}).at("results").at("bias").get<double>(), -0.075, 1e-12);
  write(folder.file("w.csv"), "a,b\nok,ok\nok,bad\nbad,bad\nbad,bad\n");
  EXPECT_NEAR(study({"agreement", folder.file("w.csv")}).at("results").at("kappa").get<double>(), 0.5, 1e-12);
}

TEST(StudyCommand, CapabilityIsRefusedWhereTheProcessIsNotStable) {
  const Folder folder;
  std::string stable = "x\n", jump = "x\n";
  for (int i = 0; i < 40; ++i) {
    const double value = 72 + 0.01 * ((i * 7) % 5);
    stable += std::to_string(value) + "\n";
    jump += std::to_string(value + (i == 30 ? 1 : 0)) + "\n";
  }
  write(folder.file("stable.csv"), stable);
  write(folder.file("jump.csv"), jump);
  EXPECT_GT(study({"capability", folder.file("stable.csv"), "--tolerance", "71.5,72.5"})
                .at("results")
                .at("Cpk")
                .get<double>(),
            1);
  const json refused = study({"capability", folder.file("jump.csv"), "--tolerance", "71.5,72.5"}, 1);
  EXPECT_TRUE(refused.at("results").at("Cpk").is_null());
  EXPECT_NE(refused.at("refused").get<std::string>().find("not stable"), std::string::npos);
  EXPECT_TRUE(study({"capability", folder.file("jump.csv"), "--tolerance", ",72.5", "--even-if-unstable"})
                  .at("results")
                  .at("Cpk")
                  .is_number());
}

TEST(StudyCommand, UncertaintyIsRefusedWhereFirstOrderIsZero) {
  const Folder folder;
  write(folder.file("b.csv"), "symbol,estimate,u\nx,0,0.5\n");
  const json document = study({"uncertainty", folder.file("b.csv"), "--model", "x^2", "--trials", "20000"}, 1);
  EXPECT_EQ(document.at("results").at("uc"), 0);
  EXPECT_TRUE(document.at("results").at("U").is_null());
  EXPECT_NEAR(document.at("results").at("monte_carlo").at("mean").get<double>(), 0.25, 0.02);
}

TEST(StudyCommand, ConformityHasThreeAnswers) {
  const Folder folder;
  write(folder.file("v.csv"), "value,u\n72.0,0.1\n72.4,0.1\n72.9,0.1\n");
  const json r = study({"conformity", folder.file("v.csv"), "--tolerance", "71.5,72.5"}).at("results");
  EXPECT_EQ(r.at("conforms"), 1);
  EXPECT_EQ(r.at("cannot_be_decided"), 1);
  EXPECT_EQ(r.at("does_not_conform"), 1);
}

TEST(StudyCommand, EveryStudyPlotsBothKinds) {
  const Folder folder;
  write(folder.file("runs.csv"), madeRuns(3, 0.01));
  write(folder.file("l.csv"), "reference,value\n1,1.1\n1,1.0\n2,2.1\n3,3.0\n");
  write(folder.file("p.csv"), "group,value\na,1\na,2\nb,2\nb,3\n");
  write(folder.file("c.csv"), "subgroup,x\n1,5\n1,6\n2,5\n2,7\n3,4\n3,6\n");
  const std::vector<std::vector<std::string>> studies = {{"repeatability", folder.file("runs.csv")},
                                                         {"linearity", folder.file("l.csv")},
                                                         {"precision", folder.file("p.csv")},
                                                         {"control-chart", folder.file("c.csv"), "--rules", "nelson"}};
  for (std::vector<std::string> arguments : studies)
    for (const std::string kind : {".svg", ".png"}) {
      const std::string plot = folder.file(arguments.front() + kind);
      arguments.insert(arguments.begin(), "study");
      arguments.insert(arguments.end(), {"--plot", plot});
      const ProgramResult result = run(arguments);
      EXPECT_EQ(result.exitCode, 0) << result.err;
      EXPECT_NE(result.out.find("formulas"), std::string::npos) << "the text for people";
      EXPECT_TRUE(testing::contents(plot).starts_with(kind == ".svg" ? "<?xml" : "\x89PNG")) << plot;
      arguments.erase(arguments.begin());
      arguments.resize(arguments.size() - 2);
    }
}

struct BadStudy {
  std::string name, content;
  std::vector<std::string> arguments;  ///< FILE stands for the file
  std::vector<std::string> said;
};
void PrintTo(const BadStudy& c, std::ostream* out) { *out << c.name; }

class BadStudies : public ::testing::TestWithParam<BadStudy> {};

TEST_P(BadStudies, AreOneLineAndLeaveNothing) {
  const BadStudy& c = GetParam();
  const Folder folder;
  write(folder.file("s.csv"), c.content);
  std::vector<std::string> arguments = {"study"};
  for (const std::string& a : c.arguments) arguments.push_back(a == "FILE" ? folder.file("s.csv") : a);
  arguments.insert(arguments.end(), {"--json", folder.file("out.json"), "--plot", folder.file("out.svg")});
  const ProgramResult result = run(arguments);
  EXPECT_EQ(result.exitCode, 2) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_EQ(result.out, "");
  for (const std::string& part : c.said)
    EXPECT_NE(result.err.find(part), std::string::npos) << part << ": " << result.err;
  EXPECT_FALSE(std::filesystem::exists(folder.file("out.json")) || std::filesystem::exists(folder.file("out.svg")));
}

INSTANTIATE_TEST_SUITE_P(
    CommandLine, BadStudies,
    ::testing::Values(
        BadStudy{"NoColumn", "y\n1\n", {"control-chart", "FILE"}, {"s.csv:1", "'x'", "y"}},
        BadStudy{"Text", "x\n1\nfoo\n", {"control-chart", "FILE"}, {"s.csv:3", "foo"}},
        BadStudy{"Empty", "", {"grr", "FILE"}, {"s.csv", "empty"}},
        BadStudy{"MissingCell",
                 "part,operator,trial,value\n1,A,1,2\n1,A,2,3\n2,A,1,2\n",
                 {"grr", "FILE"},
                 {"part 2", "operator A"}},
        BadStudy{"OneRun", "run,position_m,HW\n1,0,72\n1,1,72\n", {"repeatability", "FILE"}, {"s.csv", "two runs"}},
        BadStudy{"UnknownDimension",
                 "run,position_m,HW\n1,0,72\n2,0,72\n",
                 {"repeatability", "FILE", "--dimension", "XY"},
                 {"XY", "HW"}},
        BadStudy{"NoReference", "sample,x\n1,2\n2,3\n", {"type1", "FILE"}, {"--reference"}},
        BadStudy{
            "ToleranceUpsideDown", "x\n1\n2\n", {"capability", "FILE", "--tolerance", "2,1"}, {"--tolerance", "below"}},
        BadStudy{
            "ToleranceThatIsNone", "x\n1\n2\n", {"capability", "FILE", "--tolerance", "a,b"}, {"--tolerance", "'a'"}},
        BadStudy{"CapabilityWithoutTolerance", "x\n1\n2\n", {"capability", "FILE"}, {"--tolerance", "LO,HI"}},
        BadStudy{"UnknownSymbol",
                 "symbol,estimate,u\nx,1,0.1\n",
                 {"uncertainty", "FILE", "--model", "x + y"},
                 {"--model", "character 5", "'y'"}},
        BadStudy{"NegativeU",
                 "symbol,estimate,u,sensitivity\nx,1,-0.1,1\n",
                 {"uncertainty", "FILE"},
                 {"s.csv:2", "negative"}},
        BadStudy{"UnknownDistribution",
                 "symbol,estimate,u,sensitivity,distribution\nx,1,0.1,1,flat\n",
                 {"uncertainty", "FILE"},
                 {"s.csv:2", "flat", "rectangular"}},
        BadStudy{"SubgroupsInAnIndividualsChart",
                 "subgroup,x\n1,2\n1,3\n2,4\n",
                 {"control-chart", "FILE", "--method", "i-mr"},
                 {"subgroup 1"}}),
    [](const auto& test) { return test.param.name; });

TEST(StudyCommand, PlotsNeedAKnownEnding) {
  const ProgramResult result = run({"study", "grr", "x.csv", "--plot", "x.gif"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_NE(result.err.find(".svg"), std::string::npos);
}

}  // namespace
}  // namespace vignole
