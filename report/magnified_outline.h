#pragma once
// What is drawn of a profile: the nominal outline cut into bins of equal arc length, each with the mean deviation of
// its points, and which dimensions are taken there. Section frame, mm.

#include <cstdint>
#include <vector>

#include "engine/profile/profile.h"
#include "engine/rail/dimension.h"
#include "engine/rail/section.h"
#include "engine/registration/registration.h"

namespace vignole {

struct OutlineBin {
  Point2 point{0, 0};   ///< on the nominal outline
  Point2 normal{0, 0};  ///< unit, outwards
  std::uint16_t primitive = 0;
  bool corner = false;    ///< on an arc too small to show a magnified deviation along its normals
  bool seen = false;      ///< measured, or in a gap too short to matter
  float deviationMm = 0;  ///< mean of its points, > 0 outside; interpolated in short gaps
  std::uint32_t points = 0;
  std::uint16_t dimensions = 0;  ///< bit index(d): dimension d is taken on this stretch
};

/// A point of the profile at its place on the outline.
struct PlacedPoint {
  Point2 foot{0, 0};  ///< on the nominal outline
  Point2 normal{0, 0};
  float deviationMm = 0;
  std::uint8_t camera = 0;
};

class MagnifiedOutline {
 public:
  /// Section only: no bin is seen. `stepMm` is the largest length of a bin.
  MagnifiedOutline(const Section& section, const DimensionParameters& parameters, double stepMm = 0.5);
  /// Puts the points on their primitives; does nothing if the registration is not valid. Points that no primitive has
  /// are left out here and returned by unassigned(). Keeps each point only if `keepPoints`.
  void place(const Profile& profile, const Registration& registration, bool keepPoints);

  [[nodiscard]] const std::vector<OutlineBin>& bins() const { return bins_; }  ///< counter-clockwise, closed
  [[nodiscard]] const std::vector<PlacedPoint>& points() const { return points_; }
  [[nodiscard]] const std::vector<Point2>& unassigned() const { return unassigned_; }

 private:
  void sample(const Section& section, double stepMm);
  void markDimensions(const Section& section, const DimensionParameters& parameters);
  void bridgeGaps();

  const Section& section_;
  std::vector<OutlineBin> bins_;
  std::vector<std::size_t> firstBin_;  ///< per primitive, and the end
  std::vector<double> stepMm_;         ///< per primitive
  std::vector<PlacedPoint> points_;
  std::vector<Point2> unassigned_;
};

/// Height of the section at which its web is thinnest (the middle of that height where it is straight).
[[nodiscard]] double thinnestWebHeightMm(const Section& section, const std::vector<OutlineBin>& bins);

}  // namespace vignole
