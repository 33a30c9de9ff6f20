#include "calibration/range_finders/arc_adjustment.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "calibration/range_finders/arc_solver.h"
#include "calibration/range_finders/line_noise.h"

namespace vignole {

namespace {

constexpr int kStepsPerRound = 12;
// What arcs may lie off by in the first rounds, when cameras are where the drawing has them or a little better.
constexpr double kFirstPlaceMm = 3, kSecondPlaceMm = 0.3;
constexpr double kSettledPx = 3e-4;   // of the largest change of a pull from round to round
constexpr double kExactPinMm = 1e-4;  // uncertainty of pins that are stated without one
constexpr double kBadArc = 4;         // rms of an arc's residuals, in their standard deviations

ArcUnknowns unknownsOf(const RigState& state,
                       const std::array<Eigen::Matrix<double, 10, 1>, kCameraCount>& intrinsics) {
  ArcUnknowns unknowns;
  for (std::size_t c = 0; c < kCameraCount; ++c)
    for (std::size_t k = 0; k < kIntrinsicsUnknowns; ++k)
      unknowns.intrinsics[c][k] = intrinsics[c][static_cast<Eigen::Index>(k)];
  for (const Pin& pin : state.pins) unknowns.pins.push_back({pin.centreMm.x(), pin.centreMm.y(), pin.radiusMm});
  for (const Transform2& t : state.worldFromPlate) unknowns.placements.push_back({t.xMm, t.yMm, t.angleRad});
  return unknowns;
}

CameraChange changeOf(const CameraBase& base, const ArcUnknowns& unknowns, std::size_t camera) {
  CameraChange change = CameraChange::Zero();
  change.head<10>() =
      base.intrinsicsFactor * Eigen::Map<const Eigen::Matrix<double, 10, 1>>(unknowns.intrinsics[camera].data());
  change.tail<6>() = Eigen::Map<const Eigen::Matrix<double, 6, 1>>(unknowns.pose[camera].data());
  return change;
}

/// Takes the unknowns into the state and counts the poses from there.
void accept(ArcUnknowns& unknowns, std::array<CameraBase, kCameraCount>& base,
            std::array<Eigen::Matrix<double, 10, 1>, kCameraCount>& intrinsics, RigState& state) {
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    RangeFinderCalibration& finder = state.finders[c];
    finder.intrinsics = base[c].intrinsics;
    finder.cameraFromWorld = base[c].cameraFromWorld;
    apply(changeOf(base[c], unknowns, c), finder);
    base[c].cameraFromWorld = finder.cameraFromWorld;
    unknowns.pose[c].fill(0);
    for (std::size_t k = 0; k < kIntrinsicsUnknowns; ++k)
      intrinsics[c][static_cast<Eigen::Index>(k)] = unknowns.intrinsics[c][k];
  }
  for (std::size_t p = 0; p < state.pins.size(); ++p) {
    state.pins[p].centreMm = {unknowns.pins[p][0], unknowns.pins[p][1]};
    state.pins[p].radiusMm = unknowns.pins[p][2];
  }
  for (std::size_t m = 0; m < state.worldFromPlate.size(); ++m)
    state.worldFromPlate[m] = {unknowns.placements[m][0], unknowns.placements[m][1], unknowns.placements[m][2]};
}

std::vector<double> pulls(const std::vector<ArcObservation>& arcs) {
  std::vector<double> all;
  for (const ArcObservation& arc : arcs)
    for (std::size_t i = 0; i < arc.inside.size(); ++i)
      all.push_back(arc.inside[i] != 0 ? arc.pullMm[i] / arc.mmPerPx[i] : 0);
  return all;
}

double largestChange(const std::vector<double>& before, const std::vector<double>& now) {
  if (before.size() != now.size()) return 1e9;
  double largest = 0;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (before[i] != 0 && now[i] != 0) largest = std::max(largest, std::abs(now[i] - before[i]));
  return largest;
}

/// An arc that lies elsewhere than its pin, or is none.
void rejectBadArcs(const std::array<CameraLight, kCameraCount>& lights, double placeMm,
                   std::vector<ArcObservation>& arcs) {
  for (ArcObservation& arc : arcs) {
    if (!arc.used()) continue;
    const double noise = lights[static_cast<std::size_t>(arc.camera)].noise;
    double square = 0, sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < arc.inside.size(); ++i) {
      if (arc.inside[i] == 0) continue;
      const double scatter = std::hypot(noise * arc.sigmaPx[i], placeMm / arc.mmPerPx[i]);
      square += std::pow(std::min(std::abs(arc.residualPx[i]) / scatter, 20.0), 2);
      sum += std::abs(arc.residualPx[i]);
      ++count;
    }
    if (count == 0) {
      arc.rejected = "too short between its ends";
    } else if (square / count > kBadArc * kBadArc) {
      const auto hundredths = static_cast<int>(std::lround(100 * sum / count));
      arc.rejected = "lies " + std::to_string(hundredths / 100) + "." + (hundredths % 100 < 10 ? "0" : "") +
                     std::to_string(hundredths % 100) + " px off the pin";
    }
  }
}

/// Of points, as many as tell independent things, and of the priors; every pin and intrinsic that is free has one.
double chi2PerDof(const ArcAdjustment& a, std::span<const int> cameras, const PinPlate& plate) {
  double sum = 0, freedom = 0;
  for (const ArcObservation& arc : a.arcs) {
    if (!arc.used()) continue;
    const CameraLight& light = a.lights[static_cast<std::size_t>(arc.camera)];
    const double shared = arc.correlatedPoints(light);
    for (std::size_t i = 0; i < arc.inside.size(); ++i) {
      if (arc.inside[i] == 0) continue;
      sum += arc.weight[i] * std::pow(arc.residualPx[i] / (light.noise * arc.sigmaPx[i]), 2) / shared;
      freedom += arc.weight[i] / shared;
    }
  }
  if (a.freedom.intrinsics)
    for (const int c : cameras) sum += a.intrinsics[static_cast<std::size_t>(c)].squaredNorm();
  for (std::size_t p = 0; a.freedom.pins && p < plate.pins.size(); ++p) {
    const Pin &found = a.state.pins[p], &stated = plate.pins[p];
    sum += (found.centreMm - stated.centreMm).squaredNorm() / std::pow(std::max(stated.uCentreMm, kExactPinMm), 2) +
           std::pow((found.radiusMm - stated.radiusMm) / std::max(stated.uRadiusMm, kExactPinMm), 2);
  }
  freedom -=
      static_cast<double>(kPoseUnknowns * cameras.size() + kPlacementUnknowns * (a.state.worldFromPlate.size() - 1));
  return freedom > 0 ? sum / freedom : 0;
}

Eigen::MatrixXd freeBlock(const Eigen::MatrixXd& m, const std::vector<Eigen::Index>& rows,
                          const std::vector<Eigen::Index>& columns) {
  Eigen::MatrixXd part(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < columns.size(); ++k)
      part(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = m(rows[i], columns[k]);
  return part;
}

}  // namespace

Eigen::Matrix<double, 10, 10> intrinsicsFactor(const Eigen::Matrix<double, 10, 10>& covariance) {
  // Column by column, so that a parameter without uncertainty of its own beyond the ones before gets an empty column;
  // in correlations, since units differ by orders of magnitude.
  using Matrix = Eigen::Matrix<double, 10, 10>;
  const Eigen::Matrix<double, 10, 1> sd = covariance.diagonal().cwiseMax(0).cwiseSqrt();
  Matrix rest = Matrix::Zero(), factor = Matrix::Zero();
  for (int i = 0; i < 10; ++i)
    for (int k = 0; k < 10; ++k)
      if (sd[i] > 0 && sd[k] > 0) rest(i, k) = covariance(i, k) / (sd[i] * sd[k]);
  constexpr double kNothing = 1e-10;
  for (int k = 0; k < 10; ++k) {
    if (!(rest(k, k) > kNothing)) continue;
    factor.col(k).tail(10 - k) = rest.col(k).tail(10 - k) / std::sqrt(rest(k, k));
    rest -= factor.col(k) * factor.col(k).transpose();
  }
  return sd.asDiagonal() * factor;
}

Influence influence(const ArcAdjustment& adjustment, const PinPlate& plate, std::span<const int> cameras,
                    const ArcFreedom& freedom) {
  const auto pinCount = static_cast<int>(plate.pins.size());
  const UnknownOrder order(plate.pins.size(), adjustment.state.worldFromPlate.size());
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(order.size(), order.size());
  for (const int c : cameras) information += adjustment.normals.information[static_cast<std::size_t>(c)];
  const auto determined = [&](Eigen::Index k) { return information(k, k) > 0; };

  std::vector<Eigen::Index> freeOnes;
  Eigen::VectorXd priors = Eigen::VectorXd::Zero(order.size());
  for (const int c : cameras) {
    for (int k = 0; freedom.intrinsics && k < kIntrinsicsUnknowns; ++k)
      if (const Eigen::Index i = order.intrinsics(c) + k; determined(i)) {
        freeOnes.push_back(i);
        priors[i] = 1;
      }
    for (int k = 0; k < kPoseUnknowns; ++k)
      if (const Eigen::Index i = order.pose(c) + k; determined(i)) freeOnes.push_back(i);
  }
  const auto uOfPin = [&](int p, int k) {
    const Pin& pin = plate.pins[static_cast<std::size_t>(p)];
    return k < 2 ? pin.uCentreMm : pin.uRadiusMm;
  };
  for (int p = 0; freedom.pins && p < pinCount; ++p)
    for (int k = 0; k < kPinUnknowns; ++k)
      if (const Eigen::Index i = order.pin(p) + k; determined(i)) {
        freeOnes.push_back(i);
        priors[i] = 1 / std::pow(std::max(uOfPin(p, k), kExactPinMm), 2);
      }
  for (std::size_t m = 0; m < adjustment.state.worldFromPlate.size(); ++m)
    for (int k = 0; k < kPlacementUnknowns && static_cast<int>(m) != adjustment.referencePlacement; ++k)
      if (const Eigen::Index i = order.placement(static_cast<int>(m)) + k; determined(i)) freeOnes.push_back(i);

  // The inverse in units in which the diagonal is one.
  Eigen::MatrixXd a = freeBlock(information, freeOnes, freeOnes);
  for (std::size_t i = 0; i < freeOnes.size(); ++i)
    a(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) += priors[freeOnes[i]];
  const Eigen::VectorXd scale = a.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd unit = scale.asDiagonal() * a * scale.asDiagonal();
  const Eigen::MatrixXd inverse =
      scale.asDiagonal() * unit.ldlt().solve(Eigen::MatrixXd::Identity(a.rows(), a.cols())) * scale.asDiagonal();

  // Answers of the free unknowns -> all that is asked for: changes of the cameras, then pins.
  const Eigen::Index rows = kRigParameters + static_cast<Eigen::Index>(pinCount) * kPinUnknowns;
  const auto place = [&](const Eigen::MatrixXd& ofFree) {
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(order.size(), ofFree.cols());
    for (std::size_t i = 0; i < freeOnes.size(); ++i) all.row(freeOnes[i]) = ofFree.row(static_cast<Eigen::Index>(i));
    return all;
  };
  const auto answer = [&](Eigen::MatrixXd all) {
    for (int c = 0; c < kCameraCount; ++c)
      all.middleRows<10>(order.intrinsics(c)) =
          (adjustment.base[static_cast<std::size_t>(c)].intrinsicsFactor * all.middleRows<10>(order.intrinsics(c)))
              .eval();
    return Eigen::MatrixXd(all.topRows(rows));
  };
  const auto isFree = [&](Eigen::Index k) { return std::binary_search(freeOnes.begin(), freeOnes.end(), k); };
  const auto position = [&](Eigen::Index k) {
    return static_cast<Eigen::Index>(std::lower_bound(freeOnes.begin(), freeOnes.end(), k) - freeOnes.begin());
  };
  // What one standard deviation of what is stated of unknown k does.
  const auto ofStated = [&](Eigen::Index k, double u) {
    Eigen::MatrixXd all;
    if (isFree(k)) {
      all = place(inverse.col(position(k)) * (priors[k] * u));
    } else {
      all = place(-inverse * freeBlock(information, freeOnes, {k}) * u);
      all(k, 0) = u;
    }
    return answer(std::move(all));
  };

  Influence result;
  result.covariance = Eigen::MatrixXd::Zero(rows, rows);
  const auto take = [&](const Eigen::MatrixXd& effects) {
    result.covariance += effects * effects.transpose();
    return effects;
  };
  for (int p = 0; p < pinCount; ++p) {
    Eigen::MatrixXd effects(rows, kPinUnknowns);
    for (int k = 0; k < kPinUnknowns; ++k) {
      const Eigen::Index i = order.pin(p) + k;
      effects.col(k) = determined(i) ? Eigen::VectorXd(ofStated(i, uOfPin(p, k))) : Eigen::VectorXd::Zero(rows);
    }
    result.ofPin.push_back(take(effects));
  }
  for (const int c : cameras) {
    const auto camera = static_cast<std::size_t>(c);
    Eigen::MatrixXd effects = Eigen::MatrixXd::Zero(rows, kIntrinsicsUnknowns);
    for (int k = 0; k < kIntrinsicsUnknowns; ++k)
      if (const Eigen::Index i = order.intrinsics(c) + k; determined(i)) effects.col(k) = ofStated(i, 1);
    result.ofIntrinsics[camera] = take(effects);

    const Eigen::MatrixXd noise = freeBlock(adjustment.normals.noise[camera], freeOnes, freeOnes);
    const Eigen::MatrixXd noiseUnit = scale.asDiagonal() * noise * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(noiseUnit);
    const double nothing = 1e-12 * std::max(solver.eigenvalues().maxCoeff(), 1e-300);
    std::vector<Eigen::Index> kept;
    for (Eigen::Index i = 0; i < solver.eigenvalues().size(); ++i)
      if (solver.eigenvalues()[i] > nothing) kept.push_back(i);
    Eigen::MatrixXd root(noise.rows(), static_cast<Eigen::Index>(kept.size()));
    for (std::size_t i = 0; i < kept.size(); ++i)
      root.col(static_cast<Eigen::Index>(i)) = scale.cwiseInverse().asDiagonal() * solver.eigenvectors().col(kept[i]) *
                                               std::sqrt(solver.eigenvalues()[kept[i]]);
    result.ofLines[camera] = take(answer(place(inverse * root)));

    const Eigen::MatrixXd own = freeBlock(adjustment.normals.information[camera], freeOnes, freeOnes);
    result.parameters[camera] = (inverse * own).trace();
  }
  return result;
}

Expected<ArcAdjustment> adjustArcs(const RigInputs& inputs, const ArcStart& start, std::vector<ArcObservation> arcs,
                                   const ArcFreedom& freedom, const RigAdjustmentSettings& settings, const Job& job) {
  ArcAdjustment result;
  result.state = start.state;
  result.lights = start.lights;
  result.referencePlacement = start.referencePlacement;
  result.freedom = freedom;
  std::vector<int> cameras;
  for (int c = 0; c < kCameraCount; ++c) {
    const auto camera = static_cast<std::size_t>(c);
    const CalibratedIntrinsics& stated = inputs.cameras[camera];
    result.base[camera] = {stated.intrinsics, start.state.finders[camera].cameraFromWorld,
                           intrinsicsFactor(stated.covariance)};
    result.intrinsics[camera].setZero();
    if (std::any_of(arcs.begin(), arcs.end(), [&](const ArcObservation& arc) { return arc.camera == c; }))
      cameras.push_back(c);
  }
  double uPin = 0;
  for (const Pin& pin : inputs.plate.pins) uPin = std::max(uPin, std::max(pin.uCentreMm, pin.uRadiusMm));

  std::vector<double> before;
  ArcUnknowns unknowns = unknownsOf(result.state, result.intrinsics);
  for (int round = 0;; ++round) {
    if (job.cancelled()) return cancelledError();
    job.report(static_cast<double>(round) / (settings.maxRounds + 1), "adjustment");
    const double placeMm = round == 0 ? kFirstPlaceMm : round == 1 ? kSecondPlaceMm : freedom.pins ? 0.0 : 2 * uPin;
    predict(result.state, result.lights, settings, placeMm, arcs);
    if (round > 0 && freedom.pins) refineNoise(result, cameras, inputs.plate, arcs);
    if (round > 1) rejectBadArcs(result.lights, placeMm, arcs);
    std::vector<double> now = pulls(arcs);
    const bool settled = round > 2 && largestChange(before, now) < kSettledPx;
    before = std::move(now);
    if (round > 0 && !settled && round < settings.maxRounds) refineLights(result.state, arcs, result.lights);
    if (!solveArcs(arcs, result.lights, result.base, inputs.plate, freedom, result.referencePlacement, kStepsPerRound,
                   unknowns, job))
      return cancelledError();
    accept(unknowns, result.base, result.intrinsics, result.state);
    result.normals = normalsOf(arcs, result.lights, result.base, unknowns);
    if (settled || round >= settings.maxRounds) break;
  }
  // Residuals of what was found, by the pulls that it was found with.
  predict(result.state, result.lights, settings, freedom.pins ? 0.0 : 2 * uPin, arcs);
  result.arcs = std::move(arcs);
  result.chi2PerDof = chi2PerDof(result, cameras, inputs.plate);
  return result;
}

}  // namespace vignole
