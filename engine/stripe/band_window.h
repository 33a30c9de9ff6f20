#pragma once
// The pixels under a band and its filter, with the picture's edge repeated where they reach beyond it.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/geometry/image_view.h"
#include "engine/stripe/ridge_kernel.h"

namespace vignole {

struct BandPixels {
  const std::uint8_t* pixels = nullptr;
  std::ptrdiff_t stride = 0;
};

/// Hands out the picture itself where it suffices, else a copy that lives until the next call.
class BandWindow {
 public:
  /// For the kernels' band of `width` x 8 pixels at (column, row).
  BandPixels at(const ImageView& image, const RidgeFilter& filter, int column, int row, int width);

 private:
  std::vector<std::uint8_t> copy_;
};

}  // namespace vignole
