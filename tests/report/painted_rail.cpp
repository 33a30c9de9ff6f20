#include "painted_rail.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>

#include "engine/rail/catalogue.h"
#include "report/typeface.h"

namespace vignole::test {

namespace {

const Transform2 kPose{12.0, -80.0, 0.01};

int cameraAt(const Point2& p) {
  if (p.y() > 86) return p.x() < 0 ? 0 : 1;
  return p.x() < 0 ? 3 : 2;
}

double deviationAt(const Point2& p) { return 0.12 * std::sin(p.x() / 17.0) - 0.1 * std::cos(p.y() / 23.0); }

void addPoints(PaintedRail& rail, int missingCamera) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 0.02);
  const Section& section = rail.recipe.section;
  Profile& profile = rail.result.profile;
  Registration& registration = rail.result.registration;
  for (std::size_t p = 0; p < section.primitives.size(); ++p) {
    const Primitive& shape = section.primitives[p].shape;
    for (double s = 0.1; s < length(shape); s += 0.25) {
      const Point2 foot = pointAt(shape, s);
      const int camera = cameraAt(foot);
      if (camera == missingCamera) continue;
      const double deviation = deviationAt(foot) + noise(random);
      const Point2 world = kPose * Point2(foot + deviation * normalAt(shape, s));
      ProfilePoint point;
      point.x = world.x();
      point.y = world.y();
      point.camera = static_cast<std::uint8_t>(camera);
      profile.points.push_back(point);
      registration.primitiveOfPoint.push_back(static_cast<std::int16_t>(p));
      registration.residualMm.push_back(static_cast<float>(deviation));
    }
  }
  if (missingCamera >= 0) profile.missing[static_cast<std::size_t>(missingCamera)] = "frame lost";
  registration.valid = true;
  registration.worldFromSection = kPose;
}

std::vector<Point2> anchorsOf(Dimension d) {
  switch (d) {
    case Dimension::RH:
      return {{0, 0}, {0, 172}};
    case Dimension::RFH:
      return {{-25, 22.4}, {-25, 130.1}, {25, 22.4}, {25, 130.1}};
    case Dimension::FW:
      return {{-75, 4.9}, {75, 4.9}};
    case Dimension::HW:
      return {{-35.98, 158}, {35.98, 158}};
    case Dimension::HWA:
      return {{-36.08, 156.1}, {36.08, 156.1}};
    case Dimension::FTl:
      return {{-65, 0}, {-65, 12.2}};
    case Dimension::FTr:
      return {{65, 0}, {65, 12.2}};
    case Dimension::RASl:
      return {{-75, 4.9}, {-35.98, 158}};
    case Dimension::RASr:
      return {{35.98, 158}, {75, 4.9}};
    case Dimension::WT:
      return {{-8.25, 76.3}, {8.25, 76.3}};
    case Dimension::HR:
      return {{-10, 171.8}, {0, 172}, {10, 171.8}};
    case Dimension::FC:
      return {{0, 0}, {0, 0.1}};
    case Dimension::HF:
      break;
  }
  return {{-20, 170.9}, {20, 170.9}};
}

void addDimensions(PaintedRail& rail) {
  const PerDimension<double> nominal = {172,    107.682, 150,    0,      71.963, 72.157, 12.214,
                                        12.214, 39.018,  39.018, 16.500, 300,    0};
  for (const Dimension d : kDimensions) {
    DimensionResult& r = rail.result.measurement.dimensions[index(d)];
    const ToleranceLimits& limits = rail.recipe.limits[index(d)];
    r.nominalMm = nominal[index(d)];
    if (limits.lowerMm) r.lowerMm = r.nominalMm + *limits.lowerMm;
    if (limits.upperMm) r.upperMm = r.nominalMm + *limits.upperMm;
    r.uMm = d == Dimension::HR ? 1.9 : 0.012;
    r.points = 120;
    for (const Point2& p : anchorsOf(d)) r.anchors.push_back(kPose * p);
    setValue(rail, d, d == Dimension::HR ? -1.4 : 0.031);
  }
}

void addSummary(PaintedRail& rail) {
  RailSummary& s = rail.summary;
  s.rail.id = "0412-3-07";
  s.rail.heat = "263417";
  s.rail.sectionName = "60E1";
  s.rail.temperatureC = 23.5;
  s.recipe = "60E1 X/A v7";
  s.calibrationId = "rig-2026-11-19";
  s.lengthM = 60;
  s.profiles = 4000;
  s.verdict = Verdict::Pass;
  s.triggers = {4000, 3994, 5, 1, {{"camera 3: frame lost", 5}, {"no stripe", 1}}};
  rail.result.rail = std::make_shared<RailBegin>(s.rail);
  for (const Dimension d : kDimensions) {
    const DimensionResult& r = rail.result.measurement.dimensions[index(d)];
    DimensionSummary& out = s.dimensions[index(d)];
    out.dimension = d;
    out.nominalMm = r.nominalMm;
    out.lowerMm = r.lowerMm;
    out.upperMm = r.upperMm;
    out.uMm = r.uMm;
    out.verdict = r.verdict;
    const double swing = d == Dimension::HR ? 4.0 : 0.08;
    for (int i = 0; i < 400; ++i) {
      TrackBin bin;
      bin.positionM = 0.15 * i + 0.075;
      bin.meanMm = *r.valueMm + swing * std::sin(0.03 * i + static_cast<double>(index(d)));
      bin.minMm = bin.meanMm - 0.3 * swing;
      bin.maxMm = bin.meanMm + 0.3 * swing;
      bin.count = 10;
      out.values.add(bin.meanMm);
      out.track.push_back(bin);
    }
  }
}

}  // namespace

void setValue(PaintedRail& rail, Dimension dimension, double deviationMm) {
  DimensionResult& r = rail.result.measurement.dimensions[index(dimension)];
  r.valueMm = r.nominalMm + deviationMm;
  const bool judged = r.lowerMm || r.upperMm;
  const bool out = (r.upperMm && *r.valueMm > *r.upperMm) || (r.lowerMm && *r.valueMm < *r.lowerMm);
  const double guard = 2 * r.uMm;
  const bool near = (r.upperMm && *r.valueMm > *r.upperMm - guard) || (r.lowerMm && *r.valueMm < *r.lowerMm + guard);
  r.verdict = !judged ? Verdict::NoLimit : out ? Verdict::Fail : near ? Verdict::Near : Verdict::Pass;
}

PaintedRail paintedRail(int missingCamera) {
  PaintedRail rail;
  auto section = findSection("60E1");
  if (!section) throw std::runtime_error(section.error().message());
  rail.recipe.name = "60E1 X/A";
  rail.recipe.section = std::move(*section);
  auto limits = toleranceLimits(rail.recipe.section, "X", "A");
  if (!limits) throw std::runtime_error(limits.error().message());
  rail.recipe.limits = *limits;
  rail.recipe.note = toleranceNote();
  addPoints(rail, missingCamera);
  addDimensions(rail);
  addSummary(rail);
  return rail;
}

QImage drawn(const PaintedRail& rail, const Palette& palette, const std::function<void(ProfileDrawing&)>& change,
             QSize size) {
  QImage image(size, QImage::Format_ARGB32_Premultiplied);
  image.fill(palette.panel2);
  ProfileDrawing drawing;
  drawing.section = &rail.recipe.section;
  drawing.limits = &rail.recipe.limits;
  drawing.profile = &rail.result.profile;
  drawing.registration = &rail.result.registration;
  drawing.measurement = &rail.result.measurement;
  if (change) change(drawing);
  QPainter painter(&image);
  painter.setFont(typeface(16));
  paintProfile(painter, QRectF(QPointF(0, 0), QSizeF(size)), drawing, palette);
  return image;
}

void keep(const QImage& image, const std::string& name) {
  if (const char* folder = std::getenv("VIGNOLE_KEEP_PICTURES"))
    image.save(QString::fromStdString(std::string(folder) + "/" + name + ".png"));
}

int differentPixels(const QImage& a, const QImage& b) {
  int different = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) different += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
  return different;
}

int pixelsOf(const QImage& image, const QColor& colour) {
  int found = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor c = image.pixelColor(x, y);
      found += std::abs(c.red() - colour.red()) <= 24 && std::abs(c.green() - colour.green()) <= 24 &&
                       std::abs(c.blue() - colour.blue()) <= 24
                   ? 1
                   : 0;
    }
  return found;
}

}  // namespace vignole::test
