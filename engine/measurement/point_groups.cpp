#include "engine/measurement/point_groups.h"

#include <algorithm>
#include <cmath>

namespace vignole {
namespace {

constexpr float kFallbackSigmaMm = 0.03F;  // where a point comes without its uncertainty
// A neighbour whose curvature differs by less than this shifts a smoothed line by less than a micrometre at the joint.
constexpr double kSmoothJointPerMm = 0.01;
// Coarse profiles (a point every 0.7 mm) leave too few points inside short primitives: they are trimmed less.
constexpr std::array<double, 4> kTrimDegrees = {1, 0.5, 0.25, 0};

std::size_t countFrom(const float* margins, std::size_t count, float least) {
  unsigned n = 0;
  for (std::size_t i = 0; i < count; ++i) n += margins[i] >= least ? 1U : 0U;
  return n;
}

template <typename T>
void growTo(std::vector<T>& v, std::size_t n) {
  if (v.size() < n) v.resize(n);
}

}  // namespace

PointGroups::PointGroups(const Section& section, std::size_t footBottom, const std::vector<ChainFit>& chains,
                         const MeasurementSettings& settings)
    : settings_(settings) {
  makeBorders(section, footBottom, chains);
  coverage_.resize(section.primitives.size());
  groups_.resize(chains.size() + 1);
  for (std::size_t c = 0; c < chains.size(); ++c) groups_[c].origin = chains[c].origin();
}

void PointGroups::makeBorders(const Section& section, std::size_t footBottom, const std::vector<ChainFit>& chains) {
  const std::size_t n = section.primitives.size();
  borders_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    Border& b = borders_[k];
    const Primitive& shape = section.primitives[k].shape;
    b.lengthMm = length(shape);
    b.start = startPoint(shape);
    b.end = endPoint(shape);
    b.startTangent = tangentAt(shape, 0);
    b.endTangent = tangentAt(shape, b.lengthMm);
    b.chordMm = (b.end - b.start).norm();
    b.chord = (b.end - b.start) / b.chordMm;
    b.curvature = curvature(shape);
    const auto smooth = [&](std::size_t neighbour) {
      return std::abs(curvature(section.primitives[neighbour].shape) - b.curvature) < kSmoothJointPerMm;
    };
    b.trimStart = !smooth((k + n - 1) % n);
    b.trimEnd = !smooth((k + 1) % n);
  }
  borders_[footBottom].fit = static_cast<int>(chains.size());
  for (std::size_t c = 0; c < chains.size(); ++c) {
    const auto& members = chains[c].plan().primitives;
    for (std::size_t m = 0; m < members.size(); ++m) {
      Border& b = borders_[members[m]];
      b.fit = static_cast<int>(c);
      b.place = m;
      if (m > 0) b.trimStart = false;  // inside a chain both sides of the joint are modelled
      if (m + 1 < members.size()) b.trimEnd = false;
    }
  }
}

void PointGroups::gather(const Profile& profile, const Registration& registration, double cold) {
  for (Group& g : groups_) {
    g.points.resize(0);
    g.strides.clear();
  }
  const Transform2 fromWorld = registration.worldFromSection.inverse();
  const auto& primitiveOf = registration.primitiveOfPoint;
  const std::size_t n = profile.points.size();
  for (std::size_t i = 0; i < n;) {
    const std::int16_t k = primitiveOf[i];
    const std::uint8_t camera = profile.points[i].camera;
    std::size_t end = i + 1;
    while (end < n && primitiveOf[end] == k && profile.points[end].camera == camera) ++end;
    if (k >= 0 && borders_[static_cast<std::size_t>(k)].fit != kNoFit)
      take(&profile.points[i], end - i, static_cast<std::size_t>(k), fromWorld, cold);
    i = end;
  }
  chooseTrims();
}

/// Where a point of a profile becomes a point of a fit.
void PointGroups::take(const ProfilePoint* points, std::size_t count, std::size_t primitive,
                       const Transform2& fromWorld, double cold) {
  Group& g = groups_[static_cast<std::size_t>(borders_[primitive].fit)];
  const Stride stride{primitive, g.points.count, g.points.count + count,
                      static_cast<std::uint8_t>(points->camera % kCameraCount)};
  g.points.resize(stride.to);
  const double c = cold * std::cos(fromWorld.angleRad), s = cold * std::sin(fromWorld.angleRad);
  const double x0 = cold * fromWorld.xMm - g.origin.x, y0 = cold * fromWorld.yMm - g.origin.y;
  float* x = g.points.x.data() + stride.from;
  float* y = g.points.y.data() + stride.from;
  float* weight = g.points.weight.data() + stride.from;
  float* pull = g.points.pull.data() + stride.from;
  for (std::size_t i = 0; i < count; ++i) {
    const ProfilePoint& p = points[i];
    // The ridge itself: the fit knows the bend better than the extraction, and neighbours that were smoothed together
    // tell nothing twice.
    const double px = p.x - static_cast<double>(p.shiftMm * p.nx), py = p.y - static_cast<double>(p.shiftMm * p.ny);
    x[i] = static_cast<float>(c * px - s * py + x0);
    y[i] = static_cast<float>(s * px + c * py + y0);
    weight[i] = p.ridgeSigmaMm > 0 ? p.ridgeSigmaMm : p.sigmaMm;
    pull[i] = p.smoothingMm;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const float sigma = weight[i] > 0 ? weight[i] : kFallbackSigmaMm;
    weight[i] = 1 / (sigma * sigma);
    pull[i] = 0.5F * pull[i] * pull[i];
  }
  measureStride(g, stride);
  g.strides.push_back(stride);
}

void PointGroups::measureStride(Group& g, const Stride& stride) const {
  growTo(g.marginMm, g.points.x.size());
  growTo(g.alongMm, g.points.x.size());
  const Border& b = borders_[stride.primitive];
  const float* x = g.points.x.data();
  const float* y = g.points.y.data();
  float* margin = g.marginMm.data();
  float* along = g.alongMm.data();
  // a x + b y + c, in the frame of the points
  struct Plane {
    float a = 0, b = 0, c = 1e6F;
  };
  const auto plane = [&](const Point2& at, const Point2& direction) -> Plane {
    const double c = direction.x() * (g.origin.x - at.x()) + direction.y() * (g.origin.y - at.y());
    return {static_cast<float>(direction.x()), static_cast<float>(direction.y()), static_cast<float>(c)};
  };
  const Plane chord = plane(b.start, b.chord);
  const Plane fromStart = b.trimStart ? plane(b.start, b.startTangent) : Plane{};
  const Plane fromEnd = b.trimEnd ? plane(b.end, -b.endTangent) : Plane{};
  for (std::size_t i = stride.from; i < stride.to; ++i) {
    along[i] = chord.a * x[i] + chord.b * y[i] + chord.c;
    const float start = fromStart.a * x[i] + fromStart.b * y[i] + fromStart.c;
    const float end = fromEnd.a * x[i] + fromEnd.b * y[i] + fromEnd.c;
    margin[i] = start < end ? start : end;
  }
}

void PointGroups::chooseTrims() {
  for (Coverage& c : coverage_) c = {};
  // First all as they should be, then those that are left with too few.
  for (const double degree : kTrimDegrees) {
    bool enough = true;
    for (Coverage& c : coverage_)
      if (c.points < settings_.minPoints) c = {0, degree * settings_.trimMm, {}};
    for (Group& g : groups_)
      for (Stride& s : g.strides) {
        Coverage& c = coverage_[s.primitive];
        if (c.trimMm != degree * settings_.trimMm) continue;
        s.kept = countFrom(g.marginMm.data() + s.from, s.to - s.from, static_cast<float>(c.trimMm));
        c.points += static_cast<int>(s.kept);
      }
    for (const Group& g : groups_)
      for (const Stride& s : g.strides) enough = enough && coverage_[s.primitive].points >= settings_.minPoints;
    if (enough) return;
  }
}

void PointGroups::move(Group& g, std::size_t from, std::size_t to, std::size_t count) {
  if (from == to) return;
  for (std::vector<float>* v : {&g.points.x, &g.points.y, &g.points.weight, &g.points.pull, &g.alongMm})
    std::copy_n(v->data() + from, count, v->data() + to);  // downwards
}

const FitPoints& PointGroups::select(std::size_t fit, std::size_t first, std::size_t last) {
  Group& g = groups_[fit];
  FitPoints& p = g.points;
  p.runs.clear();
  std::size_t kept = 0;
  for (const Stride& s : g.strides) {
    const std::size_t place = borders_[s.primitive].place;
    if (place < first || place > last) continue;
    Coverage& c = coverage_[s.primitive];
    const auto trim = static_cast<float>(c.trimMm);
    if (s.kept == 0) continue;
    const std::size_t start = kept;
    std::size_t from = s.from, to = s.to;
    while (g.marginMm[from] < trim) ++from;
    while (g.marginMm[to - 1] < trim) --to;
    if (to - from == s.kept) {  // what was trimmed lies at the ends, as a rule
      move(g, from, kept, s.kept);
      kept += s.kept;
    } else {
      for (; from < to; ++from)
        if (g.marginMm[from] >= trim) move(g, from, kept++, 1);
    }
    const Interval along = intervalOf(g.alongMm.data() + start, kept - start);
    c.alongMm = {std::min(c.alongMm.low, along.low), std::max(c.alongMm.high, along.high)};
    if (p.runs.empty() || p.runs.back().camera != s.camera)
      p.runs.push_back({start, kept, s.camera});
    else
      p.runs.back().to = kept;
  }
  p.resize(kept);
  return p;
}

double PointGroups::arcLengthAt(const Border& b, double along) const {
  if (b.curvature == 0) return along;
  const double half = b.chordMm / 2, k = std::abs(b.curvature);
  return b.lengthMm / 2 + std::asin(std::clamp((along - half) * k, -1.0, 1.0)) / k;
}

std::array<double, 2> PointGroups::reachOf(std::size_t primitive) const {
  const Border& b = borders_[primitive];
  const Interval& along = coverage_[primitive].alongMm;
  return {-arcLengthAt(b, static_cast<double>(along.low)),
          arcLengthAt(b, static_cast<double>(along.high)) - b.lengthMm};
}

}  // namespace vignole
