// Many draws: how often the right lens model is chosen, and whether errors are as large as their uncertainties say.

#include <gtest/gtest.h>
#include <map>

#include "calibration/intrinsics/intrinsics_calibration.h"
#include "calibration/intrinsics/reprojection.h"
#include "calibration/parallel_for.h"
#include "tests/calibration/synthetic_target/synthetic_views.h"

namespace vignole {
namespace {

constexpr int kDraws = 100;
constexpr auto kPolynomial = DistortionModel::Polynomial;

struct Truth {
  const char* what;
  Intrinsics camera;
  std::vector<std::string> right;  ///< variants that may be chosen: what others cannot be told from
  double targetErrorMm = 0;
};

Intrinsics polynomial(double k1, double k2, double k3, double p1, double pixelHeightMm = 0.0074) {
  Intrinsics in = usualCamera();
  in.model = kPolynomial;
  in.k1 = k1;
  in.k2 = k2;
  in.k3 = k3;
  in.p1 = p1;
  in.pixelHeightMm = pixelHeightMm;
  return in;
}

Intrinsics division(double kappa) {
  Intrinsics in = usualCamera();
  in.kappa = kappa;
  return in;
}

std::vector<Truth> truths() {
  return {{"a weak division lens", division(-4e-4), {"division", "k1"}},
          {"a strong division lens", division(-4e-3), {"division"}},
          {"k1", polynomial(4e-3, 0, 0, 0), {"k1"}},
          {"k1 k2", polynomial(4e-4, -4e-6, 0, 0), {"k1 k2"}},
          {"k1 k2 k3", polynomial(4e-4, -1e-5, 4e-7, 0), {"k1 k2 k3"}},
          {"a tilted lens", polynomial(4e-4, -4e-6, 0, 0.008 / 16), {"k1 k2 p1 p2"}},
          {"pixels not square", polynomial(4e-4, -4e-6, 0, 0, 0.00743), {"k1 k2 s_y"}},
          {"a target of +-50 um", division(-4e-3), {"division"}, 0.05}};
}

class ManyCameras : public testing::TestWithParam<Truth> {};
INSTANTIATE_TEST_SUITE_P(Truths, ManyCameras, testing::ValuesIn(truths()), [](const auto& tested) {
  std::string text = tested.param.what;
  std::replace_if(
      text.begin(), text.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return text;
});

TEST_P(ManyCameras, ChooseTheModelAndErrAsTheySay) {
  const Truth& truth = GetParam();
  std::map<std::string, int> chosen;
  std::map<CameraParameter, double> squares;
  int right = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    SyntheticSettings settings{.target = chessboard(13, 9, 12), .camera = truth.camera};
    settings.targetErrorMm = truth.targetErrorMm;
    std::mt19937_64 random(std::hash<std::string>{}(truth.what) + static_cast<unsigned>(draw));  // its own views
    IntrinsicsSettings asked;
    asked.openCvReference = false;
    const auto c = calibrateIntrinsics(syntheticViews(settings, random).views, settings.target, asked);
    ASSERT_TRUE(c.has_value());
    EXPECT_TRUE(c->accepted());
    ++chosen[name(c->variant)];
    if (std::find(truth.right.begin(), truth.right.end(), name(c->variant)) == truth.right.end()) continue;
    ++right;
    const IntrinsicVector off = toVector(c->camera.intrinsics) - toVector(truth.camera);
    for (const CameraParameter p : {CameraParameter::F, CameraParameter::U0, CameraParameter::V0})
      squares[p] +=
          std::pow(off[static_cast<int>(p)], 2) / c->camera.covariance(static_cast<int>(p), static_cast<int>(p));
  }
  std::printf("%s: right in %d of %d;", truth.what, right, kDraws);
  for (const auto& [variant, count] : chosen) std::printf(" %s: %d", variant.c_str(), count);
  for (const auto& [p, sum] : squares) std::printf("; %s %.2f", std::string(name(p)).c_str(), sum / right);
  std::printf(" mean (error / u)^2\n");
  EXPECT_GE(right, 95 * kDraws / 100);
  for (const auto& [p, sum] : squares)  // 95 % each, three of them: 99 %
    EXPECT_NEAR(sum / right, 1, 3.3 * std::sqrt(2.0 / right)) << name(p) << ": beyond chance, of 24 such sums";
}

}  // namespace
}  // namespace vignole
