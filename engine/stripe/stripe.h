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
  kCrosstalk = 8,  ///< may belong to a neighbour's laser
  kRejected = 16,  ///< on a line that lost against a competitor
};

struct StripePoint {
  float x = 0, y = 0;      ///< centre of the line, px
  float nx = 0, ny = 1;    ///< unit normal of the line
  float sigmaPx = 0;       ///< standard uncertainty along the normal, px
  float strength = 0;      ///< contrast of the line, DN
  float widthPx = 0;       ///< standard deviation of the light across the line (the filter's part removed), px
  std::uint8_t flags = 0;  ///< StripeFlag
};

/// Consecutive points `first` .. `first + count` in order along one line.
struct StripeLine {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool rejected = false;
};

/// The paper's five parameters (section II-D) under its names, and two limits of ours.
struct StripeSettings {
  double sigma = 3.0;       ///< sigma: standard deviation of the Gaussian, px
  double low = 6.0;         ///< t_l: points below are rejected, DN of line contrast
  double high = 14.0;       ///< t_h: points above are accepted, DN of line contrast
  double gapDistance = 60;  ///< d: largest distance of two pieces to be linked, px
  double gapAngle = 15;     ///< alpha: largest angle between regression lines to be linked, degrees
  int minLength = 10;       ///< shortest line that is kept, points
  int maxBlocks = 9000;     ///< budget: 8x8 blocks worked on before the frame is called overloaded
};

/// Buffers are reused from frame to frame: no allocation in steady state.
struct StripeResult {
  std::vector<StripePoint> points;  ///< all lines one after the other, rejected lines last
  std::vector<StripeLine> lines;
  float noiseDn = 0;         ///< measured standard deviation of a pixel, DN
  float backgroundDn = 0;    ///< median background, DN
  float saturatedShare = 0;  ///< share of the line's points that are saturated
  /// Number of neighbouring points over which the error of a point is correlated after smoothing (>= 1).
  float correlatedPoints = 1;
  /// Standard deviation of the smoothing along the line: it pulls the centre to the inside of a bend by
  /// smoothingPx^2 / 2 * curvature (stripe design, section 5). Not removed here.
  float smoothingPx = 0;
  bool overloaded = false;  ///< texture everywhere: capped by StripeSettings::maxBlocks
};

}  // namespace vignole
