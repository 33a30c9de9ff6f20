// The stages one by one, each on one thread.

#include <algorithm>
#include <numbers>
#include <random>

#include "cli/bench_material.h"
#include "engine/inspection/stage_meter.h"
#include "engine/profile/assembler.h"
#include "engine/profile/translate.h"

namespace vignole::cli {

namespace {

/// Points of a profile, thinned evenly to at most 2,000 (the size that the goals are stated for), moved by a pose.
std::vector<ProfilePoint> movedPoints(const Profile& profile, const Transform2& move, const Point2& about) {
  constexpr std::size_t kPoints = 2000;
  const std::size_t all = profile.points.size(), count = std::min(kPoints, all);
  std::vector<ProfilePoint> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    ProfilePoint p = profile.points[i * all / count];
    const Point2 at = move * (Point2(p.x, p.y) - about) + about;
    const Point2 normal = move.rotate({static_cast<double>(p.nx), static_cast<double>(p.ny)});
    p.x = at.x();
    p.y = at.y();
    p.nx = static_cast<float>(normal.x());
    p.ny = static_cast<float>(normal.y());
    points.push_back(p);
  }
  return points;
}

}  // namespace

void benchTranslate(const BenchMaterial& material, std::vector<BenchSeries>& results) {
  BenchSeries series{"translate", "ms", {}};
  PartialContour contour;
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    const Translator translator(static_cast<int>(c), material.rig->calibration().rangeFinders[c]);
    for (const auto& stripes : material.stripes) {
      const StopWatch watch;
      translator.translate(0, stripes[c], contour);
      series.values.push_back(watch.ms());
    }
  }
  results.push_back(std::move(series));
}

void benchAssemble(const BenchMaterial& material, std::vector<BenchSeries>& results) {
  BenchSeries series{"assemble", "ms", {}};
  ProfileAssembler assembler;
  for (int c = 0; c < kCameraCount; ++c) assembler.add(c, RailBegin{});
  Assembly assembly;
  for (std::uint64_t s = 0; s < material.stripes.size(); ++s) {
    std::array<PartialContour, kCameraCount> contours;
    for (std::size_t c = 0; c < kCameraCount; ++c)
      Translator(static_cast<int>(c), material.rig->calibration().rangeFinders[c])
          .translate(s, material.stripes[s][c], contours[c]);
    const StopWatch watch;
    for (PartialContour& contour : contours) assembler.add(contour);
    while (assembler.next(assembly)) {
    }
    series.values.push_back(watch.ms());
  }
  results.push_back(std::move(series));
}

void benchRegister(const BenchMaterial& material, std::vector<BenchSeries>& results) {
  constexpr int kRounds = 20;
  constexpr double kShiftMm = 10, kTurnRad = 5 * std::numbers::pi / 180, kOutliers = 0.1;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1), share(0, 1);
  Registrar registrar(material.recipe.section, material.recipe.registration);
  Registration registration;
  for (const bool outliers : {false, true}) {
    BenchSeries series{outliers ? "register.outliers" : "register", "us", {}};
    for (int round = 0; round < kRounds; ++round)
      for (const Profile& profile : material.profiles) {
        const Point2 centre(0, material.recipe.section.heightMm() / 2);
        auto points =
            movedPoints(profile, {kShiftMm * unit(random), kShiftMm * unit(random), kTurnRad * unit(random)}, centre);
        if (outliers)
          for (ProfilePoint& p : points)
            if (share(random) < kOutliers) {
              p.x = centre.x() + 100 * unit(random);
              p.y = centre.y() + 100 * unit(random);
            }
        const StopWatch watch;
        registrar.registerProfile(points, registration);
        const double us = 1000 * watch.ms();
        if (registration.valid) series.values.push_back(us);
      }
    results.push_back(std::move(series));
  }
}

void benchMeasure(const BenchMaterial& material, std::vector<BenchSeries>& results) {
  constexpr int kRounds = 20;
  BenchSeries series{"measure", "us", {}};
  Registrar registrar(material.recipe.section, material.recipe.registration);
  Measurer measurer(material.recipe.section, material.recipe.parameters, material.recipe.limits,
                    material.recipe.measurement);
  Registration registration;
  Measurement measurement;
  for (const Profile& profile : material.profiles) {
    registrar.registerProfile(profile.points, registration, {}, static_cast<double>(profile.correlatedPoints));
    measurer.measure(profile, registration, {}, measurement);
    for (int round = 0; round < kRounds; ++round) {
      const StopWatch watch;
      measurer.measure(profile, registration, {}, measurement);
      series.values.push_back(1000 * watch.ms());
    }
  }
  results.push_back(std::move(series));
}

}  // namespace vignole::cli
