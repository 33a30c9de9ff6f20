#include "calibration/range_finders/pin_homography.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>

#include "calibration/range_finders/ellipse_fit.h"
#include "calibration/range_finders/picture_match.h"
#include "calibration/range_finders/pose_from_centres.h"
#include "engine/optics/camera_model.h"

namespace vignole {

namespace {

constexpr double kGatePx = 12;
constexpr double kSizeShare = 0.4;  // direct fits shrink on short arcs
constexpr int kBases = 30;
constexpr std::size_t kPosesTried = 8;

using Quad = std::array<int, 4>;

/// Ellipses in the undistorted picture: mm on the sensor over the focal length, times the focal length in px.
struct View {
  std::vector<Ellipse> ellipses;
  double focalPx = 1;
};

View ellipsesOf(const PinPicture& picture, const Intrinsics& intrinsics) {
  View view;
  view.focalPx = intrinsics.focalMm / intrinsics.pixelWidthMm;
  const Lens<double> camera = lens(intrinsics);
  std::vector<Point2> points;
  for (const PinArc& arc : picture.arcs) {
    if (!arc.usable()) continue;
    points.clear();
    for (const ArcPoint& p : arc.points)
      points.push_back(undistortedFromPixel<double>(camera, p.px) / intrinsics.pixelWidthMm);
    const auto ellipse = fitEllipse(points, EllipseFitVariant::Normalised);
    if (ellipse && ellipse->axisRatio() > 0.15) view.ellipses.push_back(*ellipse);
  }
  return view;
}

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Signs of the four triangles; a camera before the plate sees them all the other way round, since rows run down.
bool sidesAgree(const std::array<Point2, 4>& seen, const std::array<Point2, 4>& stated) {
  for (std::size_t left = 0; left < 4; ++left) {
    const std::size_t a = (left + 1) % 4, b = (left + 2) % 4, c = (left + 3) % 4;
    if (turn(seen[a], seen[b], seen[c]) * turn(stated[a], stated[b], stated[c]) > 0) return false;
  }
  return true;
}

Eigen::Matrix3d homography(const std::array<Point2, 4>& from, const std::array<Point2, 4>& to) {
  Eigen::Matrix<double, 8, 8> m;
  Eigen::Matrix<double, 8, 1> r;
  for (int i = 0; i < 4; ++i) {
    const Point2 &p = from[static_cast<std::size_t>(i)], &q = to[static_cast<std::size_t>(i)];
    m.row(2 * i) << p.x(), p.y(), 1, 0, 0, 0, -q.x() * p.x(), -q.x() * p.y();
    m.row(2 * i + 1) << 0, 0, 0, p.x(), p.y(), 1, -q.y() * p.x(), -q.y() * p.y();
    r[2 * i] = q.x();
    r[2 * i + 1] = q.y();
  }
  const Eigen::Matrix<double, 8, 1> h = m.partialPivLu().solve(r);
  Eigen::Matrix3d result;
  result << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], 1;
  return result;
}

Point2 through(const Eigen::Matrix3d& h, const Point2& p) {
  const Eigen::Vector3d v = h * Eigen::Vector3d(p.x(), p.y(), 1);
  return v.head<2>() / v.z();
}

bool sizeAgrees(const Eigen::Matrix3d& h, const Pin& pin, const Ellipse& ellipse) {
  const Eigen::Vector3d v = h * Eigen::Vector3d(pin.centreMm.x(), pin.centreMm.y(), 1);
  const Point2 at = v.head<2>() / v.z();
  Eigen::Matrix2d j = h.topLeftCorner<2, 2>();
  j -= at * h.row(2).head<2>();
  j /= v.z();
  const double area = std::sqrt(std::abs(j.determinant())) * pin.radiusMm;  // mean of the semi-axes
  const double seen = std::sqrt(ellipse.majorPx * ellipse.minorPx);
  return seen > (1 - kSizeShare) * area && seen < (1 + kSizeShare) * area;
}

struct Candidate {
  Eigen::Matrix3d h;
  std::vector<std::pair<int, int>> pairs;  ///< ellipse, pin
  double square = 0;
};

class Search {
 public:
  Search(const View& view, const PinPlate& plate) : view_(view), plate_(plate) {}
  [[nodiscard]] std::vector<Candidate> run() const;

 private:
  [[nodiscard]] std::vector<Quad> bases() const;
  void tryBase(const Quad& base, std::vector<Candidate>& found) const;
  [[nodiscard]] Candidate judged(const Eigen::Matrix3d& h) const;

  const View& view_;
  const PinPlate& plate_;
};

/// Quads of ellipses that are spread widely, each as unlike the ones before as the numbers allow.
std::vector<Quad> Search::bases() const {
  const auto count = static_cast<int>(view_.ellipses.size());
  struct Spread {
    Quad quad;
    double area;
  };
  std::vector<Spread> all;
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b)
      for (int c = b + 1; c < count; ++c)
        for (int d = c + 1; d < count; ++d) {
          const auto at = [&](int i) { return view_.ellipses[static_cast<std::size_t>(i)].centre; };
          const double least = std::min({std::abs(turn(at(a), at(b), at(c))), std::abs(turn(at(a), at(b), at(d))),
                                         std::abs(turn(at(a), at(c), at(d))), std::abs(turn(at(b), at(c), at(d)))});
          all.push_back({{a, b, c, d}, least});
        }
  std::stable_sort(all.begin(), all.end(), [](const Spread& x, const Spread& y) { return x.area > y.area; });
  std::vector<Quad> chosen;
  std::vector<int> uses(view_.ellipses.size(), 0);
  for (int limit = 1; limit <= kBases && static_cast<int>(chosen.size()) < kBases; ++limit)
    for (const Spread& s : all) {
      if (static_cast<int>(chosen.size()) >= kBases) break;
      if (std::any_of(s.quad.begin(), s.quad.end(),
                      [&](int i) { return uses[static_cast<std::size_t>(i)] >= 2 * limit; }))
        continue;
      if (std::find(chosen.begin(), chosen.end(), s.quad) != chosen.end()) continue;
      for (const int i : s.quad) ++uses[static_cast<std::size_t>(i)];
      chosen.push_back(s.quad);
    }
  return chosen;
}

Candidate Search::judged(const Eigen::Matrix3d& h) const {
  Candidate candidate{h, {}, 0};
  for (std::size_t p = 0; p < plate_.pins.size(); ++p) {
    const Point2 at = through(h, plate_.pins[p].centreMm);
    int nearest = -1;
    double distance = kGatePx * kGatePx;
    for (std::size_t e = 0; e < view_.ellipses.size(); ++e)
      if (const double d = (view_.ellipses[e].centre - at).squaredNorm(); d < distance) {
        distance = d;
        nearest = static_cast<int>(e);
      }
    if (nearest < 0 || !sizeAgrees(h, plate_.pins[p], view_.ellipses[static_cast<std::size_t>(nearest)])) continue;
    candidate.pairs.emplace_back(nearest, static_cast<int>(p));
    candidate.square += distance;
  }
  return candidate;
}

void Search::tryBase(const Quad& base, std::vector<Candidate>& found) const {
  std::array<Point2, 4> seen, stated;
  for (std::size_t i = 0; i < 4; ++i) seen[i] = view_.ellipses[static_cast<std::size_t>(base[i])].centre;
  const auto pins = static_cast<int>(plate_.pins.size());
  for (int a = 0; a < pins; ++a)
    for (int b = 0; b < pins; ++b)
      for (int c = 0; c < pins; ++c)
        for (int d = 0; d < pins; ++d) {
          if (a == b || a == c || a == d || b == c || b == d || c == d) continue;
          const Quad quad{a, b, c, d};
          for (std::size_t i = 0; i < 4; ++i) stated[i] = plate_.pins[static_cast<std::size_t>(quad[i])].centreMm;
          if (!sidesAgree(seen, stated)) continue;
          const Eigen::Matrix3d h = homography(stated, seen);
          if (!h.allFinite()) continue;
          bool sizes = true;
          for (std::size_t i = 0; sizes && i < 4; ++i)
            sizes = sizeAgrees(h, plate_.pins[static_cast<std::size_t>(quad[i])],
                               view_.ellipses[static_cast<std::size_t>(base[i])]);
          if (!sizes) continue;
          Candidate candidate = judged(h);
          if (candidate.pairs.size() >= 6) found.push_back(std::move(candidate));
        }
}

std::vector<Candidate> Search::run() const {
  std::vector<Candidate> found;
  for (const Quad& base : bases()) tryBase(base, found);
  std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return a.pairs.size() != b.pairs.size() ? a.pairs.size() > b.pairs.size() : a.square < b.square;
  });
  std::vector<Candidate> different;
  for (Candidate& c : found) {
    if (std::any_of(different.begin(), different.end(), [&](const Candidate& d) { return d.pairs == c.pairs; }))
      continue;
    different.push_back(std::move(c));
    if (different.size() >= kPosesTried) break;
  }
  return different;
}

/// K [r1 r2 t] up to scale, K = diag(f, f, 1) in the undistorted picture.
Extrinsics poseOf(const Eigen::Matrix3d& h, double focalPx) {
  Eigen::Matrix3d m = h;
  m.topRows<2>() /= focalPx;
  m *= 2 / (m.col(0).norm() + m.col(1).norm());
  if (m(2, 2) < 0) m = -m;
  Eigen::Matrix3d r;
  r.col(0) = m.col(0);
  r.col(1) = m.col(1);
  r.col(2) = m.col(0).cross(m.col(1));
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(r, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.matrixU() * svd.matrixV().transpose(), m.col(2)};
}

}  // namespace

Expected<Extrinsics> poseByHomography(const PinPicture& picture, const Intrinsics& intrinsics, const PinPlate& plate,
                                      const AssociationSettings& settings) {
  const View view = ellipsesOf(picture, intrinsics);
  if (static_cast<int>(view.ellipses.size()) < settings.fewestPins)
    return inputError("", "refused, because only " + std::to_string(view.ellipses.size()) + " pins are seen and " +
                              std::to_string(settings.fewestPins) +
                              " are needed; check the laser, the exposure and what stands in its way");
  const Lens<double> camera = lens(intrinsics);
  PictureMatch best;
  for (const Candidate& candidate : Search(view, plate).run()) {
    std::vector<PlaneCorrespondence> points;
    for (const auto& [ellipse, pin] : candidate.pairs) {
      const Point2 sensor = view.ellipses[static_cast<std::size_t>(ellipse)].centre * intrinsics.pixelWidthMm;
      points.push_back({plate.pins[static_cast<std::size_t>(pin)].centreMm,
                        pixelFromSensor<double>(camera, distort<double>(camera, sensor))});
    }
    const auto pose = poseFromCentres(points, intrinsics, poseOf(candidate.h, view.focalPx));
    if (!pose || !(cameraCentre(pose->cameraFromPlane).z() > 0)) continue;
    // Circles in the plane that this pose has are what the drawing's plane has otherwise.
    const PictureMatch match = matchPicture(picture, intrinsics, pose->cameraFromPlane, plate, settings);
    if (match.found && (!best.found || match.pins > best.pins)) best = match;
  }
  if (!best.found)
    return inputError("",
                      "refused, because the pins do not stand as the plate's file has them, from wherever the camera may "
                      "look; give the file of this plate");
  return best.cameraFromPlate;
}

}  // namespace vignole
