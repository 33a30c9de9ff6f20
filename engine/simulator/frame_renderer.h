#pragma once
// What one camera sees of one trigger: the lit outline, blurred by sheet, lens, pixel and movement, on a noisy ground.

#include <cstdint>
#include <vector>

#include "engine/geometry/image_view.h"
#include "engine/simulator/camera_faults.h"
#include "engine/simulator/displaced_outline.h"
#include "engine/simulator/line_painter.h"
#include "engine/simulator/rail_motion.h"
#include "engine/simulator/rig_geometry.h"
#include "engine/simulator/sensor.h"
#include "engine/simulator/surface.h"
#include "engine/simulator/virtual_rig.h"
#include "engine/simulator/visibility.h"

namespace vignole::simulator {

/// The rail at one trigger.
struct Scene {
  std::uint64_t trigger = 0;
  double alongRailMm = 0;
  ExposedPose pose;
  std::vector<OutlineVertex> vertices;         ///< section frame
  std::vector<Point2> world;                   ///< the same at the mean pose, with its thermal expansion
  const std::vector<float>* ghosts = nullptr;  ///< per vertex: strength of secondary reflections, 0..1
};

/// How a camera takes this frame, and the share of the rail's skin that is scale.
struct Shot {
  CameraShot camera;
  double scaleShare = 0.15;
};

/// Immutable but for a pool of buffers; member functions may be called from any thread. `exposure`: multiple of the
/// usual one.
class FrameRenderer {
 public:
  FrameRenderer(std::uint64_t seed, const RigGeometry& rig, const Effects& effects, double exposure);
  ~FrameRenderer();
  FrameRenderer(FrameRenderer&&) noexcept;
  FrameRenderer& operator=(FrameRenderer&&) = delete;
  FrameRenderer(const FrameRenderer&) = delete;
  FrameRenderer& operator=(const FrameRenderer&) = delete;
  void render(const Scene& scene, const Shot& shot, const MutableImageView& image) const;
  [[nodiscard]] std::vector<std::vector<Point2>> visibleLines(const Scene& scene, const Shot& shot) const;

 private:
  struct Strip;
  struct Scratch;
  void findStrips(const Scene& scene, const CameraView& view, Scratch& scratch) const;
  void lightStrip(const Scene& scene, const Shot& shot, const Strip& strip, LinePainter& painter) const;

  std::uint64_t seed_;
  RigGeometry rig_;
  Effects effects_;
  double exposure_;
  Surface surface_;
  Sensor sensor_;
  std::unique_ptr<ScratchPool<Scratch>> scratches_;
};

}  // namespace vignole::simulator
