#include "calibration/range_finders/arc_prediction.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/range_finders/arc_light.h"
#include "engine/optics/nominal_rig.h"
#include "engine/optics/plane_map.h"

namespace vignole {

namespace {

constexpr double kReferenceMm = 400, kPerMm = 0.01;
constexpr double kPixelPx2 = 1.0 / 12;
constexpr double kSaturatedFactor = 2;  // a clipped profile tells less of its middle
constexpr double kNaturalEnd = 0.5;     // of the arc's brightest light: below, the light fades; above, a shadow cuts it
constexpr double kNarrowestPx2 = 0.25;  // ArcPoint::variancePx2 is clamped at filter + this ...
constexpr double kClearOfClampPx2 = 0.35;  // ... so only lines broader by so much tell their width
// Closer to the ends and darker than what the adjustment trusts, but good enough for a circle of its own.
constexpr double kShownMargin = 1, kShownLight = 0.1;
constexpr double kHalfTurn = std::numbers::pi;

double wrapped(double angle) { return std::remainder(angle, 2 * kHalfTurn); }

/// 1 up to `from`, 0 from twice that, smooth between.
double robustWeight(double sigmas, double from) {
  const double x = std::abs(sigmas) / from - 1;
  if (x <= 0) return 1;
  if (x >= 1) return 0;
  return (1 - x * x) * (1 - x * x);
}

void resize(ArcObservation& arc, std::size_t count) {
  arc.inside.assign(count, 0);
  arc.shown.assign(count, 0);
  for (auto* v : {&arc.pullMm, &arc.mmPerPx, &arc.sigmaPx, &arc.residualPx, &arc.weight, &arc.widthMisfit,
                  &arc.lightMisfit, &arc.arcPx, &arc.angleRad})
    v->assign(count, 0.0);
}

ArcScene sceneOf(const RigState& state, const CameraLight& light, const ArcObservation& arc) {
  const Pin& pin = state.pins[static_cast<std::size_t>(arc.pin)];
  ArcScene scene;
  scene.finder = &state.finders[static_cast<std::size_t>(arc.camera)];
  scene.centreMm = state.worldFromPlate[static_cast<std::size_t>(arc.placement)] * pin.centreMm;
  scene.radiusMm = pin.radiusMm;
  scene.laserMm = light.laserMm;
  scene.othersMm = light.othersMm;
  scene.otherShare = light.otherShare;
  scene.thicknessMm = std::sqrt(light.thicknessMm2);
  return scene;
}

double brightestOf(const ArcScene& scene, const ArcObservation& arc) {
  double brightest = 0;
  for (const double angle : arc.angleRad) brightest = std::max(brightest, pinLight(scene, angle).own);
  return brightest;
}

/// The stretch that is lit and seen: as far as the line goes, and where its light fades, to where it is none.
void setLitStretch(ArcScene& scene, const ArcObservation& arc) {
  const auto [low, high] = std::minmax_element(arc.angleRad.begin(), arc.angleRad.end());
  const Point3 camera = cameraCentre(scene.finder->cameraFromWorld);
  const auto heading = [&](const Point2& to) {
    const Point2 d = to - scene.centreMm;
    const double middle = (*low + *high) / 2;
    return middle + wrapped(std::atan2(d.y(), d.x()) - middle);
  };
  // Where its own laser no longer reaches there may be light of others, as far as the camera sees.
  const double toCamera = heading(camera.head<2>());
  const double darkBelow = toCamera - kHalfTurn / 2, darkAbove = toCamera + kHalfTurn / 2;
  const double brightest = brightestOf(scene, arc);
  const auto fades = [&](double angle) { return pinLight(scene, angle).own < kNaturalEnd * brightest; };
  scene.fromRad = fades(*low) ? darkBelow : *low;
  scene.toRad = fades(*high) ? darkAbove : *high;
}

void predictArc(const RigState& state, const PlaneMap& map, const CameraLight& light,
                const RigAdjustmentSettings& settings, double placeMm, ArcObservation& arc) {
  const std::vector<ArcPoint>& points = arc.line->points;
  const std::size_t count = points.size();
  resize(arc, count);
  ArcScene scene = sceneOf(state, light, arc);
  const RangeFinderCalibration& finder = *scene.finder;
  const Point3 inCamera = finder.cameraFromWorld.rotation * Point3(scene.centreMm.x(), scene.centreMm.y(), 0) +
                          finder.cameraFromWorld.translationMm;
  arc.distanceMm = inCamera.z();
  scene.smoothingPx2 = arc.filterPx2 + light.blurAt(arc.distanceMm);

  std::vector<double> offMm(count);
  double reference = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const PlanePoint p = map(points[i].px.x(), points[i].px.y());
    const Point2 out = Point2(p.x, p.y) - scene.centreMm;
    const double distance = out.norm();
    const double angle = std::atan2(out.y(), out.x());
    if (i == count / 2) reference = angle;
    arc.angleRad[i] = angle;
    offMm[i] = distance - scene.radiusMm;
    const Point2 n = out / distance;
    arc.mmPerPx[i] = std::hypot(p.dxdc * n.x() + p.dydc * n.y(), p.dxdr * n.x() + p.dydr * n.y());
    if (i > 0) arc.arcPx[i] = arc.arcPx[i - 1] + (points[i].px - points[i - 1].px).norm();
  }
  for (double& angle : arc.angleRad) angle = reference + wrapped(angle - reference);
  const auto [low, high] = std::minmax_element(arc.angleRad.begin(), arc.angleRad.end());
  arc.arcRad = *high - *low;
  setLitStretch(scene, arc);

  const ArcLight shone(scene);
  arc.offPlanePx = shone.pxPerMmOffPlane();
  const double brightest = brightestOf(scene, arc);
  const auto smoothing = [&](std::size_t i) {
    return shone.smoothingPx(Point2(-points[i].normal.y(), points[i].normal.x()));
  };
  const double atFirst = smoothing(0), atLast = smoothing(count - 1), length = arc.arcPx.back();
  for (std::size_t i = 0; i < count; ++i) {
    const double clipped = (points[i].flags & kSaturated) != 0 ? kSaturatedFactor : 1;
    arc.sigmaPx[i] = points[i].sigmaPx * clipped;
    arc.widthMisfit[i] = std::nan("");
    const double fromEnd = std::min(arc.arcPx[i] / atFirst, (length - arc.arcPx[i]) / atLast);
    const double brightness = pinLight(scene, arc.angleRad[i]).own / brightest;
    if (fromEnd < kShownMargin || brightness < kShownLight) continue;
    const ArcLight::Ridge ridge = shone.ridgeBeside(points[i].px, points[i].normal);
    if (!ridge.found) continue;
    const PlanePoint p = map(ridge.px.x(), ridge.px.y());
    arc.pullMm[i] = (Point2(p.x, p.y) - scene.centreMm).norm() - scene.radiusMm;
    arc.residualPx[i] = (offMm[i] - arc.pullMm[i]) / arc.mmPerPx[i];
    const double scatter = std::hypot(light.noise * arc.sigmaPx[i], placeMm / arc.mmPerPx[i]);
    arc.weight[i] = robustWeight(arc.residualPx[i] / scatter, settings.outlierSigmas);
    arc.shown[i] = 1;
    if (fromEnd < settings.endMarginSigmas || brightness < settings.leastLight) continue;
    arc.inside[i] = 1;
    arc.lightMisfit[i] = std::log(std::max(points[i].lightDn, 1.0)) - ridge.logLight;
    if (clipped == 1 && ridge.variancePx2 > arc.filterPx2 + kNarrowestPx2 + kClearOfClampPx2)
      arc.widthMisfit[i] = points[i].variancePx2 - ridge.variancePx2;
  }
}

/// Rows of a weighted least-squares problem in few unknowns, summed up.
template <int kUnknowns>
struct Sums {
  Eigen::Matrix<double, kUnknowns, kUnknowns> normal = Eigen::Matrix<double, kUnknowns, kUnknowns>::Zero();
  Eigen::Matrix<double, kUnknowns, 1> right = Eigen::Matrix<double, kUnknowns, 1>::Zero();
  double square = 0, weight = 0;
  void add(const Eigen::Matrix<double, kUnknowns, 1>& row, double value, double w) {
    normal += w * row * row.transpose();
    right += w * value * row;
    square += w * value * value;
    weight += w;
  }
};

constexpr double kLargestWidthMisfitPx2 = 2.5, kLargestLightMisfit = 0.7;

void refineWidths(const std::vector<ArcObservation>& arcs, int camera, CameraLight& light) {
  Sums<4> sums;
  double shared = 1;
  for (const ArcObservation& arc : arcs) {
    if (arc.camera != camera || !arc.used()) continue;
    shared = arc.correlatedPoints(light);
    const double z = (arc.distanceMm - kReferenceMm) * kPerMm;
    for (std::size_t i = 0; i < arc.inside.size(); ++i) {
      const double misfit = arc.widthMisfit[i];
      if (arc.inside[i] == 0 || !(std::abs(misfit) < kLargestWidthMisfitPx2)) continue;
      const double across = arc.offPlanePx.dot(arc.line->points[i].normal);
      sums.add(Eigen::Vector4d(1, z, z * z, across * across), misfit, arc.weight[i] / shared);
    }
  }
  if (!(sums.weight > 20 / shared)) return;
  const double variance = std::max(1e-4, sums.square / sums.weight);  // of one width
  // What is known beforehand: a lens is in focus about where it was set to; sheets are some tenths of a millimetre.
  const Eigen::Vector4d known(0.3, 0.2, 0.2, 0.15);
  const Eigen::Vector4d now(light.blurPx2[0] - 0.27, light.blurPx2[1], light.blurPx2[2] - 0.1,
                            light.thicknessMm2 - 0.1225);
  Eigen::Matrix4d information = sums.normal / variance;
  Eigen::Vector4d right = sums.right / variance;
  for (int k = 0; k < 4; ++k) {
    information(k, k) += 1 / (known[k] * known[k]);
    right[k] -= now[k] / (known[k] * known[k]);
  }
  const Eigen::Matrix4d covariance = information.inverse();
  const Eigen::Vector4d change = covariance * right;
  light.blurPx2 += change.head<3>();
  light.thicknessMm2 = std::max(0.0, light.thicknessMm2 + change[3]);
  light.uBlurPx2 = std::sqrt(covariance(0, 0));
  light.uThicknessMm2 = std::sqrt(covariance(3, 3));
}

/// The light falls off as the cosine to the laser's direction: how it does tells where the laser stands, and how much of
/// the other lasers' light joins it where it is weak.
void refineFall(const RigState& state, const std::vector<ArcObservation>& arcs, int camera, CameraLight& light) {
  using Row = Eigen::Vector3d;
  Sums<3> sums;
  std::vector<std::pair<Row, double>> rows;
  std::vector<double> weights;
  for (const ArcObservation& arc : arcs) {
    if (arc.camera != camera || !arc.used()) continue;
    const ArcScene scene = sceneOf(state, light, arc);
    const Point2 to = light.laserMm - scene.centreMm;
    const double toLaser = std::atan2(to.y(), to.x());
    const Point2 turning = Point2(-to.y(), to.x()) / to.squaredNorm();  // of that heading, per mm of the laser
    rows.clear();
    weights.clear();
    Row meanRow = Row::Zero();
    double mean = 0, total = 0;
    for (std::size_t i = 0; i < arc.inside.size(); ++i) {
      const double off = wrapped(arc.angleRad[i] - toLaser);
      if (arc.inside[i] == 0 || std::abs(off) > 0.45 * kHalfTurn || (arc.line->points[i].flags & kSaturated) != 0)
        continue;
      const PinLight there = pinLight(scene, arc.angleRad[i]);
      Row row;
      row << std::tan(off) * turning * (there.own / there.all), there.others / there.all;
      rows.emplace_back(row, arc.lightMisfit[i]);
      weights.push_back(arc.weight[i]);
      meanRow += arc.weight[i] * row;
      mean += arc.weight[i] * arc.lightMisfit[i];
      total += arc.weight[i];
    }
    if (!(total > 6)) continue;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const double off = rows[k].second - mean / total;
      if (std::abs(off) < kLargestLightMisfit)
        sums.add(rows[k].first - meanRow / total, off, weights[k] / arc.correlatedPoints(light));
    }
  }
  if (!(sums.weight > 20)) return;
  const Row known(60, 60, 0.03);  // mm, mm, share
  const Row now(0, 0, light.otherShare);
  const double variance = std::max(1e-4, sums.square / sums.weight);
  const Row perKnown2 = known.cwiseAbs2().cwiseInverse();
  Eigen::Matrix3d information = sums.normal / variance;
  information.diagonal() += perKnown2;
  const Row change = information.ldlt().solve(sums.right / variance - perKnown2.cwiseProduct(now));
  constexpr double kLongestStepMm = 60, kLargestShare = 0.2;
  light.laserMm += change.head<2>() * std::min(1.0, kLongestStepMm / std::max(change.head<2>().norm(), 1e-9));
  light.otherShare = std::clamp(light.otherShare + change[2], 0.0, kLargestShare);
}

}  // namespace

double CameraLight::blurAt(double distanceMm) const {
  const double z = (distanceMm - kReferenceMm) * kPerMm;
  return std::max(kPixelPx2, blurPx2[0] + z * (blurPx2[1] + z * blurPx2[2]));
}

double ArcObservation::correlatedPoints(const CameraLight& light) const {
  return std::max(1.0, 2 * std::sqrt(kHalfTurn * correlationPx2(light)) / spacingPx);
}

int ArcObservation::pointsUsed() const {
  if (!used()) return 0;
  int count = 0;
  for (std::size_t i = 0; i < inside.size(); ++i) count += inside[i] != 0 && weight[i] > 0.5 ? 1 : 0;
  return count;
}

std::vector<ArcObservation> observations(const RigInputs& inputs, std::span<const int> cameras) {
  std::vector<ArcObservation> arcs;
  for (std::size_t m = 0; m < inputs.placements.size(); ++m)
    for (const int camera : cameras) {
      const PinPicture& picture = inputs.placements[m].pictures[static_cast<std::size_t>(camera)];
      if (!picture.usable()) continue;
      for (std::size_t a = 0; a < picture.arcs.size(); ++a) {
        const PinArc& line = picture.arcs[a];
        const auto pin = std::find_if(inputs.plate.pins.begin(), inputs.plate.pins.end(),
                                      [&](const Pin& p) { return p.number == line.pin; });
        if (line.pin == 0 || !line.usable() || pin == inputs.plate.pins.end() || line.points.size() < 3) continue;
        ArcObservation arc;
        arc.camera = camera;
        arc.placement = static_cast<int>(m);
        arc.pin = static_cast<int>(pin - inputs.plate.pins.begin());
        arc.arc = a;
        arc.line = &line;
        arc.filterPx2 = picture.filterVariancePx2;
        double length = 0;
        for (std::size_t i = 1; i < line.points.size(); ++i)
          length += (line.points[i].px - line.points[i - 1].px).norm();
        arc.spacingPx = std::max(0.1, length / static_cast<double>(line.points.size() - 1));
        arcs.push_back(std::move(arc));
      }
    }
  return arcs;
}

void predict(const RigState& state, const std::array<CameraLight, kCameraCount>& lights,
             const RigAdjustmentSettings& settings, double placeMm, std::vector<ArcObservation>& arcs) {
  std::vector<PlaneMap> maps;
  for (const RangeFinderCalibration& finder : state.finders) maps.emplace_back(finder);
  for (ArcObservation& arc : arcs) {
    const auto camera = static_cast<std::size_t>(arc.camera);
    predictArc(state, maps[camera], lights[camera], settings, placeMm, arc);
  }
}

void refineLights(const RigState& state, const std::vector<ArcObservation>& arcs,
                  std::array<CameraLight, kCameraCount>& lights) {
  for (int camera = 0; camera < kCameraCount; ++camera) {
    refineWidths(arcs, camera, lights[static_cast<std::size_t>(camera)]);
    refineFall(state, arcs, camera, lights[static_cast<std::size_t>(camera)]);
  }
}

}  // namespace vignole
