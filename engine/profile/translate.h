#pragma once
// 2D to 3D translation (paper sections II-C, II-E): centre lines in the image become a partial contour in the world, by
// the map from the image to the light plane.

#include <cmath>
#include <cstdint>

#include "engine/optics/oblique_sheet.h"
#include "engine/optics/plane_map.h"
#include "engine/profile/profile.h"
#include "engine/stripe/stripe.h"

namespace vignole {

/// Why there is no contour, in the ledger's few words; "" if there is one.
[[nodiscard]] const char* reasonForNoContour(const StripeResult& stripe);

/// `map(column, row)` gives PlanePoint: world x, y in mm and its derivatives in mm/px. The normal of the contour is
/// perpendicular to the mapped tangent; sigmaMm is the standard uncertainty along it, sigmaPx |det J| / |J t| (first
/// order: moving along the contour changes nothing). Rejected lines are left out. Buffers of `result` are reused.
template <typename Map>
void translateThrough(const Map& map, int camera, std::uint64_t trigger, const StripeResult& stripe,
                      PartialContour& result, const ObliqueSheet& sheet = {}) {
  result.camera = camera;
  result.trigger = trigger;
  result.points.clear();
  result.lineEnds.clear();
  result.correlatedPoints = stripe.correlatedPoints;
  result.backgroundDn = stripe.backgroundDn;
  result.noiseDn = stripe.noiseDn;
  result.saturatedShare = stripe.saturatedShare;
  result.overloaded = stripe.overloaded;
  for (const StripeLine& line : stripe.lines) {
    if (line.rejected()) continue;
    for (std::uint32_t i = line.first; i < line.first + line.count; ++i) {
      const StripePoint& p = stripe.points[i];
      const PlanePoint w = map(static_cast<double>(p.x), static_cast<double>(p.y));
      const double tx = -static_cast<double>(p.ny), ty = static_cast<double>(p.nx);
      const double wtx = w.dxdc * tx + w.dxdr * ty, wty = w.dydc * tx + w.dydr * ty;
      const double stretch = std::sqrt(wtx * wtx + wty * wty);
      const double determinant = w.dxdc * w.dydr - w.dxdr * w.dydc;
      // A point that the map sends nowhere (beyond the horizon of the light plane) is no point of the contour.
      if (!(stretch > 0) || !std::isfinite(stretch) || !std::isfinite(w.x) || !std::isfinite(w.y)) continue;
      // N . J n = -det J / |J t| for the contour's normal N as it is given here and n in the picture.
      const double across = std::abs(determinant) / stretch, px = wtx / stretch, py = wty / stretch;
      // The sheet moves the line aside where its light changes, and pulls it in bends as the filter does. With the
      // correction off (smoothingPx 0) nothing is taken off.
      double x = w.x, y = w.y, sheetPull = 0;
      if (sheet.varianceMm2() > 0 && stripe.smoothingPx > 0) {
        const Eigen::Vector2d seen = sheet.seenAt(x, y);
        const double along = seen.x() * px + seen.y() * py, aside = seen.y() * px - seen.x() * py;
        // t runs against the order of the points: a quarter turn from n, which is one from the line's direction.
        const double moved = -sheet.varianceMm2() * along * aside * static_cast<double>(p.brightening) / stretch;
        x -= moved * py;
        y += moved * px;
        sheetPull = sheet.varianceMm2() * along * along;
      }
      const double filterPull = static_cast<double>(stripe.smoothingPx) * stretch;
      result.points.push_back({x, y, static_cast<float>(-py), static_cast<float>(px),
                               static_cast<float>(static_cast<double>(p.sigmaPx) * across), p.strength,
                               static_cast<std::uint8_t>(camera), p.flags,
                               static_cast<float>(-determinant / stretch * static_cast<double>(p.shiftPx)),
                               static_cast<float>(static_cast<double>(p.ridgeSigmaPx) * across),
                               static_cast<float>(std::sqrt(filterPull * filterPull + sheetPull))});
    }
    const auto end = static_cast<std::uint32_t>(result.points.size());
    if (end > (result.lineEnds.empty() ? 0U : result.lineEnds.back())) result.lineEnds.push_back(end);
  }
  result.missing = result.points.empty() ? reasonForNoContour(stripe) : "";
}

/// Of one camera. Immutable: may be used by any thread.
class Translator {
 public:
  Translator(int camera, const RangeFinderCalibration& calibration)
      : camera_(camera), map_(calibration), sheet_(calibration) {}
  void translate(std::uint64_t trigger, const StripeResult& stripe, PartialContour& result) const;

 private:
  int camera_;
  PlaneMap map_;
  ObliqueSheet sheet_;
};

}  // namespace vignole
