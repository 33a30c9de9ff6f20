#pragma once
// What one camera sees of the pins in the light: their lit sides, in the shadows of one another, with its noise.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/simulator/camera_faults.h"
#include "engine/simulator/line_painter.h"
#include "engine/simulator/pin_body.h"
#include "engine/simulator/rig_geometry.h"
#include "engine/simulator/sensor.h"

namespace vignole::simulator {

/// A stretch of a pin's cut by its angle, from < to (to may exceed 2 pi), that the same lasers reach.
struct PinArc {
  double from = 0, to = 0;
  LitBy lit{};
};

/// A bright arc that is no pin: part of a circle in the light plane.
struct SpuriousArc {
  Point2 centre{0, 0};
  double radiusMm = 0, fromRad = 0, toRad = 0;
};

/// Pins that stand in the light.
struct PlateScene {
  std::uint64_t key = 0;  ///< draws the noise, with the camera
  std::vector<PinBody> pins;
};

/// Immutable but for a pool of buffers; member functions may be called from any thread. `exposure`: multiple of the
/// usual one, on the laser's light (the ambient light is that of the effects).
class PlateRenderer {
 public:
  PlateRenderer(std::uint64_t seed, const RigGeometry& rig, const Effects& effects, double exposure);
  ~PlateRenderer();
  PlateRenderer(PlateRenderer&&) noexcept;
  PlateRenderer& operator=(PlateRenderer&&) = delete;
  PlateRenderer(const PlateRenderer&) = delete;
  PlateRenderer& operator=(const PlateRenderer&) = delete;
  void render(const PlateScene& scene, const std::vector<SpuriousArc>& spurious, const CameraShot& shot,
              const MutableImageView& image) const;
  /// What a camera sees of one pin and its own wavelength lights at less than 80 degrees from the normal, in order
  /// around it: px, about 1 px apart, within the picture.
  [[nodiscard]] std::vector<std::vector<Point2>> visibleLines(const PlateScene& scene, std::size_t pin,
                                                              const CameraShot& shot) const;

 private:
  struct Scratch;
  [[nodiscard]] std::vector<PinArc> arcs(const PlateScene& scene, std::size_t pin, const CameraView& view) const;

  std::uint64_t seed_;
  RigGeometry rig_;
  Effects effects_;
  double exposure_;
  Sensor sensor_;
  std::unique_ptr<ScratchPool<Scratch>> scratches_;
};

}  // namespace vignole::simulator
