#pragma once
// The proof of the accuracy: single profiles of the virtual rig through the whole pipeline against the truth, beside
// the limit that follows from the light and the noise that were rendered.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/accuracy.h"
#include "cli/console.h"
#include "engine/recipe/recipe.h"
#include "engine/simulator/line_bound.h"

namespace vignole::cli {

/// Standard uncertainty, mm, that the best lines leave in each dimension; empty where one cannot be measured.
using DimensionBound = PerDimension<std::optional<double>>;

/// Limits of one profile: the exact centres of the visible lines, with the uncertainty that the light and the noise
/// leave and errors independent of each other, through the measurement of the recipe without its trimming. So it is the
/// limit of these definitions and fits on the best points of the whole visible line; that of HF is the error of the
/// extreme that the definition takes. The temperature is known.
class BoundOfDimensions {
 public:
  [[nodiscard]] static Expected<BoundOfDimensions> create(const VirtualRigSettings& settings, const Recipe& recipe);
  /// `fixedPx`: every px of the line known to that much along its normal, whatever the light; for checks.
  [[nodiscard]] DimensionBound of(std::uint64_t trigger, std::optional<double> fixedPx = {}) const;

 private:
  BoundOfDimensions(simulator::RenderedLines lines, RigCalibration calibration, simulator::PictureNoise noise,
                    double temperatureC, const Recipe& recipe);
  simulator::RenderedLines lines_;
  RigCalibration calibration_;
  simulator::PictureNoise noise_;
  double temperatureC_;
  Recipe recipe_;
};

struct AccuracyRun {
  std::string name;  ///< "accuracy", "accuracy.nospeckle"
  Accuracy measured;
  DimensionBound boundMm;  ///< root mean square over profiles spread over the run
  std::uint64_t profiles = 0, registered = 0;
};

struct AccuracySettings {
  std::uint64_t profiles = 2000;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> rigSeed;
  std::string recipe = "60E1 X/A";
  std::vector<std::string> effects;  ///< as --effect, of both runs
  /// The bound for lines known to this much along their normal in every px of their length, whatever their light.
  std::optional<double> linePx;
};

/// Two runs: every effect as it is set, and the same without speckle.
[[nodiscard]] Expected<std::vector<AccuracyRun>> benchAccuracy(const AccuracySettings& settings, Progress& progress);

}  // namespace vignole::cli
