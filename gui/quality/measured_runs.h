#pragma once
// Runs of one rail and what they are compared with, as values: read from the archive, from a table, or measured on the
// virtual rig.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/archive/rail_archive.h"
#include "engine/recipe/recipe.h"

namespace vignole {

/// Per dimension one value a profile, NaN where it was not measured; u: standard uncertainty, 0 where it is not known,
/// and the calibration's part of it, which averaging does not lessen.
struct RunColumn {
  std::vector<double> valueMm, uMm, uCalibrationMm;
};

struct MeasuredRun {
  std::string name;
  std::vector<double> positionM;
  PerDimension<RunColumn> dimensions;  ///< empty columns: the run does not have it
};

/// What another instrument, or the virtual rig itself, says of the same rail.
struct ReferencePoint {
  double positionM = 0, valueMm = 0, uMm = 0;
};

struct RunReference {
  std::string source;  ///< for people
  PerDimension<std::vector<ReferencePoint>> points;
  [[nodiscard]] bool empty() const;
};

/// A column of each dimension of `profiles`, positions from the rail's head.
[[nodiscard]] MeasuredRun runOf(const std::string& name, const std::vector<ProfileRecord>& profiles);
/// Columns [run,] position_m and dimensions by their names, as inspect --csv writes them; u_<dimension> where known.
/// A table without a column `run` is one run, named after the file.
[[nodiscard]] Expected<std::vector<MeasuredRun>> readRuns(const std::filesystem::path& file);
/// Columns dimension, position_m, value and, if known, u: one row a measurement of a CMM or a MiniProf.
[[nodiscard]] Expected<RunReference> readReference(const std::filesystem::path& file);

}  // namespace vignole
