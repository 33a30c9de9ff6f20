#pragma once
// Precision of a measurement method after ISO 5725-2: groups (laboratories, set-ups, days, calibrations) that measured
// the same level several times. Repeatability and reproducibility by one-way analysis of variance, groups of any size.

#include <optional>
#include <string>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/quality/outliers.h"
#include "engine/quality/sample.h"

namespace vignole {

struct PrecisionGroup {
  std::string name;
  std::vector<double> values;
};

struct PrecisionResult {
  std::vector<Sample> groups;
  std::size_t n = 0;
  double mean = 0;                ///< over all values
  double sr = 0, sL = 0, sR = 0;  ///< repeatability, between groups (0 if its variance is negative), reproducibility
  ValueRange srInterval;
  double r = 0, R = 0;  ///< limits, 2.8 s
  double msBetween = 0, msWithin = 0, f = 0, p = 0;
  std::optional<OutlierTest> cochranTest;                   ///< needs groups of one size
  std::optional<OutlierTest> grubbsTest, doubleGrubbsTest;  ///< on the means
  std::optional<Mandel> consistency;                        ///< needs groups of one size
  StudyNotes notes;
};

/// At least two groups, one of them with two values.
[[nodiscard]] Expected<PrecisionResult> precisionStudy(const std::vector<PrecisionGroup>& groups, double alpha = 0.05);

}  // namespace vignole
