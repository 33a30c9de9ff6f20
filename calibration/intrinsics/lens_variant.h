#pragma once
// Which parameters of a lens are estimated: the two distortion models of the paper's Table III and what is nested in
// them.

#include <string>
#include <vector>

#include "engine/optics/rig_uncertainty.h"

namespace vignole {

struct LensVariant {
  DistortionModel model = DistortionModel::Polynomial;
  int radial = 0;           ///< polynomial: k1 ... k_radial
  bool tangential = false;  ///< polynomial: p1, p2
  bool aspect = false;      ///< s^y; otherwise pixels are as high as stated

  friend bool operator==(const LensVariant&, const LensVariant&) = default;
};

/// F, U0, V0 and what the variant adds, in the order of CameraParameter.
[[nodiscard]] std::vector<CameraParameter> freeParameters(const LensVariant& variant);
/// "division", "k1", "k1 k2 p1 p2"; with " s_y" behind where that is estimated.
[[nodiscard]] std::string name(const LensVariant& variant);
/// Division, and polynomial {k1} {k1 k2} {k1 k2 k3} {k1 k2 p1 p2} {k1 k2 k3 p1 p2}: from few parameters to many.
[[nodiscard]] std::vector<LensVariant> lensVariants(bool aspect);
/// The same lens as nearly as the variant can say it to first order: where an adjustment starts.
[[nodiscard]] Intrinsics asVariant(const Intrinsics& in, const LensVariant& variant);

}  // namespace vignole
