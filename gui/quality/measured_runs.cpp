#include "gui/quality/measured_runs.h"

#include <limits>
#include <map>

#include "engine/files/csv_table.h"

namespace vignole {

namespace {
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
}

bool RunReference::empty() const {
  for (const auto& one : points)
    if (!one.empty()) return false;
  return true;
}

MeasuredRun runOf(const std::string& name, const std::vector<ProfileRecord>& profiles) {
  MeasuredRun run;
  run.name = name;
  run.positionM.reserve(profiles.size());
  for (const ProfileRecord& profile : profiles) {
    run.positionM.push_back(profile.positionMm / 1000);
    for (std::size_t d = 0; d < kDimensionCount; ++d) {
      const DimensionResult& is = profile.dimensions[d];
      run.dimensions[d].valueMm.push_back(is.valueMm.value_or(kNothing));
      run.dimensions[d].uMm.push_back(is.uMm);
      run.dimensions[d].uCalibrationMm.push_back(is.uCalibrationMm);
    }
  }
  return run;
}

Expected<std::vector<MeasuredRun>> readRuns(const std::filesystem::path& file) {
  const auto table = CsvTable::load(file);
  if (!table) return tl::unexpected(table.error());
  const auto position = table->column("position_m");
  if (!position) return tl::unexpected(position.error());
  const auto run = table->find("run");
  PerDimension<std::optional<std::size_t>> value, u;
  bool any = false;
  for (const Dimension d : kDimensions) {
    value[index(d)] = table->find(name(d));
    u[index(d)] = table->find("u_" + std::string(name(d)));
    any = any || value[index(d)];
  }
  if (!any)
    return inputError(file.string() + ":1",
                      "has no column of a dimension beside position_m; give one or more of RH, FW, HW ...");
  std::vector<MeasuredRun> runs;
  std::map<std::string, std::size_t> places;
  for (std::size_t r = 0; r < table->rows(); ++r) {
    const std::string runName = run ? table->text(r, *run) : file.stem().string();
    const auto [place, isNew] = places.emplace(runName, runs.size());
    if (isNew) {
      runs.emplace_back();
      runs.back().name = runName;
    }
    MeasuredRun& target = runs[place->second];
    const auto at = table->number(r, *position);
    if (!at) return tl::unexpected(at.error());
    target.positionM.push_back(*at);
    for (std::size_t d = 0; d < kDimensionCount; ++d) {
      if (!value[d]) continue;
      const auto is = table->optionalNumber(r, *value[d]);
      if (!is) return tl::unexpected(is.error());
      const auto itsU = u[d] ? table->optionalNumber(r, *u[d]) : Expected<std::optional<double>>(std::nullopt);
      if (!itsU) return tl::unexpected(itsU.error());
      target.dimensions[d].valueMm.push_back(is->value_or(kNothing));
      target.dimensions[d].uMm.push_back(itsU->value_or(0));
      target.dimensions[d].uCalibrationMm.push_back(0);
    }
  }
  return runs;
}

Expected<RunReference> readReference(const std::filesystem::path& file) {
  const auto table = CsvTable::load(file);
  if (!table) return tl::unexpected(table.error());
  const auto dimension = table->column("dimension");
  const auto position = table->column("position_m"), value = table->column("value");
  for (const auto* column : {&dimension, &position, &value})
    if (!*column) return tl::unexpected(column->error());
  const auto u = table->find("u");
  RunReference reference;
  reference.source = file.filename().string();
  for (std::size_t r = 0; r < table->rows(); ++r) {
    const auto known = dimensionFromName(table->text(r, *dimension));
    if (!known)
      return inputError(table->where(r), "\"" + table->text(r, *dimension) + "\" is no dimension; give RH, FW, HW ...");
    ReferencePoint point;
    const auto at = table->number(r, *position), is = table->number(r, *value);
    if (!at) return tl::unexpected(at.error());
    if (!is) return tl::unexpected(is.error());
    if (u) {
      const auto its = table->optionalNumber(r, *u);
      if (!its) return tl::unexpected(its.error());
      if (its->value_or(0) < 0) return inputError(table->where(r), "u is negative; give a standard uncertainty in mm");
      point.uMm = its->value_or(0);
    }
    point.positionM = *at;
    point.valueMm = *is;
    reference.points[index(*known)].push_back(point);
  }
  return reference;
}

}  // namespace vignole
