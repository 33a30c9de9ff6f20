#include "engine/rail/section_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace vignole {

namespace {

constexpr double kPxPerMm = 4;
constexpr double kMarginMm = 22;  // room for the names outside the outline

std::string formatted(const char* format, double a, double b, double c = 0, double d = 0) {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), format, a, b, c, d);  // NOLINT: format is ours
  return text.data();
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

/// SVG's y runs down: the picture is mirrored, and with it the sense of an arc.
std::string path(const Primitive& shape) {
  const Point2 a = startPoint(shape), b = endPoint(shape);
  std::string d = formatted("M %.4f %.4f ", a.x(), -a.y());
  const auto* arc = std::get_if<Arc>(&shape);
  if (arc == nullptr) return d + formatted("L %.4f %.4f", b.x(), -b.y());
  d += formatted("A %.4f %.4f 0 ", arc->radiusMm, arc->radiusMm);
  d += std::abs(arc->sweepRad) > std::numbers::pi ? "1 " : "0 ";
  d += arc->sweepRad > 0 ? "0 " : "1 ";
  return d + formatted("%.4f %.4f", b.x(), -b.y());
}

}  // namespace

std::string toSvg(const Section& section) {
  Point2 low(1e9, 1e9), high(-1e9, -1e9);
  for (const NamedPrimitive& p : section.primitives)
    for (int i = 0; i <= 8; ++i) {
      const Point2 at = pointAt(p.shape, length(p.shape) * i / 8);
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
  low.array() -= kMarginMm;
  high.array() += kMarginMm;
  const Point2 size = high - low;

  std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"";
  svg += formatted(" width=\"%.0f\" height=\"%.0f\"", kPxPerMm * size.x(), kPxPerMm * size.y());
  svg += formatted(" viewBox=\"%.3f %.3f %.3f %.3f\">\n", low.x(), -high.y(), size.x(), size.y());
  svg += "<title>" + escaped(section.name) + "</title>\n<desc>" + escaped(section.note) + "</desc>\n";
  svg += formatted("<rect x=\"%.3f\" y=\"%.3f\" width=\"%.3f\" height=\"%.3f\" fill=\"white\"/>\n", low.x(), -high.y(),
                   size.x(), size.y());
  svg += formatted(
      "<path d=\"M %.3f %.3f V %.3f\" stroke=\"#999\" stroke-width=\"0.15\" stroke-dasharray=\"3 1 0.5 1\"/>\n",
      section.axisXMm(), -high.y() + 2, -low.y() - 2);
  svg += "<g fill=\"none\" stroke-width=\"0.5\" stroke-linecap=\"butt\">\n";
  for (const NamedPrimitive& p : section.primitives) {
    const bool arc = std::holds_alternative<Arc>(p.shape);
    svg += std::string("<path stroke=\"") + (arc ? "#c45a00" : "#0a5a9c") + "\" d=\"" + path(p.shape) + "\"><title>" +
           escaped(p.name) + "</title></path>\n";
  }
  svg += "</g>\n<g font-family=\"sans-serif\" font-size=\"3\" fill=\"#222\">\n";
  for (const NamedPrimitive& p : section.primitives) {
    const double half = length(p.shape) / 2;
    const Point2 out = normalAt(p.shape, half);
    const Point2 at = pointAt(p.shape, half) + 2.5 * out;
    const char* anchor = out.x() > 0.3 ? "start" : out.x() < -0.3 ? "end" : "middle";
    svg += formatted("<text x=\"%.3f\" y=\"%.3f\" text-anchor=\"", at.x(), -at.y() + 1) + anchor + "\">" +
           escaped(p.name) + "</text>\n";
  }
  return svg + "</g>\n</svg>\n";
}

}  // namespace vignole
