#include "calibration/parameter_study/calibration_trial.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include "calibration/assessment/dimension_uncertainty.h"
#include "engine/acquisition/picture_file.h"

namespace vignole {
namespace {

double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string listed(const std::set<double>& exposures) {
  std::string all;
  for (const double ms : exposures) all += (all.empty() ? "" : ", ") + words(FactorLevel(ms));
  return all;
}

std::set<double> exposuresOf(const TrialMaterial& material) {
  std::set<double> exposures;
  for (const ExposedPlacement& placement : material.placements)
    if (placement.exposureMs) exposures.insert(*placement.exposureMs);
  return exposures;
}

/// Lines as they were found, associated, and what that took.
struct Found {
  RigInputs inputs;
  std::vector<int> places;  ///< of each placement: its index over all exposures
  double seconds = 0;
};

/// Names of the settings that act in a run: two runs of the same name are the same calibration.
std::string actingName(const StudyPlan& plan, const Combination& combination, const TrialSettings& settings) {
  std::string name;
  for (std::size_t f = 0; f < plan.factors.size(); ++f)
    if (!isInert(plan.factors[f].name, settings))
      name +=
          plan.factors[f].name + "=" + words(plan.factors[f].levels[static_cast<std::size_t>(combination[f])]) + ";";
  return name;
}

double& at(StudyUnit& unit, Response response) { return unit.values[static_cast<std::size_t>(response)]; }

/// Means over the pins that one camera used in one placement.
struct PinMeans {
  int used = 0, seen = 0, measured = 0;
  double cd = 0, rd = 0, pd = 0, pdNominal = 0;
  std::map<std::string, int> reasons;

  void add(const PinView& pin) {
    ++seen;
    if (!pin.used) {
      ++reasons[pin.reason];
      return;
    }
    ++used;
    if (!std::isfinite(pin.cdMm)) return;  // an arc too short to have a centre and a radius of its own
    ++measured;
    cd += pin.cdMm;
    rd += pin.rdMm;
    pd += pin.pdMm;
    pdNominal += pin.pdNominalMm;
  }
  [[nodiscard]] std::string why() const {
    const auto most = std::max_element(reasons.begin(), reasons.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == reasons.end() || most->first.empty() ? "no pin was used" : "no pin was used: " + most->first;
  }
};

StudyUnit viewUnit(const PinMeans& pins, int camera, int place, std::size_t platePins, const PinPicture& picture) {
  StudyUnit unit;
  unit.camera = camera;
  unit.placement = place;
  at(unit, Response::Association) = static_cast<double>(pins.used) / static_cast<double>(platePins);
  at(unit, Response::Success) = pins.used > 0 ? 1 : 0;
  if (pins.used == 0) {
    unit.failure = picture.usable() ? pins.why() : picture.refusal;
    return unit;
  }
  if (pins.measured == 0) return unit;
  at(unit, Response::Cd) = pins.cd / pins.measured;
  at(unit, Response::Rd) = pins.rd / pins.measured;
  at(unit, Response::Pd) = pins.pd / pins.measured;
  at(unit, Response::PdNominal) = pins.pdNominal / pins.measured;
  return unit;
}

/// The paper's method takes a camera's pose from one picture: each placement is a calibration of its own. The others
/// adjust all placements together.
std::vector<std::vector<std::size_t>> partsOf(std::size_t placements, RigMethod method) {
  std::vector<std::vector<std::size_t>> parts;
  for (std::size_t p = 0; p < placements; ++p) {
    if (parts.empty() || method == RigMethod::Paper) parts.emplace_back();
    parts.back().push_back(p);
  }
  return parts;
}

double rootMeanSquare(const std::vector<DimensionUncertainty>& dimensions) {
  double sum = 0;
  for (const DimensionUncertainty& d : dimensions) sum += d.uMm * d.uMm;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, dimensions.size())));
}

}  // namespace

struct CalibrationTrial::Impl {
  TrialMaterial material;
  StudyPlan plan;
  std::map<std::string, int> places;  ///< of a placement without its exposure
  std::map<std::string, Found> found;
  std::map<std::string, std::pair<int, StudyRun>> done;  ///< by the settings that act
  int runs = 0;

  Expected<const Found*> linesOf(const TrialSettings& settings, const Job& job);
  Expected<Found> find(const TrialSettings& settings, const Job& job) const;
  Expected<StudyRun> calibrate(const TrialSettings& settings, const Found& lines, const Job& job) const;
  void take(const RigAdjustment& rig, const Found& lines, const std::vector<std::size_t>& part, StudyRun& run) const;
};

/// The lines depend on the exposure and the line filter alone.
Expected<const Found*> CalibrationTrial::Impl::linesOf(const TrialSettings& settings, const Job& job) {
  const StripeSettings& s = settings.lines.stripe;
  std::string key = settings.exposureMs ? words(FactorLevel(*settings.exposureMs)) : "";
  for (const double v : {s.sigma, s.low, s.high}) key += ";" + words(FactorLevel(v));
  if (const auto known = found.find(key); known != found.end()) return &known->second;
  auto lines = find(settings, job);
  if (!lines) return tl::unexpected(lines.error());
  return &found.emplace(key, *std::move(lines)).first->second;
}

Expected<Found> CalibrationTrial::Impl::find(const TrialSettings& settings, const Job& job) const {
  const double began = secondsNow();
  Found result;
  result.inputs.plate = material.plate;
  result.inputs.cameras = material.cameras;
  std::vector<const ExposedPlacement*> wanted;
  for (const ExposedPlacement& placement : material.placements)
    if (!settings.exposureMs || placement.exposureMs == settings.exposureMs) wanted.push_back(&placement);
  for (const ExposedPlacement* placement : wanted) {
    PlacementLines lines;
    lines.folder = placement->folder.string();
    for (int camera = 0; camera < kCameraCount; ++camera) {
      if (job.cancelled()) return cancelledError();
      const std::string file = (placement->folder / ("camera" + std::to_string(camera + 1) + ".png")).string();
      const auto share = static_cast<double>(result.places.size()) + camera / static_cast<double>(kCameraCount);
      job.report(0.8 * share / static_cast<double>(wanted.size()), "lines of " + file);
      const auto picture = readPicture(file);
      if (!picture) return tl::unexpected(picture.error());
      PinPicture& pins = lines.pictures[static_cast<std::size_t>(camera)];
      pins = findPinLines(picture->view(), settings.lines);
      pins.file = file;
    }
    result.inputs.placements.push_back(std::move(lines));
    result.places.push_back(places.at(placement->place));
  }
  associate(result.inputs, settings.association);
  result.seconds = secondsNow() - began;
  return result;
}

/// One calibration: what its cameras yield in its placements. `part`: their indices in the lines.
void CalibrationTrial::Impl::take(const RigAdjustment& rig, const Found& lines, const std::vector<std::size_t>& part,
                                  StudyRun& run) const {
  for (const std::string& refusal : rig.refusals)
    if (run.refusal.find(refusal) == std::string::npos) run.refusal += (run.refusal.empty() ? "" : "; ") + refusal;
  std::map<std::pair<int, int>, PinMeans> views;
  std::array<int, kCameraCount> used{};
  for (const PinView& pin : rig.pins) {
    views[{pin.placement, pin.camera}].add(pin);
    used[static_cast<std::size_t>(pin.camera)] += pin.used ? 1 : 0;
  }
  const int place = part.size() == 1 ? lines.places[part.front()] : -1;
  for (std::size_t p = 0; p < part.size(); ++p)
    for (int camera = 0; camera < kCameraCount; ++camera)
      run.units.push_back(viewUnit(views[{static_cast<int>(p), camera}], camera, lines.places[part[p]],
                                   material.plate.pins.size(),
                                   lines.inputs.placements[part[p]].pictures[static_cast<std::size_t>(camera)]));
  for (int camera = 0; camera < kCameraCount; ++camera) {
    if (used[static_cast<std::size_t>(camera)] == 0) continue;
    StudyUnit unit;
    unit.camera = camera;
    unit.placement = place;
    at(unit, Response::Reprojection) = rig.finders[static_cast<std::size_t>(camera)].reprojectionPx;
    run.units.push_back(unit);
  }
  if (!material.jacobian || rig.sources.empty() || !rig.refusals.empty()) return;
  StudyUnit whole;
  whole.placement = place;
  at(whole, Response::DimensionU) = rootMeanSquare(dimensionUncertainty(*material.jacobian, rig.sources));
  run.units.push_back(whole);
}

Expected<StudyRun> CalibrationTrial::Impl::calibrate(const TrialSettings& settings, const Found& lines,
                                                     const Job& job) const {
  const double began = secondsNow();
  StudyRun run;
  const std::vector<std::vector<std::size_t>> parts = partsOf(lines.places.size(), settings.adjustment.method);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    RigInputs inputs = lines.inputs;
    inputs.placements.clear();
    for (const std::size_t p : parts[i]) inputs.placements.push_back(lines.inputs.placements[p]);
    const Job solving{[&](double share, std::string_view doing) {
                        job.report(0.8 + 0.2 * (static_cast<double>(i) + share) / static_cast<double>(parts.size()),
                                   doing);
                      },
                      job.stop};
    const auto rig = adjustRig(inputs, settings.adjustment, solving);
    if (!rig) return tl::unexpected(rig.error());
    take(*rig, lines, parts[i], run);
  }
  StudyUnit whole;
  at(whole, Response::Time) = lines.seconds + secondsNow() - began;
  run.units.push_back(whole);
  return run;
}

CalibrationTrial::CalibrationTrial(TrialMaterial material, StudyPlan plan) : impl_(std::make_unique<Impl>()) {
  impl_->material = std::move(material);
  impl_->plan = std::move(plan);
  for (const ExposedPlacement& placement : impl_->material.placements)
    impl_->places.emplace(placement.place, static_cast<int>(impl_->places.size()));
}

CalibrationTrial::~CalibrationTrial() = default;

Expected<StudyRun> CalibrationTrial::operator()(const Combination& combination, const Job& job) {
  Impl& self = *impl_;
  const auto settings = trialSettings(self.plan, combination);
  if (!settings) return tl::unexpected(settings.error());
  const int index = self.runs++;
  const std::string acting = actingName(self.plan, combination, *settings);
  if (const auto same = self.done.find(acting); same != self.done.end()) {
    StudyRun run = same->second.second;
    run.sameAs = same->second.first;
    return run;
  }
  const auto lines = self.linesOf(*settings, job);
  if (!lines) return tl::unexpected(lines.error());
  auto run = self.calibrate(*settings, **lines, job);
  if (!run) return run;
  self.done.emplace(acting, std::pair(index, *run));
  return run;
}

Expected<void> checkMaterial(const TrialMaterial& material, const StudyPlan& plan) {
  if (material.placements.empty()) return inputError("--placement", "no placement is given");
  const std::set<double> exposures = exposuresOf(material);
  std::set<double> wanted;
  for (const Factor& factor : plan.factors)
    if (factor.name == "exposure_ms")
      for (const FactorLevel& level : factor.levels) wanted.insert(std::get<double>(level));
  for (const auto& [factor, level] : plan.fixed)
    if (factor == "exposure_ms") wanted.insert(std::get<double>(level));
  for (const double ms : wanted)
    if (!exposures.contains(ms))
      return inputError("exposure_ms", "there are no placements at " + words(FactorLevel(ms)) + " ms (" +
                                           exposureFolder(ms) + "); there are at " +
                                           (exposures.empty() ? "none that is told" : listed(exposures)));
  if (wanted.empty() && exposures.size() > 1)
    return inputError("--placement", "placements at several exposures (" + listed(exposures) +
                                         " ms) without a factor exposure_ms; add the factor, fix one, or give the "
                                         "placements of one exposure");
  return {};
}

Expected<ParameterStudy> runCalibrationStudy(const StudyPlan& plan, TrialMaterial material, const Job& job) {
  if (auto fits = checkMaterial(material, plan); !fits) return tl::unexpected(fits.error());
  const auto design = factorialDesign(plan.factors, plan.design);
  if (!design) return tl::unexpected(design.error());
  CalibrationTrial trial(std::move(material), plan);
  return runParameterStudy(*design, std::ref(trial), plan.analysis, job);
}

}  // namespace vignole
