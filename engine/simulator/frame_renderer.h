#pragma once
// What one camera sees of one trigger: the lit outline, blurred by sheet, lens, pixel and movement, on a noisy ground.

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/geometry/image_view.h"
#include "engine/simulator/displaced_outline.h"
#include "engine/simulator/light_kernels.h"
#include "engine/simulator/rail_motion.h"
#include "engine/simulator/rig_geometry.h"
#include "engine/simulator/surface.h"
#include "engine/simulator/virtual_rig.h"
#include "engine/simulator/visibility.h"

namespace vignole::simulator {

/// 10,000 electrons at 60 DN: variance in DN^2 per DN of signal.
inline constexpr double kShotPerDn = 60.0 / 10000;

/// The rail at one trigger.
struct Scene {
  std::uint64_t trigger = 0;
  double alongRailMm = 0;
  ExposedPose pose;
  std::vector<OutlineVertex> vertices;         ///< section frame
  std::vector<Point2> world;                   ///< the same at the mean pose, with its thermal expansion
  const std::vector<float>* ghosts = nullptr;  ///< per vertex: strength of secondary reflections, 0..1
};

/// How a camera takes this frame.
struct Shot {
  int camera = 0;
  Extrinsics cameraFromWorld;  ///< where the camera is, which a fault may have moved off its calibration
  bool black = false;          ///< no light, no ambient
  float gain = 1;              ///< exposure: on light and ambient alike
  double scaleShare = 0.15;
};

/// Immutable but for a pool of scratch buffers; render() and visibleLines() may be called from any thread.
class FrameRenderer {
 public:
  FrameRenderer(std::uint64_t seed, const RigGeometry& rig, const Effects& effects);
  ~FrameRenderer();
  FrameRenderer(const FrameRenderer&) = delete;
  FrameRenderer& operator=(const FrameRenderer&) = delete;
  void render(const Scene& scene, const Shot& shot, const MutableImageView& image) const;
  [[nodiscard]] std::vector<std::vector<Point2>> visibleLines(const Scene& scene, const Shot& shot) const;

 private:
  struct Strip;
  struct Scratch;
  struct View;
  class Lease;
  void findStrips(const Scene& scene, const View& view, Scratch& scratch) const;
  void light(const Scene& scene, const Shot& shot, const View& view, Scratch& scratch) const;
  void lightStrip(const Scene& scene, const Shot& shot, const View& view, const Strip& strip, Scratch& scratch) const;
  [[nodiscard]] SplatKernel kernelAt(const View& view, const ExposedPose& pose, const Point2& world,
                                     double sheetSigmaMm, double offPlaneMm) const;
  void fillBackground(std::uint64_t key, const Shot& shot, const MutableImageView& image) const;

  std::uint64_t seed_;
  RigGeometry rig_;
  Effects effects_;
  Surface surface_;
  std::vector<float> speckle_, normals_;
  std::vector<std::uint8_t> background_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Scratch>> idle_;
};

}  // namespace vignole::simulator
