#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#include <gtest/gtest.h>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <map>
#include "calibration/range_finders/arc_adjustment.h"
#include "tests/calibration/range_finders/virtual_campaign.h"
namespace vignole {
double env(const char* name, double other) { const char* v = std::getenv(name); return v ? std::atof(v) : other; }
std::array<CameraLight, 4> startLights(const RigState& s) {
  std::array<CameraLight, 4> l;
  for (std::size_t c = 0; c < 4; ++c) {
    Eigen::Vector3d cam = -(s.finders[c].cameraFromWorld.rotation.transpose() * s.finders[c].cameraFromWorld.translationMm);
    Point2 d = (Point2(cam.head<2>()) - Point2(0, 86)).normalized();
    l[c].laserMm = Point2(0, 86) + 480 * d;
  }
  for (std::size_t c = 0; c < 4; ++c) for (std::size_t k = 0, o = 0; k < 4; ++k) if (k != c) l[c].othersMm[o++] = l[k].laserMm;

  return l;
}
void l_at(CameraLight& l, double az) { l.laserMm = Point2(0, 86) + 480 * Point2(std::cos(az * M_PI / 180), std::sin(az * M_PI / 180)); }
TEST(Scratch, Pull) {
  CampaignSettings cs;
  cs.seed = static_cast<std::uint64_t>(env("SEED", 3)); cs.rigSeed = cs.seed;
  cs.plateErrorMm = 0; cs.noisePx = env("NOISE", 0); cs.intrinsicsErr = false; cs.placements = 2;
  cs.lines.stripe.sigma = env("SIGMA", 1.8);
  Campaign camp = renderCampaign(cs);
  associateByTruth(camp);
  RigState s;
  s.finders = camp.plate->calibration().rangeFinders;
  s.pins = camp.plate->truePlate().pins;
  for (const auto& p : camp.plate->settings().placements) s.worldFromPlate.push_back(p.worldFromPlate);
  auto lights = startLights(s);
  RigAdjustmentSettings set;
  set.endMarginSigmas = env("MARGIN", 2);
  set.leastLight = env("LL", 0.3);
  std::vector<int> cams{0, 1, 2, 3};
  auto arcs = observations(camp.inputs, cams);
  for (int k = 0; k < 4; ++k) { predict(s, lights, set, 1, arcs); refineLights(s, arcs, lights); }
  if (env("TRUEBLUR", 0) > 0) for (auto& l : lights) { l.blurPx2 = {0.186, 0, 0.36}; l.thicknessMm2 = 0.1225 * env("TSCALE", 1); }
  if (env("TRUELASER", 0) > 0) for (std::size_t c = 0; c < 4; ++c) { const double az[4] = {140, 40, -35, -145}; l_at(lights[c], az[c]); }
  predict(s, lights, set, 1, arcs);
  for (auto& l : lights) std::cout << "blur " << l.blurPx2.transpose() << " t " << std::sqrt(l.thicknessMm2) << " share " << l.otherShare << " laser " << l.laserMm.transpose() << " u " << l.uBlurPx2 << " " << l.uThicknessMm2 << "\n";
  double sp = 0, sr = 0, sp2 = 0, sr2 = 0, sw = 0, sw2=0; int n = 0, nw = 0;
  int narc=0; double worstarc=0;
  std::vector<double> nf2(4, 0); std::vector<int> nn(4,0);
  for (auto& a : arcs) {
    double m = 0; int k = 0; double mp=0;
    for (std::size_t i = 0; i < a.inside.size(); ++i) if (a.inside[i]) {
      double p = a.pullMm[i] / a.mmPerPx[i], r = a.residualPx[i];
      sp += p; sp2 += p * p; sr += r; sr2 += r * r; ++n; m += r; mp+=p; ++k;
      nf2[a.camera] += std::pow(r / a.sigmaPx[i], 2); nn[a.camera]++;
      if (std::isfinite(a.widthMisfit[i])) { sw += a.widthMisfit[i]; sw2 += a.widthMisfit[i]*a.widthMisfit[i]; ++nw; }
      if (env("DUMP", -1) == narc) std::cout << i << " arcpx " << a.arcPx[i] << " ang " << a.angleRad[i] << " pull " << p << " res " << r << " sig " << a.sigmaPx[i] << " w " << a.widthMisfit[i] << " l " << a.lightMisfit[i] << " fl " << int(a.line->points[i].flags) << "\n";
    }
    if (env("ARCS", 0) > 0) std::cout << narc << " cam " << a.camera << " pl " << a.placement << " pin " << s.pins[a.pin].number << " pts " << a.inside.size() << " used " << k << " arc " << a.arcRad * 57.3 << " meanpull " << (k ? mp / k : 0) << " meanres " << (k ? m / k : 0) << "\n";
    ++narc;
    if (k) worstarc = std::max(worstarc, std::abs(m / k));
  }
  if (env("PSI", 0) > 0) {
    std::map<int, std::array<double, 4>> bins;
    for (auto& a : arcs) for (std::size_t i = 0; i < a.inside.size(); ++i) if (a.inside[i]) {
      const Eigen::Vector3d cam = -(s.finders[a.camera].cameraFromWorld.rotation.transpose() * s.finders[a.camera].cameraFromWorld.translationMm);
      const Point2 d = Point2(cam.head<2>()) - s.worldFromPlate[a.placement] * s.pins[a.pin].centreMm;
      const double psi = std::remainder(a.angleRad[i] - std::atan2(d.y(), d.x()), 2 * M_PI) * 57.3;
      auto& b = bins[a.camera * 100 + static_cast<int>((psi + 90) / 10)]; b[0] += 1; b[1] += a.residualPx[i]; b[2] += a.residualPx[i] * a.residualPx[i]; b[3] += a.lightMisfit[i];
    }
    for (auto& [k, b] : bins) std::cout << "psi cam " << k / 100 << " " << (k % 100) * 10 - 85 << " n " << b[0] << " mean " << b[1] / b[0] << " rms " << std::sqrt(b[2] / b[0]) << " light " << b[3]/b[0] << "\n";
  }
  if (env("WIDTH", 0) > 0) {
    std::map<int, std::array<double, 4>> bins, far;
    for (auto& a : arcs) for (std::size_t i = 0; i < a.inside.size(); ++i) if (a.inside[i] && std::isfinite(a.widthMisfit[i]) && std::min(a.arcPx[i], a.arcPx.back() - a.arcPx[i]) > 8) {
      const double across = a.offPlanePx.dot(a.line->points[i].normal);
      auto& b = bins[static_cast<int>(across * across)]; b[0] += 1; b[1] += a.widthMisfit[i]; b[2] += a.widthMisfit[i] * a.widthMisfit[i]; b[3]+= across*across;
      const Point2 from = a.line->points[i].px - Point2(699.5, 511.5);
      if (across*across > 10) { auto& f = far[static_cast<int>(from.norm() / 100)]; f[0] += 1; f[1] += a.widthMisfit[i]; f[3] += a.widthMisfit[i] / (across*across); }
    }
    for (auto& [k, b] : bins) std::cout << "width at jn2 " << b[3]/b[0] << " n " << b[0] << " mean " << b[1] / b[0] << " rms " << std::sqrt(b[2] / b[0]) << "\n";
    for (auto& [k, b] : far) std::cout << "width at r " << k * 100 << " n " << b[0] << " mean " << b[1] / b[0] << " per jn2 " << b[3]/b[0] << "\n";
  }
  if (env("ENDS", 0) > 0) {
    std::map<int, std::array<double, 4>> bins;
    for (auto& a : arcs) for (std::size_t i = 0; i < a.inside.size(); ++i) if (a.inside[i]) {
      const double len = a.arcPx.back();
      const bool first = a.arcPx[i] < len - a.arcPx[i];
      const double edge = std::min(a.arcPx[i], len - a.arcPx[i]);
      const std::size_t e = first ? 0 : a.inside.size() - 1;
      const double lightEnd = a.line->points[e].lightDn, lightMid = a.line->points[a.inside.size() / 2].lightDn;
      const Point2 along(-a.line->points[e].normal.y(), a.line->points[e].normal.x());
      const double sm = std::sqrt(a.filterPx2 + 0.25 + 0.1225 * std::pow(a.offPlanePx.dot(along), 2));
      const int bin = static_cast<int>(4 * edge / sm) + (lightEnd > 0.25 * lightMid ? 1000 : 0);
      auto& b = bins[bin]; b[0] += 1; b[1] += a.residualPx[i]; b[2] += a.residualPx[i] * a.residualPx[i]; b[3] += a.pullMm[i] / a.mmPerPx[i];
    }
    for (auto& [k, b] : bins) if (k % 1000 < 24) std::cout << (k >= 1000 ? "shadow " : "natural ") << (k % 1000) / 4. << " n " << b[0] << " mean " << b[1] / b[0] << " rms " << std::sqrt(b[2] / b[0]) << " pull " << b[3]/b[0] << "\n";
  }
  std::cout << "points " << n << " pull mean " << sp / n << " rms " << std::sqrt(sp2 / n) << " residual mean " << sr / n << " rms " << std::sqrt(sr2 / n) << " worst arc " << worstarc << " left " << std::sqrt(sr2 / sp2) * 100 << " % mean " << sr/sp*100 << " width misfit " << sw/nw << " rms " << std::sqrt(sw2/nw) << "\n";
  { double a=0,b=0,u=0,g=0,gw=0; int q=0; for (auto& x : arcs) for (std::size_t i = 0; i < x.inside.size(); ++i) if (x.inside[i]) { const double w=1/(x.sigmaPx[i]*x.sigmaPx[i]); a+=w*x.residualPx[i]; b+=w; u+=x.residualPx[i]; ++q; const double wr = x.weight[i]; g += wr*w*x.residualPx[i]; gw += wr*w; }
    std::cout << "MEAN unweighted " << u/q << " weighted " << a/b << " robust " << g/gw << " blur " << lights[0].blurAt(400) << " " << lights[1].blurAt(400) << " t2 " << lights[0].thicknessMm2 << "\n"; }
  for (int c = 0; c < 4; ++c) std::cout << "nf " << std::sqrt(nf2[c]/nn[c]) << " ";
  std::cout << "\n";
}
}
#include "engine/systematic/calibration_error.h"
#include "engine/rail/catalogue.h"
namespace vignole {
TEST(Scratch, Campaign) {
  const int n = static_cast<int>(env("N", 3));
  const char* mt = std::getenv("METHOD");
  RigAdjustmentSettings set;
  set.endMarginSigmas = env("MARGIN", 2);
  set.leastLight = env("LL", 0.3);
  set.maxRounds = static_cast<int>(env("ROUNDS", 6));
  if (mt && std::string(mt) == "per-camera") set.method = RigMethod::PerCamera;
  if (env("INTR", 0) == 1) set.intrinsics = IntrinsicsUse::Held;
  if (env("INTR", 0) == 2) set.intrinsics = IntrinsicsUse::Freed;
  const auto section = *findSection("60E1");
  const std::vector<std::pair<Dimension, const char*>> dims{{Dimension::HW, "HW"}, {Dimension::FW, "FW"}, {Dimension::RH, "RH"}, {Dimension::WT, "WT"}, {Dimension::FTl, "FTl"}, {Dimension::FTr, "FTr"}, {Dimension::RASl, "RASl"}, {Dimension::RASr, "RASr"}, {Dimension::FC, "FC"}};
  std::vector<double> sum(dims.size()), sum2(dims.size()), u2(dims.size()), z2(dims.size());
  double cd = 0, rd = 0, pd = 0; double rep = 0, secs = 0, noise[4] = {};
  for (int k = 0; k < n; ++k) {
    CampaignSettings cs;
    cs.seed = static_cast<std::uint64_t>(env("SEED", 100)) + k; cs.rigSeed = env("RIG", 0) > 0 ? static_cast<std::uint64_t>(env("RIG", 0)) : cs.seed;
    cs.plateErrorMm = env("PLATE", 0.05); cs.noisePx = env("NOISE", 0.1); cs.intrinsicsErr = env("EXACT", 0) == 0; cs.placements = static_cast<int>(env("PLACEMENTS", 4));
    cs.lines.stripe.sigma = env("SIGMA", 1.8);
    Campaign camp = renderCampaign(cs);
    associateByTruth(camp);
    auto t0 = std::chrono::steady_clock::now();
    auto adj = adjustRig(camp.inputs, set, Job{});
    secs += std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
    if (!adj) { std::cout << adj.error().message() << "\n"; continue; }
    for (auto& r : adj->refusals) std::cout << r << "\n";
    auto before = SectionBeforeRig::create(section, section.parameters, camp.plate->calibration());
    if (!before) { std::cout << before.error().message(); return; }
    auto v0 = before->measuredBy(camp.plate->calibration()), v1 = before->measuredBy(adj->calibration);
    auto jac = dimensionJacobian(section, section.parameters, adj->calibration);
    std::cout << cs.seed << " ";
    for (std::size_t d = 0; d < dims.size(); ++d) {
      const double e = 1000 * (v1->mm[index(dims[d].first)] - v0->mm[index(dims[d].first)]);
      const Eigen::VectorXd row = jac->row(static_cast<int>(index(dims[d].first)));
      if (env("LIN", 0) > 0) std::cout << "[lin " << std::round(1e4 * row.dot(errorOf(adj->calibration, camp.plate->calibration()))) / 10 << "] ";
      const double var = 1e6 * row.dot(adj->calibration.covariance * row);
      sum[d] += e; sum2[d] += e * e; u2[d] += var; z2[d] += e * e / var;
      std::cout << dims[d].second << " " << std::round(e * 10) / 10 << "(" << std::round(std::sqrt(var) * 10) / 10 << ") ";
    }
    double c = 0, r = 0, p = 0;
    for (int i = 0; i < 4; ++i) { auto& f = adj->finders[i]; c += f.cd.mean / 4; r += f.rd.mean / 4; p += f.pd.mean / 4; rep += f.reprojectionPx / 4; noise[i] += f.noisePx / f.expectedNoisePx; }
    std::cout << " cd " << c << " rd " << r << " pd " << p << " freed " << adj->intrinsicsFreed << " rep " << adj->finders[0].reprojectionPx << " noise " << adj->finders[0].noisePx << "/" << adj->finders[0].expectedNoisePx << " corr " << adj->finders[1].correlatedPoints << " nc " << adj->finders[0].correlatedPoints << " blur " << adj->calibration.rangeFinders[0].blurPx << " th " << adj->calibration.rangeFinders[0].lightPlane.thicknessMm << "\n";
    if (env("PINS", 0) > 0) for (auto& v : adj->pins) if (!v.used || v.cdMm > 0.15) std::cout << "   pin " << v.pin << " cam " << v.camera << " pl " << v.placement << " " << v.reason << " arc " << v.arcDeg << " pts " << v.points << " cd " << v.cdMm << " rd " << v.rdMm << "\n";
    cd += c; rd += r; pd += p;
  }
  for (std::size_t d = 0; d < dims.size(); ++d) std::cout << dims[d].second << ": mean " << sum[d] / n << " rms " << std::sqrt(sum2[d] / n) << " u " << std::sqrt(u2[d] / n) << " chi2/n " << z2[d] / n << "\n";
  std::cout << "CD " << cd / n << " RD " << rd / n << " PD " << pd / n << " rep " << rep / n << " s " << secs / n << " noise factors " << noise[0]/n << " " << noise[1]/n << " " << noise[2]/n << " " << noise[3]/n << "\n";
}
}

namespace vignole {
TEST(Scratch, Bias) {
  std::map<int, std::array<double, 2>> corr; double corr0 = 0, corrn = 0, vf = 0, blockVar = 0, blockExp = 0; int blocks = 0;
  std::map<int, std::array<double, 5>> byEnd, byAngle, byPin, byStrength;
  const int n = static_cast<int>(env("N", 10));
  for (int k = 0; k < n; ++k) {
  CampaignSettings cs;
  cs.seed = static_cast<std::uint64_t>(env("SEED", 3)) + k; cs.rigSeed = static_cast<std::uint64_t>(env("RIG", 5));
  cs.plateErrorMm = 0; cs.noisePx = env("NOISE", 0.1); cs.intrinsicsErr = false; cs.placements = 1;
  cs.lines.stripe.sigma = env("SIGMA", 1.8);
  Campaign camp = renderCampaign(cs);
  associateByTruth(camp);
  RigState s;
  s.finders = camp.plate->calibration().rangeFinders;
  s.pins = camp.plate->truePlate().pins;
  for (const auto& p : camp.plate->settings().placements) s.worldFromPlate.push_back(p.worldFromPlate);
  auto lights = startLights(s);
  RigAdjustmentSettings set;
  set.endMarginSigmas = env("MARGIN", 2);
  set.leastLight = env("LL", 0.3);
  std::vector<int> cams{0, 1, 2, 3};
  auto arcs = observations(camp.inputs, cams);
  for (int r = 0; r < 4; ++r) { predict(s, lights, set, 1, arcs); refineLights(s, arcs, lights); }
  predict(s, lights, set, 1, arcs);
  for (auto& a : arcs) {
    vf = a.filterPx2;
    double m = 0, e = 0, nn = 0;
    for (std::size_t i = 0; i < a.inside.size(); ++i) if (a.inside[i]) {
      corr0 += std::pow(a.residualPx[i] / a.sigmaPx[i], 2); corrn += 1; m += a.residualPx[i] / a.sigmaPx[i]; ++nn;
      for (std::size_t j = 0; j < a.inside.size(); ++j) if (a.inside[j]) {
        e += std::exp(-std::pow(a.arcPx[j] - a.arcPx[i], 2) / (4 * vf));
        if (j > i) { auto& b = corr[static_cast<int>(2 * (a.arcPx[j] - a.arcPx[i]))]; b[0] += 1; b[1] += a.residualPx[i] * a.residualPx[j] / a.sigmaPx[i] / a.sigmaPx[j]; }
      }
    }
    if (nn > 15) { blockVar += m * m / e; blockExp += 1; ++blocks; }
  }
  for (auto& a : arcs) for (std::size_t i = 0; i < a.inside.size(); ++i) if (a.inside[i]) {
      const double len = a.arcPx.back();
      const double edge = std::min(a.arcPx[i], len - a.arcPx[i]);
      const bool first = a.arcPx[i] < len - a.arcPx[i];
      const double frac = a.arcPx[i] / len;
      const double r = a.residualPx[i], w = 1 / (a.sigmaPx[i] * a.sigmaPx[i]);
      auto add = [&](auto& m, int key) { auto& b = m[key]; b[0] += 1; b[1] += r; b[2] += r * r; b[3] += w; b[4] += w * r; };
      add(byEnd, static_cast<int>(edge) * 2 + (first ? 1 : 0));
      add(byAngle, a.camera * 100 + static_cast<int>(10 * frac));
      add(byPin, a.camera * 100 + s.pins[a.pin].number);
      add(byStrength, static_cast<int>(a.line->points[i].lightDn / 8) + ((a.line->points[i].flags & kSaturated) ? 1000 : 0));
  }
  }
  for (auto& [k, b] : corr) std::cout << "corr " << (k + 0.5) / 2 << " " << b[1] / corr0 * corrn / b[0] << " theory " << std::exp(-std::pow((k + 0.5) / 2, 2) / (4 * vf)) << "\n";
  std::cout << "block " << blockVar / blocks << " expected " << blockExp / blocks << "\n";
  auto show = [&](const char* what, auto& m) { for (auto& [k, b] : m) std::cout << what << " " << k << " n " << b[0] << " mean " << b[1] / b[0] << " +- " << std::sqrt(b[2] / b[0]) / std::sqrt(b[0] / 6) << " rms " << std::sqrt(b[2] / b[0]) << " weighted " << b[4] / b[3] << "\n"; };
  show("end", byEnd); show("frac", byAngle); show("pin", byPin); show("light", byStrength);
}
}

#include <random>
#include <Eigen/Geometry>
#include "calibration/range_finders/association.h"
#include "engine/optics/nominal_rig.h"
namespace vignole {
TEST(Scratch, Associate) {
  std::mt19937_64 rng(7);
  std::normal_distribution<double> g;
  std::uniform_real_distribution<double> u(0, 1);
  int images = 0, right = 0, refused = 0, wrongImages = 0; double secs = 0;
  std::map<std::string, int> reasons;
  for (int k = 0; k < static_cast<int>(env("N", 6)); ++k) {
    CampaignSettings cs; cs.seed = 500 + k; cs.rigSeed = 900 + k; cs.placements = static_cast<int>(env("PLACEMENTS", 4)); cs.noisePx = env("NOISE", 0.1); cs.spurious = static_cast<int>(env("SPUR", 2));
    cs.turnDeg = env("TURN", 3) * g(rng); cs.shiftMm = env("SHIFT", 5);
    Campaign truth = renderCampaign(cs);
    associateByTruth(truth);
    for (int rep = 0; rep < static_cast<int>(env("REP", 4)); ++rep) {
      RigInputs in = truth.inputs;
      for (auto& pl : in.placements) for (auto& pic : pl.pictures) {
        std::vector<PinArc> kept;
        for (auto& a : pic.arcs) if (u(rng) > env("MISS", 0.25)) kept.push_back(a);
        pic.arcs = kept;
      }
      const RigInputs want = in;
      AssociationSettings as;
      as.useDrawing = env("DRAWING", 1) > 0;
      for (auto& f : as.drawing.rangeFinders) {
        const double rot = env("ROT", 2) * M_PI / 180, mm = env("MM", 10), roll = env("ROLL", 0) * M_PI / 180;
        Eigen::Vector3d w(rot * g(rng), rot * g(rng), rot * g(rng)); w.z() += roll * g(rng);
        f.cameraFromWorld.rotation = Eigen::AngleAxisd(w.norm(), w.normalized()).toRotationMatrix() * f.cameraFromWorld.rotation;
        f.cameraFromWorld.translationMm = Eigen::AngleAxisd(w.norm(), w.normalized()).toRotationMatrix() * f.cameraFromWorld.translationMm + mm * Eigen::Vector3d(g(rng), g(rng), g(rng));
      }
      auto t0 = std::chrono::steady_clock::now();
      associate(in, as);
      secs += std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
      for (std::size_t m = 0; m < in.placements.size(); ++m) for (std::size_t c = 0; c < 4; ++c) {
        auto& got = in.placements[m].pictures[c]; auto& w = want.placements[m].pictures[c];
        int ok = 0, wrong = 0, seen = 0;
        for (std::size_t a = 0; a < got.arcs.size(); ++a) { if (w.arcs[a].pin) ++seen; if (got.usable() && got.arcs[a].pin && got.arcs[a].usable()) (got.arcs[a].pin == w.arcs[a].pin ? ok : wrong)++; }
        if (seen < 6) continue;
        ++images;
        if (!got.usable()) { ++refused; reasons[got.refusal.substr(0, 120) + " seen " + std::to_string(seen)]++; } else if (wrong) { ++wrongImages; if (env("VERB", 0) > 0) for (std::size_t a = 0; a < got.arcs.size(); ++a) if (got.arcs[a].pin && got.arcs[a].pin != w.arcs[a].pin) std::cout << "k " << k << " pl " << m << " cam " << c << " got " << got.arcs[a].pin << " want " << w.arcs[a].pin << " pts " << got.arcs[a].points.size() << "\n"; } else if (ok >= 6) ++right;
      }
    }
  }
  std::cout << "images " << images << " right " << 100.0 * right / images << " % refused " << refused << " wrong " << wrongImages << " s/image " << secs / images << "\n";
  for (auto& [r, n] : reasons) std::cout << n << " x " << r << "\n";
}
}
