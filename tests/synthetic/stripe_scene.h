#pragma once
// Pictures of a laser line whose true centre is known: the scenes of the extraction's design (stripe.md, section 1).

#include <cstdint>
#include <string>
#include <vector>

#include "engine/geometry/image_view.h"

namespace vignole::synthetic {

/// One sample of the true centre line, every 0.25 px along it. Pixel centres at integers.
struct TruthSample {
  double x = 0, y = 0;    ///< px
  double nx = 0, ny = 0;  ///< unit normal
  double contrast = 0;    ///< A, DN
  double sigma = 0;       ///< sd of the light across the line, px
  bool visible = true;    ///< false in a gap
  double edgePx = 0;      ///< way along the line to its next end or gap edge
};

struct StripeScene {
  std::string name;
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
  std::vector<TruthSample> truth;
  [[nodiscard]] ImageView view() const { return {pixels.data(), width, height, width}; }
};

inline constexpr const char* kSceneNames[] = {"clean", "rail", "narrow", "wide", "sat", "hard"};

/// 1400 x 1024 pixels of scene `name`; the seed draws the curve's place and shape, the brightness, the defects, the
/// noise.
[[nodiscard]] StripeScene stripeScene(const std::string& name, std::uint64_t seed);

/// A straight line through the point (x0, y0), its normal at `angleRad` to the x axis, across the whole picture.
struct StraightLine {
  int width = 200, height = 160;
  double x0 = 100, y0 = 80, angleRad = 1.5707963267948966;
  double contrast = 150, sigma = 3, noiseDn = 0, backgroundDn = 20;
  double firstPx = -1e9, lastPx = 1e9;  ///< visible stretch along the line, from (x0, y0)
};
[[nodiscard]] std::vector<std::uint8_t> straightLinePicture(const StraightLine& line, std::uint64_t seed);

}  // namespace vignole::synthetic
