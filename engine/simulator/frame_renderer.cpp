#include "engine/simulator/frame_renderer.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "engine/optics/camera_model.h"
#include "engine/optics/nominal_rig.h"
#include "engine/simulator/hashing.h"

namespace vignole::simulator {

namespace {

constexpr double kFNumber = 8;                         // the lens' opening
constexpr double kPixelSigmaPx = 0.28867513459481287;  // of a square pixel: 1/sqrt(12)
constexpr double kPower = 4200;                        // DN px/mm, so that a bare face seen frontally peaks near 200 DN
constexpr double kLaserReferenceMm = 480;
constexpr double kStepPx = 0.7;  // between samples of light; a ripple below 0.1 % at the sharpest
constexpr int kMostReachPx = kMargin - 8;
constexpr double kKernelReachMm = 2.5;  // a kernel serves this far along the outline
constexpr double kGhostSheetMm = 0.8, kGhostStepPx = 1.6;
constexpr double kGhostSpread = 2;  // a ghost is so much broader, so its energy for the same peak is higher

constexpr std::uint32_t kNormals = 1U << 18;
constexpr std::uint32_t kBackgroundPixels = kNormals;
constexpr double kGrazingCosine = 0.17364817766693033;  // 80 degrees from the normal: too little light for a line

constexpr double kernelReach(double sigma) { return 4 * sigma; }

}  // namespace

/// A stretch of the outline that the camera sees and the same lasers light.
struct FrameRenderer::Strip {
  double from, to;
  std::array<bool, kCameraCount> lit;
};

struct FrameRenderer::Scratch {
  Scratch(int width, int height) : canvas(width, height) {}
  Canvas canvas;
  VisibilityScratch visibility;
  std::vector<Interval> seen;
  std::array<std::vector<Interval>, kCameraCount> lit;
  std::vector<double> cuts;
  std::vector<Strip> strips;
  std::vector<Splat> splats;
  std::vector<SplatKernel> kernels;
};

/// A scratch from the pool, given back at the end of the scope.
class FrameRenderer::Lease {
 public:
  explicit Lease(const FrameRenderer& renderer) : renderer_(renderer) {
    const std::lock_guard lock(renderer.mutex_);
    if (!renderer.idle_.empty()) {
      scratch_ = std::move(renderer.idle_.back());
      renderer.idle_.pop_back();
    } else {
      const Intrinsics& in = renderer.rig_.calibration.rangeFinders[0].intrinsics;
      scratch_ = std::make_unique<Scratch>(in.widthPx, in.heightPx);
    }
  }
  ~Lease() {
    const std::lock_guard lock(renderer_.mutex_);
    renderer_.idle_.push_back(std::move(scratch_));
  }
  Lease(const Lease&) = delete;
  Lease& operator=(const Lease&) = delete;
  Scratch& operator*() { return *scratch_; }

 private:
  const FrameRenderer& renderer_;
  std::unique_ptr<Scratch> scratch_;
};

/// A camera as the renderer needs it.
struct FrameRenderer::View {
  View(const RigGeometry& rig, const Shot& shot, double crosstalk)
      : camera(shot.camera),
        lens(vignole::lens(rig.calibration.rangeFinders[static_cast<std::size_t>(shot.camera)].intrinsics)),
        rotation(shot.cameraFromWorld.rotation),
        translation(shot.cameraFromWorld.translationMm),
        centre(cameraCentre(shot.cameraFromWorld)) {
    const double own = rig.lasers[static_cast<std::size_t>(camera)].wavelengthNm;
    for (std::size_t i = 0; i < kCameraCount; ++i) passes[i] = rig.lasers[i].wavelengthNm == own ? 1 : crosstalk;
  }
  [[nodiscard]] Eigen::Vector2d pixel(const Point2& world, double z = 0) const {
    return project<double>(lens, rotation, translation, {world.x(), world.y(), z});
  }
  int camera;
  Lens<double> lens;
  Eigen::Matrix3d rotation;
  Point3 translation;
  Point3 centre;
  std::array<double, kCameraCount> passes{};  ///< share of each laser's light that the filter lets through
};

FrameRenderer::FrameRenderer(std::uint64_t seed, const RigGeometry& rig, const Effects& effects)
    : seed_(seed),
      rig_(rig),
      effects_(effects),
      surface_(seed),
      speckle_(speckleField(seed, effects.speckle)),
      normals_(kNormals),
      background_(kBackgroundPixels + static_cast<std::size_t>(rig.calibration.rangeFinders[0].intrinsics.widthPx)) {
  Draws draws(seed, Stream::NoiseBank);
  for (float& n : normals_) n = static_cast<float>(draws.normal());
  const double sd =
      std::sqrt(effects.readNoiseDn * effects.readNoiseDn + effects.shotNoise * kShotPerDn * effects.ambientDn);
  for (std::size_t i = 0; i < background_.size(); ++i)
    background_[i] = static_cast<std::uint8_t>(
        std::clamp(std::nearbyint(effects.ambientDn + sd * normals_[i % kNormals]), 0.0, 255.0));
}

FrameRenderer::~FrameRenderer() = default;

void FrameRenderer::fillBackground(std::uint64_t key, const Shot& shot, const MutableImageView& image) const {
  const auto width = static_cast<std::size_t>(image.width);
  const auto ambient = static_cast<int>(std::nearbyint(effects_.ambientDn));
  for (int y = 0; y < image.height; ++y) {
    const std::uint64_t offset =
        hash(key, Stream::Background, {static_cast<std::uint64_t>(y)}) % (kBackgroundPixels - 1);
    const std::uint8_t* from = background_.data() + offset;
    std::uint8_t* to = image.row(y);
    std::memcpy(to, from, width);
    if (shot.black)
      for (std::size_t x = 0; x < width; ++x) to[x] = static_cast<std::uint8_t>(std::max(0, to[x] - ambient));
    else if (shot.gain != 1)
      for (std::size_t x = 0; x < width; ++x)
        to[x] = static_cast<std::uint8_t>(
            std::min(255.0F, shot.gain * static_cast<float>(ambient) + static_cast<float>(to[x] - ambient)));
  }
}

void FrameRenderer::findStrips(const Scene& scene, const View& view, Scratch& s) const {
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

SplatKernel FrameRenderer::kernelAt(const View& view, const ExposedPose& pose, const Point2& world, double sheetSigmaMm,
                                    double offPlaneMm) const {
  const Point3 inCamera = view.rotation * Point3(world.x(), world.y(), offPlaneMm) + view.translation;
  const double z = inCamera.z();
  const double fx = view.lens.focalMm / view.lens.pixelWidthMm / z,
               fy = view.lens.focalMm / view.lens.pixelHeightMm / z;
  Eigen::Matrix<double, 2, 3> j;  // d pixel / d world; the lens' distortion changes it by less than 2 %
  j.row(0) = fx * (view.rotation.row(0) - inCamera.x() / z * view.rotation.row(2));
  j.row(1) = fy * (view.rotation.row(1) - inCamera.y() / z * view.rotation.row(2));

  // Lens: disk of confusion of a thin lens that is focused at the aim (variance d^2/16), diffraction, pixel.
  const double focus = rig_.focusMm[static_cast<std::size_t>(view.camera)];
  const double aperture = view.lens.focalMm / kFNumber;
  const double disk = effects_.defocus * aperture * view.lens.focalMm / (focus - view.lens.focalMm) *
                      std::abs(z - focus) / z / view.lens.pixelWidthMm;
  const double wavelengthMm = rig_.lasers[static_cast<std::size_t>(view.camera)].wavelengthNm * 1e-6;
  const double diffraction = 0.45 * wavelengthMm * kFNumber / view.lens.pixelWidthMm;
  const double round = disk * disk / 16 + diffraction * diffraction + kPixelSigmaPx * kPixelSigmaPx;

  // Movement within the exposure: shift, and turn about the section's origin.
  const Point2 arm = world - Point2(pose.worldFromSection.xMm, pose.worldFromSection.yMm);
  Eigen::Matrix<double, 2, 3> moved;
  moved << 1, 0, -arm.y(), 0, 1, arm.x();
  const Eigen::Matrix<double, 2, 3> image = j.leftCols<2>() * moved;
  Eigen::Matrix2d covariance = image * pose.covariance * image.transpose();
  covariance += sheetSigmaMm * sheetSigmaMm * j.col(2) * j.col(2).transpose();
  covariance(0, 0) += round;
  covariance(1, 1) += round;

  const double det = covariance.determinant();
  SplatKernel kernel;
  kernel.a = static_cast<float>(covariance(1, 1) / det);
  kernel.b = static_cast<float>(-covariance(0, 1) / det);
  kernel.c = static_cast<float>(covariance(0, 0) / det);
  kernel.scale = static_cast<float>(1 / (2 * std::numbers::pi * std::sqrt(det)));
  kernel.bend = std::exp(-kernel.c);
  kernel.halfWidth = static_cast<float>(std::min<double>(kMostReachPx, kernelReach(std::sqrt(covariance(0, 0)))));
  kernel.halfHeight = std::min(kMostReachPx, static_cast<int>(std::ceil(kernelReach(std::sqrt(covariance(1, 1))))));
  return kernel;
}

void FrameRenderer::lightStrip(const Scene& scene, const Shot& shot, const View& view, const Strip& strip,
                               Scratch& s) const {
  const std::size_t n = scene.world.size();
  Point2 kernelPlace(1e9, 1e9);
  const double sheetSigmaMm =
      rig_.calibration.rangeFinders[static_cast<std::size_t>(view.camera)].lightPlane.thicknessMm;
  bool ghostKernel = false;
  const double phase = 2 * std::numbers::pi * scene.alongRailMm / 900;
  const auto first = static_cast<std::size_t>(strip.from);
  const auto last = std::min(static_cast<std::size_t>(std::ceil(strip.to)), n);
  Eigen::Vector2d lastPixel(0, 0);
  bool chained = false;  // lastPixel is the start of this edge
  for (std::size_t e = first; e < last; ++e) {
    const OutlineVertex& v0 = scene.vertices[e];
    const OutlineVertex& v1 = scene.vertices[(e + 1) % n];
    const Point2 &a = scene.world[e], &b = scene.world[(e + 1) % n];
    const double t0 = std::max(0.0, strip.from - static_cast<double>(e));
    const double t1 = std::min(1.0, strip.to - static_cast<double>(e));
    const Point2 p0 = a + t0 * (b - a), p1 = a + t1 * (b - a);
    const double lengthMm = (p1 - p0).norm();
    if (!(lengthMm > 0)) continue;
    const Eigen::Vector2d q0 = chained && t0 == 0 ? lastPixel : view.pixel(p0), q1 = view.pixel(p1);
    lastPixel = q1;
    chained = t1 == 1;

    const Point2 normal = Point2(b.y() - a.y(), a.x() - b.x()) / (b - a).norm();
    const Point2 middle = (p0 + p1) / 2;
    double light = 0;
    for (std::size_t k = 0; k < kCameraCount; ++k) {
      if (!strip.lit[k]) continue;
      const Point2 to = rig_.lasers[k].positionMm - middle;
      const double distance = to.norm();
      light += view.passes[k] * std::max(0.0, normal.dot(to)) / (distance * distance) * kLaserReferenceMm;
    }
    const Point3 toCamera = (view.centre - Point3(middle.x(), middle.y(), 0)).normalized();
    light *= kPower * std::max(0.0, normal.dot(toCamera.head<2>())) * lengthMm;
    if (light <= 0) continue;

    const double closing = scene.vertices.back().alongMm + lengthMm;  // the last edge runs into the first vertex
    const double along1 = v1.alongMm > v0.alongMm ? v1.alongMm : closing;
    const auto around = [&](double t) { return v0.alongMm + t * (along1 - v0.alongMm); };
    const double r0 = surface_.reflectance(around(t0), scene.alongRailMm, shot.scaleShare);
    const double r1 = surface_.reflectance(around(t1), scene.alongRailMm, shot.scaleShare);
    const bool newKernel = (middle - kernelPlace).squaredNorm() > kKernelReachMm * kKernelReachMm;
    if (newKernel) {
      s.kernels.push_back(kernelAt(view, scene.pose, middle, sheetSigmaMm, 0));
      kernelPlace = middle;
      ghostKernel = false;
    }
    auto kernel = static_cast<std::uint32_t>(s.kernels.size() - 1);
    if (ghostKernel) --kernel;
    const auto spread = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to, double energy, double step,
                            std::uint32_t which) {
      const int count = std::max(1, static_cast<int>(std::ceil((to - from).norm() / step)));
      for (int i = 0; i < count; ++i) {
        const double t = (i + 0.5) / count;
        const Eigen::Vector2d at = from + t * (to - from);
        s.splats.push_back({static_cast<float>(at.x()), static_cast<float>(at.y()),
                            static_cast<float>(energy * (r0 + t * (r1 - r0)) / count), which});
      }
    };
    spread(q0, q1, light, kStepPx, kernel);

    const float ghost = scene.ghosts != nullptr ? (*scene.ghosts)[e] : 0.0F;
    if (ghost > 0.02F && effects_.reflections > 0) {
      // Light that came by way of the opposite face meets this one some millimetres before or behind the sheet.
      const double offPlane = (middle.y() - scene.pose.worldFromSection.yMm > 76 ? -1 : 1) *
                              (4.5 + 1.5 * std::sin(phase + 0.02 * v0.alongMm));
      if (!ghostKernel) {
        s.kernels.push_back(kernelAt(view, scene.pose, middle, kGhostSheetMm, offPlane));
        ghostKernel = true;
      }
      spread(view.pixel(p0, offPlane), view.pixel(p1, offPlane), light * ghost * effects_.reflections * kGhostSpread,
             kGhostStepPx, static_cast<std::uint32_t>(s.kernels.size() - 1));
    }
  }
}

void FrameRenderer::light(const Scene& scene, const Shot& shot, const View& view, Scratch& s) const {
  findStrips(scene, view, s);
  s.splats.clear();
  s.kernels.clear();
  for (const Strip& strip : s.strips) lightStrip(scene, shot, view, strip, s);
  s.canvas.add(s.splats, s.kernels);
}

void FrameRenderer::render(const Scene& scene, const Shot& shot, const MutableImageView& image) const {
  const std::uint64_t key = hash(seed_, Stream::Background, {static_cast<std::uint64_t>(shot.camera), scene.trigger});
  fillBackground(key, shot, image);
  if (shot.black) return;
  Lease lease(*this);
  Scratch& scratch = *lease;
  light(scene, shot, View(rig_, shot, effects_.crosstalk), scratch);
  DevelopSettings settings;
  settings.gain = shot.gain;
  settings.ambientDn = shot.gain * static_cast<float>(effects_.ambientDn);
  settings.readVariance = static_cast<float>(effects_.readNoiseDn * effects_.readNoiseDn);
  settings.shotPerDn = static_cast<float>(effects_.shotNoise * kShotPerDn);
  settings.speckle = speckle_.data();
  settings.normals = normals_.data();
  settings.normalCount = kNormals;
  settings.key = key;
  develop(scratch.canvas, settings, image);
}

std::vector<std::vector<Point2>> FrameRenderer::visibleLines(const Scene& scene, const Shot& shot) const {
  std::vector<std::vector<Point2>> lines;
  if (shot.black) return lines;
  Lease lease(*this);
  Scratch& s = *lease;
  const View view(rig_, shot, 0);  // a laser of the other wavelength alone draws no line
  findStrips(scene, view, s);
  const std::size_t n = scene.world.size();
  const Intrinsics& in = rig_.calibration.rangeFinders[static_cast<std::size_t>(shot.camera)].intrinsics;
  const auto inside = [&](const Point2& p) {
    return p.x() >= 0 && p.y() >= 0 && p.x() <= in.widthPx - 1 && p.y() <= in.heightPx - 1;
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
