// vignole-cli archive, and inspect --archive, as processes.

#include <chrono>
#include <csignal>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "tests/end_to_end/program.h"

namespace vignole {
namespace {

using nlohmann::json;
using testing::Folder;
using testing::run;

std::vector<std::vector<std::string>> rowsOf(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    auto& row = rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
  }
  return rows;
}

TEST(ArchiveCommand, WhatInspectMeasuredComesOutOfTheArchiveAgain) {
  const Folder folder;
  const std::string archive = folder.file("rails.db"), csv = folder.file("inspect.csv"),
                    out = folder.file("inspect.json");
  const auto inspected = run({"inspect", "--length", "1.5", "--rails", "2", "--deviation", "HW=0.6", "--archive",
                              archive, "--csv", csv, "--json", out, "--quiet"});
  ASSERT_EQ(inspected.exitCode, 1) << inspected.err;
  const json told = json::parse(testing::contents(out))["rails"];

  const auto listed = run({"archive", "list", archive, "--json", "-"});
  ASSERT_EQ(listed.exitCode, 0) << listed.err;
  const json rails = json::parse(listed.out)["rails"];
  ASSERT_EQ(rails.size(), 2U);
  EXPECT_EQ(rails[0]["id"], told[1]["id"]);
  EXPECT_EQ(rails[0]["verdict"], "fail");
  EXPECT_EQ(rails[0]["worst"]["name"], "HW");
  EXPECT_EQ(rails[0]["state"], "finished");

  const auto shown = run({"archive", "show", archive, told[0]["id"].get<std::string>(), "--json", "-"});
  ASSERT_EQ(shown.exitCode, 0) << shown.err;
  json kept = json::parse(shown.out);
  EXPECT_EQ(kept["profiles_with_points"], 100);
  EXPECT_EQ(kept["stages"].size(), 14U);
  for (json& dimension : kept["dimensions"]) dimension.erase("excess_mm");
  for (std::size_t d = 0; d < told[0]["dimensions"].size(); ++d) {
    const json &a = told[0]["dimensions"][d], &b = kept["dimensions"][d];
    for (const auto& [key, value] : a.items()) {
      if (value.is_number_float())
        EXPECT_NEAR(value.get<double>(), b[key].get<double>(), 1e-9) << a["name"] << " " << key;
      else
        EXPECT_EQ(value, b[key]) << a["name"] << " " << key;
    }
  }

  const auto exported = run({"archive", "export", archive, told[0]["id"].get<std::string>(), "--csv", "-"});
  ASSERT_EQ(exported.exitCode, 0) << exported.err;
  const auto before = rowsOf(testing::contents(csv)), after = rowsOf(exported.out);
  ASSERT_EQ(after.size(), 101U);
  EXPECT_EQ(before[0], after[0]);
  for (std::size_t r = 1; r < after.size(); ++r) {
    ASSERT_EQ(before[r].size(), after[r].size());
    EXPECT_EQ(before[r][0], after[r][0]);
    for (std::size_t c = 1; c < after[r].size(); ++c) {
      if (before[r][c].empty() || after[r][c].empty()) {
        EXPECT_EQ(before[r][c], after[r][c]);
        continue;
      }
      EXPECT_NEAR(std::stod(before[r][c]), std::stod(after[r][c]), 0.51e-6) << before[0][c] << " of row " << r;
    }
  }

  const std::string points = folder.file("points.csv");
  ASSERT_EQ(run({"archive", "export", archive, "1", "--points", "7", "--csv", points}).exitCode, 0);
  const auto measured = run({"measure", points, "--rail", "60E1", "--json", "-"});
  const json profile = json::parse(measured.out)["files"][0];
  EXPECT_NEAR(profile["dimensions"][4]["deviation_mm"].get<double>(), 0.6, 0.06);
  EXPECT_EQ(run({"archive", "verify", archive}).exitCode, 0);
}

TEST(ArchiveCommand, FindsByWhatOneDimensionDid) {
  const Folder folder;
  const std::string archive = folder.file("rails.db");
  ASSERT_EQ(run({"archive", "generate", archive, "--rails", "12", "--length", "1.5", "--failing", "1", "--seed", "3",
                 "--quiet"})
                .exitCode,
            0);
  const auto all = json::parse(run({"archive", "list", archive, "--json", "-"}).out)["rails"];
  EXPECT_EQ(all.size(), 12U);
  const auto some = json::parse(run({"archive", "list", archive, "--exceeds", "HW=0.02", "--json", "-"}).out)["rails"];
  std::size_t expected = 0;
  for (const json& rail : all) {
    const json shown = json::parse(run({"archive", "show", archive, rail["id"].get<std::string>(), "--json", "-"}).out);
    expected += shown["dimensions"][4]["excess_mm"].get<double>() > 0.02 ? 1 : 0;
  }
  EXPECT_EQ(some.size(), expected);
  EXPECT_GT(expected, 0U);
}

TEST(ArchiveCommand, ADamagedArchiveIsNotWhole) {
  const Folder folder;
  const std::string archive = folder.file("rails.db");
  ASSERT_EQ(run({"archive", "generate", archive, "--rails", "3", "--length", "15", "--quiet"}).exitCode, 0);
  ASSERT_EQ(run({"archive", "backup", archive, folder.file("copy.db")}).exitCode, 0);
  ASSERT_EQ(run({"archive", "verify", folder.file("copy.db")}).exitCode, 0);
  // One bit within the packed profiles of a rail: such a block begins with these two bytes.
  const std::size_t block = testing::contents(archive).find("\xB7\x01");
  ASSERT_NE(block, std::string::npos);
  std::fstream file(archive, std::ios::in | std::ios::out | std::ios::binary);
  const auto place = static_cast<std::streamoff>(block) + 1000;
  file.seekg(place);
  const char byte = static_cast<char>(file.get() ^ 0x20);
  file.seekp(place);
  file.put(byte);
  file.close();
  const auto verified = run({"archive", "verify", archive, "--json", "-"});
  EXPECT_EQ(verified.exitCode, 1) << verified.out << verified.err;
  EXPECT_FALSE(json::parse(verified.out)["findings"].empty());
}

TEST(ArchiveCommand, AKilledInspectionLeavesWhatItHadMeasured) {
  const Folder folder;
  const std::string archive = folder.file("rails.db");
  testing::Program program(
      {"inspect", "--length", "600", "--paced", "--speed", "0.3", "--archive", archive, "--quiet"});
  json rails;
  for (int i = 0; i < 600 && (rails.empty() || rails[0]["profiles"] < 20); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const auto listed = run({"archive", "list", archive, "--json", "-"});
    if (listed.exitCode == 0) rails = json::parse(listed.out)["rails"];
  }
  program.signal(SIGKILL);
  (void)program.wait();
  ASSERT_FALSE(rails.empty());
  EXPECT_EQ(rails[0]["state"], "running");
  EXPECT_EQ(run({"archive", "verify", archive}).exitCode, 0);
  ASSERT_LE(run({"inspect", "--length", "0.3", "--archive", archive, "--quiet"}).exitCode, 1);
  const json after = json::parse(run({"archive", "list", archive, "--json", "-"}).out)["rails"];
  ASSERT_EQ(after.size(), 2U);
  EXPECT_EQ(after[0]["state"], "finished");
  EXPECT_EQ(after[1]["state"], "interrupted");
  EXPECT_GE(after[1]["profiles"], rails[0]["profiles"]);
  EXPECT_EQ(run({"archive", "verify", archive}).exitCode, 0);
}

TEST(ArchiveCommand, WhatCannotBeIsRefusedInOneLine) {
  const Folder folder;
  const std::string archive = folder.file("rails.db");
  ASSERT_EQ(run({"archive", "generate", archive, "--rails", "1", "--length", "0.3", "--quiet"}).exitCode, 0);
  std::ofstream(folder.file("text")) << "no archive\n";
  const std::vector<std::vector<std::string>> bad = {{"archive", "list", folder.file("missing.db")},
                                                     {"archive", "list", folder.file("text")},
                                                     {"archive", "list", archive, "--exceeds", "XX"},
                                                     {"archive", "list", archive, "--exceeds", "HW=wide"},
                                                     {"archive", "list", archive, "--verdict", "good"},
                                                     {"archive", "list", archive, "--from", "yesterday"},
                                                     {"archive", "show", archive, "R1"},
                                                     {"archive", "show", archive, "7"},
                                                     {"archive", "export", archive, "1"},
                                                     {"archive", "export", archive, "1", "--points", "3", "--csv", "-"},
                                                     {"archive", "backup", archive, archive},
                                                     {"archive", "verify"}};
  for (const auto& arguments : bad) {
    const auto result = run(arguments);
    EXPECT_EQ(result.exitCode, 2) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_TRUE(result.out.empty());
  }
  const auto away = run({"archive", "list", "postgresql://user:secret@127.0.0.1:1/rails"});
  EXPECT_EQ(away.exitCode, 3) << away.err;
  EXPECT_EQ(std::count(away.err.begin(), away.err.end(), '\n'), 1) << away.err;
  EXPECT_EQ(away.err.find("secret"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.file("missing.db")));
}

}  // namespace
}  // namespace vignole
