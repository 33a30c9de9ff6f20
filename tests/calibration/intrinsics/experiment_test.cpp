#include <chrono>
#include <cstdio>
#include <map>
#include <gtest/gtest.h>
#include "calibration/intrinsics/information.h"
#include "calibration/intrinsics/model_choice.h"
#include "calibration/intrinsics/robust_fit.h"
#include "tests/calibration/intrinsics/synthetic_views.h"
using namespace vignole;
static double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }
static TargetObservations toObs(const SyntheticViews& s, const PlanarTarget& t) {
  TargetObservations o; o.radiusMm = t.diameterMm / 2;
  for (auto& p : t.points()) o.points.emplace_back(p.x(), p.y(), 0);
  for (auto& v : s.views) { ObservedView w; for (auto& f : v.points) w.push_back({f.index, f.px, f.uPx, f.uPx}); o.views.push_back(w); }
  return o;
}
TEST(Experiment, One) {
  SyntheticSettings s; s.target = chessboard(13, 9, 15); s.camera = usualCamera();
  s.camera.kappa = -4e-4;
  std::mt19937_64 random(1);
  auto views = syntheticViews(s, random);
  auto obs = toObs(views, s.target);
  std::size_t n = 0; for (auto& v : obs.views) n += v.size();
  std::printf("points %zu\n", n);
  Intrinsics like; 
  double t0 = now();
  LensVariant full{DistortionModel::Polynomial, 3, true, true};
  auto r = robustFit(obs, full, like, 0, {}, {});
  double t1 = now();
  std::printf("robust fit %.3f s f %.5f cx %.3f cy %.3f sy %.7f k %.3g %.3g %.3g p %.3g %.3g unexplained %.4f\n", t1 - t0, r->fit.intrinsics.focalMm, r->fit.intrinsics.cxPx, r->fit.intrinsics.cyPx, r->fit.intrinsics.pixelHeightMm,
    r->fit.intrinsics.k1, r->fit.intrinsics.k2, r->fit.intrinsics.k3, r->fit.intrinsics.p1, r->fit.intrinsics.p2, r->unexplainedPx);
  auto variants = lensVariants(true);
  auto used = selected(obs, r->selection); weigh(used, r->unexplainedPx);
  std::vector<TargetFit> fits;
  t0 = now();
  for (auto& v : variants) { auto st = r->fit; st.intrinsics = asVariant(st.intrinsics, v); fits.push_back(adjust(used, v, st)); auto c = informationOf(used, v, fits.back(), 0).covariance(); std::printf("%s conv %d f %.5f u %.5f cx %.3f u %.3f\n", name(v).c_str(), fits.back().converged, fits.back().intrinsics.focalMm, std::sqrt(c(0,0)), fits.back().intrinsics.cxPx, std::sqrt(c(2,2))); }
  t1 = now();
  auto h = crossValidate(used, variants, fits, {}, {});
  double t2 = now();
  for (std::size_t i = 0; i < variants.size(); ++i) { auto d = difference((*h)[i], (*h)[0]); std::printf("%s heldout %.5f diff %.3g se %.3g\n", name(variants[i]).c_str(), (*h)[i].rmsPx, d.mean, d.standardError); }
  std::printf("fits %.3f cv %.3f chosen %zu\n", t1 - t0, t2 - t1, chooseSimplest(variants, *h, 1));
}

static void choice(const char* what, Intrinsics cam, double noise, int nviews, int draws) {
  std::map<std::string, int> c1, c2, c3;
  for (int d = 0; d < draws; ++d) {
    SyntheticSettings s; s.target = chessboard(13, 9, 15); s.camera = cam; s.noisePx = noise; s.views = nviews;
    std::mt19937_64 random(100 + d);
    auto obs = toObs(syntheticViews(s, random), s.target);
    for (auto& v : obs.views) for (auto& o : v) o.sigmaPx = noise;
    auto variants = lensVariants(false);
    TargetFit st; st.intrinsics = cam; st.points = obs.points;
    std::mt19937_64 again(100 + d);
    st.cameraFromTarget = syntheticViews(s, again).cameraFromTarget;
    std::vector<TargetFit> fits(variants.size());
    for (std::size_t i = 0; i < variants.size(); ++i) { auto b = st; b.intrinsics = asVariant(b.intrinsics, variants[i]); fits[i] = adjust(obs, variants[i], b); }
    auto h = crossValidate(obs, variants, fits, {}, {});
    c1[name(variants[chooseSimplest(variants, *h, 1)])]++;
    c2[name(variants[chooseSimplest(variants, *h, 2)])]++;
    c3[name(variants[chooseSimplest(variants, *h, 3)])]++;
  }
  std::printf("%s\n", what);
  for (auto* c : {&c1, &c2, &c3}) { for (auto& [k, v] : *c) std::printf("  %s: %d", k.c_str(), v); std::printf("\n"); }
}
TEST(Experiment, Choice) {
  auto base = usualCamera();
  auto c = base; c.kappa = -4e-4; choice("division -4e-4", c, 0.05, 16, 40);
  c = base; c.kappa = -4e-3; choice("division -4e-3", c, 0.05, 16, 40);
  c = base; c.model = DistortionModel::Polynomial; c.k1 = 4e-4; c.k2 = -4e-6; choice("k1k2", c, 0.05, 16, 40);
  c.k1 = 4e-4; c.k2 = -1e-5; c.k3 = 2e-7; choice("k1k2k3", c, 0.05, 16, 40);
  c.k1 = 4e-4; c.k2 = -4e-6; c.k3 = 0; c.p1 = 0.008 / 16; choice("tilted", c, 0.05, 16, 40);
  c.k1 = 4e-4; c.k2 = 0; c.k3 = 0; c.p1 = 0; choice("k1", c, 0.05, 16, 40);
}
