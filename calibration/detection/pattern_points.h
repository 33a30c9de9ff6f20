#pragma once
// The points that a target's lattice is made of, dots or corners of squares: where they may be, which may be
// neighbours, where they are to a fraction of a pixel.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "calibration/detection/circle_fit.h"
#include "calibration/detection/corner_fit.h"
#include "calibration/detection/lattice.h"
#include "calibration/detection/picture_levels.h"

namespace vignole {

/// A point as it was fitted to the picture.
struct PatternPoint {
  Point2 px{0, 0};
  double uPx = 0, blurPx = 0;
  double contrastDn = 0;  ///< dots: inside less outside; corners: bright less dark
  double groundDn = 0;    ///< dots: outside; corners: the mean of bright and dark
  double noiseDn = 0, rmsDn = 0, saturatedShare = 0;
  DotEllipse ellipse;  ///< of a dot
  Corner corner;       ///< of squares
};

/// Candidates in one picture and what can be said of them. Places are the picture's, whatever level they were found at.
class PatternPoints {
 public:
  virtual ~PatternPoints() = default;
  [[nodiscard]] virtual std::span<const Point2> places() const = 0;
  /// A candidate with a neighbour to two sides.
  [[nodiscard]] virtual std::optional<LatticeSeed> seedAt(std::size_t candidate, const PointIndex& index) const = 0;
  [[nodiscard]] virtual bool mayBeNeighbours(std::size_t a, std::size_t b) const = 0;
  /// The candidate, fitted; nothing where it is none after all.
  [[nodiscard]] virtual std::optional<PatternPoint> fit(std::size_t candidate, const LatticeSteps& steps) const = 0;
  /// A point that was not among the candidates, by its neighbour in the lattice, an odd number of steps away or not.
  [[nodiscard]] virtual std::optional<PatternPoint> fitAt(const Point2& place, const LatticeSteps& steps,
                                                          const PatternPoint& neighbour, bool oddSteps) const = 0;
};

[[nodiscard]] std::unique_ptr<PatternPoints> dots(const ImageView& picture, std::vector<DotEllipse> candidates);
[[nodiscard]] std::unique_ptr<PatternPoints> corners(const ImageView& picture, std::vector<Corner> candidates);

/// In the picture's pixels.
[[nodiscard]] DotEllipse inPicture(const DotEllipse& ellipse, const PictureLevel& level);

}  // namespace vignole
