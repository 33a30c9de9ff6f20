#include "report/profile_drawing.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QPen>
#include <QPolygonF>
#include <QVarLengthArray>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "report/dimension_text.h"
#include "report/drawing_frame.h"
#include "report/drawing_words.h"
#include "report/engine_words.h"
#include "report/magnified_outline.h"
#include "report/profile_callouts.h"
#include "report/profile_legend.h"
#include "report/state_symbol.h"

namespace vignole {

namespace {

constexpr double kWhiskerStepMm = 2.0;
constexpr double kSymbolPx = 16;
constexpr double kLegendPx = 41;
constexpr double kBodyPx = 16;

enum class Stretch : std::uint8_t { Unseen, Good, Near, Out };

struct Run {
  Stretch stretch = Stretch::Good;
  QPolygonF line;
};

/// What part of a dimension's tolerance one face may use: a width is shared by its two faces.
struct ToleranceShare {
  Dimension dimension;
  double share;
};
constexpr std::array<ToleranceShare, 9> kShownTolerances = {{{Dimension::HW, 0.5},
                                                             {Dimension::WT, 0.5},
                                                             {Dimension::FW, 0.5},
                                                             {Dimension::FTl, 1},
                                                             {Dimension::FTr, 1},
                                                             {Dimension::RASl, 1},
                                                             {Dimension::RASr, 1},
                                                             {Dimension::RH, 1},
                                                             {Dimension::HF, 1}}};

bool takenAt(const OutlineBin& bin, Dimension d) { return (bin.dimensions >> index(d) & 1u) != 0; }

class ProfilePainter {
 public:
  ProfilePainter(QPainter& painter, const QRectF& area, const ProfileDrawing& drawing, const Palette& palette)
      : painter_(painter),
        drawing_(drawing),
        palette_(palette),
        scale_(std::clamp(QFontInfo(painter.font()).pixelSize() / kBodyPx, 0.5, 4.0)),
        legendArea_(area.left() + 16 * scale_, area.bottom() - kLegendPx * scale_, area.width() - 32 * scale_,
                    kLegendPx * scale_),
        outline_(*drawing.section, drawing.parameters != nullptr ? *drawing.parameters : DimensionParameters{}) {
    frame_.area = QRectF(area.topLeft(), QPointF(area.right(), legendArea_.top()));
    if (hasProfile()) outline_.place(*drawing.profile, *drawing.registration, drawing.byCamera);
    chooseView();
  }

  void paint() {
    painter_.save();
    painter_.setClipRect(frame_.area, Qt::IntersectClip);
    painter_.setRenderHint(QPainter::Antialiasing);
    paintSteel();
    if (!drawing_.beforeRegistration) paintTolerances();
    paintModel();
    if (hasProfile() && drawing_.beforeRegistration) {
      paintCloud();
    } else if (hasProfile()) {
      paintWhiskers();
      paintMeasured();
      if (drawing_.byCamera) paintPoints();
    }
    paintTexts();
    painter_.restore();
    paintProfileLegend(painter_, legendArea_, {drawing_, palette_, scale_, frame_.pxPerMm});
  }

 private:
  [[nodiscard]] bool hasProfile() const {
    return drawing_.profile != nullptr && drawing_.registration != nullptr && drawing_.registration->valid;
  }
  [[nodiscard]] QPointF measuredAt(const OutlineBin& bin) const {
    return frame_.map(bin.point, bin.normal, drawing_.magnification * static_cast<double>(bin.deviationMm));
  }
  [[nodiscard]] Stretch stretchOf(const OutlineBin& bin) const {
    if (!bin.seen) return Stretch::Unseen;
    Stretch worst = Stretch::Good;
    if (drawing_.measurement == nullptr || drawing_.held || bin.dimensions == 0) return worst;
    for (const Dimension d : kDimensions) {
      if (!takenAt(bin, d)) continue;
      const Verdict verdict = drawing_.measurement->dimensions[index(d)].verdict;
      if (verdict == Verdict::Fail) return Stretch::Out;
      if (verdict == Verdict::Near) worst = Stretch::Near;
    }
    return worst;
  }
  [[nodiscard]] QPen penOf(Stretch stretch) const {
    const auto dashed = [](const QColor& colour, double width, const QList<qreal>& pattern) {
      QPen pen(QBrush(colour), width, Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
      // Qt counts dashes in pen widths, the mock-ups in pixels.
      QList<qreal> inWidths = pattern;
      for (qreal& dash : inWidths) dash /= width;
      pen.setDashPattern(inWidths);
      return pen;
    };
    switch (stretch) {
      case Stretch::Unseen:
        return dashed(palette_.invalid, 4, {3, 6});
      case Stretch::Near:
        return dashed(palette_.nearInk, 3.5, {9, 4});
      case Stretch::Out:
        return {QBrush(palette_.out), 4.5, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin};
      case Stretch::Good:
        break;
    }
    const bool faint = drawing_.held || drawing_.byCamera;
    return {QBrush(faint ? palette_.t3 : palette_.t1), drawing_.byCamera ? 1.0 : 2.0, Qt::SolidLine, Qt::FlatCap,
            Qt::BevelJoin};
  }

  void chooseView();
  void paintSteel();
  void paintTolerances();
  void paintModel();
  void paintWhiskers();
  void paintMeasured();
  void paintPoints();
  void paintCloud();
  [[nodiscard]] Callout movedCallout() const;
  void paintTexts();
  [[nodiscard]] std::vector<Run> runs() const;
  [[nodiscard]] const ToleranceShare* toleranceAt(const OutlineBin& bin) const;
  void paintTolerance(std::size_t first, std::size_t count, const ToleranceShare& share);
  void markOut(const QPolygonF& line);
  [[nodiscard]] FreeSpace spaceAroundRail() const;
  [[nodiscard]] std::optional<Callout> unseenCallout() const;

  QPainter& painter_;
  const ProfileDrawing& drawing_;
  const Palette& palette_;
  double scale_;
  QRectF legendArea_;
  MagnifiedOutline outline_;
  DrawingFrame frame_;
  QPolygonF closedOutline_;
};

void ProfilePainter::chooseView() {
  const Section& section = *drawing_.section;
  const double height = section.heightMm();
  double headFrom = height, footTo = 0;
  for (const OutlineBin& b : outline_.bins()) {
    const std::string& name = section.primitives[b.primitive].name;
    if (name.starts_with("SHB")) headFrom = std::min(headFrom, b.point.y());
    if (name.starts_with("SWB")) footTo = std::max(footTo, b.point.y());
  }
  double from = 0, to = height;
  if (drawing_.view == ProfileView::Head) from = headFrom - 8;
  if (drawing_.view == ProfileView::Web) from = footTo - 8, to = headFrom + 8;
  if (drawing_.view == ProfileView::Foot) to = footTo + 8;
  double left = 0, right = 0;
  for (const OutlineBin& b : outline_.bins())
    if (b.point.y() >= from && b.point.y() <= to) {
      left = std::min(left, b.point.x());
      right = std::max(right, b.point.x());
    }
  // Room for the magnified deviations; beyond that they are cut off rather than the rail made small.
  const double m = drawing_.magnification;
  const double top = drawing_.view == ProfileView::Web ? 0 : std::min(0.6 * m + 3, 16.0);
  const double side = std::min(0.5 * m + 3, 14.0);
  const double bottom = drawing_.view == ProfileView::Web ? 0 : std::min(0.2 * m + 3, 7.0);
  const bool narrowPart = drawing_.view == ProfileView::Head || drawing_.view == ProfileView::Web;
  const double forTexts = narrowPart ? std::min(0.07 * frame_.area.width(), 120 * scale_) : 8 * scale_;
  const double across = std::max(40.0, frame_.area.width() - 2 * forTexts);
  frame_.pxPerMm = std::max(0.05, std::min(across / (right - left + 2 * side),
                                           std::max(40.0, frame_.area.height()) / (to - from + top + bottom)));
  frame_.centreMm = Point2(0.5 * (left + right), 0.5 * (from - bottom + to + top));

  if (drawing_.beforeRegistration && hasProfile()) {
    // The rail may have lain anywhere: both clouds have room.
    Point2 low(left, 0), high(right, height);
    for (const ProfilePoint& p : drawing_.profile->points) {
      low = low.cwiseMin(Point2(p.x, p.y));
      high = high.cwiseMax(Point2(p.x, p.y));
    }
    const Point2 extent = high - low + Point2(16, 10);
    frame_.pxPerMm = std::max(0.05, std::min(across / extent.x(), std::max(40.0, frame_.area.height()) / extent.y()));
    frame_.centreMm = 0.5 * (low + high);
  }
  closedOutline_.reserve(static_cast<qsizetype>(outline_.bins().size()));
  for (const OutlineBin& b : outline_.bins()) closedOutline_ << frame_.map(b.point);
}

void ProfilePainter::paintSteel() {
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(palette_.steel);
  painter_.drawPolygon(closedOutline_);
}

void ProfilePainter::paintModel() {
  painter_.setPen(QPen(palette_.model, 1.5));
  painter_.setBrush(Qt::NoBrush);
  painter_.drawPolygon(closedOutline_);
}

const ToleranceShare* ProfilePainter::toleranceAt(const OutlineBin& bin) const {
  for (const ToleranceShare& shown : kShownTolerances) {
    if (!takenAt(bin, shown.dimension)) continue;
    const ToleranceLimits& limits = (*drawing_.limits)[index(shown.dimension)];
    if (limits.lowerMm || limits.upperMm) return &shown;
  }
  return nullptr;
}

void ProfilePainter::paintTolerances() {
  if (drawing_.limits == nullptr) return;
  const auto& bins = outline_.bins();
  for (std::size_t i = 0; i < bins.size();) {
    const ToleranceShare* shown = toleranceAt(bins[i]);
    std::size_t end = i + 1;
    while (end < bins.size() && toleranceAt(bins[end]) == shown) ++end;
    if (shown != nullptr && end - i > 1) paintTolerance(i, end - i, *shown);
    i = end;
  }
}

void ProfilePainter::paintTolerance(std::size_t first, std::size_t count, const ToleranceShare& share) {
  const ToleranceLimits& limits = (*drawing_.limits)[index(share.dimension)];
  const double upper = limits.upperMm.value_or(0) * share.share * drawing_.magnification;
  const double lower = limits.lowerMm.value_or(0) * share.share * drawing_.magnification;
  QPolygonF band, outer, inner;
  band.reserve(2 * static_cast<qsizetype>(count));
  for (std::size_t i = first; i < first + count; ++i) {
    const OutlineBin& b = outline_.bins()[i];
    outer << frame_.map(b.point, b.normal, upper);
    inner << frame_.map(b.point, b.normal, lower);
  }
  band << outer;
  for (qsizetype i = inner.size() - 1; i >= 0; --i) band << inner[i];
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(palette_.chan);
  painter_.setOpacity(0.75);
  painter_.drawPolygon(band);
  painter_.setOpacity(1);
  QPen dashed(QBrush(palette_.t3), 1, Qt::CustomDashLine, Qt::FlatCap);
  dashed.setDashPattern({5, 3});
  painter_.setPen(dashed);
  painter_.drawPolyline(outer);
  painter_.drawPolyline(inner);
}

void ProfilePainter::paintWhiskers() {
  std::array<QList<QLineF>, 4> whiskers;
  double since = kWhiskerStepMm;
  Point2 previous = outline_.bins().front().point;
  for (const OutlineBin& b : outline_.bins()) {
    since += (b.point - previous).norm();
    previous = b.point;
    if (b.corner || !b.seen || since < kWhiskerStepMm) continue;
    since = 0;
    whiskers[static_cast<std::size_t>(stretchOf(b))] << QLineF(frame_.map(b.point), measuredAt(b));
  }
  const auto draw = [&](Stretch stretch, const QColor& colour, double opacity) {
    painter_.setOpacity(opacity);
    painter_.setPen(QPen(colour, 1.25));
    painter_.drawLines(whiskers[static_cast<std::size_t>(stretch)]);
  };
  draw(Stretch::Good, palette_.t2, 0.42);
  draw(Stretch::Near, palette_.near, 1);
  draw(Stretch::Out, palette_.out, 0.8);
  painter_.setOpacity(1);
}

std::vector<Run> ProfilePainter::runs() const {
  const auto& bins = outline_.bins();
  const std::size_t n = bins.size();
  if (n == 0) return {};
  std::size_t origin = 0;  // where the stretch changes, so that no run is cut in two
  for (std::size_t i = 0; i < n; ++i)
    if (!bins[i].corner && stretchOf(bins[i]) != stretchOf(bins[(i + n - 1) % n])) {
      origin = i;
      break;
    }
  std::vector<Run> all;
  Run run;
  const auto flush = [&] {
    if (run.line.size() > 1) all.push_back(run);
    run.line.clear();
  };
  for (std::size_t k = 0; k <= n; ++k) {
    const OutlineBin& b = bins[(origin + k) % n];
    const Stretch stretch = stretchOf(b);
    // Deviations of a small arc would cross each other: its neighbours are joined straight.
    if (b.corner && stretch != Stretch::Unseen) continue;
    const QPointF at = stretch == Stretch::Unseen ? frame_.map(b.point) : measuredAt(b);
    if (!run.line.isEmpty() && stretch != run.stretch) {
      const bool joined = stretch != Stretch::Unseen && run.stretch != Stretch::Unseen;
      const QPointF last = run.line.back();
      // The thinner line makes the join, so that a marked stretch is as long as it is and no longer.
      if (joined && stretch > run.stretch) run.line << at;
      const bool startAtLast = joined && stretch < run.stretch;
      flush();
      if (startAtLast) run.line << last;
    }
    run.stretch = stretch;
    run.line << at;
  }
  flush();
  return all;
}

void ProfilePainter::paintMeasured() {
  const std::vector<Run> all = runs();
  painter_.setBrush(Qt::NoBrush);
  for (const Stretch stretch : {Stretch::Unseen, Stretch::Good, Stretch::Near, Stretch::Out}) {
    painter_.setPen(penOf(stretch));
    for (const Run& run : all)
      if (run.stretch == stretch) painter_.drawPolyline(run.line);
  }
  for (const Run& run : all)
    if (run.stretch == Stretch::Out) markOut(run.line);
}

void ProfilePainter::markOut(const QPolygonF& line) {
  // Not in the middle, where the measure's arrow stands.
  const QPointF at = line[line.size() / 5];
  const double side = kSymbolPx * scale_;
  paintSymbol(painter_, QRectF(at.x() - side / 2, at.y() - side / 2, side, side), StateSymbol::Out, palette_);
}

void ProfilePainter::paintPoints() {
  std::array<QList<QRectF>, 4> dots;
  for (auto& list : dots) list.reserve(static_cast<qsizetype>(outline_.points().size() / 2));
  const double half = 1.1 * std::max(1.0, scale_);
  for (const PlacedPoint& p : outline_.points()) {
    const QPointF at = frame_.map(p.foot, p.normal, drawing_.magnification * static_cast<double>(p.deviationMm));
    if (p.camera < dots.size() && frame_.area.contains(at))
      dots[p.camera] << QRectF(at.x() - half, at.y() - half, 2 * half, 2 * half);
  }
  painter_.setPen(Qt::NoPen);
  for (std::size_t camera = 0; camera < dots.size(); ++camera) {
    painter_.setBrush(drawing_.held ? palette_.t3 : palette_.camera[camera]);
    painter_.drawRects(dots[camera]);
  }
  QList<QRectF> strays;
  for (const Point2& p : outline_.unassigned()) {
    const QPointF at = frame_.map(p);
    if (frame_.area.contains(at)) strays << QRectF(at.x() - half, at.y() - half, 2 * half, 2 * half);
  }
  painter_.setBrush(palette_.t3);
  painter_.drawRects(strays);
}

FreeSpace ProfilePainter::spaceAroundRail() const {
  FreeSpace space(frame_.area);
  for (const OutlineBin& b : outline_.bins()) {
    space.occupy(frame_.map(b.point));
    if (b.seen && !b.corner) space.occupy(measuredAt(b));
    if (drawing_.limits == nullptr) continue;
    if (const ToleranceShare* shown = toleranceAt(b)) {
      const double upper = (*drawing_.limits)[index(shown->dimension)].upperMm.value_or(0);
      space.occupy(frame_.map(b.point, b.normal, upper * shown->share * drawing_.magnification));
    }
  }
  return space;
}

std::optional<Callout> ProfilePainter::unseenCallout() const {
  const auto& bins = outline_.bins();
  std::size_t best = 0, bestLength = 0;
  for (std::size_t i = 0; i < bins.size();) {
    std::size_t end = i;
    while (end < bins.size() && !bins[end].seen) ++end;
    if (end - i > bestLength) best = i, bestLength = end - i;
    i = std::max(end, i + 1);
  }
  if (bestLength == 0) return std::nullopt;
  Callout callout;
  callout.symbol = StateSymbol::NotMeasured;
  callout.title = Drawing::tr("No points");
  for (std::size_t camera = 0; camera < drawing_.profile->missing.size(); ++camera) {
    const std::string& reason = drawing_.profile->missing[camera];
    if (reason.empty()) continue;
    if (!callout.detail.isEmpty()) callout.detail += QStringLiteral("\n");
    callout.detail += inWords("camera " + std::to_string(camera + 1) + ": " + reason);
  }
  // Short hidden stretches are ordinary (a flank no camera sees): dotted, but not worth a word.
  if (callout.detail.isEmpty() && bestLength < 20) return std::nullopt;
  callout.ink = palette_.invalid;
  callout.ground = palette_.invalidSoft;
  const OutlineBin& middle = bins[best + bestLength / 2];
  callout.target = frame_.map(middle.point, middle.normal, 6 / frame_.pxPerMm);
  callout.wishedY = callout.target->y();
  callout.leftSide = middle.point.x() < drawing_.section->axisFromFootMiddleMm;
  return callout;
}

void ProfilePainter::paintCloud() {
  const Transform2 sectionFromWorld = drawing_.registration->worldFromSection.inverse();
  const double half = 0.9 * std::max(1.0, scale_);
  QList<QRectF> before, after;
  for (const ProfilePoint& p : drawing_.profile->points) {
    const Point2 seen(p.x, p.y);
    for (auto& [dots, at] :
         {std::pair{&before, frame_.map(seen)}, std::pair{&after, frame_.map(sectionFromWorld * seen)}})
      if (frame_.area.contains(at)) *dots << QRectF(at.x() - half, at.y() - half, 2 * half, 2 * half);
  }
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(palette_.camera[1]);
  painter_.drawRects(before);
  painter_.setBrush(drawing_.held ? palette_.t3 : palette_.t1);
  painter_.drawRects(after);
}

/// How far the rail lay from where the section is drawn.
Callout ProfilePainter::movedCallout() const {
  const Transform2& pose = drawing_.registration->worldFromSection;
  const int decimals = decimalsIn(drawing_.unit, 2);
  const auto length = [&](double mm) { return deviationText(inUnit(mm, drawing_.unit), decimals); };
  Callout moved;
  moved.title = Drawing::tr("Before registration");
  moved.detail = Drawing::tr("across %1, up %2 %3, turned %4°")
                     .arg(length(pose.xMm), length(pose.yMm), QString::fromLatin1(unitName(drawing_.unit)),
                          deviationText(pose.angleRad * 180 / std::numbers::pi, 2));
  moved.ink = palette_.camera[1];
  moved.ground = palette_.panel;
  moved.wishedY = frame_.area.center().y();
  return moved;
}

void ProfilePainter::paintTexts() {
  FreeSpace space = spaceAroundRail();
  ProfileCallouts callouts(painter_, frame_, palette_, scale_, space);
  if (drawing_.held) {
    Callout held;
    held.symbol = StateSymbol::Held;
    held.title = Drawing::tr("Held");
    held.detail = QString::fromStdString(drawing_.heldNote);
    held.ink = palette_.t3;
    held.ground = palette_.panel;
    held.wishedY = frame_.area.center().y();
    held.leftSide = true;
    callouts.paint(held);
  }
  if (drawing_.registration != nullptr && !drawing_.registration->valid) {
    Callout lost;
    lost.symbol = StateSymbol::NotMeasured;
    lost.title = Drawing::tr("No rail found");
    lost.detail = inWords(drawing_.registration->reason);
    lost.ink = palette_.invalid;
    lost.ground = palette_.invalidSoft;
    lost.wishedY = frame_.area.center().y();
    callouts.paint(lost);
  }
  if (hasProfile() && drawing_.beforeRegistration)
    callouts.paint(movedCallout());
  else
    callouts.paintDimensions(drawing_);
  if (hasProfile())
    if (const auto unseen = unseenCallout()) callouts.paint(*unseen);
  callouts.finish();
}

}  // namespace

void paintProfile(QPainter& painter, const QRectF& area, const ProfileDrawing& drawing, const Palette& palette) {
  if (drawing.section == nullptr || drawing.section->primitives.empty() || area.isEmpty()) return;
  painter.save();
  ProfilePainter(painter, area, drawing, palette).paint();
  painter.restore();
}

}  // namespace vignole
