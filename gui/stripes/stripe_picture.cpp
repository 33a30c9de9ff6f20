#include "gui/stripes/stripe_picture.h"

#include <algorithm>
#include <cmath>

namespace vignole {

namespace {

constexpr std::size_t kBrightnessBins = 400;
constexpr double kMarkMarginPx = 12, kMarkGapPx = 25;

QPointF position(const StripePoint& p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

/// First and last of the pixels that fall into `at` of `count`.
std::pair<int, int> share(int at, int count, int pixels) {
  const auto begin = static_cast<int>(static_cast<std::int64_t>(at) * pixels / count);
  const auto end = static_cast<int>(static_cast<std::int64_t>(at + 1) * pixels / count);
  return {begin, std::max(end, begin + 1)};
}

template <typename Visit>
void eachPoint(const StripeResult& stripe, Visit visit) {
  for (const StripeLine& line : stripe.lines)
    if (!line.rejected())
      for (std::size_t i = line.first; i < std::size_t{line.first} + line.count; ++i) visit(stripe.points[i]);
}

std::vector<QRectF> saturatedStretches(const StripeResult& stripe) {
  std::vector<QRectF> stretches;
  eachPoint(stripe, [&](const StripePoint& p) {
    if ((p.flags & kSaturated) == 0) return;
    const QPointF at = position(p);
    const QRectF spot(at.x() - kMarkMarginPx, at.y() - kMarkMarginPx, 2 * kMarkMarginPx, 2 * kMarkMarginPx);
    if (!stretches.empty() && stretches.back().adjusted(-kMarkGapPx, -kMarkGapPx, kMarkGapPx, kMarkGapPx).contains(at))
      stretches.back() = stretches.back().united(spot);
    else
      stretches.push_back(spot);
  });
  return stretches;
}

std::vector<float> brightnessAlong(const StripeResult& stripe, std::size_t points) {
  const std::size_t bins = std::min(points, kBrightnessBins);
  std::vector<float> brightness(bins, 0);
  std::size_t i = 0;
  eachPoint(stripe, [&](const StripePoint& p) {
    float& bin = brightness[i++ * bins / points];
    bin = std::max(bin, p.strength);
  });
  return brightness;
}

}  // namespace

StripeFigures stripeFigures(const StripeResult& stripe) {
  StripeFigures figures;
  for (const StripeLine& line : stripe.lines) figures.pieces += line.rejected() ? 0 : 1;
  eachPoint(stripe, [&](const StripePoint& p) {
    ++figures.points;
    figures.saturatedPoints += (p.flags & kSaturated) != 0 ? 1 : 0;
    figures.meanDn += static_cast<double>(p.strength);
    figures.sigmaPx += static_cast<double>(p.sigmaPx);
  });
  if (figures.points > 0) {
    figures.meanDn /= static_cast<double>(figures.points);
    figures.sigmaPx /= static_cast<double>(figures.points);
    figures.saturatedShare = static_cast<double>(figures.saturatedPoints) / static_cast<double>(figures.points);
  }
  figures.noiseDn = static_cast<double>(stripe.noiseDn);
  return figures;
}

QImage reduced(const ImageView& image, const QSize& size) {
  const QSize target = QSize(image.width, image.height).scaled(size, Qt::KeepAspectRatio);
  if (target.width() < 1 || target.height() < 1) return {};
  QImage out(target, QImage::Format_RGB32);
  std::vector<std::uint8_t> brightest(static_cast<std::size_t>(image.width));
  std::vector<std::pair<int, int>> columns;
  for (int x = 0; x < target.width(); ++x) columns.push_back(share(x, target.width(), image.width));
  for (int y = 0; y < target.height(); ++y) {
    const auto [first, end] = share(y, target.height(), image.height);
    std::copy_n(image.row(first), image.width, brightest.data());
    for (int row = first + 1; row < end; ++row) {
      const std::uint8_t* from = image.row(row);
      for (std::size_t x = 0; x < brightest.size(); ++x) brightest[x] = std::max(brightest[x], from[x]);
    }
    auto* into = reinterpret_cast<QRgb*>(out.scanLine(y));
    for (const auto& [left, right] : columns) {
      std::uint8_t value = 0;
      for (int x = left; x < right; ++x) value = std::max(value, brightest[static_cast<std::size_t>(x)]);
      *into++ = qRgb(value, value, value);
    }
  }
  return out;
}

std::vector<QPolygonF> strokesOf(const StripeResult& stripe, double stepPx) {
  std::vector<QPolygonF> strokes;
  for (const StripeLine& line : stripe.lines) {
    if (line.rejected() || line.count == 0) continue;
    QPolygonF stroke;
    const std::size_t last = std::size_t{line.first} + line.count - 1;
    for (std::size_t i = line.first; i <= last; ++i) {
      const QPointF at = position(stripe.points[i]);
      if (stroke.isEmpty() || i == last || std::hypot(at.x() - stroke.last().x(), at.y() - stroke.last().y()) >= stepPx)
        stroke << at;
    }
    strokes.push_back(std::move(stroke));
  }
  return strokes;
}

StripePicture stripePicture(LatestFrames::Held taken, const QSize& size) {
  StripePicture picture;
  const ImageView& image = taken->frame.image;
  picture.camera = taken->frame.camera;
  picture.trigger = taken->frame.trigger;
  picture.whole = reduced(image, size);
  const double step = picture.whole.isNull() ? 1 : static_cast<double>(image.width) / picture.whole.width();
  picture.strokes = strokesOf(taken->stripe, 1.5 * step);
  picture.saturated = saturatedStretches(taken->stripe);
  picture.figures = stripeFigures(taken->stripe);
  picture.brightnessDn = brightnessAlong(taken->stripe, picture.figures.points);
  picture.at = std::chrono::steady_clock::now();
  picture.taken = std::move(taken);
  return picture;
}

}  // namespace vignole
