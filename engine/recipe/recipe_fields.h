#pragma once
// The settings of a recipe file, once: key, value, range, comment. Reader and writer walk the same list.

#include <string>

#include "engine/recipe/recipe.h"

namespace vignole {

inline constexpr double kWidestToleranceMm = 100;

/// Shortest text that reads back to the same number.
[[nodiscard]] std::string plainNumber(double value);
/// "RH, RFH, ..."
[[nodiscard]] std::string dimensionNames();

/// Calls `visit(key, value, min, max, comment)` for every setting; keys are dotted, tables in one piece.
template <typename RecipeType, typename Visitor>
void forEachField(RecipeType& recipe, Visitor visit) {
  auto& p = recipe.parameters;
  visit("parameters.rfh_from_axis_mm", p.rfhFromAxisMm, 1, 100, "RFH: distance from the axis, left and right");
  visit("parameters.hf_half_width_mm", p.hfHalfWidthMm, 1, 100,
        "HF: crown compared this far from the axis, left and right");
  visit("parameters.hw_depth_mm", p.hwDepthMm, 1, 100, "HW: depth below the crown");
  visit("parameters.hwa_depth_mm", p.hwaDepthMm, 1, 100, "HWA: the AREMA depth");
  visit("parameters.ft_inside_mm", p.ftInsideMm, 1, 100, "FT: inside the foot edges, left and right");
  visit("parameters.ras_depth_mm", p.rasDepthMm, 1, 100, "RAS: depth below the crown, left and right");
  visit("parameters.wt_height_mm", p.wtHeightMm, 1, 250,
        "WT: height above the base; without it where the web is thinnest");
  visit("parameters.base_inset_mm", p.baseInsetMm, 0, 50, "base line: taken this far inside the foot edges");

  auto& s = recipe.stripe;
  visit("stripe.sigma_px", s.sigma, 1, 8, "sigma: standard deviation of the Gaussian");
  visit("stripe.t_l_dn", s.low, 0.1, 255, "t_l: weaker points are rejected, line contrast in grey values");
  visit("stripe.t_h_dn", s.high, 0.1, 255, "t_h: stronger points are accepted");
  visit("stripe.d_px", s.gapDistance, 0, 10000, "d: longest gap that is bridged");
  visit("stripe.alpha_deg", s.gapAngle, 0, 90, "alpha: largest angle between the pieces that are joined");
  visit("stripe.min_length_points", s.minLength, 3, 100000, "shorter lines are dropped");
  visit("stripe.max_blocks", s.maxBlocks, 1, 65000, "8x8 blocks worked on before a frame counts as overloaded");
  visit("stripe.correction", s.correction, "the pull of bends taken off, smoothed along the line");

  auto& r = recipe.registration;
  visit("registration.start_scale_mm", r.startScaleMm, 0.1, 1000, "robust scale of the first pass without a start");
  visit("registration.track_scale_mm", r.trackScaleMm, 0.1, 1000, "the same with a start");
  visit("registration.inlier_mm", r.inlierMm, 0.001, 10, "a point is an inlier below 3 sigma or this");
  visit("registration.assign_mm", r.assignMm, 0.01, 50, "points further from their primitive are not used");
  visit("registration.max_rms_mm", r.maxRmsMm, 0.001, 50, "registration fails above");
  visit("registration.min_inlier_share", r.minInlierShare, 0, 1, "and below");

  auto& m = recipe.measurement;
  visit("measurement.trim_mm", m.trimMm, 0, 20, "left out at the ends of every primitive");
  visit("measurement.min_points", m.minPoints, 3, 100000, "fewer on a primitive: not measured");
  visit("measurement.expansion_per_k", m.expansionPerK, 0, 1e-4, "values are given at 15 degrees C");
  visit("measurement.max_temperature_c", m.maxTemperatureC, 15, 1500, "above, no cold size is given");
}

}  // namespace vignole
