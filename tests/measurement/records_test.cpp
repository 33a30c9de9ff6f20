// Profiles that others made (../shared/data/profiles), through reader, registration and measurement.
#include <filesystem>
#include <gtest/gtest.h>

#include "engine/measurement/measurement.h"
#include "engine/profile/profile_file.h"
#include "engine/rail/catalogue.h"

namespace vignole {
namespace {

class Records : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  }
  void measure(const char* file, const char* rail = "60E1", double mmPerUnit = 1) {
    const auto section = findSection(rail);
    ASSERT_TRUE(section) << section.error().message();
    auto points = readProfile(folder / file, {ProfileFormat::Auto, mmPerUnit, 0.03});
    ASSERT_TRUE(points) << points.error().message();
    Registrar registrar(*section, {});
    flip = registerEitherWay(*points, *section, registrar, registration);
    Profile profile;
    profile.points = std::move(*points);
    Measurer(*section, defaultParameters(*section), {}, {}).measure(profile, registration, {}, result);
  }
  const DimensionResult& operator[](Dimension d) const { return result.dimensions[index(d)]; }

  const std::filesystem::path folder = std::filesystem::path(VIGNOLE_SHARED_DATA) / "profiles";
  Registration registration;
  Measurement result;
  AxisFlip flip;
};

TEST_F(Records, AnotherProgramsOutlineHasTheNominalsWithin30Micrometres) {
  measure("UIC60_rolland_1000pt.csv", "60E1", 1000);
  ASSERT_TRUE(registration.valid) << registration.reason;
  EXPECT_FALSE(flip.y);
  for (const Dimension d : {Dimension::RH, Dimension::FW, Dimension::HW, Dimension::HWA, Dimension::WT, Dimension::RFH,
                            Dimension::FTl, Dimension::FTr, Dimension::RASl, Dimension::RASr}) {
    ASSERT_TRUE((*this)[d].valueMm) << name(d) << ": " << (*this)[d].reason;
    EXPECT_NEAR(*(*this)[d].valueMm, (*this)[d].nominalMm, 0.03) << name(d);
  }
}

TEST_F(Records, CantedHeadsWithZDownGiveTheirWidthOnly) {
  for (const char* file : {"MBench_UIC60_v3.ban", "MBench_UIC60_v3.prr"}) {
    measure(file);
    ASSERT_TRUE(registration.valid) << file << ": " << registration.reason;
    EXPECT_TRUE(flip.y) << file;
    EXPECT_NEAR(std::abs(registration.worldFromSection.angleRad), 1.0 / 40, 0.002) << file;
    for (const Dimension d : {Dimension::HW, Dimension::HWA}) {
      ASSERT_TRUE((*this)[d].valueMm) << name(d) << ": " << (*this)[d].reason;
      EXPECT_NEAR(*(*this)[d].valueMm, (*this)[d].nominalMm, 0.05) << file << " " << name(d);
    }
    for (const Dimension d : {Dimension::RH, Dimension::FW, Dimension::RASl, Dimension::WT, Dimension::FC}) {
      EXPECT_FALSE((*this)[d].valueMm) << name(d);
      EXPECT_FALSE((*this)[d].reason.empty()) << name(d);
    }
  }
}

TEST_F(Records, RollersWornAndOtherRailsDoNotPretend) {
  for (const char* file : {"left-roller-v1-pre-dry.ban", "avg_HR.BAN", "guard_rail_test.ban"}) {
    measure(file);
    for (const Dimension d : kDimensions) {
      const DimensionResult& r = (*this)[d];
      EXPECT_NE(r.valueMm.has_value(), !r.reason.empty()) << file << " " << name(d);
      EXPECT_TRUE(registration.valid || !r.valueMm) << file;
    }
    EXPECT_FALSE((*this)[Dimension::RH].valueMm) << file;
    EXPECT_FALSE((*this)[Dimension::RASl].valueMm) << file;
    std::printf("%s: %s, %d of %d points, rms %.3f mm, chi2 %.1f\n", file,
                registration.valid ? "registered" : registration.reason.c_str(), registration.inliers,
                registration.points, registration.rmsMm, registration.chi2);
  }
}

}  // namespace
}  // namespace vignole
