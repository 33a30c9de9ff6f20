// The bound of the line's place: the closed form under white noise, and reached but never beaten on rendered light.

#include "engine/simulator/line_bound.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "engine/rail/catalogue.h"
#include "engine/simulator/hashing.h"
#include "engine/simulator/light_kernels.h"
#include "engine/simulator/surface.h"

namespace vignole::simulator {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(LineBound, WhiteNoiseGivesTheClosedForm) {
  for (const double sigma : {0.9, 1.5, 3.0})
    for (const double contrast : {20.0, 150.0}) {
      const double noise = 4;
      const double information = informationPerPx({contrast, sigma}, {noise * noise, 0, 0});
      const double oneColumn = noise / contrast * std::sqrt(2 * sigma / std::sqrt(kPi));  // stripe design, section 5
      EXPECT_NEAR(1 / std::sqrt(information), oneColumn, 2e-3 * oneColumn) << sigma;
    }
}

TEST(LineBound, MoreNoiseOrLessLightTellsLess) {
  const PictureNoise noise = pictureNoise({});
  const double usual = informationPerPx({120, 1.4}, noise);
  EXPECT_LT(informationPerPx({60, 1.4}, noise), usual);
  EXPECT_LT(informationPerPx({120, 2}, noise), usual);
  Effects quiet;
  quiet.speckle = 0;
  EXPECT_GT(informationPerPx({120, 1.4}, pictureNoise(quiet)), 10 * usual);
  EXPECT_EQ(informationPerPx({}, noise), 0);
  PictureNoise dark = noise;
  dark.clipDn = 60;  // the middle of the line is clipped
  EXPECT_LT(informationPerPx({120, 1.4}, dark), usual);
  EXPECT_GT(informationPerPx({120, 1.4}, dark), 0);
}

/// A straight stretch of line as the renderer draws it, and its pixels as a vector.
class Patch {
 public:
  Patch(double angleRad, const LineLight& light, const Effects& effects) : light_(light), effects_(effects) {
    normal_ = {std::cos(angleRad), std::sin(angleRad)};
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const Point2 d = Point2(x, y) - kMiddle;
        const double across = d.dot(normal_), along = normal_.x() * d.y() - normal_.y() * d.x();
        if (std::abs(across) > 5 * light.sigmaPx || std::abs(along) > kLength / 2) continue;
        pixels_.push_back({x, y, across});
      }
  }
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(pixels_.size()); }
  /// Light without noise, by the pixel's distance from the line.
  [[nodiscard]] double mean(Eigen::Index i) const { return light_.contrastDn * std::exp(-square(across(i)) / 2); }
  /// Its change as the line moves along its normal by 1 px.
  [[nodiscard]] double slope(Eigen::Index i) const { return mean(i) * across(i) / light_.sigmaPx; }
  [[nodiscard]] double acrossPx(Eigen::Index i) const { return pixels_[static_cast<std::size_t>(i)].across; }

  [[nodiscard]] Eigen::MatrixXd covariance() const {
    const std::vector<double> correlation = speckleCorrelation();
    const auto along = [&](int lag) {
      const auto l = static_cast<std::size_t>(std::abs(lag));
      return l < correlation.size() ? correlation[l] : 0.0;
    };
    const PictureNoise noise = pictureNoise(effects_);
    Eigen::MatrixXd c(size(), size());
    for (Eigen::Index i = 0; i < size(); ++i)
      for (Eigen::Index j = 0; j < size(); ++j) {
        const Pixel &a = pixels_[static_cast<std::size_t>(i)], &b = pixels_[static_cast<std::size_t>(j)];
        c(i, j) = square(noise.speckle) * mean(i) * mean(j) * along(a.x - b.x) * along(a.y - b.y);
        if (i == j) c(i, j) += noise.groundDn2 + noise.shotPerDn * mean(i);
      }
    return c;
  }

  /// The picture's pixels less the ambient light.
  [[nodiscard]] Eigen::VectorXd render(std::uint64_t key, const std::vector<float>& speckle,
                                       const std::vector<float>& normals) const {
    static Canvas canvas(kSize, kSize);
    SplatKernel kernel;
    kernel.a = kernel.c = static_cast<float>(1 / square(light_.sigmaPx));
    kernel.scale = static_cast<float>(1 / (2 * kPi * square(light_.sigmaPx)));
    kernel.bend = std::exp(-kernel.c);
    kernel.halfWidth = 16;
    kernel.halfHeight = 16;
    const double perPx = light_.contrastDn * std::sqrt(2 * kPi) * light_.sigmaPx, step = 0.25;
    std::vector<Splat> splats;
    for (double t = -kLength / 2 - 10; t <= kLength / 2 + 10; t += step) {
      const Point2 at = kMiddle + t * Point2(-normal_.y(), normal_.x());
      splats.push_back({static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(perPx * step), 0});
    }
    canvas.add(splats, {kernel});
    DevelopSettings settings;
    settings.ambientDn = static_cast<float>(effects_.ambientDn);
    settings.readVariance = static_cast<float>(square(effects_.readNoiseDn));
    settings.shotPerDn = static_cast<float>(pictureNoise(effects_).shotPerDn);
    settings.speckle = speckle.data();
    settings.normals = normals.data();
    settings.normalCount = static_cast<std::uint32_t>(normals.size());
    settings.key = key;
    std::vector<std::uint8_t> picture(kSize * kSize);
    develop(canvas, settings, {picture.data(), kSize, kSize, kSize});
    Eigen::VectorXd values(size());
    for (Eigen::Index i = 0; i < size(); ++i) {
      const Pixel& p = pixels_[static_cast<std::size_t>(i)];
      values(i) = picture[static_cast<std::size_t>(p.y * kSize + p.x)] - effects_.ambientDn;
    }
    return values;
  }

  static constexpr double kLength = 50;

 private:
  struct Pixel {
    int x, y;
    double across;
  };
  static constexpr int kSize = 96;
  static double square(double v) { return v * v; }
  [[nodiscard]] double across(Eigen::Index i) const { return acrossPx(i) / light_.sigmaPx; }
  static inline const Point2 kMiddle{47.3, 47.8};
  LineLight light_;
  Effects effects_;
  Point2 normal_;
  std::vector<Pixel> pixels_;
};

/// Estimates the shift linearly about the truth, with such weights that a shift of 1 px gives 1.
Eigen::VectorXd normalised(Eigen::VectorXd weights, const Eigen::VectorXd& slope) {
  weights /= weights.dot(slope);
  return weights;
}

TEST(LineBound, IsReachedByTheBestEstimatorOnRenderedLightAndBeatenByNoFilter) {
  constexpr int kFields = 8, kFrames = 250;  // a field of speckle holds some 300 independent patches
  const Effects effects;
  std::vector<float> normals(1U << 18);
  Draws draws(3, Stream::NoiseBank);
  for (float& n : normals) n = static_cast<float>(draws.normal());
  for (const double angleDeg : {0.0, 20.0, 45.0}) {
    const LineLight light{120, 1.3};
    const Patch patch(angleDeg * kPi / 180, light, effects);
    Eigen::VectorXd mean(patch.size()), slope(patch.size());
    for (Eigen::Index i = 0; i < patch.size(); ++i) mean(i) = patch.mean(i), slope(i) = patch.slope(i);
    std::vector<Eigen::VectorXd> estimators = {normalised(patch.covariance().llt().solve(slope), slope)};
    for (const double sigma : {1.0, 2.0, 3.0}) {  // the derivative of a Gaussian
      Eigen::VectorXd weights(patch.size());
      for (Eigen::Index i = 0; i < patch.size(); ++i) {
        const double d = patch.acrossPx(i);
        weights(i) = d * std::exp(-d * d / (2 * sigma * sigma));
      }
      estimators.push_back(normalised(weights, slope));
    }
    std::vector<double> squares(estimators.size(), 0.0);
    double sum = 0;
    for (std::uint64_t field = 0; field < kFields; ++field) {
      const std::vector<float> speckle = speckleField(100 + field, effects.speckle);
      for (std::uint64_t frame = 0; frame < kFrames; ++frame) {
        const Eigen::VectorXd error = patch.render(mix(1000 * field + frame), speckle, normals) - mean;
        sum += estimators.front().dot(error);
        for (std::size_t e = 0; e < estimators.size(); ++e) squares[e] += std::pow(estimators[e].dot(error), 2);
      }
    }
    const double bound = 1 / std::sqrt(Patch::kLength * informationPerPx(light, pictureNoise(effects)));
    const auto rms = [&](std::size_t e) { return std::sqrt(squares[e] / (kFields * kFrames)); };
    EXPECT_NEAR(rms(0), bound, 0.1 * bound) << angleDeg;
    EXPECT_NEAR(sum / (kFields * kFrames), 0, 0.1 * bound) << angleDeg;
    for (std::size_t e = 1; e < estimators.size(); ++e) EXPECT_GT(rms(e), 1.1 * rms(0)) << angleDeg << " " << e;
  }
}

TEST(RenderedLines, TheLightThatIsReadMakesThePicture) {
  VirtualRigSettings settings;
  settings.section = *findSection("60E1");
  settings.parameters = settings.section.parameters;
  const auto lines = RenderedLines::create(settings);
  ASSERT_TRUE(lines.has_value());
  settings.effects.readNoiseDn = settings.effects.shotNoise = settings.effects.speckle = settings.effects.reflections =
      0;
  const auto rig = VirtualRig::create(settings);
  ASSERT_TRUE(rig.has_value());
  constexpr int kWidth = 1400, kHeight = 1024;
  std::vector<std::uint8_t> picture(kWidth * kHeight);
  for (int camera = 0; camera < kCameraCount; ++camera) {
    (*rig)->render(camera, 7, {picture.data(), kWidth, kHeight, kWidth});
    double lengthPx = 0;
    int looked = 0, close = 0;
    for (const auto& line : lines->at(camera, 7))
      for (std::size_t i = 0; i < line.size(); ++i) {
        const LinePlace& place = line[i];
        lengthPx += place.lengthPx;
        if (i < 12 || i + 12 > line.size()) continue;  // the light fades at the ends
        EXPECT_NEAR(place.normal.norm(), 1, 1e-9);
        const auto x = std::lround(place.px.x() + place.normal.x()), y = std::lround(place.px.y() + place.normal.y());
        const double d = (Point2(static_cast<double>(x), static_cast<double>(y)) - place.px).dot(place.normal);
        const double expected =
            settings.effects.ambientDn +
            place.light.contrastDn * std::exp(-d * d / (2 * place.light.sigmaPx * place.light.sigmaPx));
        const double seen = picture[static_cast<std::size_t>(y * kWidth + x)];
        ++looked;
        close += std::abs(seen - std::min(255.0, expected)) < 2 + 0.03 * expected;
      }
    EXPECT_GT(lengthPx, 900) << camera;
    EXPECT_LT(lengthPx, 1700) << camera;
    EXPECT_GT(close, 0.97 * looked) << camera;
  }
}

}  // namespace
}  // namespace vignole::simulator
