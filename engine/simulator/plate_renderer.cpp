#include "engine/simulator/plate_renderer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/simulator/hashing.h"

namespace vignole::simulator {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kSagittaMm = 5e-5;    // chords of a pin leave its cut by no more
constexpr double kScanRad = 0.02;      // shadows that are narrower may be overlooked: 0.1 mm on a pin of 5 mm
constexpr float kReflectance = 0.85F;  // ground matt

double chordRad(double radiusMm) { return std::sqrt(8 * kSagittaMm / radiusMm); }

/// What a place sees of one pin: the part that faces it and that no other pin hides.
class Outlook {
 public:
  Outlook(const Point3& eye, const std::vector<PinBody>& pins, std::size_t pin) : eye_(eye), pin_(&pins[pin]) {
    const Point2 from = pin_->centre(), way = eye.head<2>() - from;
    const double distance = way.norm();
    for (std::size_t i = 0; i < pins.size(); ++i) {
      if (i == pin) continue;
      // Near the way from the pin to the eye, looked at along z.
      const Point2 to = pins[i].centre() - from;
      const double reach = pins[i].reachMm() + pin_->reachMm();
      const double along = std::clamp(to.dot(way) / distance, 0.0, distance);
      if ((to - along / distance * way).norm() < reach) near_.push_back(&pins[i]);
    }
  }
  [[nodiscard]] bool sees(const Point3& onSkin, const Point3& normal) const {
    if (!(normal.dot(eye_ - onSkin) > 0)) return false;
    return std::none_of(near_.begin(), near_.end(), [&](const PinBody* other) { return other->hides(onSkin, eye_); });
  }

 private:
  Point3 eye_;
  const PinBody* pin_;
  std::vector<const PinBody*> near_;
};

bool withinFan(const Laser& laser, const Point2& place) {
  const Point2 to = place - laser.positionMm;
  const double ahead = to.dot(laser.direction);
  const double aside = laser.direction.x() * to.y() - laser.direction.y() * to.x();
  return ahead > 0 && std::abs(aside) <= std::tan(laser.halfFanRad) * ahead;
}

/// What a camera and the lasers have of one pin, by the angle around it: bits of the lasers that reach it, 0 where the
/// camera sees nothing.
class PinState {
 public:
  PinState(const RigGeometry& rig, const CameraView& view, const std::vector<PinBody>& pins, std::size_t pin)
      : rig_(rig), pin_(pins[pin]), camera_(view.centre, pins, pin) {
    for (std::size_t k = 0; k < kCameraCount; ++k)
      if (view.passes[k] > 0)
        lasers_.emplace_back(k,
                             Outlook(Point3(rig.lasers[k].positionMm.x(), rig.lasers[k].positionMm.y(), 0), pins, pin));
  }
  [[nodiscard]] unsigned operator()(double angleRad) const {
    const Point2 at = pin_.cut(angleRad);
    const Point3 onSkin(at.x(), at.y(), 0), normal = pin_.normal(angleRad);
    if (!camera_.sees(onSkin, normal)) return 0;
    unsigned lit = 0;
    for (const auto& [k, outlook] : lasers_)
      if (withinFan(rig_.lasers[k], at) && outlook.sees(onSkin, normal)) lit |= 1U << k;
    return lit;
  }

 private:
  const RigGeometry& rig_;
  const PinBody& pin_;
  Outlook camera_;
  std::vector<std::pair<std::size_t, Outlook>> lasers_;
};

LitBy litBy(unsigned bits) {
  LitBy lit{};
  for (std::size_t k = 0; k < kCameraCount; ++k) lit[k] = (bits >> k & 1U) != 0;
  return lit;
}

/// Chords of an arc, short enough to be taken for it.
template <typename At, typename Visit>
void forEachChord(double from, double to, double radiusMm, const At& at, const Visit& visit) {
  const int count = std::max(1, static_cast<int>(std::ceil((to - from) / chordRad(radiusMm))));
  Point2 a = at(from);
  for (int i = 1; i <= count; ++i) {
    const Point2 b = at(from + (to - from) * i / count);
    visit(a, b);
    a = b;
  }
}

}  // namespace

struct PlateRenderer::Scratch {
  Scratch(int width, int height) : canvas(width, height) {}
  Canvas canvas;
  LightSamples samples;
};

PlateRenderer::PlateRenderer(std::uint64_t seed, const RigGeometry& rig, const Effects& effects, double exposure)
    : seed_(seed),
      rig_(rig),
      effects_(effects),
      exposure_(exposure),
      sensor_(seed, effects, rig.calibration.rangeFinders[0].intrinsics.widthPx,
              rig.calibration.rangeFinders[0].intrinsics.heightPx),
      scratches_(std::make_unique<ScratchPool<Scratch>>()) {}

PlateRenderer::~PlateRenderer() = default;
PlateRenderer::PlateRenderer(PlateRenderer&&) noexcept = default;

std::vector<PinArc> PlateRenderer::arcs(const PlateScene& scene, std::size_t pin, const CameraView& view) const {
  const PinState state(rig_, view, scene.pins, pin);
  // From the side that the camera cannot see once around, so that what it sees is one piece.
  const Point2 away = scene.pins[pin].centre() - view.centre.head<2>();
  const double start = std::atan2(away.y(), away.x());
  const int steps = static_cast<int>(std::ceil(kTurn / kScanRad));
  std::vector<PinArc> found;
  double since = start;
  unsigned now = state(start);
  const auto close = [&](double end) {
    if (now != 0) found.push_back({since, end, litBy(now)});
  };
  for (int i = 1; i <= steps; ++i) {
    const double next = start + kTurn * i / steps;
    const unsigned there = state(next);
    // A pin's own edge and a shadow's may both lie within one step: each border is sought in turn.
    for (int borders = 0; there != now && borders < 4; ++borders) {
      double low = std::max(since, start + kTurn * (i - 1) / steps), high = next;
      while (high - low > 1e-10) {
        const double middle = (low + high) / 2;
        (state(middle) == now ? low : high) = middle;
      }
      close(low);
      since = high;
      now = state(high);
    }
  }
  close(start + kTurn);
  return found;
}

void PlateRenderer::render(const PlateScene& scene, const std::vector<SpuriousArc>& spurious, const CameraShot& shot,
                           const MutableImageView& image) const {
  const Exposure exposure{hash(seed_, Stream::Background, {static_cast<std::uint64_t>(shot.camera), scene.key}),
                          shot.black, shot.gain};
  sensor_.fillGround(exposure, image);
  if (shot.black) return;
  typename ScratchPool<Scratch>::Lease lease(*scratches_, sensor_.widthPx(), sensor_.heightPx());
  Scratch& s = *lease;
  s.samples.clear();
  const CameraView view(rig_, shot.camera, shot.cameraFromWorld, effects_.crosstalk, effects_.defocus);
  const ExposedPose still;
  LinePainter painter(rig_, view, still, exposure_, s.samples);
  for (std::size_t i = 0; i < scene.pins.size(); ++i) {
    const PinBody& pin = scene.pins[i];
    for (const PinArc& arc : arcs(scene, i, view)) {
      painter.startStretch(arc.lit);
      forEachChord(
          arc.from, arc.to, pin.radiusMm(), [&](double angle) { return pin.cut(angle); },
          [&](const Point2& a, const Point2& b) {
            const double light = painter.step(a, b, outwardNormal(a, b));
            if (light > 0) painter.paint(light, kReflectance, kReflectance);
          });
    }
  }
  for (const SpuriousArc& arc : spurious) {
    painter.startStretch({});
    forEachChord(
        arc.fromRad, arc.toRad, arc.radiusMm,
        [&](double angle) { return Point2(arc.centre + arc.radiusMm * Point2(std::cos(angle), std::sin(angle))); },
        [&](const Point2& a, const Point2& b) {
          painter.step(a, b, outwardNormal(a, b));
          painter.paint(painter.frontalLight((b - a).norm()), kReflectance, kReflectance);
        });
  }
  s.canvas.add(s.samples.splats, s.samples.kernels);
  sensor_.expose(exposure, s.canvas, image);
}

std::vector<std::vector<Point2>> PlateRenderer::visibleLines(const PlateScene& scene, std::size_t pin,
                                                             const CameraShot& shot) const {
  std::vector<std::vector<Point2>> lines;
  if (shot.black) return lines;
  // A laser of the other wavelength alone draws no line.
  const CameraView view(rig_, shot.camera, shot.cameraFromWorld, 0, effects_.defocus);
  const PinBody& body = scene.pins[pin];
  const auto draws = [&](const PinArc& arc, double angle) {
    const Point2 at = body.cut(angle);
    const Point3 onSkin(at.x(), at.y(), 0), normal = body.normal(angle);
    const auto meets = [&](const Point3& eye) { return normal.dot((eye - onSkin).normalized()) >= kGrazingCosine; };
    if (!meets(view.centre)) return false;
    for (std::size_t k = 0; k < kCameraCount; ++k)
      if (arc.lit[k] && meets(Point3(rig_.lasers[k].positionMm.x(), rig_.lasers[k].positionMm.y(), 0))) return true;
    return false;
  };
  double end = -1e9;
  for (const PinArc& arc : arcs(scene, pin, view)) {
    const Point2 first = view.pixel(body.cut(arc.from)), last = view.pixel(body.cut(arc.to));
    const Point2 middle = view.pixel(body.cut((arc.from + arc.to) / 2));
    const double lengthPx = 1.1 * ((middle - first).norm() + (last - middle).norm());
    const int count = std::max(1, static_cast<int>(std::ceil(lengthPx)));
    bool open = arc.from - end < 1e-8 && !lines.empty();
    end = arc.to;
    for (int i = open ? 1 : 0; i <= count; ++i) {
      const double angle = arc.from + (arc.to - arc.from) * i / count;
      const Point2 px = view.pixel(body.cut(angle));
      const bool inside =
          px.x() >= 0 && px.y() >= 0 && px.x() <= sensor_.widthPx() - 1 && px.y() <= sensor_.heightPx() - 1;
      if (!inside || !draws(arc, angle)) {
        open = false;
        continue;
      }
      if (!open) lines.emplace_back();
      open = true;
      lines.back().push_back(px);
    }
  }
  std::erase_if(lines, [](const auto& line) { return line.size() < 2; });
  return lines;
}

}  // namespace vignole::simulator
