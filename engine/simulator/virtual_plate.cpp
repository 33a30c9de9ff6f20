#include "engine/simulator/virtual_plate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/optics/nominal_rig.h"
#include "engine/simulator/hashing.h"
#include "engine/simulator/noise_scale.h"
#include "engine/simulator/plate_renderer.h"

namespace vignole {

using namespace simulator;  // the room's own parts

namespace {

constexpr double kUsualExposureMs = 15;
constexpr double kDegree = std::numbers::pi / 180;
const Point2 kFieldMiddle(0, 86);

/// A pin as it was made: where its axis meets the plate's surface, and its lean.
struct MadePin {
  Pin stated;
  Point2 foot{0, 0};
  double radiusMm = 0;
  Point2 lean{0, 0};  ///< mm of x and y per mm of z
};

MadePin makePin(const Pin& stated, const VirtualPlateSettings& settings) {
  Draws draws(settings.seed, Stream::Plate, {static_cast<std::uint64_t>(stated.number)});
  MadePin pin;
  pin.stated = stated;
  const auto within = [&](double most) { return most * draws.uniform(-1, 1); };
  pin.foot = stated.centreMm;
  pin.foot.x() += within(settings.plateErrorMm);
  pin.foot.y() += within(settings.plateErrorMm);
  pin.radiusMm = stated.radiusMm + within(settings.radiusErrorMm);
  pin.lean = {1e-3 * settings.leanMrad * draws.normal(), 1e-3 * settings.leanMrad * draws.normal()};
  return pin;
}

/// The plate's frame (z towards the cameras, 0 where the light plane cuts an upright plate) in the world.
Eigen::Isometry3d worldFromPlate(const PlatePlacement& placement, const Point2& middleOfPlate) {
  const Transform2& flat = placement.worldFromPlate;
  const Point2 middle = flat * middleOfPlate;
  const Eigen::Translation3d toMiddle(middle.x(), middle.y(), 0), shift(flat.xMm, flat.yMm, 0);
  return toMiddle * Eigen::AngleAxisd(placement.tiltXRad, Point3::UnitX()) *
         Eigen::AngleAxisd(placement.tiltYRad, Point3::UnitY()) * toMiddle.inverse() * shift *
         Eigen::AngleAxisd(flat.angleRad, Point3::UnitZ());
}

Transform2 aboutFieldMiddle(double angleRad, const Point2& shift) {
  const Transform2 turn{0, 0, angleRad};
  const Point2 at = kFieldMiddle - turn.rotate(kFieldMiddle) + shift;
  return {at.x(), at.y(), angleRad};
}

/// Arcs that shine as a pin does but stand elsewhere, clear of the pins so that they are lines of their own.
std::vector<SpuriousArc> drawSpurious(std::uint64_t seed, int camera, int placement, int count, const PlateScene& scene,
                                      const Point3& eye) {
  constexpr double kClearMm = 3;
  constexpr int kTrials = 200;
  Draws draws(seed, Stream::Spurious, {static_cast<std::uint64_t>(camera), static_cast<std::uint64_t>(placement)});
  std::vector<SpuriousArc> arcs;
  for (int trial = 0; static_cast<int>(arcs.size()) < count && trial < kTrials * count; ++trial) {
    SpuriousArc arc;
    arc.centre = kFieldMiddle + Point2(draws.uniform(-90, 90), draws.uniform(-100, 100));
    arc.radiusMm = draws.uniform(3, 12);
    const Point2 toEye = eye.head<2>() - arc.centre;
    const double facing = std::atan2(toEye.y(), toEye.x()) + draws.uniform(-30, 30) * kDegree;
    const double length = draws.uniform(40, 150) * kDegree;
    arc.fromRad = facing - length / 2;
    arc.toRad = facing + length / 2;
    const auto clear = [&](const Point2& centre, double radius) {
      return (arc.centre - centre).norm() > arc.radiusMm + radius + kClearMm;
    };
    const bool alone =
        std::all_of(scene.pins.begin(), scene.pins.end(),
                    [&](const PinBody& pin) { return clear(pin.centre(), pin.radiusMm()); }) &&
        std::all_of(arcs.begin(), arcs.end(), [&](const SpuriousArc& a) { return clear(a.centre, a.radiusMm); });
    if (alone) arcs.push_back(arc);
  }
  return arcs;
}

Expected<void> check(const VirtualPlateSettings& s) {
  const auto between = [](double value, double min, double max) { return value >= min && value <= max; };
  if (s.plate.pins.empty()) return inputError("plate", "has no pins");
  if (s.placements.empty()) return inputError("placements", "there must be at least one");
  if (!between(s.plateErrorMm, 0, 2)) return inputError("plate-error-um", "must lie between 0 and 2,000");
  if (!between(s.radiusErrorMm, 0, 2)) return inputError("radius error", "must lie between 0 and 2 mm");
  if (!between(s.leanMrad, 0, 100)) return inputError("lean", "must lie between 0 and 100 mrad");
  if (!between(s.exposureMs, 0.01, 10000)) return inputError("exposure", "must lie between 0.01 and 10,000 ms");
  if (s.noisePx && !between(*s.noisePx, 1e-4, 10)) return inputError("noise-px", "must lie between 0.0001 and 10");
  if (s.spurious < 0 || s.spurious > 50) return inputError("spurious", "must lie between 0 and 50 arcs a picture");
  for (const PlatePlacement& p : s.placements)
    if (!between(std::hypot(p.tiltXRad, p.tiltYRad), 0, 30 * kDegree))
      return inputError("tilt", "must not exceed 30 degrees");
  for (const int missing : s.missingPins)
    if (std::none_of(s.plate.pins.begin(), s.plate.pins.end(), [&](const Pin& p) { return p.number == missing; }))
      return inputError("missing pin " + std::to_string(missing), "is no pin of plate " + s.plate.id);
  for (const Pin& pin : s.plate.pins)
    if (!(pin.radiusMm > s.radiusErrorMm))
      return inputError("pin " + std::to_string(pin.number), "has a radius that its error may use up");
  for (const Fault& fault : s.faults)
    if (fault.kind != "black" && fault.kind != "saturated" && fault.kind != "move" && fault.kind != "turn")
      return inputError("fault " + fault.kind,
                        "means nothing to a plate; there are black, saturated, move=NUMBER, turn=NUMBER");
  return {};
}

Effects exposedFor(const Effects& effects, double exposureMs) {
  Effects exposed = effects;
  exposed.ambientDn *= exposureMs / kUsualExposureMs;
  return exposed;
}

/// The light of every visible px of line in all cameras of one scene, off a twin without noise.
std::vector<LineLight> visibleLight(const PlateScene& scene, const RigGeometry& rig, std::uint64_t seed,
                                    const Effects& effects) {
  const PlateRenderer twin(seed, rig, withNoise(effects, 0), 1);
  const Intrinsics& in = rig.calibration.rangeFinders[0].intrinsics;
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(in.widthPx) * static_cast<std::size_t>(in.heightPx));
  std::vector<LineLight> light;
  for (int camera = 0; camera < kCameraCount; ++camera) {
    const CameraShot shot = shotUnder({}, rig.calibration, camera, 1);
    twin.render(scene, {}, shot, {pixels.data(), in.widthPx, in.heightPx, in.widthPx});
    const ImageView picture{pixels.data(), in.widthPx, in.heightPx, in.widthPx};
    for (std::size_t pin = 0; pin < scene.pins.size(); ++pin)
      for (const auto& line : twin.visibleLines(scene, pin, shot))
        for (const LinePlace& place : readPlaces(line, picture, effects.ambientDn)) light.push_back(place.light);
  }
  return light;
}

}  // namespace

struct VirtualPlate::Impl {
  VirtualPlateSettings settings;
  RigGeometry geometry;
  std::vector<MadePin> pins;
  PinPlate truePlate;
  double noiseFactor = 1;
  std::vector<PlateScene> scenes;  ///< per placement
  std::unique_ptr<PlateRenderer> renderer;

  void makePlate();
  [[nodiscard]] PlateScene sceneOf(std::size_t placement) const;
  [[nodiscard]] CameraShot shot(int camera, int placement) const {
    return shotUnder(settings.faults, geometry.calibration, camera, static_cast<std::uint64_t>(placement) + 1);
  }
};

void VirtualPlate::Impl::makePlate() {
  truePlate = settings.plate;
  truePlate.pins.clear();
  for (const Pin& stated : settings.plate.pins) {
    const MadePin made = makePin(stated, settings);
    pins.push_back(made);
    truePlate.pins.push_back({stated.number, made.foot + settings.plate.surfaceMm * made.lean, made.radiusMm, 0, 0});
  }
}

PlateScene VirtualPlate::Impl::sceneOf(std::size_t placement) const {
  Point2 middle(0, 0);
  for (const Pin& pin : settings.plate.pins) middle += pin.centreMm / static_cast<double>(settings.plate.pins.size());
  const Eigen::Isometry3d pose = worldFromPlate(settings.placements[placement], middle);
  PlateScene scene;
  scene.key = placement;
  const double surface = settings.plate.surfaceMm, protrusion = settings.plate.protrusionMm;
  for (const MadePin& pin : pins) {
    if (std::find(settings.missingPins.begin(), settings.missingPins.end(), pin.stated.number) !=
        settings.missingPins.end())
      continue;
    const Point3 foot(pin.foot.x(), pin.foot.y(), -surface), along(pin.lean.x(), pin.lean.y(), 1);
    scene.pins.emplace_back(pin.stated.number, pose * foot, pose.linear() * along.normalized(), pin.radiusMm, 0.0,
                            (surface + protrusion) * along.norm());
  }
  return scene;
}

std::vector<PlatePlacement> usualPlacements(int count, std::uint64_t seed) {
  std::vector<PlatePlacement> placements;
  for (int i = 0; i < count; ++i) {
    Draws draws(seed, Stream::Placement, {static_cast<std::uint64_t>(i)});
    const Point2 hand(draws.uniform(-1, 1), draws.uniform(-1, 1));
    const double handRad = draws.uniform(-0.3, 0.3) * kDegree;
    Transform2 place;
    if (i == 1) place = aboutFieldMiddle(180 * kDegree + handRad, hand);
    if (i == 2) place = aboutFieldMiddle(4 * kDegree + handRad, Point2(5, -4) + hand);
    if (i == 3) place = aboutFieldMiddle(176 * kDegree + handRad, Point2(-4, 3) + hand);
    if (i > 3) {
      const double turn = (i % 2 == 0 ? 0 : 180) + draws.uniform(-8, 8);
      place = aboutFieldMiddle(turn * kDegree, {draws.uniform(-6, 6), draws.uniform(-6, 6)});
    }
    placements.push_back({place, 0, 0});
  }
  return placements;
}

PlatePlacement turned(const PlatePlacement& placement, double angleRad) {
  PlatePlacement further = placement;
  further.worldFromPlate = aboutFieldMiddle(angleRad, {0, 0}) * placement.worldFromPlate;
  return further;
}

Expected<std::shared_ptr<const VirtualPlate>> VirtualPlate::create(VirtualPlateSettings settings) {
  if (auto fine = check(settings); !fine) return tl::unexpected<Error>(fine.error());
  auto impl = std::make_unique<Impl>();
  impl->settings = std::move(settings);
  const VirtualPlateSettings& s = impl->settings;
  impl->geometry = drawRig(s.rigSeed.value_or(s.seed));
  impl->makePlate();
  for (std::size_t i = 0; i < s.placements.size(); ++i) impl->scenes.push_back(impl->sceneOf(i));
  if (s.noisePx) {
    const auto factor =
        noiseFactorFor(*s.noisePx, visibleLight(impl->scenes.front(), impl->geometry, s.seed, s.effects), s.effects);
    if (!factor) return tl::unexpected<Error>(factor.error());
    impl->noiseFactor = *factor;
  }
  impl->renderer = std::make_unique<PlateRenderer>(s.seed, impl->geometry,
                                                   exposedFor(withNoise(s.effects, impl->noiseFactor), s.exposureMs),
                                                   s.exposureMs / kUsualExposureMs);
  return std::shared_ptr<const VirtualPlate>(new VirtualPlate(std::move(impl)));
}

VirtualPlate::VirtualPlate(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VirtualPlate::~VirtualPlate() = default;

const VirtualPlateSettings& VirtualPlate::settings() const { return impl_->settings; }
const RigCalibration& VirtualPlate::calibration() const { return impl_->geometry.calibration; }
const RigCalibration& VirtualPlate::nominalRig() { return vignole::nominalRig(); }
const PinPlate& VirtualPlate::truePlate() const { return impl_->truePlate; }
double VirtualPlate::noiseFactor() const { return impl_->noiseFactor; }

void VirtualPlate::render(int camera, int placement, const MutableImageView& image) const {
  const PlateScene& scene = impl_->scenes[static_cast<std::size_t>(placement)];
  const CameraShot shot = impl_->shot(camera, placement);
  const auto spurious = drawSpurious(impl_->settings.seed, camera, placement, impl_->settings.spurious, scene,
                                     cameraCentre(shot.cameraFromWorld));
  impl_->renderer->render(scene, spurious, shot, image);
}

std::vector<Point2> VirtualPlate::visibleArc(int camera, int placement, int pin) const {
  const PlateScene& scene = impl_->scenes[static_cast<std::size_t>(placement)];
  std::vector<Point2> points;
  for (std::size_t i = 0; i < scene.pins.size(); ++i)
    if (scene.pins[i].number() == pin)
      for (const auto& line : impl_->renderer->visibleLines(scene, i, impl_->shot(camera, placement)))
        points.insert(points.end(), line.begin(), line.end());
  return points;
}

}  // namespace vignole
