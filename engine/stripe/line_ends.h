#pragma once
// The last pixels of a line. There the light ends along the line as well as across it, the Hessian's direction turns
// away and the ridge forks around the corners of the end (0.2 to 7 px off). The line is therefore followed to its end
// once more with the direction it comes from, instead of the direction found on the spot.

#include <span>
#include <vector>

#include "engine/geometry/image_view.h"
#include "engine/stripe/band_window.h"
#include "engine/stripe/line_linking.h"

namespace vignole {

/// Buffers live from frame to frame.
class LineEnds {
 public:
  /// A piece too short to have a part that its ends do not touch (7 sigma) stays as it is.
  void retrace(const ImageView& image, const RidgeFilter& filter, const RidgePoints& ridges, const LineLinker& lines);
  /// `first` and `count` of each among points().
  [[nodiscard]] const std::vector<LinePiece>& pieces() const { return pieces_; }
  [[nodiscard]] const RidgeArrays& points() const { return points_; }

 private:
  /// One end of a piece, from the inside outwards.
  class Outwards;
  struct Trusted {
    std::size_t last = 0;  // place of the last point that the end does not touch
    float curvature = 0;   // 1/px, positive turns from x towards y
    float ridge = 0;       // mean second derivative there
  };
  [[nodiscard]] Trusted trustedPart(const Outwards& points) const;
  /// Fills `tail` with the points behind the trusted ones; false: the end stays as it is.
  bool retraceEnd(const ImageView& image, const RidgeFilter& filter, const RidgePoints& ridges, const Outwards& points,
                  Trusted& trusted, std::vector<RidgePoint>& tail);
  void follow(const ImageView& image, const RidgeFilter& filter, const RidgePoints& ridges, const Trusted& trusted);
  [[nodiscard]] bool measure(const ImageView& image, const RidgeFilter& filter, float x, float y, float nx, float ny,
                             RidgePoint& point);

  float sigma_ = 3;
  BandWindow window_;
  std::vector<RidgePoint> traced_, head_, stop_;
  RidgeArrays points_;
  std::vector<LinePiece> pieces_;
};

}  // namespace vignole
