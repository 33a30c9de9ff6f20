#pragma once
// A picture that somebody else owns: 8-bit grey, row-major, pixel (0,0) is the centre of the top-left pixel.

#include <cstddef>
#include <cstdint>

namespace vignole {

struct ImageView {
  const std::uint8_t* data = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;  ///< bytes from one row to the next

  [[nodiscard]] const std::uint8_t* row(int y) const { return data + y * stride; }
  [[nodiscard]] bool empty() const { return data == nullptr || width <= 0 || height <= 0; }
};

struct MutableImageView {
  std::uint8_t* data = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;

  [[nodiscard]] std::uint8_t* row(int y) const { return data + y * stride; }
  operator ImageView() const { return {data, width, height, stride}; }  // NOLINT: a view that may write may be read
};

}  // namespace vignole
