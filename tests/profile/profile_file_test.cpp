#include "engine/profile/profile_file.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace vignole {
namespace {

std::string refusal(std::string_view text, const std::string& name = "p.csv", const ProfileFileOptions& options = {}) {
  const auto points = parseProfile(text, name, options);
  EXPECT_FALSE(points) << text;
  return points ? "" : points.error().message();
}

std::size_t count(std::string_view text, const std::string& name = "p.csv") {
  const auto points = parseProfile(text, name);
  EXPECT_TRUE(points) << points.error().message();
  return points ? points->size() : 0;
}

TEST(ProfileFile, ReadsCsvWithAnyHeaderAndSeparator) {
  EXPECT_EQ(count("1,2\n3,4\n"), 2U);
  EXPECT_EQ(count("\xEF\xBB\xBFY,Z\r\n1,2\r\n\r\n3,4"), 2U);
  EXPECT_EQ(count("# made by hand\nquer [mm];hoch [mm]\n1,5;2,5\n"), 1U);
  EXPECT_EQ(count("x\ty\n1\t2\n"), 1U);
  EXPECT_EQ(count("  1e1   -2.5 \n+3 4\n"), 2U);
  const auto p = parseProfile("quer;hoch\n1,5;-2,5\n", "p.csv", {ProfileFormat::Auto, 1000, 0.1});
  ASSERT_TRUE(p);
  EXPECT_DOUBLE_EQ((*p)[0].x, 1500);
  EXPECT_DOUBLE_EQ((*p)[0].y, -2500);
  EXPECT_FLOAT_EQ((*p)[0].sigmaMm, 0.1F);
}

TEST(ProfileFile, SaysWhereCsvIsBad) {
  EXPECT_EQ(refusal("x,y\n1,2\n3\n"), "p.csv:3: has 1 of 2 columns; is the file truncated?");
  EXPECT_EQ(refusal("1,2\n3,nan\n"), "p.csv:2: column 2 is nan: remove the point");
  EXPECT_EQ(refusal("1,2\nthree,4\n"), "p.csv:2: column 1 is not a number: 'three'");
  EXPECT_EQ(refusal("x,y\n"), "p.csv: holds no points; two numeric columns are needed");
  EXPECT_EQ(refusal(""), "p.csv: holds no points; two numeric columns are needed");
  EXPECT_EQ(refusal("1\n2\n"),
            "p.csv:1: column 2 is missing: the line has 1 column; two numbers are needed, is the file truncated?");
  EXPECT_EQ(refusal("x\n1\n"), "p.csv:1: one column; two numeric columns are needed");
  EXPECT_EQ(refusal("1,2\n75,171", "p.csv", {ProfileFormat::Csv, 1000, 0.03}),
            "p.csv:2: column 1 lies 75 m from the origin; is --units right?");
  EXPECT_EQ(refusal("1,2\n3,4x\n"), "p.csv:2: column 2 is not a number: '4x'");
  EXPECT_EQ(refusal(std::string_view("\x89PNG\0\0", 6)), "p.csv: is not text; CSV, .ban and .prr are read");
}

TEST(ProfileFile, ReadsMiniProfColumnsByName) {
  const std::string header = "ProgramName=MiniProf\n\"RefPoint1=\"\nXYPoints=2\nColumnDef=N,Y,X\n\n";
  const auto p = parseProfile(header + "1 2.5 3.5\n2 4 5 \n\n", "r.BAN");
  ASSERT_TRUE(p) << p.error().message();
  ASSERT_EQ(p->size(), 2U);
  EXPECT_DOUBLE_EQ((*p)[0].x, 3.5);
  EXPECT_DOUBLE_EQ((*p)[0].y, 2.5);
  EXPECT_EQ(refusal(header + "1 2 3\n", "r.ban"),
            "r.ban:6: ends after 1 points, the header says XYPoints=2; is the file truncated?");
  EXPECT_EQ(refusal(header + "1 2 3\n1 2\n", "r.ban"),
            "r.ban:7: column 3 is missing: the line has 2 columns; two numbers are needed, is the file truncated?");
  EXPECT_EQ(refusal("ColumnDef=X,A\n\n1 2\n", "r.ban"), "r.ban:1: ColumnDef has no column Y: 'X,A'");
  EXPECT_EQ(refusal("ColumnDef=X,Y\n\n", "r.ban"), "r.ban: holds no points after its header");
}

TEST(ProfileFile, ReadsSimpackInItsOwnUnits) {
  const std::string good =
      "! head\nheader.begin\nheader.end\nspline.begin\n  units.len.f = +1.0 ! metres\n"
      "point.begin\n 0.001 0.002 ! c\n0.003 0.004\npoint.end\nspline.end\n";
  const auto p = parseProfile(good, "r.prr");
  ASSERT_TRUE(p) << p.error().message();
  ASSERT_EQ(p->size(), 2U);
  EXPECT_DOUBLE_EQ((*p)[1].y, 4);
  EXPECT_EQ(refusal(good.substr(0, good.find("point.end")), "r.prr"),
            "r.prr:8: ends before point.end; is the file truncated?");
  EXPECT_EQ(refusal("header.begin\n", "r.prr"), "r.prr:1: has no point.begin");
}

TEST(ProfileFile, AMissingFileIsNamed) {
  const auto p = readProfile("/nowhere/at/all.csv");
  ASSERT_FALSE(p);
  EXPECT_NE(p.error().message().find("/nowhere/at/all.csv"), std::string::npos);
}

TEST(ProfileFile, ReadsTheRecordsThatOthersMade) {
  const std::filesystem::path folder = std::filesystem::path(VIGNOLE_SHARED_DATA) / "profiles";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  const std::pair<const char*, std::size_t> expected[] = {
      {"MBench_UIC60_v3.ban", 495}, {"MBench_UIC60_v3.prr", 495},        {"UIC60_rolland_1000pt.csv", 1000},
      {"avg_HR.BAN", 147},          {"left-roller-v1-pre-dry.ban", 345}, {"guard_rail_test.ban", 1067}};
  for (const auto& [name, points] : expected) {
    const auto p = readProfile(folder / name);
    ASSERT_TRUE(p) << p.error().message();
    EXPECT_EQ(p->size(), points) << name;
  }
}

}  // namespace
}  // namespace vignole
