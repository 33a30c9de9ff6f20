#include "calibration/light_plane/line_choice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace vignole {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Candidate {
  std::size_t stripe = 0;
  int line = 0;
  double light = 0;              // length times contrast
  std::array<Vector3d, 2> ends;  // camera's frame, mm
  Matrix3d covariance;           // of the line as a whole
  double distanceMm = 0;
};

struct Trial {
  Vector3d normal;
  double distanceMm = 0;
};

Candidate candidateOf(const TargetStripe& stripe, std::size_t index, int line, const Intrinsics& in) {
  const TargetLine& l = stripe.lines[static_cast<std::size_t>(line)];
  const PlaneView view = planeView(l, stripe.pose, in);
  Candidate c;
  c.stripe = index;
  c.line = line;
  c.light = l.lengthMm * l.contrastDn;
  c.covariance.setZero();
  if (view.points.empty()) {
    c.light = 0;
    c.ends = {Vector3d::Zero(), Vector3d::Zero()};
    return c;
  }
  const LinePoint &first = view.points[0], &second = view.points[1];
  const Eigen::Matrix<double, 3, 6> byPose = 0.5 * (first.byPose + second.byPose);
  c.covariance = 0.5 * first.sigmaMm * first.sigmaMm * first.across * first.across.transpose() +
                 byPose * stripe.pose.covariance * byPose.transpose();
  c.ends = {first.mm, second.mm};
  c.distanceMm = first.mm.norm();
  return c;
}

/// The plane nearest to two lines: through their middles, along the mean of their directions.
Trial planeThrough(const Candidate& a, const Candidate& b) {
  const Vector3d middleA = 0.5 * (a.ends[0] + a.ends[1]), middleB = 0.5 * (b.ends[0] + b.ends[1]);
  Vector3d alongA = (a.ends[1] - a.ends[0]), alongB = (b.ends[1] - b.ends[0]);
  if (alongA.dot(alongB) < 0) alongB = -alongB;
  const Vector3d across = middleB - middleA;
  // Both normals that hold one of the lines exactly, and their mean.
  const Vector3d normal = across.cross(alongA).normalized() + across.cross(alongB).normalized();
  Trial t;
  t.normal = normal.normalized();
  t.distanceMm = t.normal.dot(0.5 * (middleA + middleB));
  return t;
}

double offPlane(const Candidate& c, const Trial& t) {
  return std::max(std::abs(t.normal.dot(c.ends[0]) - t.distanceMm), std::abs(t.normal.dot(c.ends[1]) - t.distanceMm));
}

double allowed(const Candidate& c, const Trial& t, const LineChoiceSettings& settings) {
  const double u = std::sqrt(std::max(0.0, t.normal.dot(c.covariance * t.normal)));
  return std::max(settings.sigmas * u, settings.distanceShare * c.distanceMm);
}

}  // namespace

std::vector<int> chooseLines(std::span<const TargetStripe> stripes, const Intrinsics& in,
                             const LineChoiceSettings& settings) {
  std::vector<Candidate> candidates;
  std::vector<int> chosen(stripes.size(), -1);
  std::size_t usable = 0;
  for (std::size_t i = 0; i < stripes.size(); ++i) {
    if (!stripes[i].usable()) continue;
    ++usable;
    for (std::size_t l = 0; l < stripes[i].lines.size(); ++l)
      candidates.push_back(candidateOf(stripes[i], i, static_cast<int>(l), in));
  }
  if (usable < 2) {
    // Nothing to agree with: the brightest.
    for (std::size_t i = 0; i < stripes.size(); ++i)
      if (stripes[i].usable() && !stripes[i].lines.empty()) chosen[i] = 0;
    return chosen;
  }
  double bestLight = 0;
  for (std::size_t a = 0; a < candidates.size(); ++a)
    for (std::size_t b = a + 1; b < candidates.size(); ++b) {
      if (candidates[a].stripe == candidates[b].stripe) continue;
      const Trial trial = planeThrough(candidates[a], candidates[b]);
      if (!trial.normal.allFinite()) continue;
      std::vector<int> agreeing(stripes.size(), -1);
      std::vector<double> lights(stripes.size(), 0.0);
      for (const Candidate& c : candidates) {
        if (c.light <= lights[c.stripe]) continue;
        // The trial's own error grows away from the two lines it is made of.
        if (offPlane(c, trial) > 3 * allowed(c, trial, settings)) continue;
        agreeing[c.stripe] = c.line;
        lights[c.stripe] = c.light;
      }
      double light = 0;
      for (const double l : lights) light += l;
      if (light > bestLight) {
        bestLight = light;
        chosen = agreeing;
      }
    }
  // What agrees with the plane through all of them.
  for (int round = 0; round < 3; ++round) {
    std::vector<PlaneView> views;
    for (std::size_t i = 0; i < stripes.size(); ++i)
      if (chosen[i] >= 0)
        views.push_back(planeView(stripes[i].lines[static_cast<std::size_t>(chosen[i])], stripes[i].pose, in));
    if (views.size() < 2) break;
    const FittedPlane plane = fitPlane(views);
    if (!plane.ok) break;
    const Trial trial{plane.normal, plane.distanceMm};
    std::vector<int> next(stripes.size(), -1);
    std::vector<double> lights(stripes.size(), 0.0);
    for (const Candidate& c : candidates)
      if (c.light > lights[c.stripe] && offPlane(c, trial) <= allowed(c, trial, settings)) {
        next[c.stripe] = c.line;
        lights[c.stripe] = c.light;
      }
    if (next == chosen) break;
    chosen = next;
  }
  return chosen;
}

}  // namespace vignole
