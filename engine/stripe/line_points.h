#pragma once
// The points of a frame's lines on their way into the result, quantity by quantity, one line after the other.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/stripe/ridge_kernel.h"

namespace vignole {

/// Floats with a margin on both sides, which whole vectors and neighbours may read. Grows and never shrinks.
class PaddedFloats {
 public:
  static constexpr std::size_t kMargin = 64;
  void reserve(std::size_t count) {
    if (values_.size() < count + 2 * kMargin) values_.resize(count + 2 * kMargin);
  }
  [[nodiscard]] float* data() { return values_.data() + kMargin; }
  [[nodiscard]] const float* data() const { return values_.data() + kMargin; }
  float& operator[](std::size_t i) { return values_[i + kMargin]; }
  const float& operator[](std::size_t i) const { return values_[i + kMargin]; }

 private:
  std::vector<float> values_;
};

struct LinePoints {
  std::size_t size = 0;
  PaddedFloats x, y;                 ///< px
  PaddedFloats nx, ny;               ///< unit normal, a quarter turn from x towards y when looking along the line
  PaddedFloats ridge;                ///< second derivative across the line, negated, DN/px^2
  PaddedFloats light;                ///< smoothed brightness above the background, DN
  PaddedFloats along;                ///< RidgePoint::along; used up by measureLight
  PaddedFloats s2;                   ///< variance of the light across the line, the filter's part removed, px^2
  PaddedFloats strength;             ///< contrast of the line, DN
  PaddedFloats step;                 ///< distance to the next point, px; of the last of a line: meaningless
  PaddedFloats arc;                  ///< way along the line from its first point, px
  PaddedFloats edge;                 ///< way to the nearest end of the line or of a gap in it, px
  PaddedFloats room;                 ///< neighbours on both sides that no end touches
  PaddedFloats sigma;                ///< standard uncertainty of the ridge along the normal, px
  PaddedFloats bend;                 ///< half the curvature, 1/px, weighted by its noise; > 0 towards the normal
  PaddedFloats shift;                ///< along the normal from the ridge to the point as given out, px
  PaddedFloats shiftedSigma;         /// standard uncertainty of the point as given out, px
  PaddedFloats brightening;          ///< relative change of the strength along the line, 1/px
  std::vector<std::uint32_t> pixel;  ///< packedPixel(); readable by whole vectors
  std::vector<std::uint8_t> flags;

  void reserve(std::size_t count) {
    for (PaddedFloats* v : {&x, &y, &nx, &ny, &ridge, &light, &along, &s2, &strength, &step, &arc, &edge, &room, &sigma,
                            &bend, &shift, &shiftedSigma, &brightening})
      v->reserve(count);
    if (pixel.size() < count + PaddedFloats::kMargin) pixel.resize(count + PaddedFloats::kMargin);
    if (flags.size() < count) flags.resize(count);
  }
};

/// Points `first` .. `first + count` of one line.
struct LineRange {
  std::uint32_t first = 0, count = 0;
  [[nodiscard]] std::uint32_t end() const { return first + count; }
};

}  // namespace vignole
