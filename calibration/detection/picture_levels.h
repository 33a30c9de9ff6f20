#pragma once
// A picture at half, a quarter ... of its size, for the search of what is large or blurred.

#include <cstdint>
#include <vector>

#include "engine/geometry/image_view.h"
#include "engine/geometry/transform2.h"

namespace vignole {

/// Pixels are means of squares of `factor` pixels of the picture.
class PictureLevel {
 public:
  /// The picture itself, which must outlive the level.
  explicit PictureLevel(const ImageView& picture) : view_(picture) {}
  [[nodiscard]] PictureLevel half() const;

  [[nodiscard]] ImageView view() const;
  [[nodiscard]] int factor() const { return factor_; }
  [[nodiscard]] Point2 inPicture(const Point2& px) const {
    return (px + Point2(0.5, 0.5)) * factor_ - Point2(0.5, 0.5);
  }

 private:
  PictureLevel(std::vector<std::uint8_t> pixels, int width, int height, int factor);
  ImageView view_;
  std::vector<std::uint8_t> pixels_;  // empty for the picture itself
  int factor_ = 1;
};

/// Standard deviation of a pixel's noise, DN: median of what second differences leave (edges are few).
[[nodiscard]] double noiseOf(const ImageView& image);

}  // namespace vignole
