#include "report/rail_report.h"

#include <QImage>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

#include "painted_rail.h"
#include "report/dimension_text.h"
#include "report/tolerance_chart.h"

namespace vignole::test {

namespace {

namespace fs = std::filesystem;

std::string run(const std::string& command) {
  std::string out;
  if (FILE* pipe = popen(command.c_str(), "r")) {
    std::array<char, 4096> block{};
    for (std::size_t n = 0; (n = fread(block.data(), 1, block.size(), pipe)) > 0;) out.append(block.data(), n);
    pclose(pipe);
  }
  return out;
}

bool has(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

class RailReportTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("vignole_report_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + "_" +
               std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  RailReport report() {
    RailReport r;
    r.summary = &rail_.summary;
    r.recipe = &rail_.recipe;
    r.example = &rail_.result;
    r.programVersion = "0.1.0";
    return r;
  }
  void failWebThickness() {
    setValue(rail_, Dimension::WT, 1.032);
    DimensionSummary& s = rail_.summary.dimensions[index(Dimension::WT)];
    for (std::size_t i = 250; i < 280; ++i) {
      s.track[i].meanMm = s.track[i].maxMm = 17.53;
      s.values.add(17.532);
    }
    s.exceptions.push_back({37.0, 41.4, 17.532});
    s.verdict = rail_.summary.verdict = Verdict::Fail;
  }
  static void keepFile(const fs::path& file, const std::string& name) {
    if (const char* folder = std::getenv("VIGNOLE_KEEP_PICTURES"))
      fs::copy_file(file, fs::path(folder) / name, fs::copy_options::overwrite_existing);
  }
  std::size_t filesLeft() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  PaintedRail rail_ = paintedRail();
  fs::path folder_;
};

}  // namespace

TEST_F(RailReportTest, PdfHasItsPagesAndItsText) {
  failWebThickness();
  RailReport r = report();
  r.simulation = true;
  const fs::path file = folder_ / "rail.pdf";
  const auto written = writeRailReport(r, file);
  ASSERT_TRUE(written) << written.error().message();
  keepFile(file, "rail.pdf");
  if (run("command -v pdftotext").empty()) GTEST_SKIP() << "pdftotext (poppler-utils) is not installed";
  const std::string info = run("pdfinfo '" + file.string() + "'");
  EXPECT_TRUE(has(info, "Pages:           3")) << info;
  EXPECT_TRUE(has(info, "A4")) << info;
  const std::string text = run("pdftotext -layout '" + file.string() + "' -");
  for (const char* expected : {"0412-3-07", "263417", "60E1 X/A v7", "rig-2026-11-19", "Out of tolerance", "SIMULATION",
                               "17.532", "Page 1 of 3", "Page 3 of 3", "UTC", "camera 3: frame lost", "0.1.0"})
    EXPECT_TRUE(has(text, expected)) << expected << " is missing in\n" << text;
  EXPECT_TRUE(has(text, "\u22120.60")) << "a real minus sign in the limits";
}

TEST_F(RailReportTest, ManyExceptionsTakeMorePagesAndAreCounted) {
  failWebThickness();
  auto& exceptions = rail_.summary.dimensions[index(Dimension::WT)].exceptions;
  for (int i = 0; i < 600; ++i) exceptions.push_back({0.1 * i, 0.1 * i + 0.045, 17.6});
  const fs::path file = folder_ / "rail.pdf";
  ASSERT_TRUE(writeRailReport(report(), file));
  if (run("command -v pdftotext").empty()) GTEST_SKIP() << "pdftotext (poppler-utils) is not installed";
  const std::string text = run("pdftotext -layout '" + file.string() + "' -");
  EXPECT_TRUE(has(text, "the first 400 of 601"));
  EXPECT_TRUE(has(text, "continued"));
}

TEST_F(RailReportTest, PictureShowsTheVerdict) {
  failWebThickness();
  const fs::path bad = folder_ / "bad.png", good = folder_ / "good.PNG";
  ASSERT_TRUE(writeRailReport(report(), bad));
  keepFile(bad, "rail-bad.png");
  rail_ = paintedRail();
  RailReport r = report();
  r.simulation = true;
  ASSERT_TRUE(writeRailReport(r, good));
  keepFile(good, "rail-good.png");
  const QImage badImage(QString::fromStdString(bad.string())), goodImage(QString::fromStdString(good.string()));
  EXPECT_EQ(badImage.size(), QSize(1600, 1024));
  EXPECT_GT(pixelsOf(badImage, lightPalette().out), 4000);
  EXPECT_EQ(pixelsOf(goodImage, lightPalette().out), 0);
}

TEST_F(RailReportTest, WorksWithoutAnExampleAndWithNothingMeasured) {
  for (DimensionSummary& s : rail_.summary.dimensions) {
    s.values = {};
    s.track.clear();
    s.verdict = Verdict::NotMeasured;
    s.reason = "camera 3 lost";
  }
  rail_.summary.verdict = Verdict::NotMeasured;
  rail_.summary.lengthM = 0;
  rail_.summary.triggers = {};
  RailReport r = report();
  r.example = nullptr;
  ASSERT_TRUE(writeRailReport(r, folder_ / "none.pdf"));
  ASSERT_TRUE(writeRailReport(r, folder_ / "none.png"));
  keepFile(folder_ / "none.png", "rail-none.png");
  keepFile(folder_ / "none.pdf", "rail-none.pdf");
}

TEST_F(RailReportTest, AFileThatCannotBeWrittenGivesOneLineAndLeavesNothing) {
  for (const fs::path& file : {folder_ / "no" / "such" / "folder" / "rail.pdf", folder_ / "no" / "rail.png"}) {
    const auto written = writeRailReport(report(), file);
    ASSERT_FALSE(written);
    EXPECT_FALSE(has(written.error().message(), "\n"));
    EXPECT_TRUE(has(written.error().message(), file.parent_path().string())) << written.error().message();
  }
  fs::create_directories(folder_ / "folder.pdf");
  EXPECT_FALSE(writeRailReport(report(), folder_ / "folder.pdf"));
  EXPECT_EQ(filesLeft(), 1u);
}

TEST_F(RailReportTest, OtherExtensionsAreRefused) {
  for (const char* name : {"rail.docx", "rail", "rail.pdf.tmp"}) {
    const auto written = writeRailReport(report(), folder_ / name);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, ErrorKind::Input);
    EXPECT_TRUE(has(written.error().message(), ".pdf"));
  }
  EXPECT_EQ(filesLeft(), 0u);
}

TEST(DimensionText, NumbersHaveFixedDecimalsAndARealMinus) {
  EXPECT_EQ(numberText(-0.182, 3), QStringLiteral("\u22120.182"));
  EXPECT_EQ(numberText(-0.0004, 3), QStringLiteral("0.000"));
  EXPECT_EQ(deviationText(0.05, 3), QStringLiteral("+0.050"));
  EXPECT_EQ(deviationText(0.0001, 3), QStringLiteral("0.000"));
  EXPECT_EQ(decimalsOf(Dimension::HR), 1);
  EXPECT_EQ(decimalsOf(Dimension::FTl), 3);
}

TEST(DimensionText, SaysHowFarOut) {
  DimensionResult r;
  r.verdict = Verdict::Fail;
  r.lowerMm = -0.3;
  r.upperMm = 0.6;
  r.valueMm = 0.1;
  r.secondMm = -0.35;
  EXPECT_EQ(verdictSentence(Dimension::HF, r), QStringLiteral("0.050 below the limit"));
  r.valueMm = 0.7;
  EXPECT_EQ(verdictSentence(Dimension::HF, r), QStringLiteral("0.100 above the limit"));
  r.valueMm.reset();
  r.reason = "18 points of 60";
  EXPECT_EQ(verdictSentence(Dimension::RFH, r), QStringLiteral("not measured, because 18 points of 60"));
}

TEST(ToleranceChart, AxisStepsAreRound) {
  EXPECT_DOUBLE_EQ(axisStep(60, 6), 10);
  EXPECT_DOUBLE_EQ(axisStep(61, 6), 20);
  EXPECT_DOUBLE_EQ(axisStep(1.2, 6), 0.2);
  EXPECT_DOUBLE_EQ(axisStep(120, 4), 50);
}

}  // namespace vignole::test
