#pragma once
// Lines that are no image of the laser's line on the rail: ghosts (reflections in the rail or in the lens), told by
// brightness, width and continuity beside the line that they follow, and light where the light plane cannot be seen.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/stripe/line_points.h"
#include "engine/stripe/stripe.h"

namespace vignole {

struct CompetitionSettings {
  float distancePx = 40;         ///< a ghost is so near to the line that it follows
  float parallelCosine = 0.94F;  ///< and parallel within 20 degrees
  float leastShare = 0.7F;       ///< over at least this share of its length; a doubtful line is kept
  float weakShare = 0.35F;       ///< weaker than this share of its contrast, ...
  float broadShare = 0.6F;       ///< ... or than this, if it is
  float broadness = 1.3F;        ///< so many times as broad
  float spotBroadness = 2;       ///< a spot is so many times as broad as the longest line
  float spotLength = 0.35F;      ///< and at most this share as long
  float continuity = 0.7F;       ///< and at most this share as long: of two lines the one without breaks is the line's
};

/// A line as a competitor.
struct Competitor {
  LineRange range;
  Rejection rejection = Rejection::None;
};

/// Buffers live from frame to frame.
class Competition {
 public:
  /// Marks the lines that lose. `field`: see StripeOptics.
  void judge(const LinePoints& points, std::span<Competitor> lines, std::span<const PixelPosition> field,
             const CompetitionSettings& settings);

 private:
  struct Box {
    float left = 0, top = 0, right = 0, bottom = 0;
    [[nodiscard]] float distance2(float x, float y) const;
    void include(const Box& other);
  };
  struct BoxesOfLine {
    std::uint32_t first = 0, count = 0;
    Box all;
  };
  void enclose(const LinePoints& points, const LineRange& range);
  /// Index of the point of a line nearest to (x, y); its count if none lies within the limit.
  [[nodiscard]] std::size_t nearest(const LinePoints& points, const LineRange& range, const BoxesOfLine& boxes, float x,
                                    float y, float limitPx) const;
  [[nodiscard]] Rejection against(const LinePoints& points, const LineRange& doubtful, const LineRange& line,
                                  const BoxesOfLine& boxes, const CompetitionSettings& settings) const;

  static void rejectSpots(const LinePoints& points, std::span<Competitor> lines, const CompetitionSettings& settings);

  std::vector<Box> boxes_;  // of a few points each, line by line
  std::vector<BoxesOfLine> ofLine_;
};

}  // namespace vignole
