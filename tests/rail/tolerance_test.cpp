#include "engine/rail/tolerance.h"

#include <gtest/gtest.h>

#include "engine/rail/catalogue.h"

namespace vignole {
namespace {

using Limits = std::pair<std::optional<double>, std::optional<double>>;

Limits limits(const char* section, const char* profile, const char* straightness, Dimension d) {
  const auto all = toleranceLimits(*findSection(section), profile, straightness);
  EXPECT_TRUE(all) << (all ? "" : all.error().message());
  if (!all) return {};
  return {all->at(index(d)).lowerMm, all->at(index(d)).upperMm};
}

TEST(Tolerance, ClassesOfEn13674) {
  EXPECT_EQ(limits("60E1", "X", "A", Dimension::RH), Limits(-0.6, 0.6));
  EXPECT_EQ(limits("54E1", "X", "A", Dimension::RH), Limits(-0.5, 0.5)) << "below 165 mm";
  EXPECT_EQ(limits("60E1", "Y", "A", Dimension::RH), Limits(-1.1, 0.6));
  EXPECT_EQ(limits("49E5", "Y", "A", Dimension::RH), Limits(-1.0, 0.5));
  EXPECT_EQ(limits("60E1", "X", "A", Dimension::HF), Limits(-0.3, 0.6));
  EXPECT_EQ(limits("60E1", "Y", "B", Dimension::HF), Limits(-0.6, 0.6)) << "straightness is chosen apart";
  EXPECT_EQ(limits("60E1", "X", "A", Dimension::HW), Limits(-0.5, 0.5));
  EXPECT_EQ(limits("60E1", "Y", "A", Dimension::HW), Limits(-0.5, 0.6));
  EXPECT_EQ(limits("60E1", "X", "A", Dimension::FW), Limits(-1.0, 1.0));
  EXPECT_EQ(limits("60E1", "Y", "A", Dimension::FW), Limits(-1.0, 1.5));
  EXPECT_EQ(limits("60E1", "X", "A", Dimension::WT), Limits(-0.5, 1.0));
  EXPECT_EQ(limits("60E1", "X", "A", Dimension::FTl), Limits(-0.5, 0.75));
  EXPECT_EQ(limits("60E1", "X", "A", Dimension::RASr), Limits(-1.2, 1.2));
  EXPECT_EQ(limits("60E1", "X", "A", Dimension::FC), Limits(std::nullopt, 0.3));
  EXPECT_EQ(limits("60E1", "X", "A", Dimension::HR), Limits(std::nullopt, std::nullopt));
}

TEST(Tolerance, OtherClasses) {
  EXPECT_EQ(limits("60E1", "IRS-T12", "A", Dimension::FW), Limits(-1.0, 1.2)) << "from 60 kg/m";
  EXPECT_EQ(limits("54E1", "IRS-T12", "A", Dimension::FW), Limits(-1.0, 1.0));
  EXPECT_EQ(limits("115RE", "AREMA", "A", Dimension::HWA), Limits(-0.635, 0.635));
}

TEST(Tolerance, ClassThatDoesNotExist) {
  const auto profile = toleranceLimits(*findSection("60E1"), "Z", "A");
  ASSERT_FALSE(profile);
  EXPECT_NE(profile.error().message().find("X, Y"), std::string::npos) << profile.error().message();
  const auto straightness = toleranceLimits(*findSection("60E1"), "X", "C");
  ASSERT_FALSE(straightness);
  EXPECT_NE(straightness.error().message().find("A, B"), std::string::npos);
  EXPECT_FALSE(toleranceLimits(*findSection("60E1"), "", "A"));
}

TEST(Tolerance, NoteNamesTheEdition) {
  EXPECT_NE(toleranceNote().find("2008"), std::string::npos);
  EXPECT_NE(toleranceNote().find("edition in force"), std::string::npos);
}

}  // namespace
}  // namespace vignole
