#pragma once
// The last pixels of a line. There the light ends along the line as well as across it, the Hessian's direction turns
// away and the ridge forks around the corners of the end (0.2 to 7 px off). The line is therefore followed to its end
// once more with the direction it comes from, instead of the direction found on the spot.

#include <memory>
#include <span>
#include <vector>

#include "engine/geometry/image_view.h"
#include "engine/stripe/band_window.h"
#include "engine/stripe/line_linking.h"

namespace vignole {

/// Buffers live from frame to frame.
class LineEnds {
 public:
  LineEnds();
  /// A piece too short to have a part that its ends do not touch (7 sigma) stays as it is.
  void retrace(const ImageView& image, const RidgeFilter& filter, const LineLinker& lines);
  [[nodiscard]] const std::vector<LinePiece>& pieces() const { return pieces_; }
  [[nodiscard]] const std::vector<RidgePoint>& points() const { return points_; }

 private:
  struct Trusted {
    std::size_t last = 0;  // index of the last point that the end does not touch
    float curvature = 0;   // 1/px, positive turns from x towards y
    float ridge = 0;       // mean second derivative there
  };
  [[nodiscard]] Trusted trustedPart(std::span<const RidgePoint> outwards) const;
  void follow(const ImageView& image, const RidgeFilter& filter, std::span<const RidgePoint> outwards,
              const Trusted& trusted);
  void smoothAround(const ImageView& image, const RidgeFilter& filter, int column, int row);
  [[nodiscard]] bool measure(float x, float y, float nx, float ny, RidgePoint& point) const;

  static constexpr int kPatch = 32;  // px, a whole number of bands
  float sigma_ = 3;
  std::unique_ptr<RidgeBand> band_;
  BandWindow window_;
  int patchColumn_ = 0, patchRow_ = 0;  // of the patch's first pixel
  std::vector<float> patch_;            // (kPatch + 2) squared: one more to all sides
  std::vector<RidgePoint> traced_;
  std::vector<RidgePoint> points_;
  std::vector<LinePiece> pieces_;
};

}  // namespace vignole
