#include "engine/simulator/frame_renderer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/simulator/hashing.h"
#include "engine/simulator/visibility.h"

namespace vignole::simulator {

/// A stretch of the outline that the camera sees and the same lasers light.
struct FrameRenderer::Strip {
  double from, to;
  LitBy lit;
};

struct FrameRenderer::Scratch {
  Scratch(int width, int height) : canvas(width, height) {}
  Canvas canvas;
  VisibilityScratch visibility;
  std::vector<Interval> seen;
  std::array<std::vector<Interval>, kCameraCount> lit;
  std::vector<double> cuts;
  std::vector<Strip> strips;
  LightSamples samples;
};

FrameRenderer::FrameRenderer(std::uint64_t seed, const RigGeometry& rig, const Effects& effects, double exposure)
    : seed_(seed),
      rig_(rig),
      effects_(effects),
      exposure_(exposure),
      surface_(seed),
      sensor_(seed, effects, rig.calibration.rangeFinders[0].intrinsics.widthPx,
              rig.calibration.rangeFinders[0].intrinsics.heightPx),
      scratches_(std::make_unique<ScratchPool<Scratch>>()) {}

FrameRenderer::~FrameRenderer() = default;
FrameRenderer::FrameRenderer(FrameRenderer&&) noexcept = default;

void FrameRenderer::findStrips(const Scene& scene, const CameraView& view, Scratch& s) const {
  // The camera looks across; what hides the rail from it is decided in the plane.
  const Point2 eye = view.centre.head<2>();
  Point2 middle(0, 0);
  for (const Point2& p : scene.world) middle += p;
  middle /= static_cast<double>(scene.world.size());
  visibleParts(scene.world, {eye, (middle - eye).normalized(), 1e9}, s.visibility, s.seen);
  for (std::size_t i = 0; i < kCameraCount; ++i) {
    s.lit[i].clear();
    if (view.passes[i] <= 0) continue;
    const Laser& laser = rig_.lasers[i];
    visibleParts(scene.world, {laser.positionMm, laser.direction, std::tan(laser.halfFanRad)}, s.visibility, s.lit[i]);
  }
  s.strips.clear();
  for (const Interval& seen : s.seen) {
    s.cuts.assign({seen.from, seen.to});
    for (const auto& lit : s.lit)
      for (const Interval& interval : lit)
        for (const double cut : {interval.from, interval.to})
          if (cut > seen.from && cut < seen.to) s.cuts.push_back(cut);
    std::sort(s.cuts.begin(), s.cuts.end());
    for (std::size_t i = 0; i + 1 < s.cuts.size(); ++i) {
      Strip strip{s.cuts[i], s.cuts[i + 1], {}};
      const double inside = (strip.from + strip.to) / 2;
      if (strip.to - strip.from < 1e-9) continue;
      bool any = false;
      for (std::size_t k = 0; k < kCameraCount; ++k) {
        strip.lit[k] = std::any_of(s.lit[k].begin(), s.lit[k].end(),
                                   [&](const Interval& l) { return inside > l.from && inside < l.to; });
        any = any || strip.lit[k];
      }
      if (any) s.strips.push_back(strip);
    }
  }
}

void FrameRenderer::lightStrip(const Scene& scene, const Shot& shot, const Strip& strip, LinePainter& painter) const {
  const std::size_t n = scene.world.size();
  const double phase = 2 * std::numbers::pi * scene.alongRailMm / 900;
  const auto first = static_cast<std::size_t>(strip.from);
  const auto last = std::min(static_cast<std::size_t>(std::ceil(strip.to)), n);
  painter.startStretch(strip.lit);
  for (std::size_t e = first; e < last; ++e) {
    const OutlineVertex& v0 = scene.vertices[e];
    const OutlineVertex& v1 = scene.vertices[(e + 1) % n];
    const Point2 &a = scene.world[e], &b = scene.world[(e + 1) % n];
    const double t0 = std::max(0.0, strip.from - static_cast<double>(e));
    const double t1 = std::min(1.0, strip.to - static_cast<double>(e));
    const Point2 p0 = a + t0 * (b - a), p1 = a + t1 * (b - a);
    const double lengthMm = (p1 - p0).norm();
    if (!(lengthMm > 0)) continue;
    const double light = painter.step(p0, p1, outwardNormal(a, b));
    if (light <= 0) continue;

    const double closing = scene.vertices.back().alongMm + lengthMm;  // the last edge runs into the first vertex
    const double along1 = v1.alongMm > v0.alongMm ? v1.alongMm : closing;
    const auto around = [&](double t) { return v0.alongMm + t * (along1 - v0.alongMm); };
    const double r0 = surface_.reflectance(around(t0), scene.alongRailMm, shot.scaleShare);
    const double r1 = surface_.reflectance(around(t1), scene.alongRailMm, shot.scaleShare);
    painter.paint(light, r0, r1);

    const float ghost = scene.ghosts != nullptr ? (*scene.ghosts)[e] : 0.0F;
    if (ghost > 0.02F && effects_.reflections > 0) {
      // Light that came by way of the opposite face meets this one some millimetres before or behind the sheet.
      const double offPlane = (painter.middle().y() - scene.pose.worldFromSection.yMm > 76 ? -1 : 1) *
                              (4.5 + 1.5 * std::sin(phase + 0.02 * v0.alongMm));
      painter.paintGhost(light * ghost * effects_.reflections, r0, r1, offPlane);
    }
  }
}

void FrameRenderer::render(const Scene& scene, const Shot& shot, const MutableImageView& image) const {
  const CameraShot& camera = shot.camera;
  const Exposure exposure{hash(seed_, Stream::Background, {static_cast<std::uint64_t>(camera.camera), scene.trigger}),
                          camera.black, camera.gain};
  sensor_.fillGround(exposure, image);
  if (camera.black) return;
  ScratchPool<Scratch>::Lease lease(*scratches_, sensor_.widthPx(), sensor_.heightPx());
  Scratch& s = *lease;
  const CameraView view(rig_, camera.camera, camera.cameraFromWorld, effects_.crosstalk, effects_.defocus);
  findStrips(scene, view, s);
  s.samples.clear();
  LinePainter painter(rig_, view, scene.pose, exposure_, s.samples);
  for (const Strip& strip : s.strips) lightStrip(scene, shot, strip, painter);
  s.canvas.add(s.samples.splats, s.samples.kernels);
  sensor_.expose(exposure, s.canvas, image);
}

std::vector<std::vector<Point2>> FrameRenderer::visibleLines(const Scene& scene, const Shot& shot) const {
  std::vector<std::vector<Point2>> lines;
  if (shot.camera.black) return lines;
  ScratchPool<Scratch>::Lease lease(*scratches_, sensor_.widthPx(), sensor_.heightPx());
  Scratch& s = *lease;
  // A laser of the other wavelength alone draws no line.
  const CameraView view(rig_, shot.camera.camera, shot.camera.cameraFromWorld, 0, effects_.defocus);
  findStrips(scene, view, s);
  const std::size_t n = scene.world.size();
  const auto inside = [&](const Point2& p) {
    return p.x() >= 0 && p.y() >= 0 && p.x() <= sensor_.widthPx() - 1 && p.y() <= sensor_.heightPx() - 1;
  };
  // An edge draws a line where it is met by the camera and by a laser less than 80 degrees from its normal.
  const auto draws = [&](const Strip& strip, std::size_t e) {
    const Point2 &a = scene.world[e], &b = scene.world[(e + 1) % n];
    const Point2 normal = Point2(b.y() - a.y(), a.x() - b.x()).normalized();
    const Point3 toCamera = (view.centre - Point3(a.x(), a.y(), 0)).normalized();
    if (normal.dot(toCamera.head<2>()) < kGrazingCosine) return false;
    for (std::size_t k = 0; k < kCameraCount; ++k)
      if (strip.lit[k] && normal.dot((rig_.lasers[k].positionMm - a).normalized()) >= kGrazingCosine) return true;
    return false;
  };
  double end = -1;
  for (const Strip& strip : s.strips)
    for (auto e = static_cast<std::size_t>(strip.from); static_cast<double>(e) < strip.to; ++e) {
      if (!draws(strip, e)) continue;
      const double from = std::max(strip.from, static_cast<double>(e));
      const double to = std::min(strip.to, static_cast<double>(e + 1));
      const auto at = [&](double stop) {
        const double t = stop - static_cast<double>(e);
        return view.pixel(scene.world[e] + t * (scene.world[(e + 1) % n] - scene.world[e]));
      };
      const Point2 p0 = at(from), p1 = at(to);
      const bool first = lines.empty() || from != end;
      if (first) lines.emplace_back();
      end = to;
      const int count = std::max(1, static_cast<int>(std::ceil((p1 - p0).norm())));
      for (int i = first ? 0 : 1; i <= count; ++i) {
        const Point2 p = p0 + (p1 - p0) * i / count;
        if (inside(p))
          lines.back().push_back(p);
        else if (!lines.back().empty())
          lines.emplace_back();
      }
    }
  // A line that runs through the outline's first vertex is one line.
  if (lines.size() > 1 && !lines.front().empty() && !lines.back().empty() &&
      (lines.front().front() - lines.back().back()).norm() < 1e-9) {
    lines.back().insert(lines.back().end(), lines.front().begin() + 1, lines.front().end());
    lines.front().clear();
  }
  std::erase_if(lines, [](const auto& line) { return line.size() < 2; });
  return lines;
}

}  // namespace vignole::simulator
