#include "cli/study_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "engine/files/atomic_file.h"

namespace vignole::cli {

namespace {

constexpr double kWidth = 960, kPanelHeight = 340;
constexpr double kLeft = 84, kRight = 150, kTop = 40, kBottom = 52;  // room for labels, names of levels, title

struct Colour {
  int red, green, blue;
};
constexpr std::array<Colour, 6> kColours = {
    {{31, 119, 180}, {44, 140, 90}, {150, 90, 170}, {200, 30, 30}, {70, 70, 70}, {200, 30, 30}}};
constexpr Colour kInk{40, 40, 40}, kGrid{225, 225, 225};

Colour colourOf(ChartColour colour) { return kColours.at(static_cast<std::size_t>(colour)); }

enum class Anchor { Start, Middle, End };

/// SVG and PNG only differ in how they draw lines, dots, boxes and words.
class Canvas {
 public:
  Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  virtual ~Canvas() = default;
  virtual void polyline(const std::vector<Point2>& points, Colour colour, double width) = 0;
  virtual void dot(const Point2& at, Colour colour, double radius) = 0;
  virtual void box(const Point2& corner, const Point2& size, Colour colour) = 0;
  virtual void text(const Point2& at, const std::string& text, Anchor anchor, bool large) = 0;
};

std::string number(double value, int decimals) {
  std::array<char, 64> text{};
  if (std::abs(value) < 0.5 * std::pow(10.0, -decimals)) value = 0;  // never -0
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

class SvgCanvas : public Canvas {
 public:
  explicit SvgCanvas(double height) {
    text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
            number(kWidth, 0) + "\" height=\"" + number(height, 0) + "\" viewBox=\"0 0 " + number(kWidth, 0) + " " +
            number(height, 0) +
            "\" font-family=\"sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  }
  void polyline(const std::vector<Point2>& points, Colour colour, double width) override {
    text_ +=
        "<polyline fill=\"none\" stroke=\"" + rgb(colour) + "\" stroke-width=\"" + number(width, 1) + "\" points=\"";
    for (const Point2& p : points) text_ += number(p.x(), 2) + "," + number(p.y(), 2) + " ";
    text_ += "\"/>\n";
  }
  void dot(const Point2& at, Colour colour, double radius) override {
    text_ += "<circle cx=\"" + number(at.x(), 2) + "\" cy=\"" + number(at.y(), 2) + "\" r=\"" + number(radius, 1) +
             "\" fill=\"" + rgb(colour) + "\"/>\n";
  }
  void box(const Point2& corner, const Point2& size, Colour colour) override {
    text_ += "<rect x=\"" + number(corner.x(), 2) + "\" y=\"" + number(corner.y(), 2) + "\" width=\"" +
             number(size.x(), 2) + "\" height=\"" + number(size.y(), 2) + "\" fill=\"" + rgb(colour) + "\"/>\n";
  }
  void text(const Point2& at, const std::string& words, Anchor anchor, bool large) override {
    constexpr std::array<const char*, 3> kAnchors = {"start", "middle", "end"};
    text_ += "<text x=\"" + number(at.x(), 2) + "\" y=\"" + number(at.y(), 2) + "\" font-size=\"" +
             (large ? "16" : "13") + "\" text-anchor=\"" + kAnchors.at(static_cast<std::size_t>(anchor)) +
             "\" fill=\"" + rgb(kInk) + "\">" + escaped(words) + "</text>\n";
  }
  [[nodiscard]] std::string finished() const { return text_ + "</svg>\n"; }

 private:
  static std::string rgb(Colour c) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", c.red & 255, c.green & 255, c.blue & 255);
    return text.data();
  }
  static std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    return result;
  }
  std::string text_;
};

class PngCanvas : public Canvas {
 public:
  explicit PngCanvas(double height) : image_(px(height), px(kWidth), CV_8UC3, cv::Scalar(255, 255, 255)) {}
  void polyline(const std::vector<Point2>& points, Colour colour, double width) override {
    std::vector<cv::Point> path;
    for (const Point2& p : points) path.push_back(at(p));
    cv::polylines(image_, path, false, bgr(colour), std::max(1, px(width)), cv::LINE_AA);
  }
  void dot(const Point2& where, Colour colour, double radius) override {
    cv::circle(image_, at(where), std::max(1, px(radius)), bgr(colour), cv::FILLED, cv::LINE_AA);
  }
  void box(const Point2& corner, const Point2& size, Colour colour) override {
    cv::rectangle(image_, at(corner), at(corner + size), bgr(colour), cv::FILLED);
  }
  void text(const Point2& where, const std::string& words, Anchor anchor, bool large) override {
    const double scale = (large ? 0.5 : 0.42) * kScale;
    const int thickness = 1;
    const cv::Size size = cv::getTextSize(words, cv::FONT_HERSHEY_SIMPLEX, scale, thickness, nullptr);
    cv::Point origin = at(where);
    origin.x -= anchor == Anchor::Middle ? size.width / 2 : anchor == Anchor::End ? size.width : 0;
    cv::putText(image_, words, origin, cv::FONT_HERSHEY_SIMPLEX, scale, bgr(kInk), thickness, cv::LINE_AA);
  }
  [[nodiscard]] std::string finished() const {
    std::vector<unsigned char> bytes;
    cv::imencode(".png", image_, bytes);
    return {bytes.begin(), bytes.end()};
  }

 private:
  static constexpr double kScale = 1.5;
  static int px(double length) { return static_cast<int>(std::lround(length * kScale)); }
  static cv::Point at(const Point2& p) { return {px(p.x()), px(p.y())}; }
  static cv::Scalar bgr(Colour c) {
    return {static_cast<double>(c.blue), static_cast<double>(c.green), static_cast<double>(c.red)};
  }
  cv::Mat image_;
};

/// One axis: the stretch that is shown and its round marks.
struct Axis {
  double low = 0, high = 1, step = 1;
  int decimals = 0;

  static Axis over(double low, double high, double margin) {
    Axis a;
    if (!(high > low)) {
      const double half = low == 0 ? 1 : 0.05 * std::abs(low);
      low -= half;
      high += half;
    }
    a.low = low - margin * (high - low);
    a.high = high + margin * (high - low);
    const double rough = (a.high - a.low) / 6, power = std::pow(10.0, std::floor(std::log10(rough)));
    const double digit = rough / power;
    a.step = power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
    a.decimals = std::clamp(static_cast<int>(-std::floor(std::log10(a.step) + 1e-9)), 0, 9);
    return a;
  }
  [[nodiscard]] std::vector<double> marks() const {
    std::vector<double> list;
    for (double k = std::ceil(low / step); k * step <= high && list.size() < 20; ++k) list.push_back(k * step);
    return list;
  }
};

class Panel {
 public:
  Panel(Canvas& canvas, const Chart& chart, double top) : canvas_(canvas), chart_(chart), top_(top) {
    double xLow = INFINITY, xHigh = -INFINITY, yLow = INFINITY, yHigh = -INFINITY;
    bool bars = false;
    for (const ChartSeries& s : chart.series) {
      bars = bars || s.look == ChartSeries::Look::Bars;
      for (const Point2& p : s.points) {
        if (!p.allFinite()) continue;
        xLow = std::min(xLow, p.x());
        xHigh = std::max(xHigh, p.x());
        yLow = std::min(yLow, p.y());
        yHigh = std::max(yHigh, p.y());
      }
    }
    for (const ChartLevel& level : chart.levels) {
      yLow = std::min(yLow, level.value);
      yHigh = std::max(yHigh, level.value);
    }
    if (bars) yLow = std::min(yLow, 0.0);
    if (!std::isfinite(xLow) || !std::isfinite(yLow)) return;
    empty_ = false;
    x_ = bars ? Axis::over(xLow - 0.6, xHigh + 0.6, 0) : Axis::over(xLow, xHigh, 0.02);
    y_ = Axis::over(yLow, yHigh, 0.06);
  }

  void draw() {
    canvas_.text({kLeft, top_ + 22}, chart_.title, Anchor::Start, true);
    if (empty_) return canvas_.text({kLeft, top_ + 60}, "no values", Anchor::Start, false);
    axes();
    for (const ChartSeries& s : chart_.series) series(s);
    levels();
    key();
  }

 private:
  [[nodiscard]] double right() const { return kWidth - kRight; }
  [[nodiscard]] double bottom() const { return top_ + kPanelHeight - kBottom; }
  [[nodiscard]] Point2 at(const Point2& p) const {
    return {kLeft + (p.x() - x_.low) / (x_.high - x_.low) * (right() - kLeft),
            bottom() - (p.y() - y_.low) / (y_.high - y_.low) * (bottom() - top_ - kTop)};
  }

  void axes() {
    for (const double mark : y_.marks()) {
      const Point2 p = at({x_.low, mark});
      canvas_.polyline({p, {right(), p.y()}}, kGrid, 1);
      canvas_.text({kLeft - 8, p.y() + 4}, number(mark, y_.decimals), Anchor::End, false);
    }
    if (chart_.categories.empty()) {
      for (const double mark : x_.marks()) xMark(mark, number(mark, x_.decimals));
    } else {
      const std::size_t every = 1 + chart_.categories.size() / 24;
      for (std::size_t i = 0; i < chart_.categories.size(); i += every)
        xMark(static_cast<double>(i), chart_.categories[i].substr(0, 12));
    }
    canvas_.polyline({{kLeft, top_ + kTop}, {kLeft, bottom()}, {right(), bottom()}}, kInk, 1);
    canvas_.text({0.5 * (kLeft + right()), bottom() + 38}, chart_.xLabel, Anchor::Middle, false);
    canvas_.text({right(), top_ + 22}, chart_.yLabel, Anchor::End, false);
  }
  void xMark(double x, const std::string& label) {
    const Point2 p = at({x, y_.low});
    canvas_.polyline({p, p + Point2(0, 5)}, kInk, 1);
    canvas_.text(p + Point2(0, 20), label, Anchor::Middle, false);
  }

  void series(const ChartSeries& s) {
    const Colour colour = colourOf(s.colour);
    std::vector<Point2> path;
    for (const Point2& p : s.points) {
      if (!p.allFinite()) {  // a gap
        if (path.size() > 1) canvas_.polyline(path, colour, 1.3);
        path.clear();
        continue;
      }
      const Point2 q = at(p);
      if (s.look == ChartSeries::Look::Bars) {
        const double zero = at({p.x(), 0}).y(), half = 0.35 * (at({1, 0}).x() - at({0, 0}).x());
        canvas_.box({q.x() - half, std::min(q.y(), zero)}, {2 * half, std::abs(zero - q.y())}, colour);
        continue;
      }
      if (s.look != ChartSeries::Look::Dots) path.push_back(q);
      if (s.look != ChartSeries::Look::Line) canvas_.dot(q, colour, 2.5);
    }
    if (path.size() > 1) canvas_.polyline(path, colour, 1.3);
  }

  /// Names beside their lines, moved apart where they would cover each other.
  void levels() {
    std::vector<const ChartLevel*> order;
    for (const ChartLevel& level : chart_.levels) order.push_back(&level);
    std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) { return a->value > b->value; });
    double last = -INFINITY;
    for (const ChartLevel* level : order) {
      const double y = at({x_.low, level->value}).y();
      canvas_.polyline({{kLeft, y}, {right(), y}}, colourOf(level->colour), 1.3);
      last = std::max(y + 4, last + 15);
      canvas_.text({right() + 6, last}, level->name, Anchor::Start, false);
    }
  }

  void key() {
    double x = kLeft + 40 + 8.5 * static_cast<double>(chart_.title.size());
    for (const ChartSeries& s : chart_.series) {
      if (s.name.empty() || x > right() - 60) continue;
      canvas_.box({x, top_ + 15}, {14, 4}, colourOf(s.colour));
      canvas_.text({x + 19, top_ + 22}, s.name, Anchor::Start, false);
      x += 40 + 8.0 * static_cast<double>(s.name.size());
    }
  }

  Canvas& canvas_;
  const Chart& chart_;
  double top_;
  Axis x_, y_;
  bool empty_ = true;
};

void draw(Canvas& canvas, const std::vector<Chart>& charts) {
  double top = 0;
  for (const Chart& chart : charts) {
    Panel(canvas, chart, top).draw();
    top += kPanelHeight;
  }
}

}  // namespace

Expected<void> checkPlotFile(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension != ".svg" && extension != ".png")
    return inputError("--plot", "'" + file.string() + "' ends neither in .svg nor in .png");
  return {};
}

Expected<void> writePlot(const std::vector<Chart>& charts, const std::filesystem::path& file) {
  const double height = kPanelHeight * static_cast<double>(std::max<std::size_t>(charts.size(), 1));
  if (file.extension() == ".svg") {
    SvgCanvas canvas(height);
    draw(canvas, charts);
    return writeFile(file, canvas.finished());
  }
  PngCanvas canvas(height);
  draw(canvas, charts);
  return writeFile(file, canvas.finished());
}

}  // namespace vignole::cli
