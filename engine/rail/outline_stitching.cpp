#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "engine/rail/outline.h"

namespace vignole {

namespace {

constexpr double kJoinedMm = 1e-3;

Primitive reversed(const Primitive& shape) {
  if (const auto* s = std::get_if<Segment>(&shape)) return Segment{s->end, s->start};
  Arc arc = std::get<Arc>(shape);
  arc.startAngleRad += arc.sweepRad;
  arc.sweepRad = -arc.sweepRad;
  return arc;
}

bool near(const Point2& a, const Point2& b) { return (a - b).norm() < kJoinedMm; }

bool samePiece(const Primitive& a, const Primitive& b) {
  const bool ends = (near(startPoint(a), startPoint(b)) && near(endPoint(a), endPoint(b))) ||
                    (near(startPoint(a), endPoint(b)) && near(endPoint(a), startPoint(b)));
  return ends && near(pointAt(a, length(a) / 2), pointAt(b, length(b) / 2));
}

/// An end of a piece that no other piece touches.
struct FreeEnd {
  std::size_t piece;
  Point2 at;
};

std::vector<FreeEnd> freeEnds(const std::vector<Piece>& pieces) {
  std::vector<FreeEnd> found;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const Point2& end : {startPoint(pieces[i].shape), endPoint(pieces[i].shape)}) {
      const auto touches = [&](const Piece& other) {
        return &other != &pieces[i] && (near(startPoint(other.shape), end) || near(endPoint(other.shape), end));
      };
      if (std::none_of(pieces.begin(), pieces.end(), touches)) found.push_back({i, end});
    }
  return found;
}

/// Without points, and without what is drawn twice: drawings often hold the same line again.
void clean(std::vector<Piece>& pieces) {
  std::erase_if(pieces, [](const Piece& p) { return length(p.shape) < kJoinedMm; });
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = pieces.size() - 1; j > i; --j)
      if (samePiece(pieces[i].shape, pieces[j].shape)) pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(j));
}

/// The free end that is nearest to the first one; there are two or more.
const FreeEnd& nearestToFirst(const std::vector<FreeEnd>& ends) {
  const FreeEnd& first = ends.front();
  return *std::min_element(ends.begin() + 1, ends.end(), [&](const FreeEnd& a, const FreeEnd& b) {
    return (a.at - first.at).squaredNorm() < (b.at - first.at).squaredNorm();
  });
}

tl::unexpected<Error> openAt(const std::vector<Piece>& pieces, const std::vector<FreeEnd>& ends) {
  const FreeEnd& first = ends.front();
  std::string text;
  std::array<char, 200> line{};
  std::snprintf(line.data(), line.size(), "does not close: %s ends free at (%.4f, %.4f)",
                pieces[first.piece].label.c_str(), first.at.x(), first.at.y());
  text = line.data();
  if (ends.size() > 1) {
    const FreeEnd* nearest = &nearestToFirst(ends);
    std::snprintf(line.data(), line.size(), ", the nearest free end is that of %s at (%.4f, %.4f), %.4g mm away",
                  pieces[nearest->piece].label.c_str(), nearest->at.x(), nearest->at.y(),
                  (nearest->at - first.at).norm());
    text += line.data();
  }
  return inputError("outline", text + "; a section must be one closed outline");
}

double signedArea(const std::vector<Primitive>& outline) {
  Section section;
  for (const Primitive& p : outline) section.primitives.push_back({"", p});
  return properties(section).areaMm2;
}

/// The two as one, where they are parts of the same line or circle.
std::optional<Primitive> merged(const Primitive& a, const Primitive& b) {
  if (const auto* s = std::get_if<Segment>(&a), *t = std::get_if<Segment>(&b); s != nullptr && t != nullptr) {
    const Primitive whole = Segment{s->start, t->end};
    const bool straight =
        std::abs(nearest(whole, s->end).distanceMm) < 1e-4 && tangentAt(a, 0).dot(tangentAt(b, 0)) > 0.99;
    return straight ? std::optional(whole) : std::nullopt;
  }
  if (const auto* s = std::get_if<Arc>(&a), *t = std::get_if<Arc>(&b); s != nullptr && t != nullptr) {
    const bool same = near(s->centre, t->centre) && std::abs(s->radiusMm - t->radiusMm) < kJoinedMm &&
                      s->sweepRad * t->sweepRad > 0 && std::abs(s->sweepRad + t->sweepRad) < 2 * std::numbers::pi;
    if (same) return Arc{s->centre, s->radiusMm, s->startAngleRad, s->sweepRad + t->sweepRad};
  }
  return std::nullopt;
}

void mergeHalves(std::vector<Primitive>& outline) {
  for (std::size_t i = 0; i < outline.size() && outline.size() > 3;) {
    const std::size_t next = (i + 1) % outline.size();
    const auto whole = merged(outline[i], outline[next]);
    if (!whole) {
      ++i;
      continue;
    }
    outline[i] = *whole;
    outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(next));
    if (next < i) --i;
  }
}

}  // namespace

std::optional<OutlineGap> firstGap(std::vector<Piece> pieces) {
  clean(pieces);
  const auto ends = freeEnds(pieces);
  if (ends.empty()) return {};
  OutlineGap gap{ends.front().at, {}};
  if (ends.size() > 1) gap.other = nearestToFirst(ends).at;
  return gap;
}

Expected<std::vector<Primitive>> stitch(std::vector<Piece> pieces) {
  clean(pieces);
  if (pieces.size() < 3) return inputError("outline", "has fewer than 3 lines and arcs; a closed section is expected");
  if (const auto ends = freeEnds(pieces); !ends.empty()) return openAt(pieces, ends);

  std::vector<Primitive> outline = {pieces.front().shape};
  pieces.erase(pieces.begin());
  while (!near(endPoint(outline.back()), startPoint(outline.front()))) {
    double best = std::numeric_limits<double>::infinity();
    std::size_t at = 0;
    bool backwards = false;
    const Point2 end = endPoint(outline.back());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const double toStart = (startPoint(pieces[i].shape) - end).norm(),
                   toEnd = (endPoint(pieces[i].shape) - end).norm();
      if (std::min(toStart, toEnd) >= best) continue;
      best = std::min(toStart, toEnd);
      at = i;
      backwards = toEnd < toStart;
    }
    if (best >= kJoinedMm) return inputError("outline", "branches; remove what is not the outline");
    outline.push_back(backwards ? reversed(pieces[at].shape) : pieces[at].shape);
    pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(at));
  }
  if (!pieces.empty())
    return inputError("outline", "is not alone: " + pieces.front().label + " belongs to another line; remove it");

  if (signedArea(outline) < 0) {
    std::reverse(outline.begin(), outline.end());
    for (Primitive& p : outline) p = reversed(p);
  }
  mergeHalves(outline);
  return outline;
}

}  // namespace vignole
