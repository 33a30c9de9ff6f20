#include "engine/simulator/virtual_rig.h"

#include <algorithm>
#include <cmath>

#include "engine/rail/catalogue.h"
#include "engine/simulator/camera_faults.h"
#include "engine/simulator/displaced_outline.h"
#include "engine/simulator/frame_renderer.h"
#include "engine/simulator/rail_motion.h"
#include "engine/simulator/rail_truth.h"
#include "engine/simulator/rig_geometry.h"
#include "engine/simulator/shape_law.h"

namespace vignole {

using namespace simulator;  // the room's own parts

namespace {

constexpr double kExpansionPerK = 11.5e-6;
constexpr double kReferenceC = 15;
// Chords of the rendered outline stay this close to it; coarser where the truth is drawn only.
constexpr double kRenderSagittaMm = 5e-4, kRenderStepMm = 2;
constexpr double kTruthSagittaMm = 5e-5, kTruthStepMm = 1.5;

/// One section that may pass: as it is made and as it is judged.
struct RailModel {
  OutlineShaper shaper;
  TruthGauge gauge;
  std::vector<float> ghosts;

  static Expected<RailModel> create(const Section& section, const DimensionParameters& parameters);
};

/// Strength of secondary reflections per vertex: highest in the corners between web and foot or head.
std::vector<float> ghostStrength(const OutlineShaper& shaper, const std::vector<OutlineVertex>& vertices) {
  constexpr double kCornerRadiusMm = 30, kReachMm = 9;
  const auto& primitives = shaper.section().primitives;
  std::vector<double> corners;  // middle of each tight concave arc, by arc length
  double along = 0;
  for (const NamedPrimitive& p : primitives) {
    const double l = length(p.shape);
    if (curvature(p.shape) < -1 / kCornerRadiusMm && p.name.starts_with("AW")) corners.push_back(along + l / 2);
    along += l;
  }
  std::vector<float> strength;
  for (const OutlineVertex& v : vertices) {
    double s = 0;
    for (const double corner : corners) {
      const double d = (v.alongMm - corner) / kReachMm;
      s = std::max(s, std::exp(-d * d / 2));
    }
    strength.push_back(static_cast<float>(s));
  }
  return strength;
}

Expected<RailModel> RailModel::create(const Section& section, const DimensionParameters& parameters) {
  auto shaper = OutlineShaper::create(section, parameters);
  if (!shaper) return tl::unexpected<Error>(shaper.error());
  RailModel model{*std::move(shaper), TruthGauge(section, parameters), {}};
  const auto nominal = model.shaper.displaced({});
  if (!nominal) return tl::unexpected<Error>(nominal.error());
  std::vector<OutlineVertex> vertices;
  model.shaper.sample(*nominal, kTruthSagittaMm, kTruthStepMm, vertices);
  const TrueDimensions truth = model.gauge.measure(vertices);
  for (const Dimension d : kDimensions)
    if (!std::isfinite(truth.mm[index(d)]))
      return inputError("section " + section.name,
                        std::string(name(d)) + " falls off its primitive; change its parameter in the recipe");
  model.shaper.sample(*nominal, kRenderSagittaMm, kRenderStepMm, vertices);
  model.ghosts = ghostStrength(model.shaper, vertices);
  return model;
}

}  // namespace

struct VirtualRig::Impl {
  VirtualRigSettings settings;
  RigGeometry geometry;
  std::vector<RailModel> models;          ///< the section, then those of wrong-rail faults
  std::vector<std::size_t> modelOfFault;  ///< per fault; 0 for the others
  ShapeLaw law;
  RailMotion motion;
  FrameRenderer renderer;

  [[nodiscard]] double position(std::uint64_t trigger) const {
    return static_cast<double>(trigger) * settings.spacingMm;
  }
  [[nodiscard]] ExposedPose pose(std::uint64_t trigger) const {
    return motion.exposed(position(trigger) / settings.speedMmPerS);
  }
  [[nodiscard]] const Fault* fault(std::string_view kind, int camera, std::uint64_t trigger) const {
    return activeFault(settings.faults, kind, camera, trigger);
  }
  [[nodiscard]] const RailModel& model(std::uint64_t trigger) const {
    const Fault* wrong = fault("wrong-rail", -1, trigger);
    return wrong == nullptr ? models.front()
                            : models[modelOfFault[static_cast<std::size_t>(wrong - settings.faults.data())]];
  }
  [[nodiscard]] std::vector<OutlinePiece> pieces(const RailModel& model, std::uint64_t trigger) const {
    if (auto displaced = model.shaper.displaced(law.at(position(trigger)))) return *std::move(displaced);
    // create() has tried the law's extremes; a section of a fault may still not follow: then it passes as it is.
    return model.shaper.displaced({}).value_or(std::vector<OutlinePiece>{});
  }
  [[nodiscard]] std::vector<Point2> toWorld(const std::vector<OutlineVertex>& vertices, const Transform2& pose) const {
    const double size = 1 + kExpansionPerK * (settings.temperatureC - kReferenceC);
    const double c = size * std::cos(pose.angleRad), s = size * std::sin(pose.angleRad);
    std::vector<Point2> world;
    world.reserve(vertices.size());
    for (const OutlineVertex& v : vertices)
      world.emplace_back(c * v.point.x() - s * v.point.y() + pose.xMm, s * v.point.x() + c * v.point.y() + pose.yMm);
    return world;
  }
  [[nodiscard]] Scene scene(std::uint64_t trigger) const {
    const RailModel& rail = model(trigger);
    Scene scene;
    scene.trigger = trigger;
    scene.alongRailMm = position(trigger);
    scene.pose = pose(trigger);
    rail.shaper.sample(pieces(rail, trigger), kRenderSagittaMm, kRenderStepMm, scene.vertices);
    scene.world = toWorld(scene.vertices, scene.pose.worldFromSection);
    scene.ghosts = &rail.ghosts;
    return scene;
  }
  [[nodiscard]] Shot shot(int camera, std::uint64_t trigger) const;
};

Shot VirtualRig::Impl::shot(int camera, std::uint64_t trigger) const {
  Shot shot{shotUnder(settings.faults, geometry.calibration, camera, trigger), settings.effects.scale};
  if (const Fault* scale = fault("scale", camera, trigger)) shot.scaleShare = std::max(shot.scaleShare, scale->value);
  return shot;
}

Expected<std::shared_ptr<const VirtualRig>> VirtualRig::create(VirtualRigSettings settings) {
  if (!(settings.spacingMm > 0 && settings.spacingMm <= 1e4))
    return inputError("spacing", "must lie between 0 and 10,000 mm");
  if (!(settings.speedMmPerS > 0 && settings.speedMmPerS <= 1e5))
    return inputError("speed", "must lie between 0 and 100 m/s");
  if (!(settings.exposureMs >= 0.01 && settings.exposureMs <= 1e4))
    return inputError("exposure", "must lie between 0.01 and 10,000 ms");
  if (!(settings.temperatureC >= -50 && settings.temperatureC <= 1200))
    return inputError("temperature", "must lie between -50 and 1200 degrees C");
  auto model = RailModel::create(settings.section, settings.parameters);
  if (!model) return tl::unexpected<Error>(model.error());
  std::vector<RailModel> models;
  models.push_back(*std::move(model));
  std::vector<std::size_t> modelOfFault(settings.faults.size(), 0);
  for (std::size_t i = 0; i < settings.faults.size(); ++i) {
    if (settings.faults[i].kind != "wrong-rail") continue;
    const auto section = findSection(settings.faults[i].text);
    if (!section) return tl::unexpected<Error>(section.error());
    auto other = RailModel::create(*section, section->parameters);
    if (!other) return tl::unexpected<Error>(other.error());
    modelOfFault[i] = models.size();
    models.push_back(*std::move(other));
  }
  auto law =
      ShapeLaw::create(settings.seed, settings.varyDimensions, models.front().shaper.latitude(), settings.deviationMm);
  if (!law) return tl::unexpected<Error>(law.error());
  const auto& hf = settings.deviationMm[index(Dimension::HF)];
  if (hf && *hf != 0 && !models.front().shaper.canSteerCrown())
    return inputError("deviation HF",
                      "can be made only on a crown with one shoulder arc a side, not on this one (section " +
                          settings.section.name + "); leave it out");
  // Whatever the rail will look like must be an outline: tried here, where it can still be refused.
  const int trials = settings.varyDimensions ? 80 : 1;
  for (int i = 0; i < trials; ++i)
    if (auto displaced = models.front().shaper.displaced(law->at(500.0 * i)); !displaced)
      return tl::unexpected<Error>(displaced.error());

  const Effects effects = exposedFor(settings.effects, settings.exposureMs);
  const RigGeometry geometry = drawRig(settings.rigSeed.value_or(settings.seed));
  const MotionSettings motion{
      effects.wander, effects.vibration,
      effects.motion * std::min(settings.exposureMs / 1000, settings.spacingMm / settings.speedMmPerS)};
  const std::uint64_t seed = settings.passSeed.value_or(settings.seed);
  const double exposure = settings.exposureMs / kUsualExposureMs;
  std::unique_ptr<Impl> impl(new Impl{std::move(settings), geometry, std::move(models), std::move(modelOfFault),
                                      *std::move(law), RailMotion(seed, motion),
                                      FrameRenderer(seed, geometry, effects, exposure)});
  return std::shared_ptr<const VirtualRig>(new VirtualRig(std::move(impl)));
}

VirtualRig::VirtualRig(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VirtualRig::~VirtualRig() = default;

const VirtualRigSettings& VirtualRig::settings() const { return impl_->settings; }
const RigCalibration& VirtualRig::calibration() const { return impl_->geometry.calibration; }

void VirtualRig::render(int camera, std::uint64_t trigger, const MutableImageView& image) const {
  impl_->renderer.render(impl_->scene(trigger), impl_->shot(camera, trigger), image);
}

Truth VirtualRig::truth(std::uint64_t trigger) const {
  const RailModel& rail = impl_->model(trigger);
  std::vector<OutlineVertex> vertices;
  rail.shaper.sample(impl_->pieces(rail, trigger), kTruthSagittaMm, kTruthStepMm, vertices);
  const TrueDimensions dimensions = rail.gauge.measure(vertices);
  Truth truth;
  truth.valueMm = dimensions.mm;
  truth.hfMinMm = dimensions.hfMinMm;
  truth.worldFromSection = impl_->pose(trigger).worldFromSection;
  return truth;
}

std::vector<Point2> VirtualRig::outline(std::uint64_t trigger) const {
  const RailModel& rail = impl_->model(trigger);
  std::vector<OutlineVertex> vertices;
  rail.shaper.sample(impl_->pieces(rail, trigger), kRenderSagittaMm, 0.2, vertices);
  return impl_->toWorld(vertices, impl_->pose(trigger).worldFromSection);
}

std::vector<std::vector<Point2>> VirtualRig::visibleLines(int camera, std::uint64_t trigger) const {
  return impl_->renderer.visibleLines(impl_->scene(trigger), impl_->shot(camera, trigger));
}

}  // namespace vignole
