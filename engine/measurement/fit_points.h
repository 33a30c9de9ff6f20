#pragma once
// The points of one fit, number by number in arrays of their own, for loops over many points at once.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vignole {

/// Section frame less the fit's own origin, mm: floats there are good to a few nanometres. weight: 1 / sigma^2.
/// `pull` (mm^2) times the curvature is how far the line filter has pulled the point to the inside of the bend
/// (ProfilePoint::smoothingMm^2 / 2): the fit is of the curve that the filter saw, so that the curve itself comes out,
/// with the curvature of the data and not of the section.
struct FitPoints {
  std::vector<float> x, y, weight, pull;
  std::size_t count = 0;
  /// Runs of points of one camera.
  struct Run {
    std::size_t from = 0, to = 0;
    std::uint8_t camera = 0;
  };
  std::vector<Run> runs;

  /// The arrays only ever grow and reach kPadding beyond the last point, so that it can be loaded with a whole vector.
  void resize(std::size_t n) {
    count = n;
    for (std::vector<float>* v : {&x, &y, &weight, &pull})
      if (v->size() < n + kPadding) v->resize(n + kPadding, 0.0F);
  }
  void append(const FitPoints& from, std::size_t i) {
    resize(count + 1);
    x[count - 1] = from.x[i];
    y[count - 1] = from.y[i];
    weight[count - 1] = from.weight[i];
    pull[count - 1] = from.pull[i];
  }
  static constexpr std::size_t kPadding = 8;
};

}  // namespace vignole
