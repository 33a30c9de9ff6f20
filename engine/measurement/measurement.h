#pragma once
// Measurement (paper section II-F): primitives fitted to their points, the dimensions of Table II in datums taken from
// the data (rails.md), each with its standard uncertainty, and a verdict.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/geometry/primitive.h"
#include "engine/profile/profile.h"
#include "engine/rail/dimension.h"
#include "engine/rail/section.h"
#include "engine/rail/tolerance.h"
#include "engine/registration/registration.h"

namespace vignole {

enum class Verdict { Pass, Near, Fail, NotMeasured, NoLimit };  ///< Near: within the guard band U, cannot be decided

/// "pass", "near", "fail", "not measured", "no limit"
[[nodiscard]] std::string_view name(Verdict verdict);

struct MeasurementSettings {
  double trimMm = 0.5;             ///< points nearer than this to the end of a primitive are left out of its fit
  int minPoints = 6;               ///< fewer on a primitive: not measured
  double expansionPerK = 11.5e-6;  ///< values are given at 15 degrees C
  double maxTemperatureC = 150;    ///< above, a cold size is refused
};

struct DimensionResult {
  std::optional<double> valueMm;  ///< at 15 degrees C
  double nominalMm = 0;
  double uMm = 0;             ///< standard uncertainty, of everything
  double uCalibrationMm = 0;  ///< the part of it that the calibration leaves in every profile alike
  int points = 0;
  std::string reason;  ///< "not measured, because ..." (the part after because)
  Verdict verdict = Verdict::NotMeasured;
  std::optional<double> lowerMm, upperMm;  ///< limits as values, not deviations
  std::optional<double> leftMm, rightMm;   ///< parts, where the dimension has them (RFH)
  /// HF: the smallest deviation (HF_min) and its uncertainty; WT: the smallest distance along the web.
  std::optional<double> secondMm;
  double secondUMm = 0;
  std::vector<Point2> anchors;  ///< world points between which it was taken, to draw it as in Fig. 5
};

/// A primitive as fitted to the data, world frame.
struct FittedPrimitive {
  std::size_t primitive = 0;  ///< index into Section::primitives
  Primitive shape;
  int points = 0;
  double rmsMm = 0;
};

struct Measurement {
  PerDimension<DimensionResult> dimensions;
  std::vector<FittedPrimitive> fitted;
  Verdict verdict = Verdict::NotMeasured;  ///< the worst of the dimensions that have limits
};

/// Nominals by the same definitions from the section itself (anything not defined on it is empty, with no number).
/// Refuses a parameter that falls off its primitive, naming dimension and parameter.
[[nodiscard]] Expected<PerDimension<std::optional<double>>> nominalDimensions(const Section& section,
                                                                              const DimensionParameters& parameters);

/// The usual parameters, moved onto the section's primitives where the usual ones miss them: on the asymmetric example
/// the fishing surfaces of the left side do not lie over each other at 25 mm from the axis.
[[nodiscard]] DimensionParameters defaultParameters(const Section& section);

struct RailTemperature {
  double celsius = 15;
  double uncertaintyK = 0;
};

/// One per thread.
class Measurer {
 public:
  /// Section and parameters that passed nominalDimensions. `calibrationUMm`: standard uncertainty that the calibration
  /// leaves in each dimension (calibration_error.h); it joins that of the profile.
  Measurer(const Section& section, const DimensionParameters& parameters, const PerDimension<ToleranceLimits>& limits,
           const MeasurementSettings& settings, const PerDimension<double>& calibrationUMm = {});
  ~Measurer();
  Measurer(Measurer&&) noexcept;
  Measurer& operator=(Measurer&&) noexcept;

  /// Never throws, never invents: a dimension without its points says why.
  void measure(const Profile& profile, const Registration& registration, const RailTemperature& temperature,
               Measurement& result);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vignole
