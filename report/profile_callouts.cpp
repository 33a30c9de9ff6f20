#include "report/profile_callouts.h"

#include <QFontMetricsF>
#include <QPen>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "report/dimension_text.h"
#include "report/typeface.h"

namespace vignole {

namespace {

// Sizes of the mock-ups in px at scale 1.
constexpr double kTitlePx = 22, kDetailPx = 16, kSymbolPx = 26;
constexpr double kPaddingPx = 12, kBarPx = 6, kTextGapPx = 8;
constexpr double kWidestDetailPx = 232;
constexpr double kArrowLengthPx = 11, kArrowHalfPx = 4;
constexpr double kTailPx = 44;          // of an arrow that points inwards from outside
constexpr double kShortMeasurePx = 70;  // below, arrows stand outside
constexpr double kLeaderGapPx = 4;
constexpr std::size_t kMostCallouts = 3;

const QColor& inkOf(Verdict verdict, bool held, const Palette& palette) {
  if (held) return palette.t3;
  switch (verdict) {
    case Verdict::Fail:
      return palette.out;
    case Verdict::Near:
      return palette.nearInk;
    case Verdict::NotMeasured:
      return palette.invalid;
    case Verdict::Pass:
    case Verdict::NoLimit:
      break;
  }
  return palette.t1;
}

bool isHorizontal(Dimension d) {
  return d == Dimension::FW || d == Dimension::HW || d == Dimension::HWA || d == Dimension::WT ||
         d == Dimension::RASl || d == Dimension::RASr;
}

bool isGap(Dimension d) { return d == Dimension::RASl || d == Dimension::RASr; }

/// How far beyond its limit, as a share of the tolerance, so that unlike dimensions compare.
double excess(Dimension d, const DimensionResult& r) {
  if (!r.valueMm) return 0;
  const double high = d == Dimension::FC ? std::max(0.0, *r.valueMm) : *r.valueMm;
  const double low = d == Dimension::HF && r.secondMm ? *r.secondMm : high;
  const double width = r.lowerMm && r.upperMm ? *r.upperMm - *r.lowerMm
                                              : 2 * std::abs(r.upperMm.value_or(r.lowerMm.value_or(0)) - r.nominalMm);
  if (width <= 0) return 0;
  double beyond = -1e9;
  if (r.upperMm) beyond = std::max(beyond, high - *r.upperMm);
  if (r.lowerMm) beyond = std::max(beyond, *r.lowerMm - low);
  return beyond / width;
}

std::vector<Dimension> dimensionsToName(const ProfileDrawing& drawing) {
  std::vector<Dimension> named;
  const auto& results = drawing.measurement->dimensions;
  if (!drawing.held) {
    const auto rank = [&](Dimension d) {
      const DimensionResult& r = results[index(d)];
      return (r.verdict == Verdict::Fail ? 1e6 : 0.0) + excess(d, r);
    };
    for (const Dimension d : kDimensions) {
      const Verdict verdict = results[index(d)].verdict;
      if (verdict == Verdict::Fail || verdict == Verdict::Near) named.push_back(d);
    }
    std::stable_sort(named.begin(), named.end(), [&](Dimension a, Dimension b) { return rank(a) > rank(b); });
    if (named.size() > kMostCallouts) named.resize(kMostCallouts);
  }
  if (drawing.selected && std::find(named.begin(), named.end(), *drawing.selected) == named.end())
    named.push_back(*drawing.selected);
  return named;
}

}  // namespace

ProfileCallouts::ProfileCallouts(QPainter& painter, const DrawingFrame& frame, const Palette& palette, double scale,
                                 FreeSpace& space)
    : painter_(painter), frame_(frame), palette_(palette), scale_(scale), space_(space) {}

void ProfileCallouts::paintDimensions(const ProfileDrawing& drawing) {
  if (drawing.measurement == nullptr) return;
  for (const Dimension d : dimensionsToName(drawing)) paintDimension(drawing, d);
}

void ProfileCallouts::paintDimension(const ProfileDrawing& drawing, Dimension d) {
  const DimensionResult& result = drawing.measurement->dimensions[index(d)];
  const bool abnormal = result.verdict != Verdict::Pass && result.verdict != Verdict::NoLimit && !drawing.held;

  Callout callout;
  callout.dimension = d;
  callout.ink = inkOf(result.verdict, drawing.held, palette_);
  if (result.valueMm) callout.title = lengthText(*result.valueMm, decimalsOf(d), drawing.unit);
  if (drawing.held && result.valueMm) callout.symbol = StateSymbol::Held;
  if (abnormal) {
    callout.symbol = symbolOf(result.verdict);
    callout.detail = verdictSentence(d, result, drawing.unit);
    if (result.verdict == Verdict::Fail) callout.ground = palette_.outSoft;
    if (result.verdict == Verdict::NotMeasured) callout.ground = palette_.invalidSoft;
  }
  callout.wishedY = frame_.area.center().y();

  std::vector<QPointF> anchors;
  if (drawing.registration != nullptr && drawing.registration->valid && result.valueMm) {
    const Transform2 sectionFromWorld = drawing.registration->worldFromSection.inverse();
    for (const Point2& world : result.anchors) anchors.push_back(frame_.map(sectionFromWorld * world));
  }
  painter_.setPen(QPen(callout.ink, 1.75));
  if (d == Dimension::HR || d == Dimension::HF || d == Dimension::FC) {
    if (result.valueMm) pointAt(*drawing.section, d, anchors, callout);
  } else if (anchors.size() >= 2) {
    if (isGap(d)) {
      measureGap(*drawing.section, anchors[0], anchors[1], callout);
    } else if (isHorizontal(d)) {
      measureAcross(anchors[0], anchors[1], callout);
    } else {
      measureUpright(anchors, callout);
    }
  }
  paint(callout);
}

void ProfileCallouts::pointAt(const Section& section, Dimension d, const std::vector<QPointF>& anchors,
                              Callout& callout) {
  // These have no two ends to measure between: one arrow shows where they are taken. A radius is pointed at from
  // inside.
  const double axis = section.axisFromFootMiddleMm;
  QPointF at = frame_.map(d == Dimension::FC ? Point2(0, 0) : Point2(axis, section.heightMm()));
  if (!anchors.empty()) at = anchors.front();
  const double down = d == Dimension::HF ? -1 : 1;
  const QPointF tail = at + QPointF(0, down * (d == Dimension::FC ? 0.5 : 0.8) * kTailPx * scale_);
  painter_.drawLine(at, tail);
  arrow(at, QPointF(0, -down));
  callout.target = tail;
  callout.wishedY = tail.y();
}

void ProfileCallouts::measureGap(const Section& section, QPointF a, QPointF b, Callout& callout) {
  callout.leftSide = *callout.dimension == Dimension::RASl;
  if (a.x() > b.x()) std::swap(a, b);
  const double level = std::min(a.y(), b.y());
  // The foot edge lies far below the head side; it is carried up to where the arrow stands.
  const double edgeX = callout.leftSide ? a.x() : b.x();
  double edgeY = std::max(a.y(), b.y());
  if (const auto edge = section.find(callout.leftSide ? "SBL" : "SBR")) {
    const Primitive& shape = section.primitives[*edge].shape;
    edgeY = frame_.map(vignole::pointAt(shape, 0.5 * length(shape))).y();
  }
  QPen dashed(QBrush(callout.ink), 1, Qt::CustomDashLine, Qt::FlatCap);
  dashed.setDashPattern({6, 4});
  painter_.setPen(dashed);
  painter_.drawLine(QPointF(edgeX, edgeY), QPointF(edgeX, level - 10 * scale_));
  painter_.setPen(QPen(callout.ink, 1.75));
  measureLine(QPointF(a.x(), level), QPointF(b.x(), level), false, 0);
  space_.occupy(QRectF(QPointF(a.x(), level - 2), QPointF(b.x(), level + 2)));
  callout.wishedY = level - 40 * scale_;
}

void ProfileCallouts::measureAcross(QPointF a, QPointF b, Callout& callout) {
  if (a.x() > b.x()) std::swap(a, b);
  const double level = 0.5 * (a.y() + b.y()), shortTail = kTailPx * scale_;
  a.setY(level);
  b.setY(level);
  measureLine(a, b, true, shortTail);
  callout.wishedY = level;
  // Where the text stands at the same height, the right arrow's tail goes to it; else a leader does.
  const QRectF box = space_.find(sizeOf(callout), callout.leftSide, level);
  if (level > box.top() && level < box.bottom()) {
    const double gap = callout.ground ? 0 : kLeaderGapPx;
    painter_.drawLine(b, QPointF(std::max(box.left() - gap, b.x() + shortTail), level));
  } else {
    callout.target = b + QPointF(shortTail, 0);
  }
}

void ProfileCallouts::measureUpright(const std::vector<QPointF>& anchors, Callout& callout) {
  for (std::size_t pair = 0; pair + 1 < anchors.size(); pair += 2) {
    QPointF low = anchors[pair], high = anchors[pair + 1];
    if (low.y() < high.y()) std::swap(low, high);
    const double x = 0.5 * (low.x() + high.x());
    low.setX(x);
    high.setX(x);
    const bool outside = low.y() - high.y() < kShortMeasurePx * scale_;
    measureLine(high, low, outside, kTailPx * scale_);
    callout.target = outside ? high + QPointF(0, -kTailPx * scale_) : 0.5 * (low + high);
  }
  callout.leftSide = *callout.dimension == Dimension::FTl;
  callout.wishedY = callout.target->y();
}

void ProfileCallouts::measureLine(const QPointF& a, const QPointF& b, bool outside, double tailPx) {
  const QPointF delta = b - a;
  const double long_ = std::hypot(delta.x(), delta.y());
  if (long_ < 1e-6) return;
  const QPointF along = delta / long_;
  if (outside) {
    painter_.drawLine(a, a - along * tailPx);
    painter_.drawLine(b, b + along * tailPx);
    arrow(a, along);
    arrow(b, -along);
  } else {
    painter_.drawLine(a, b);
    arrow(a, -along);
    arrow(b, along);
  }
}

void ProfileCallouts::arrow(const QPointF& tip, const QPointF& direction) {
  const QPointF across(-direction.y(), direction.x());
  const QPointF base = tip - direction * (kArrowLengthPx * scale_);
  const QPointF half = across * (kArrowHalfPx * scale_);
  const QPen pen = painter_.pen();
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(pen.color());
  painter_.drawPolygon(QPolygonF{{tip, base + half, base - half}});
  painter_.setPen(pen);
  painter_.setBrush(Qt::NoBrush);
}

QSizeF ProfileCallouts::sizeOf(const Callout& callout) const {
  const QFont titleFont = typeface(kTitlePx * scale_, QFont::Medium);
  double titleWidth = callout.symbol ? (kSymbolPx + kTextGapPx) * scale_ : 0;
  if (callout.dimension) titleWidth += dimensionNameWidth(titleFont, *callout.dimension) + kTextGapPx * scale_;
  titleWidth += QFontMetricsF(titleFont).horizontalAdvance(callout.title);
  double width = titleWidth, height = 30 * scale_;
  if (!callout.detail.isEmpty()) {
    const QFontMetricsF metrics(typeface(kDetailPx * scale_));
    const QRectF text =
        metrics.boundingRect(QRectF(0, 0, kWidestDetailPx * scale_, 1000), Qt::TextWordWrap, callout.detail);
    width = std::max(width, text.width() + 2);
    height += text.height() + 2 * scale_;
  }
  if (callout.ground) return {width + 2 * kPaddingPx * scale_ + kBarPx * scale_, height + 1.2 * kPaddingPx * scale_};
  return {width, height};
}

void ProfileCallouts::paint(const Callout& callout) {
  const QRectF box = space_.find(sizeOf(callout), callout.leftSide, callout.wishedY);
  space_.occupy(box);
  if (callout.target) leader(*callout.target, box, callout.ink);
  // Boxes come last: a measure of one dimension must not cross the text of another.
  boxes_.emplace_back(callout, box);
}

void ProfileCallouts::finish() {
  for (const auto& [callout, box] : boxes_) paintBox(callout, box);
  boxes_.clear();
}

void ProfileCallouts::leader(const QPointF& from, const QRectF& box, const QColor& ink) {
  if (!frame_.area.contains(from)) return;
  QPointF to(std::clamp(from.x(), box.left() + 4, box.right() - 4),
             std::clamp(from.y(), box.top() + 4, box.bottom() - 4));
  if (from.x() < box.left())
    to.setX(box.left() - kLeaderGapPx);
  else if (from.x() > box.right())
    to.setX(box.right() + kLeaderGapPx);
  else if (from.y() > box.bottom())
    to.setY(box.bottom());
  else
    to.setY(box.top());
  painter_.setPen(QPen(ink, 1.5));
  painter_.drawLine(from, to);
}

void ProfileCallouts::paintBox(const Callout& callout, const QRectF& box) {
  QPointF at = box.topLeft();
  painter_.setPen(Qt::NoPen);
  if (callout.ground) {
    painter_.fillRect(box, *callout.ground);
    painter_.fillRect(QRectF(box.topLeft(), QSizeF(kBarPx * scale_, box.height())), callout.ink);
    at += QPointF((kBarPx + kPaddingPx) * scale_, 0.6 * kPaddingPx * scale_);
  }
  const double left = at.x();
  if (callout.symbol) {
    paintSymbol(painter_, QRectF(at + QPointF(0, 2 * scale_), QSizeF(kSymbolPx * scale_, kSymbolPx * scale_)),
                *callout.symbol, palette_);
    at.rx() += (kSymbolPx + kTextGapPx) * scale_;
  }
  painter_.setPen(palette_.t1);
  painter_.setFont(typeface(kTitlePx * scale_, QFont::Medium));
  const QPointF baseLine = at + QPointF(0, 23 * scale_);
  double advance = 0;
  if (callout.dimension) advance = drawDimensionName(painter_, baseLine, *callout.dimension) + kTextGapPx * scale_;
  painter_.drawText(baseLine + QPointF(advance, 0), callout.title);
  if (callout.detail.isEmpty()) return;
  painter_.setFont(typeface(kDetailPx * scale_));
  painter_.setPen(callout.ground ? palette_.t1 : palette_.t2);
  painter_.drawText(QRectF(left, at.y() + 32 * scale_, kWidestDetailPx * scale_, box.height()),
                    Qt::TextWordWrap | Qt::AlignLeft | Qt::AlignTop, callout.detail);
}

}  // namespace vignole
