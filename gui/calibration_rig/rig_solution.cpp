#include "gui/calibration_rig/rig_solution.h"

#include <chrono>
#include <ctime>

namespace vignole {

namespace {

std::string isoUtcNow() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 24> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text.data();
}

Job part(const Job& job, double from, double to) {
  return {[&job, from, to](double share, std::string_view doing) { job.report(from + (to - from) * share, doing); },
          job.stop};
}

}  // namespace

Expected<RigSolution> solveRig(RigInputs inputs, const RigSolveSettings& settings, const Job& job) {
  RigSolution solution;
  const auto kept = std::make_shared<const RigInputs>(std::move(inputs));
  solution.inputs = kept;
  const RigAdjustmentSettings how;
  auto adjustment = adjustRig(*kept, how, part(job, 0, 0.4));
  if (!adjustment) return tl::unexpected<Error>(adjustment.error());
  solution.adjustment = *std::move(adjustment);
  RigCalibration& calibration = solution.adjustment.calibration;
  calibration.created = isoUtcNow();
  calibration.id = "rig-" + calibration.created;
  calibration.intervalDays = settings.intervalDays;
  solution.refusals = solution.adjustment.refusals;
  const Section& section = settings.recipe.section;
  const DimensionParameters& parameters = settings.recipe.parameters;
  if (solution.refusals.empty()) {
    if (const auto jacobian = dimensionJacobian(section, parameters, calibration); !jacobian) {
      solution.refusals.push_back("refused, because a " + section.name + " cannot be measured with this calibration (" +
                                  jacobian.error().message() +
                                  "); look at the pictures of the plate and calibrate again");
    } else {
      solution.dimensions = dimensionUncertainty(*jacobian, solution.adjustment.sources);
      RigCheckSettings what;
      what.previous = settings.inForce;
      auto checks = checkRig(*kept, how, solution.adjustment, section, parameters, what, part(job, 0.4, 0.95));
      if (!checks) return tl::unexpected<Error>(checks.error());
      solution.checks = *std::move(checks);
      for (std::string& refusal : refusalsOf(solution.checks.checks)) solution.refusals.push_back(std::move(refusal));
    }
  }
  job.report(0.95, "old and new in millimetres");
  solution.worth =
      dimensionWorth(settings.recipe, settings.inForce, solution.dimensions.empty() ? nullptr : &solution.dimensions);
  if (job.cancelled()) return cancelledError();
  return solution;
}

Document documentOf(const RigSolution& solution, const std::array<Picture, kCameraCount>& pictures,
                    const std::string& section, bool simulation) {
  RigCalibrationReport report;
  report.adjustment = &solution.adjustment;
  report.inputs = solution.inputs.get();
  for (std::size_t c = 0; c < pictures.size(); ++c) report.pictures[c] = &pictures[c];
  report.section = section;
  report.dimensions = solution.dimensions;
  report.checks = solution.checks.checks;
  report.refusals = solution.refusals;
  report.simulation = simulation;
  return rigCalibrationDocument(report);
}

}  // namespace vignole
