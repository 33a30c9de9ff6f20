#include "engine/registration/pose_kernels.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "engine/rail/catalogue.h"
#include "engine/registration/carrier.h"

namespace vignole {
namespace {

/// 60E1 with points near it, primitive by primitive: between none and 40 on each.
struct Scene {
  Scene() {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> share(0, 1), off(-1.5, 1.5);
    std::uniform_int_distribution<std::uint32_t> number(0, 40);
    for (std::uint32_t k = 0; k < section.primitives.size(); ++k) {
      const Primitive& shape = section.primitives[k].shape;
      carriers.push_back(Carrier::of(shape).flat());
      const auto from = static_cast<std::uint32_t>(x.size());
      for (std::uint32_t i = number(random); i > 0; --i) {
        const double s = share(random) * length(shape);
        const Point2 p = pointAt(shape, s) + off(random) * normalAt(shape, s);
        x.push_back(static_cast<float>(p.x()));
        y.push_back(static_cast<float>(p.y()));
        sigma.push_back(0.02F + 0.02F * static_cast<float>(share(random)));
        home.push_back(static_cast<std::int32_t>(k));
      }
      runs.push_back({k, from, static_cast<std::uint32_t>(x.size())});
    }
    count = x.size();
    for (auto* v : {&x, &y, &sigma}) v->resize(count + kSlack);
    home.resize(count + kSlack);
  }
  [[nodiscard]] Points points() const { return {x.data(), y.data(), count}; }

  Section section = findSection("60E1").value();
  std::vector<FlatCarrier> carriers;
  std::vector<float> x, y, sigma;
  std::vector<std::int32_t> home;
  std::vector<Run> runs;
  std::size_t count = 0;
  Motion motion{std::cos(0.01F), std::sin(0.01F), 0.4F, -0.3F};
  Tukey tukey{86, 2.5F};
};

struct Foot {
  double x, y, nx, ny, residual;
};
Foot footOf(const Scene& scene, std::size_t i) {
  const Motion& m = scene.motion;
  const double c = static_cast<double>(m.cosine), s = static_cast<double>(m.sine);
  const double px = static_cast<double>(scene.x[i]), py = static_cast<double>(scene.y[i]);
  const Point2 p(c * px - s * py + static_cast<double>(m.x), s * px + c * py + static_cast<double>(m.y));
  const Primitive& shape = scene.section.primitives[static_cast<std::size_t>(scene.home[i])].shape;
  if (const auto* arc = std::get_if<Arc>(&shape)) {
    const double side = arc->sweepRad > 0 ? 1 : -1;
    const Point2 d = p - arc->centre;
    return {p.x(), p.y(), side * d.x() / d.norm(), side * d.y() / d.norm(), side * (d.norm() - arc->radiusMm)};
  }
  const Point2 n = normalAt(shape, 0);
  return {p.x(), p.y(), n.x(), n.y(), n.dot(p - startPoint(shape))};
}

TEST(PoseKernels, SumAsPlainArithmeticDoes) {
  const Scene scene;
  NormalEquations plain, scattered, runs;
  double cost = 0;
  for (std::size_t i = 0; i < scene.count; ++i) {
    const Foot f = footOf(scene, i);
    const double scale = static_cast<double>(scene.tukey.scaleMm), r = f.residual;
    const double u = std::max(0.0, 1 - r * r / (scale * scale)), w = u * u;
    const double turn = f.x * f.ny - (f.y - static_cast<double>(scene.tukey.centreY)) * f.nx;
    plain.xx += w * f.nx * f.nx;
    plain.xy += w * f.nx * f.ny;
    plain.xa += w * f.nx * turn;
    plain.yy += w * f.ny * f.ny;
    plain.ya += w * f.ny * turn;
    plain.aa += w * turn * turn;
    plain.bx += w * f.nx * r;
    plain.by += w * f.ny * r;
    plain.ba += w * turn * r;
    plain.weight += w;
    plain.weightedSquares += w * r * r;
    cost += std::min(1.0, r * r);
  }
  const double scatteredCost =
      sumScattered(scene.points(), scene.motion, scene.carriers.data(), scene.home.data(), scene.tukey, scattered);
  EXPECT_NEAR(scatteredCost, cost, 1e-3 * cost);
  sumRuns(scene.points(), scene.motion, scene.carriers.data(), scene.runs, scene.tukey, runs);
  for (const NormalEquations& e : {scattered, runs}) {
    EXPECT_NEAR(e.weight, plain.weight, 1e-4 * plain.weight);
    EXPECT_NEAR(e.weightedSquares, plain.weightedSquares, 1e-4 * plain.weightedSquares);
    EXPECT_LT((e.matrix() - plain.matrix()).norm(), 1e-4 * plain.matrix().norm());
    EXPECT_NEAR(e.bx, plain.bx, 1e-2);
    EXPECT_NEAR(e.by, plain.by, 1e-2);
    EXPECT_NEAR(e.ba, plain.ba, 0.5);
    Eigen::Vector3d step, wanted;
    ASSERT_TRUE(e.solve(step) && plain.solve(wanted));
    EXPECT_LT((step - wanted).norm(), 1e-4);
  }
}

TEST(PoseKernels, FarPointsCostTheirFull) {
  Scene scene;
  NormalEquations e;
  for (std::int32_t& k : scene.home) k += kFarAway;
  EXPECT_DOUBLE_EQ(sumScattered(scene.points(), scene.motion, scene.carriers.data(), scene.home.data(), scene.tukey, e),
                   static_cast<double>(scene.count));
}

TEST(PoseKernels, ResidualsAndTheirSums) {
  const Scene scene;
  std::vector<float> residual(scene.count + kSlack);
  const ResidualLimits limits{1.2F, 0.1F, 0.5F};
  for (const auto& run : scene.runs) {
    const RunResiduals of = residualsOf(scene.points(), scene.sigma.data(), scene.motion, scene.carriers[run.primitive],
                                        run, limits, residual.data());
    double assigned = 0, sum = 0, chi2 = 0, near = 0, inliers = 0;
    for (std::uint32_t i = run.from; i < run.to; ++i) {
      const double r = footOf(scene, i).residual, sigma = static_cast<double>(scene.sigma[i]);
      EXPECT_NEAR(static_cast<double>(residual[i]), r, 1e-4);
      if (std::abs(residual[i]) > limits.assignMm) continue;
      ++assigned;
      sum += r;
      chi2 += r * r / (sigma * sigma);
      near += std::abs(residual[i]) < limits.nearMm ? 1 : 0;
      inliers += std::abs(residual[i]) < std::max(3 * scene.sigma[i], limits.inlierMm) ? 1 : 0;
    }
    EXPECT_EQ(of.assigned, assigned);
    EXPECT_EQ(of.near, near);
    EXPECT_EQ(of.inliers, inliers);
    EXPECT_NEAR(of.sum, sum, 1e-2);
    EXPECT_NEAR(of.chi2, chi2, 0.01 * chi2 + 0.1);
  }
}

}  // namespace
}  // namespace vignole
