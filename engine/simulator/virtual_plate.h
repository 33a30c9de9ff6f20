#pragma once
// The pin plate before the virtual rig: what the four cameras see of the pins that the lasers light, and the truth.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulator/virtual_rig.h"
#include "engine/target/pin_plate.h"

namespace vignole {

/// Where the plate stands: in the light plane, and tilted out of it (about the world's x and y axes through its
/// middle).
struct PlatePlacement {
  Transform2 worldFromPlate;
  double tiltXRad = 0, tiltYRad = 0;
};

struct VirtualPlateSettings {
  PinPlate plate;                        ///< as stated; the true one differs by the errors below
  std::uint64_t seed = 1;                ///< draws the plate's errors, noise
  std::optional<std::uint64_t> rigSeed;  ///< draws the rig; default: the seed
  double plateErrorMm = 0;               ///< each coordinate of a centre uniform within +- this
  double radiusErrorMm = 0;              ///< each radius uniform within +- this
  double leanMrad = 0;                   ///< standard deviation of each pin's own lean, each direction
  std::vector<PlatePlacement> placements;
  double exposureMs = 15;
  std::optional<double> noisePx;  ///< all noise scaled so that the median Cramer-Rao bound of a stripe point is this
  Effects effects;
  std::vector<int> missingPins;  ///< numbers
  int spurious = 0;              ///< bright arcs that are no pins, per picture
  std::vector<Fault> faults;     ///< black, saturated, move, turn; by camera and, as triggers, by placement
};

/// 0, 180, 4 degrees with a shift, 176 degrees (optics design, section 1.8), then drawn ones.
[[nodiscard]] std::vector<PlatePlacement> usualPlacements(int count, std::uint64_t seed);

/// Immutable; member functions may be called from any thread.
class VirtualPlate {
 public:
  [[nodiscard]] static Expected<std::shared_ptr<const VirtualPlate>> create(VirtualPlateSettings settings);
  ~VirtualPlate();
  VirtualPlate(const VirtualPlate&) = delete;
  VirtualPlate& operator=(const VirtualPlate&) = delete;

  [[nodiscard]] const VirtualPlateSettings& settings() const;
  /// The exact calibration of the rig that looks at it: as VirtualRig's of the same rig seed.
  [[nodiscard]] const RigCalibration& calibration() const;
  /// The drawing of the rig: what a technician knows before any calibration.
  [[nodiscard]] static const RigCalibration& nominalRig();
  /// True pins in the light plane, plate frame.
  [[nodiscard]] const PinPlate& truePlate() const;
  /// The factor on all noise that noisePx asked for; 1 without it.
  [[nodiscard]] double noiseFactor() const;
  void render(int camera, int placement, const MutableImageView& image) const;
  /// Centre of the visible laser line on one pin, px, in order; empty where the camera sees none of it.
  [[nodiscard]] std::vector<Point2> visibleArc(int camera, int placement, int pin) const;

 private:
  struct Impl;
  explicit VirtualPlate(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace vignole
