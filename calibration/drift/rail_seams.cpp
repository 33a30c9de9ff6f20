#include "calibration/drift/rail_seams.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/stripe/stripe.h"

namespace vignole {

namespace {

constexpr double kPieceMm = 2;
constexpr double kZonePieces = 7;
constexpr float kFewestPoints = 3;   // of each camera on a piece
constexpr float kFarthestMm = 0.5F;  // between two cameras: beyond is another surface, or dirt
constexpr std::uint8_t kUnsure = kLineEnd | kGapEdge | kCrosstalk | kRejected;

/// Which neighbours see the same of a rail: both upper, right, both lower, left.
constexpr std::array<std::array<int, 2>, 4> kPairs = {{{0, 1}, {1, 2}, {2, 3}, {3, 0}}};

std::size_t piecesOf(double lengthMm) {
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(lengthMm / kPieceMm)));
}
std::size_t zonesOf(std::size_t pieces) {
  return static_cast<std::size_t>(std::ceil(static_cast<double>(pieces) / kZonePieces));
}

/// Arc length of the place on the curve that is nearest to a point beside it; outside 0 .. length beyond its ends.
double alongOf(const Primitive& shape, const Point2& p) {
  if (const Segment* s = std::get_if<Segment>(&shape)) return (p - s->start).dot(s->end - s->start) / length(shape);
  const Arc& arc = std::get<Arc>(shape);
  const Point2 d = p - arc.centre;
  const double middle = arc.startAngleRad + arc.sweepRad / 2;
  const double fromMiddle = std::remainder(std::atan2(d.y(), d.x()) - middle, 2 * std::numbers::pi);
  return arc.radiusMm * (std::abs(arc.sweepRad) / 2 + (arc.sweepRad > 0 ? fromMiddle : -fromMiddle));
}

}  // namespace

std::vector<SeamZone> seamZones(const Section& section) {
  std::vector<SeamZone> zones;
  const Point2 middle(section.axisXMm(), section.heightMm() / 2);
  for (std::size_t p = 0; p < section.primitives.size(); ++p) {
    const Primitive& shape = section.primitives[p].shape;
    const double mm = length(shape);
    const std::size_t count = zonesOf(piecesOf(mm));
    for (std::size_t z = 0; z < count; ++z) {
      const double s = mm * (static_cast<double>(z) + 0.5) / static_cast<double>(count);
      for (const auto& pair : kPairs)
        zones.push_back({pair[0], pair[1], p, pointAt(shape, s) - middle, normalAt(shape, s)});
    }
  }
  return zones;
}

RailSeams::RailSeams(const Section& section) : zones_(seamZones(section)), seams_(zones_.size()) {
  std::size_t zone = 0;
  for (const NamedPrimitive& primitive : section.primitives) {
    const double mm = length(primitive.shape);
    const std::size_t pieces = piecesOf(mm), zones = zonesOf(pieces);
    curves_.push_back({primitive.shape, mm, zoneOfPiece_.size(), pieces});
    for (std::size_t k = 0; k < pieces; ++k) zoneOfPiece_.push_back(zone + k * zones / pieces * kPairs.size());
    zone += zones * kPairs.size();
  }
  pieces_.resize(zoneOfPiece_.size());
}

void RailSeams::add(const Profile& profile, const Registration& registration) {
  if (!registration.valid || registration.primitiveOfPoint.size() != profile.points.size()) return;
  std::fill(pieces_.begin(), pieces_.end(), Piece{});
  const Transform2 sectionFromWorld = registration.worldFromSection.inverse();
  const double c = std::cos(sectionFromWorld.angleRad), s = std::sin(sectionFromWorld.angleRad);
  for (std::size_t i = 0; i < profile.points.size(); ++i) {
    const ProfilePoint& p = profile.points[i];
    const int primitive = registration.primitiveOfPoint[i];
    if (primitive < 0 || (p.flags & kUnsure) != 0) continue;
    const Curve& curve = curves_[static_cast<std::size_t>(primitive)];
    const Point2 at(c * p.x - s * p.y + sectionFromWorld.xMm, s * p.x + c * p.y + sectionFromWorld.yMm);
    const double share = alongOf(curve.shape, at) / curve.lengthMm;
    if (!(share >= 0 && share < 1)) continue;
    Piece& piece = pieces_[curve.firstPiece + static_cast<std::size_t>(share * static_cast<double>(curve.pieces))];
    piece.sum[p.camera] += registration.residualMm[i];
    piece.count[p.camera] += 1;
  }
  addPieces();
  ++profiles_;
}

void RailSeams::addPieces() {
  for (std::size_t k = 0; k < pieces_.size(); ++k)
    for (std::size_t pair = 0; pair < kPairs.size(); ++pair) {
      const auto a = static_cast<std::size_t>(kPairs[pair][0]), b = static_cast<std::size_t>(kPairs[pair][1]);
      const Piece& piece = pieces_[k];
      if (piece.count[a] < kFewestPoints || piece.count[b] < kFewestPoints) continue;
      const float between = piece.sum[a] / piece.count[a] - piece.sum[b] / piece.count[b];
      if (!(std::abs(between) < kFarthestMm)) continue;
      const auto weight = static_cast<double>(1 / (1 / piece.count[a] + 1 / piece.count[b]));
      Seam& seam = seams_[zoneOfPiece_[k] + pair];
      seam.weight += weight;
      seam.mm += (static_cast<double>(between) - seam.mm) * weight / seam.weight;
    }
}

std::vector<Seam> RailSeams::take() {
  std::vector<Seam> taken(seams_.size());
  taken.swap(seams_);
  profiles_ = 0;
  return taken;
}

}  // namespace vignole
