#pragma once
// How badly a section explains a registered profile, when a real rail's smooth deviations are allowed for.
//
// The rail's outline is taken to be the section's, displaced by a vector that changes smoothly along it (integrated
// white noise, a Kalman filter along the outline): a head that is too high, a foot that is too wide, a fillet that is
// carried along cost little; a bend of another radius or in another place costs a lot.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/profile/profile.h"
#include "engine/rail/section.h"
#include "engine/registration/registration.h"

namespace vignole {

struct Misfit {
  double chi2 = 0;        ///< mean over the places along the outline (2 mm each), each limited to kWorst
  int places = 0;         ///< that had points
  double strayShare = 0;  ///< points without a primitive
  static constexpr double kWorst = 25;
};

class ShapeMisfit {
 public:
  explicit ShapeMisfit(const Section& section);

  /// Registered to this section. A chi2 of about 1 and below: explained.
  Misfit measure(std::span<const ProfilePoint> points, const Registration& registration, double correlatedPoints);

 private:
  /// A stretch of a primitive, and where the residuals of its points end (they begin where those of the one before do).
  struct Place {
    double nx = 0, ny = 0, lengthMm = 0;
    std::size_t end = 0;
  };
  /// Sorts the residuals into the places.
  void gather(std::span<const ProfilePoint> points, const Registration& registration, std::size_t stride);

  std::vector<Primitive> shapes_;
  std::vector<Place> outline_;
  std::vector<std::size_t> first_;  ///< place of a primitive's first stretch; one more than there are primitives
  // Of the points that are looked at: place (none: one past the last), residual; then residuals place by place.
  std::vector<std::uint32_t> placeOf_;
  std::vector<float> found_, residuals_;
  double variance_ = 0;  ///< mean of one point
  std::size_t strays_ = 0;
};

}  // namespace vignole
