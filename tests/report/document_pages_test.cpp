#include "report/document_pages.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

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

Curve wave(int colour, bool line) {
  Curve c{"camera " + std::to_string(colour + 1), {}, colour, line, 3};
  for (int i = 0; i < 60; ++i) c.points.emplace_back(i, std::sin(0.1 * i + colour));
  return c;
}

Document everyBlock() {
  Document d{"Calibration report", "rig 7", "Vignole 0.1.0   plate13", true, {}};
  d.blocks.push_back(
      VerdictLine{Standing::Near, "May be used", "one check is near its limit: the seam between 1 and 2"});
  d.blocks.push_back(FactList{
      {{"Plate", "plate13"}, {"Cameras", "4"}, {"Placements", "4"}, {"Method", "joint"}, {"Residuals", "8,412"}}});
  d.blocks.push_back(Heading{"Residuals"});
  d.blocks.push_back(Paragraph{"What is left after the adjustment, in units of its standard uncertainty.", false});
  TableBlock table{"Table IV", {"<camera", "CD mean", "CD max"}, {}, {}, "mm"};
  for (int i = 0; i < 60; ++i) table.rows.push_back({"camera " + std::to_string(i), "0.026", "0.048"});
  table.standings.assign(60, Standing::Good);
  table.standings[3] = Standing::Bad;
  d.blocks.push_back(table);
  PictureCell cell{140, 102, std::vector<std::uint8_t>(140 * 102, 60), {wave(1, true)}, "camera 2"};
  d.blocks.push_back(PictureBlock{"Lines", 2, {cell, cell, cell}, ""});
  Plot plot{"Residuals", "point", "px", {wave(0, true), wave(1, false)}, false, false, {}, false};
  Plot bars{"Effects",
            "",
            "mm",
            {Curve{"", {{0, 0.2}, {1, -0.1}, {2, 0.4}}, 5, true, 2}},
            false,
            false,
            {"exposure", "sigma", "fit"},
            true};
  d.blocks.push_back(PlotBlock{"Plots", 2, 0.7, {plot, bars}, "left: over the points; right: by factor"});
  return d;
}

}  // namespace

TEST(DocumentPages, EveryBlockIsSetAndTablesRepeatTheirHead) {
  const fs::path file = fs::temp_directory_path() / ("vignole_document_" + std::to_string(getpid()) + ".pdf");
  const auto written = writeDocument(everyBlock(), "0.1.0", file);
  ASSERT_TRUE(written) << written.error().message();
  if (const char* folder = std::getenv("VIGNOLE_KEEP_PICTURES"))
    fs::copy_file(file, fs::path(folder) / "document.pdf", fs::copy_options::overwrite_existing);
  const std::string text =
      run("command -v pdftotext").empty() ? "" : run("pdftotext -layout '" + file.string() + "' -");
  const auto size = fs::file_size(file);
  fs::remove(file);
  EXPECT_GT(size, 4000U);
  if (text.empty()) GTEST_SKIP() << "pdftotext (poppler-utils) is not installed";
  for (const char* expected : {"Calibration report", "rig 7", "May be used", "SIMULATION", "plate13", "8,412",
                               "camera 59", "Residuals", "exposure", "Page 1 of"})
    EXPECT_NE(text.find(expected), std::string::npos) << expected << " is missing in\n" << text;
  const std::size_t first = text.find("CD mean");
  ASSERT_NE(first, std::string::npos);
  EXPECT_NE(text.find("CD mean", first + 1), std::string::npos) << "the head is not repeated on the next page";
}

TEST(DocumentPages, RefusesOtherExtensions) {
  const auto written = writeDocument(everyBlock(), "0.1.0", "/tmp/report.png");
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message().find(".pdf"), std::string::npos);
}

}  // namespace vignole::test
