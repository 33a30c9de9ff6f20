#pragma once
// Where two cameras see the same stretch of the outline, their points should lie on one line. What lies between them,
// along a rail, zone by zone: the seams.

#include <array>
#include <cstdint>
#include <vector>

#include "engine/profile/profile.h"
#include "engine/rail/section.h"
#include "engine/registration/registration.h"

namespace vignole {

/// A piece of the outline, at most 15 mm long, that a pair of cameras may see.
struct SeamZone {
  int first = 0, second = 0;  ///< cameras
  std::size_t primitive = 0;  ///< of the section
  Point2 at{0, 0};            ///< middle, section frame, relative to the middle of the section's height
  Point2 normal{0, 0};        ///< outwards
};

/// How far the first camera's points lie outside the second's, over a rail.
struct Seam {
  double weight = 0;  ///< number of points that the mean is worth, 1 / (1/n + 1/m) summed over pieces of 2 mm
  double mm = 0;      ///< weighted mean
};

/// All zones of a section, in one order for all its rails.
[[nodiscard]] std::vector<SeamZone> seamZones(const Section& section);

/// Gathers the seams of one rail from registered profiles. Which camera and which zone follows from the registration:
/// both cameras' distances from the same nominal curve are compared, so it matters little how the rail deviates from
/// it.
class RailSeams {
 public:
  explicit RailSeams(const Section& section);
  /// Profiles that are not registered, and points at ends of lines, give nothing.
  void add(const Profile& profile, const Registration& registration);
  /// In the order of seamZones; starts the next rail.
  [[nodiscard]] std::vector<Seam> take();
  [[nodiscard]] int profiles() const { return profiles_; }

 private:
  struct Curve {
    Primitive shape;
    double lengthMm = 0;
    std::size_t firstPiece = 0, pieces = 0;
  };
  struct Piece {
    std::array<float, kCameraCount> sum{}, count{};
  };
  void addPieces();

  std::vector<SeamZone> zones_;
  std::vector<Curve> curves_;
  std::vector<std::size_t> zoneOfPiece_;  ///< of the first pair; the others follow
  std::vector<Piece> pieces_;
  std::vector<Seam> seams_;
  int profiles_ = 0;
};

}  // namespace vignole
