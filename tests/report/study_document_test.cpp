#include "report/study_document.h"

#include <cmath>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <unistd.h>

#include "report/document_pages.h"

namespace vignole::test {

namespace {

/// Two factors that act, together too, and one that does not; a camera that fails.
ParameterStudy madeStudy() {
  const auto design = factorialDesign(
      {{"exposure_ms", {5.0, 10.0, 15.0, 20.0}}, {"sigma_px", {1.5, 2.0, 3.0}}, {"fit", {"stable", "direct"}}});
  std::mt19937 random(1);
  std::normal_distribution<double> gauss(0, 0.1);
  const StudyTrial trial = [&](const Combination& c, const Job&) -> Expected<StudyRun> {
    StudyRun run;
    for (int camera = 0; camera < 4; ++camera) {
      StudyUnit unit;
      unit.camera = camera;
      unit.placement = 0;
      const bool fails = c[0] == 0 && c[1] == 0 && camera == 3;
      unit.failure = fails ? "too few pins" : "";
      unit.values[static_cast<std::size_t>(Response::Success)] = fails ? 0 : 1;
      if (!fails)
        unit.values[static_cast<std::size_t>(Response::Cd)] =
            0.1 * std::exp(0.3 * std::pow(c[0] - 2, 2) + 0.2 * c[1] * (c[0] == 0 ? -1 : 1) + gauss(random));
      run.units.push_back(unit);
    }
    return run;
  };
  return *runParameterStudy(*design, trial, {}, {});
}

template <typename BlockType>
std::vector<const BlockType*> blocksOf(const Document& document) {
  std::vector<const BlockType*> found;
  for (const Block& block : document.blocks)
    if (const auto* b = std::get_if<BlockType>(&block)) found.push_back(b);
  return found;
}

void expectPages(const Document& document, const char* name) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / (std::string(name) + std::to_string(::getpid()) + ".pdf");
  const auto written = writeDocument(document, "0", file);
  ASSERT_TRUE(written) << written.error().message();
  EXPECT_GT(std::filesystem::file_size(file), 5000U);
  if (std::getenv("VIGNOLE_KEEP") == nullptr) std::filesystem::remove(file);
}

TEST(StudyDocument, CarriesVerdictInfluenceAndEffects) {
  const ParameterStudy study = madeStudy();
  const Document document = studyDocument(study, "plate13");
  ASSERT_EQ(blocksOf<VerdictLine>(document).size(), 1U);
  EXPECT_THAT(blocksOf<VerdictLine>(document).front()->headline, testing::HasSubstr("exposure_ms 15, sigma_px 1.5"));
  const auto plots = blocksOf<PlotBlock>(document);
  ASSERT_EQ(plots.size(), 3U) << "influence, main effects, interactions";
  EXPECT_TRUE(plots[0]->plots.front().bars);
  EXPECT_EQ(plots[0]->plots.front().categories.front(), "exposure_ms");
  EXPECT_EQ(plots[1]->plots.size(), 3U);
  EXPECT_EQ(plots[1]->plots.front().curves.front().points.size(), 4U);
  EXPECT_EQ(plots[2]->plots.size(), 3U);
  const auto tables = blocksOf<TableBlock>(document);
  EXPECT_EQ(tables.front()->rows.front(), (std::vector<std::string>{"too few pins", "2"})) << "failures are told";
  expectPages(document, "vignole-study");
}

TEST(StudyDocument, OfAnExposureTellsLimits) {
  std::vector<ExposureReading> readings;
  for (const double ms : {5.0, 10.0, 15.0, 20.0})
    readings.push_back({ms, "scene", 0, 1000, ms > 15 ? 0.1 : 0, 8 * ms, 4 * ms, 3, 0.5 / ms, 2, 0.2});
  const auto advice = adviseExposure(readings, {});
  ASSERT_TRUE(advice);
  const Document document = exposureDocument(*advice, "rails");
  EXPECT_EQ(blocksOf<VerdictLine>(document).front()->headline, "15 ms");
  EXPECT_EQ(blocksOf<TableBlock>(document).front()->standings,
            (std::vector<Standing>{Standing::Good, Standing::Good, Standing::Good, Standing::Bad}));
  expectPages(document, "vignole-exposure");
}

}  // namespace

}  // namespace vignole::test
