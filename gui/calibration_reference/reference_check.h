#pragma once
// A reference piece whose dimensions are certified, measured with a calibration: does the gauge say what is true?

#include <optional>
#include <string>
#include <vector>

#include "calibration/job.h"
#include "engine/recipe/recipe.h"

namespace vignole {

struct ReferenceSettings {
  Recipe recipe;
  RigCalibration calibration;  ///< that is checked
  std::uint64_t rigSeed = 1;   ///< of the virtual rig before which the piece stands
  int profiles = 30;
};

struct ReferenceRow {
  Dimension dimension = Dimension::RH;
  double certifiedMm = 0, uCertifiedMm = 0;
  std::optional<double> measuredMm;  ///< mean of the profiles
  double uMeasuredMm = 0;            ///< standard, of the mean and by the calibration
  std::string reason;                ///< not measured
  /// Deviation over the expanded uncertainty of both; 1 or less: they agree (ISO 13528). Empty: not measured.
  [[nodiscard]] std::optional<double> normalisedError() const;
  [[nodiscard]] bool agrees() const { return !normalisedError() || *normalisedError() <= 1; }
};

struct ReferenceResult {
  std::vector<ReferenceRow> rows;  ///< in the order of kDimensions
  int profiles = 0;                ///< registered
  [[nodiscard]] bool agrees() const;
};

/// The virtual piece is a section with deviations of its own that stands still; its certificate is the truth of what is
/// rendered, U (k = 2) = 2 um. Error: cancelled, or why nothing can be measured.
[[nodiscard]] Expected<ReferenceResult> checkVirtualReference(const ReferenceSettings& settings, const Job& job);

}  // namespace vignole
