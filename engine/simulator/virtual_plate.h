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
  /// Standard deviation of each pin's own lean, each direction, about its foot in the plate's surface.
  double leanMrad = 0;
  std::vector<PlatePlacement> placements;
  double exposureMs = 15;  ///< scales the light, the pins' and the ambient; shot noise follows
  /// All noise (read noise, speckle contrast; variance of shot noise by the square) is scaled by the one factor at
  /// which the median Cramer-Rao bound, along the normal, of a point that 1 px of line gives is this many px: over
  /// every visible px of line in all cameras of the first placement, exposed for 15 ms (line_bound.h), whatever
  /// exposureMs is.
  std::optional<double> noisePx;
  Effects effects;               ///< read-noise, shot-noise, speckle, crosstalk, ambient, defocus; the pins are matt
  std::vector<int> missingPins;  ///< numbers
  int spurious = 0;              ///< bright arcs that are no pins, per picture
  /// black, saturated, move, turn; by camera and, as triggers, by placement (1 is the first).
  std::vector<Fault> faults;
};

/// 0, 180, 4 degrees with a shift, 176 degrees with another (optics design, section 1.8), all but the first with what a
/// hand leaves (1 mm, 0.3 degrees), then drawn ones; turned about the middle of the rig's field.
[[nodiscard]] std::vector<PlatePlacement> usualPlacements(int count, std::uint64_t seed);
/// The same placement with the plate turned further about the middle of the rig's field.
[[nodiscard]] PlatePlacement turned(const PlatePlacement& placement, double angleRad);

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
  /// The drawing of the rig (engine/optics/nominal_rig.h): what a technician knows before any calibration.
  [[nodiscard]] static const RigCalibration& nominalRig();
  /// True pins in the light plane, plate frame.
  [[nodiscard]] const PinPlate& truePlate() const;
  /// The factor on all noise that noisePx asked for; 1 without it.
  [[nodiscard]] double noiseFactor() const;
  /// image: as large as the camera's sensor. Same (camera, placement), same bytes, in any thread and order.
  void render(int camera, int placement, const MutableImageView& image) const;
  /// Centre of the visible laser line on the pin of that number, px, about 1 px apart and in order around it, within
  /// the picture and not too oblique to be read; where a shadow cuts it the distance is more. Empty where the camera
  /// sees none of it.
  [[nodiscard]] std::vector<Point2> visibleArc(int camera, int placement, int pin) const;

 private:
  struct Impl;
  explicit VirtualPlate(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace vignole
