#include "gui/calibration_reference/reference_check.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <thread>

#include "engine/inspection/inspection.h"
#include "engine/simulator/virtual_rig.h"
#include "engine/systematic/calibration_error.h"

namespace vignole {

namespace {

constexpr double kUCertificateMm = 0.001;
constexpr double kCoverage = 2;
constexpr std::uint64_t kPieceSeed = 4711;

/// What the piece has been ground to: away from nominal, so that a gauge that always says nominal does not pass.
PerDimension<std::optional<double>> pieceDeviations() {
  PerDimension<std::optional<double>> deviations{};
  deviations[index(Dimension::RH)] = 0.21;
  deviations[index(Dimension::FW)] = -0.34;
  deviations[index(Dimension::HW)] = 0.17;
  deviations[index(Dimension::WT)] = 0.12;
  return deviations;
}

struct Sums {
  int count = 0;
  double sum = 0, squares = 0;
  std::string reason;
};

}  // namespace

std::optional<double> ReferenceRow::normalisedError() const {
  if (!measuredMm) return {};
  return std::abs(*measuredMm - certifiedMm) / (kCoverage * std::hypot(uMeasuredMm, uCertifiedMm));
}

bool ReferenceResult::agrees() const {
  return std::all_of(rows.begin(), rows.end(), [](const ReferenceRow& r) { return r.agrees(); });
}

Expected<ReferenceResult> checkVirtualReference(const ReferenceSettings& settings, const Job& job) {
  VirtualRigSettings piece;
  piece.section = settings.recipe.section;
  piece.parameters = settings.recipe.parameters;
  piece.seed = kPieceSeed;
  piece.rigSeed = settings.rigSeed;
  piece.varyDimensions = false;
  piece.deviationMm = pieceDeviations();
  piece.effects.scale = 0;
  piece.effects.wander = 0;
  piece.effects.vibration = 0;
  const auto rig = VirtualRig::create(piece);
  if (!rig) return tl::unexpected<Error>(rig.error());
  const Truth truth = (*rig)->truth(0);
  std::optional<PerDimension<double>> byCalibration;
  if (settings.calibration.covariance.size() > 0) {
    const auto u = calibrationUncertainty(settings.recipe.section, settings.recipe.parameters, settings.calibration);
    if (!u) return tl::unexpected<Error>(u.error());
    byCalibration = *u;
  }

  VirtualSourceSettings source;
  source.lengthMm = settings.profiles * piece.spacingMm;
  const auto frames = makeVirtualSource(*rig, source);
  PerDimension<Sums> sums{};
  ReferenceResult result;
  std::string failed;
  InspectionObserver observer;
  int seen = 0;
  observer.profileMeasured = [&](const ProfileResult& profile) {
    job.report(static_cast<double>(++seen) / settings.profiles, "measuring the piece");
    if (profile.registration.valid) ++result.profiles;
    for (const Dimension d : kDimensions) {
      const DimensionResult& r = profile.measurement.dimensions[index(d)];
      Sums& s = sums[index(d)];
      if (!r.valueMm) {
        s.reason = r.reason;
        continue;
      }
      ++s.count;
      s.sum += *r.valueMm;
      s.squares += *r.valueMm * *r.valueMm;
    }
  };
  observer.ended = [&](const std::string& error) { failed = error; };
  {
    Inspection inspection(*frames, settings.recipe, settings.calibration, observer);
    const std::stop_callback stops(job.stop, [&inspection] { inspection.stop(); });
    inspection.start();
    inspection.wait();
  }
  if (job.cancelled()) return cancelledError();
  if (!failed.empty()) return worldError("reference piece", failed);
  if (result.profiles == 0)
    return inputError("reference piece", "no profile fits the section; check the recipe and the calibration");
  const auto nominal = nominalDimensions(settings.recipe.section, settings.recipe.parameters);
  if (!nominal) return tl::unexpected<Error>(nominal.error());
  for (const Dimension d : kDimensions) {
    if (!(*nominal)[index(d)]) continue;
    ReferenceRow row;
    row.dimension = d;
    row.certifiedMm = truth.valueMm[index(d)];
    row.uCertifiedMm = kUCertificateMm;
    const Sums& s = sums[index(d)];
    if (s.count < 2) {
      row.reason = s.reason.empty() ? "too few profiles" : s.reason;
    } else {
      const double n = s.count, mean = s.sum / n, variance = std::max(0.0, (s.squares - n * mean * mean) / (n - 1));
      row.measuredMm = mean;
      // HF is an extreme: the noise of its profiles pushes it outwards and does not average out.
      const double averaged = d == Dimension::HF ? 1 : n;
      row.uMeasuredMm = std::hypot(std::sqrt(variance / averaged), byCalibration ? (*byCalibration)[index(d)] : 0.0);
    }
    result.rows.push_back(std::move(row));
  }
  return result;
}

}  // namespace vignole
