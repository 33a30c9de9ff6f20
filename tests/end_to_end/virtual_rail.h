#pragma once
// A short rail of the virtual rig through the whole engine.

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "engine/inspection/inspection.h"
#include "engine/inspection/rail_summary.h"
#include "engine/simulator/virtual_rig.h"

namespace vignole::testing {

struct InspectedProfile {
  std::uint64_t trigger = 0;
  PerDimension<std::optional<double>> valueMm;
  PerDimension<double> uMm{};
  std::array<std::string, kCameraCount> missing;
  bool registered = false;
  std::string reason;
  Transform2 worldFromSection;
  Eigen::Matrix3d poseCovariance = Eigen::Matrix3d::Zero();  ///< Registration::covariance
};

struct InspectedRun {
  std::vector<InspectedProfile> profiles;
  std::vector<RailSummary> rails;
  TriggerLedger triggers;
  std::string error;

  /// Every number that came out, to the last bit.
  [[nodiscard]] std::string bits() const {
    std::string text;
    char number[40];
    for (const InspectedProfile& p : profiles) {
      text += std::to_string(p.trigger);
      for (std::size_t d = 0; d < kDimensionCount; ++d) {
        std::snprintf(number, sizeof number, " %a %a", p.valueMm[d].value_or(0), p.uMm[d]);
        text += number;
      }
      text += "\n";
    }
    return text;
  }
};

inline InspectedRun inspect(const std::shared_ptr<const VirtualRig>& rig, const Recipe& recipe,
                            const VirtualSourceSettings& sourceSettings, const InspectionSettings& settings = {},
                            const std::optional<RigCalibration>& calibration = {}) {
  InspectedRun run;
  const auto source = makeVirtualSource(rig, sourceSettings);
  std::optional<RailSummariser> summariser;
  InspectionObserver observer;
  observer.railBegan = [&](const RailBegin& rail) { summariser.emplace(rail, recipe, rig->calibration().id); };
  observer.profileMeasured = [&](const ProfileResult& result) {
    summariser->add(result);
    InspectedProfile& p = run.profiles.emplace_back();
    p.trigger = result.profile.trigger;
    p.missing = result.profile.missing;
    p.registered = result.registration.valid;
    p.reason = result.registration.reason;
    p.worldFromSection = result.registration.worldFromSection;
    p.poseCovariance = result.registration.covariance;
    for (std::size_t d = 0; d < kDimensionCount; ++d) {
      p.valueMm[d] = result.measurement.dimensions[d].valueMm;
      p.uMm[d] = result.measurement.dimensions[d].uMm;
    }
  };
  observer.railEnded = [&](const RailBegin&, const TriggerLedger& ledger) {
    run.rails.push_back(summariser->summary(ledger));
  };
  observer.ended = [&](const std::string& error) { run.error = error; };
  Inspection inspection(*source, recipe, calibration.value_or(rig->calibration()), observer, settings);
  inspection.start();
  inspection.wait();
  run.triggers = inspection.triggers();
  return run;
}

inline std::shared_ptr<const VirtualRig> makeRig(const Recipe& recipe, std::uint64_t seed,
                                                 const std::vector<std::string>& faults = {}) {
  VirtualRigSettings settings;
  settings.section = recipe.section;
  settings.parameters = recipe.parameters;
  settings.seed = seed;
  for (const std::string& text : faults) settings.faults.push_back(parseFault(text).value());
  return VirtualRig::create(std::move(settings)).value();
}

}  // namespace vignole::testing
