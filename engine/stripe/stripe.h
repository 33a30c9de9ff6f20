#pragma once
// What extraction yields: sub-pixel centre lines with their uncertainty. Pixels; (0,0) is the centre of the top-left
// pixel, x to the right (column), y down (row).

#include <cstdint>
#include <string>
#include <vector>

namespace vignole {

/// Flags of a point, joined by |. A flagged point stays.
enum StripeFlag : std::uint8_t {
  kSaturated = 1,  ///< the profile across the line is clipped
  kLineEnd = 2,    ///< within 3 sigma of an end of the line
  kGapEdge = 4,    ///< next to a gap that was bridged
  kCrosstalk = 8,  ///< so weak beside the rest of its line that it may be a neighbour's laser alone
  kRejected = 16,  ///< on a line that lost against a competitor
};

struct StripePoint {
  float x = 0, y = 0;    ///< centre of the line, px
  float nx = 0, ny = 1;  ///< unit normal of the line
  float sigmaPx = 0;     ///< standard uncertainty along the normal, px
  float strength = 0;    ///< contrast of the line, DN
  float widthPx = 0;     ///< standard deviation of the light across the line (the filter's part removed), px
  /// How far along the normal the point was moved off the ridge that the filter found: the pull of the bend taken off
  /// and the line smoothed. The ridge itself is (x, y) - shiftPx (nx, ny), with a standard uncertainty of its own.
  float shiftPx = 0;
  float ridgeSigmaPx = 0;
  /// Relative change of the contrast along the line, in the order of its points, 1/px: a blur that lies oblique to the
  /// line moves it aside by this times the blur's covariance of along and across. 0 where an end of the line is near.
  float brightening = 0;
  std::uint8_t flags = 0;  ///< StripeFlag
};

/// Why a line lost.
enum class Rejection : std::uint8_t {
  None,
  Weaker,     ///< much weaker beside a line that it follows
  Broader,    ///< weaker, broader and shorter beside a line that it follows
  Spot,       ///< many times as broad as the frame's longest line and short beside it: a reflection's blob
  OutOfField  ///< where the light plane cannot be seen
};
/// In a few words; "" for None.
[[nodiscard]] const char* reasonOf(Rejection rejection);

/// Consecutive points `first` .. `first + count` in order along one line.
struct StripeLine {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  Rejection rejection = Rejection::None;
  [[nodiscard]] bool rejected() const { return rejection != Rejection::None; }
};

struct PixelPosition {
  float x = 0, y = 0;
};

/// What is known of a camera, beside its picture. The default knows nothing.
struct StripeOptics {
  double blurPx = 0;  ///< standard deviation of the blur by the lens; it pulls the ridge in bends as the filter does
  std::vector<PixelPosition>
      field;  ///< convex polygon outside of which the light plane cannot be seen; empty: no limit
};

/// The paper's five parameters (section II-D) under its names, and what is ours.
struct StripeSettings {
  double sigma = 3.0;       ///< sigma: standard deviation of the Gaussian, px
  double low = 6.0;         ///< t_l: points below are rejected, DN of line contrast
  double high = 14.0;       ///< t_h: points above are accepted, DN of line contrast
  double gapDistance = 60;  ///< d: largest distance of two pieces to be linked, px
  double gapAngle = 15;     ///< alpha: largest angle between regression lines to be linked, degrees
  int minLength = 10;       ///< shortest line that is kept, points
  int maxBlocks = 3000;     ///< budget: 8x8 blocks worked on before the frame is called overloaded
  bool correction = true;   ///< the pull of bends taken off, smoothed along the line; false: the ridge as it is
};

/// Buffers are reused from frame to frame: no allocation in steady state.
struct StripeResult {
  std::vector<StripePoint> points;  ///< all lines one after the other, rejected lines last
  std::vector<StripeLine> lines;
  float noiseDn = 0;         ///< measured standard deviation of a pixel, DN
  float backgroundDn = 0;    ///< median background, DN
  float saturatedShare = 0;  ///< share of the line's points that are saturated
  /// Number of neighbouring ridge points over which their error is shared (>= 1).
  float correlatedPoints = 1;
  /// Standard deviation of what has smoothed the ridge along the line, filter and lens: it lies smoothingPx^2 / 2 *
  /// curvature too far to the inside of a bend (stripe design, section 5). 0 with the correction off: the pull stays.
  float smoothingPx = 0;
  bool overloaded = false;  ///< texture everywhere: capped by StripeSettings::maxBlocks
};

}  // namespace vignole
