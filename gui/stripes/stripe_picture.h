#pragma once
// One picture of one camera, made ready for the screen away from the window's thread: reduced to the view's size, its
// line as few strokes, its figures.

#include <QImage>
#include <QPolygonF>
#include <chrono>
#include <optional>
#include <vector>

#include "engine/inspection/latest_frames.h"
#include "gui/stripes/line_difference.h"

namespace vignole {

/// What is said of a line.
struct StripeFigures {
  std::size_t points = 0, pieces = 0, saturatedPoints = 0;
  double saturatedShare = 0, noiseDn = 0, meanDn = 0, sigmaPx = 0;  ///< means over the line's points
};
[[nodiscard]] StripeFigures stripeFigures(const StripeResult& stripe);

/// The same picture, or one with another exposure, extracted with what is on trial.
struct StripeTrial {
  LatestFrames::Held taken;
  StripeFigures figures;
  LineDifference difference;
  std::vector<QPolygonF> strokes;
};

struct StripePicture {
  int camera = 0;
  std::uint64_t trigger = 0;
  LatestFrames::Held taken;         ///< the pixels, with the line that is measured with
  QImage whole;                     ///< reduced to the view, brightest pixel of those that fall together
  std::vector<QPolygonF> strokes;   ///< of the line, px of the picture (pixel centres at integers)
  std::vector<QRectF> saturated;    ///< around the saturated stretches
  std::vector<float> brightnessDn;  ///< along the line, a value for each of at most 400 stretches
  StripeFigures figures;
  std::optional<StripeTrial> trial;
  std::chrono::steady_clock::time_point at;  ///< when it came
};

/// `size`: of the view, in its own pixels; the picture keeps its proportions and fills one side.
[[nodiscard]] QImage reduced(const ImageView& image, const QSize& size);
/// No two points of a stroke nearer than `stepPx`, but for its ends.
[[nodiscard]] std::vector<QPolygonF> strokesOf(const StripeResult& stripe, double stepPx);
/// `taken` is not null.
[[nodiscard]] StripePicture stripePicture(LatestFrames::Held taken, const QSize& size);

}  // namespace vignole
