// Registration, and the ways to look up the primitive that is nearest to a point.

#include <algorithm>
#include <boost/geometry/algorithms/assign.hpp>
#include <boost/geometry/algorithms/comparable_distance.hpp>
#include <boost/geometry/algorithms/expand.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <numbers>
#include <random>

#include "cli/bench_material.h"
#include "engine/inspection/stage_meter.h"
#include "engine/registration/candidate_grid.h"

namespace vignole::cli {

namespace {

constexpr int kRounds = 20;

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

/// The paper's way: an R-tree over the boxes of the primitives. They come nearest box first, until a box is further
/// than the nearest primitive so far.
class PrimitiveTree {
 public:
  explicit PrimitiveTree(const std::vector<Carrier>& carriers, const Section& section) : carriers_(carriers) {
    std::vector<Entry> entries;
    for (std::size_t k = 0; k < carriers.size(); ++k) {
      Box box;
      boost::geometry::assign_inverse(box);
      constexpr int kSteps = 64;  // of an arc; the box takes in what bulges between them
      const Primitive& shape = section.primitives[k].shape;
      const double each = length(shape) / kSteps, bulge = each * each / (8 * carriers[k].bendRadius());
      for (int i = 0; i <= kSteps; ++i) {
        const Point2 p = pointAt(shape, i * each);
        boost::geometry::expand(box, Box({p.x() - bulge, p.y() - bulge}, {p.x() + bulge, p.y() + bulge}));
      }
      entries.emplace_back(box, static_cast<std::uint16_t>(k));
    }
    tree_ = Tree(entries);
  }

  [[nodiscard]] std::uint16_t nearest(double x, double y) const {
    std::uint16_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    const Corner p(x, y);
    const auto all = static_cast<unsigned>(carriers_.size());
    for (auto it = tree_.qbegin(boost::geometry::index::nearest(p, all)); it != tree_.qend(); ++it) {
      if (boost::geometry::comparable_distance(p, it->first) > least) break;
      const double squared = carriers_[it->second].squaredDistance(x, y);
      if (squared < least) {
        least = squared;
        best = it->second;
      }
    }
    return best;
  }

 private:
  using Corner = boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian>;
  using Box = boost::geometry::model::box<Corner>;
  using Entry = std::pair<Box, std::uint16_t>;
  using Tree = boost::geometry::index::rtree<Entry, boost::geometry::index::rstar<8>>;

  const std::vector<Carrier>& carriers_;
  Tree tree_;
};

/// The nearest primitives of one profile's points, found by each way at the pose that registration starts its last
/// passes from, i.e. near the outline; and by way of the primitive that is already known (the paper's cache).
class SearchBench {
 public:
  explicit SearchBench(const Section& section)
      : carriers_(carriersOf(section)), grid_(carriers_, 1, 40, 3), tree_(carriers_, section) {}

  void run(const std::vector<ProfilePoint>& points, const Transform2& sectionFromWorld) {
    const std::size_t n = points.size();
    x_.assign(n + kSlack, 0);
    y_.assign(n + kSlack, 0);
    cells_.resize(n + kSlack);
    found_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const Point2 p = sectionFromWorld * Point2(points[i].x, points[i].y);
      x_[i] = static_cast<float>(p.x());
      y_[i] = static_cast<float>(p.y());
    }
    time(grid, n, [&] {
      locate({x_.data(), y_.data(), n}, {}, grid_.frame(), cells_.data());
      for (std::size_t i = 0; i < n; ++i) found_[i] = grid_.within(cells_[i], x_[i], y_[i]);
    });
    time(rtree, n, [&] {
      for (std::size_t i = 0; i < n; ++i) found_[i] = tree_.nearest(at(x_, i), at(y_, i));
    });
    time(all, n, [&] {
      for (std::size_t i = 0; i < n; ++i) found_[i] = nearestOfAll(at(x_, i), at(y_, i));
    });
    // What the cache saves the search for: the distance to the primitive that a point had before.
    double sum = 0;
    time(cached, n, [&] {
      for (std::size_t i = 0; i < n; ++i) sum += carriers_[found_[i]].squaredDistance(at(x_, i), at(y_, i));
    });
    if (!(sum >= 0)) cached.values.clear();  // keeps the work from being optimised away
  }

  BenchSeries grid{"register.search.grid", "us", {}}, rtree{"register.search.rtree", "us", {}},
      all{"register.search.all", "us", {}}, cached{"register.search.cached", "us", {}};

 private:
  static std::vector<Carrier> carriersOf(const Section& section) {
    std::vector<Carrier> carriers;
    for (const NamedPrimitive& p : section.primitives) carriers.push_back(Carrier::of(p.shape));
    return carriers;
  }
  static double at(const std::vector<float>& values, std::size_t i) { return static_cast<double>(values[i]); }

  [[nodiscard]] std::uint16_t nearestOfAll(double x, double y) const {
    std::size_t best = 0;
    double least = carriers_[0].squaredDistance(x, y);
    for (std::size_t k = 1; k < carriers_.size(); ++k)
      if (const double squared = carriers_[k].squaredDistance(x, y); squared < least) {
        least = squared;
        best = k;
      }
    return static_cast<std::uint16_t>(best);
  }

  /// As for 2,000 points, whatever the number.
  template <typename Work>
  static void time(BenchSeries& series, std::size_t points, const Work& work) {
    const StopWatch watch;
    work();
    series.values.push_back(1000 * watch.ms() * 2000 / static_cast<double>(points));
  }

  std::vector<Carrier> carriers_;
  CandidateGrid grid_;
  PrimitiveTree tree_;
  std::vector<float> x_, y_;
  std::vector<std::int32_t> cells_;
  std::vector<std::uint16_t> found_;
};

}  // namespace

void benchRegister(const BenchMaterial& material, std::vector<BenchSeries>& results) {
  constexpr double kShiftMm = 10, kTurnRad = 5 * std::numbers::pi / 180, kOutliers = 0.1;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1), share(0, 1);
  const Point2 centre(0, material.recipe.section.heightMm() / 2);
  Registrar registrar(material.recipe.section, material.recipe.registration);
  Registration registration;
  SearchBench search(material.recipe.section);
  for (const bool outliers : {false, true}) {
    BenchSeries series{outliers ? "register.outliers" : "register", "us", {}};
    for (int round = 0; round < kRounds; ++round)
      for (const Profile& profile : material.profiles) {
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
        if (!registration.valid) continue;
        series.values.push_back(us);
        if (!outliers && round == 0) search.run(points, registration.worldFromSection.inverse());
      }
    results.push_back(std::move(series));
  }
  results.insert(results.end(),
                 {std::move(search.grid), std::move(search.rtree), std::move(search.all), std::move(search.cached)});
}

}  // namespace vignole::cli
