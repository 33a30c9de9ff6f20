#include "cli/profile_overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string_view>
#include <vector>

namespace vignole::cli {
namespace {

constexpr double kMarginMm = 12;
constexpr double kStepMm = 0.5;     // chords of arcs
constexpr double kPixelsPerMm = 8;  // of the PNG

struct Colour {
  int red, green, blue;
};
constexpr Colour kSection{150, 150, 150}, kPoint{60, 60, 60}, kFitted{214, 39, 40}, kDimension{31, 119, 180};

struct Line {
  std::vector<Point2> points;
  Colour colour;
  double widthMm;
};
struct Label {
  Point2 at;
  std::string text;
  Colour colour;
};
/// What is drawn, in the frame of the points; SVG and PNG only differ in how they write it.
struct Picture {
  std::vector<Line> lines;
  std::vector<Point2> dots;
  std::vector<Label> labels;
  Point2 low{1e300, 1e300}, high{-1e300, -1e300};

  void include(const Point2& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
};

std::string number(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

Picture compose(const Section& section, std::span<const ProfilePoint> points, const Registration& registration,
                const Measurement& measurement) {
  Picture picture;
  for (const ProfilePoint& p : points) {
    picture.dots.emplace_back(p.x, p.y);
    picture.include({p.x, p.y});
  }
  if (registration.valid)
    for (const auto& p : section.primitives) {
      picture.lines.push_back({polyline(transformed(registration.worldFromSection, p.shape), kStepMm), kSection, 0.15});
      for (const Point2& q : picture.lines.back().points) picture.include(q);
    }
  for (const FittedPrimitive& f : measurement.fitted)
    picture.lines.push_back({polyline(f.shape, kStepMm), kFitted, 0.3});
  for (const Dimension d : kDimensions) {
    const DimensionResult& r = measurement.dimensions[index(d)];
    if (!r.valueMm || r.anchors.size() < 2) continue;
    for (std::size_t k = 0; k + 1 < r.anchors.size(); k += 2)
      picture.lines.push_back({{r.anchors[k], r.anchors[k + 1]}, kDimension, 0.25});
    picture.labels.push_back(
        {0.5 * (r.anchors[0] + r.anchors[1]), std::string(name(d)) + " " + number(*r.valueMm, 3), kDimension});
  }
  picture.low -= Point2(kMarginMm, kMarginMm);
  picture.high += Point2(kMarginMm, kMarginMm);
  return picture;
}

std::string rgb(const Colour& c) {
  char text[16];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", c.red & 255, c.green & 255, c.blue & 255);
  return text;
}

}  // namespace

std::string overlaySvg(const Section& section, std::span<const ProfilePoint> points, const Registration& registration,
                       const Measurement& measurement) {
  const Picture picture = compose(section, points, registration, measurement);
  const Point2 size = picture.high - picture.low;
  const auto x = [&](const Point2& p) { return number(p.x() - picture.low.x(), 4); };
  const auto y = [&](const Point2& p) { return number(picture.high.y() - p.y(), 4); };
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(size.x(), 2) + "mm\" height=\"" +
                    number(size.y(), 2) + "mm\" viewBox=\"0 0 " + number(size.x(), 2) + " " + number(size.y(), 2) +
                    "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  svg += "<g fill=\"" + rgb(kPoint) + "\">\n";
  for (const Point2& p : picture.dots) svg += "<circle cx=\"" + x(p) + "\" cy=\"" + y(p) + "\" r=\"0.2\"/>\n";
  svg += "</g>\n";
  for (const Line& line : picture.lines) {
    svg += "<polyline fill=\"none\" stroke=\"" + rgb(line.colour) + "\" stroke-width=\"" + number(line.widthMm, 2) +
           "\" points=\"";
    for (const Point2& p : line.points) svg += x(p) + "," + y(p) + " ";
    svg += "\"/>\n";
  }
  for (const Label& label : picture.labels)
    svg += "<text x=\"" + x(label.at) + "\" y=\"" + y(label.at) +
           "\" font-family=\"sans-serif\" font-size=\"3\" fill=\"" + rgb(label.colour) + "\">" + label.text +
           "</text>\n";
  return svg + "</svg>\n";
}

Expected<std::string> overlayPng(const Section& section, std::span<const ProfilePoint> points,
                                 const Registration& registration, const Measurement& measurement) {
  const Picture picture = compose(section, points, registration, measurement);
  const Point2 size = (picture.high - picture.low) * kPixelsPerMm;
  constexpr double kLargestPx = 8000;  // a profile whose points do not belong together may be huge
  const double scale = kPixelsPerMm * std::min(1.0, kLargestPx / size.maxCoeff());
  const auto pixel = [&](const Point2& p) {
    return cv::Point(static_cast<int>(std::lround((p.x() - picture.low.x()) * scale)),
                     static_cast<int>(std::lround((picture.high.y() - p.y()) * scale)));
  };
  const auto colour = [](const Colour& c) { return cv::Scalar(c.blue, c.green, c.red); };
  cv::Mat image(static_cast<int>(size.y() * scale / kPixelsPerMm) + 1,
                static_cast<int>(size.x() * scale / kPixelsPerMm) + 1, CV_8UC3, cv::Scalar(255, 255, 255));
  for (const Point2& p : picture.dots) cv::circle(image, pixel(p), 1, colour(kPoint), cv::FILLED, cv::LINE_AA);
  for (const Line& line : picture.lines) {
    std::vector<cv::Point> path;
    for (const Point2& p : line.points) path.push_back(pixel(p));
    const int width = std::max(1, static_cast<int>(std::lround(line.widthMm * scale)));
    cv::polylines(image, path, false, colour(line.colour), width, cv::LINE_AA);
  }
  for (const Label& label : picture.labels)
    cv::putText(image, label.text, pixel(label.at), cv::FONT_HERSHEY_SIMPLEX, 0.6, colour(label.colour), 1,
                cv::LINE_AA);
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".png", image, bytes)) return worldError("overlay", "OpenCV cannot write PNG");
  return std::string(bytes.begin(), bytes.end());
}

}  // namespace vignole::cli
