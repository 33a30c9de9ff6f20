#include "calibration/intrinsics/lens_variant.h"

namespace vignole {

std::vector<CameraParameter> freeParameters(const LensVariant& variant) {
  std::vector<CameraParameter> free = {CameraParameter::F};
  if (variant.aspect) free.push_back(CameraParameter::PixelHeight);
  free.insert(free.end(), {CameraParameter::U0, CameraParameter::V0});
  if (variant.model == DistortionModel::Division) {
    free.push_back(CameraParameter::Kappa);
    return free;
  }
  for (int i = 0; i < variant.radial; ++i)
    free.push_back(static_cast<CameraParameter>(static_cast<int>(CameraParameter::K1) + i));
  if (variant.tangential) free.insert(free.end(), {CameraParameter::P1, CameraParameter::P2});
  return free;
}

std::string name(const LensVariant& variant) {
  std::string text;
  if (variant.model == DistortionModel::Division) text = "division";
  for (int i = 1; i <= variant.radial; ++i) text += (i > 1 ? " k" : "k") + std::to_string(i);
  if (variant.tangential) text += " p1 p2";
  if (variant.aspect) text += " s_y";
  return text;
}

std::vector<LensVariant> lensVariants(bool aspect) {
  constexpr auto kPolynomial = DistortionModel::Polynomial;
  return {{DistortionModel::Division, 0, false, aspect},
          {kPolynomial, 1, false, aspect},
          {kPolynomial, 2, false, aspect},
          {kPolynomial, 3, false, aspect},
          {kPolynomial, 2, true, aspect},
          {kPolynomial, 3, true, aspect}};
}

Intrinsics asVariant(const Intrinsics& in, const LensVariant& variant) {
  Intrinsics out = in;
  out.model = variant.model;
  if (variant.model == DistortionModel::Division) {
    if (in.model == DistortionModel::Polynomial) out.kappa = -in.k1;
    out.k1 = out.k2 = out.k3 = out.p1 = out.p2 = 0;
    return out;
  }
  if (in.model == DistortionModel::Division) {  // 1 / (1 + kappa r^2) as a series
    out.k1 = -in.kappa;
    out.k2 = in.kappa * in.kappa;
    out.k3 = -in.kappa * in.kappa * in.kappa;
    out.p1 = out.p2 = 0;
  }
  out.kappa = 0;
  if (variant.radial < 3) out.k3 = 0;
  if (variant.radial < 2) out.k2 = 0;
  if (variant.radial < 1) out.k1 = 0;
  if (!variant.tangential) out.p1 = out.p2 = 0;
  return out;
}

}  // namespace vignole
