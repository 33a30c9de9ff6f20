#include "calibration/light_plane/target_stripe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "calibration/intrinsics/reprojection.h"
#include "calibration/light_plane/target_print.h"
#include "engine/optics/camera_model.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole {
namespace {

constexpr double kStraightPx = 1.5;       // how far off the straight line a point may lie
constexpr std::size_t kLeastPoints = 12;  // of a line
constexpr int kLeastSide = 32;            // px, for the extraction
constexpr int kMarginPx = 16;             // about the target
// Print under the line pulls it aside: what is predicted is taken off, half of it stays uncertain. Lines pulled
// further, in their widths, are left out.
constexpr double kPullUncertain = 0.5, kMostPull = 0.35;
constexpr double kUsualBlack = 0.3;  // light that black gives back, of white's, where the line does not show it
constexpr std::size_t kLeastShades = 15;

struct Sample {
  StripeSample stripe;
  double contrastDn = 0;
  double mmPerPx = 1;    // across the line
  double stepMm = 0;     // along the line, from one point to the next
  double widthPx = 1;    // of the light, standard deviation
  Point2 widthMm{0, 0};  // the same on the target, across the line
  std::size_t line = 0;  // of the extraction
};

Point2 inTarget(const Eigen::Vector3d& inCamera, const Extrinsics& pose) {
  return (pose.rotation.transpose() * (inCamera - pose.translationMm)).head<2>();
}

std::optional<Point2> onTarget(const Point2& px, const Extrinsics& pose, const Intrinsics& in) {
  const auto at = onTargetPlane(px, pose, in);
  if (!at) return std::nullopt;
  return inTarget(*at, pose);
}

struct Window {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // x1, y1: beyond the last
};

/// The part of the picture that shows the target.
Window windowOf(const TargetRectangle& area, const Extrinsics& pose, const Intrinsics& in) {
  constexpr int kSteps = 8;
  Point2 low(in.widthPx, in.heightPx), high(0, 0);
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; j <= kSteps; ++j) {
      const Point2 size = area.max - area.min;
      const Point2 at = area.min + Point2(size.x() * i / kSteps, size.y() * j / kSteps);
      const Point2 px = reprojected(in, pose, Eigen::Vector3d(at.x(), at.y(), 0), 0);
      if (!px.allFinite()) continue;
      low = low.cwiseMin(px);
      high = high.cwiseMax(px);
    }
  const auto bound = [](double value, int most) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
  };
  return {bound(low.x() - kMarginPx, in.widthPx), bound(low.y() - kMarginPx, in.heightPx),
          bound(high.x() + kMarginPx, in.widthPx), bound(high.y() + kMarginPx, in.heightPx)};
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Straight line on the target: normal . point = offset.
struct Straight {
  Point2 normal{1, 0};
  double offset = 0;
  [[nodiscard]] double distance(const Point2& p) const { return normal.dot(p) - offset; }
};

Straight fitted(const std::vector<const Sample*>& samples) {
  Point2 middle(0, 0);
  double weights = 0;
  const auto weightOf = [](const Sample& s) { return 1 / std::pow(s.stripe.sigmaPx * s.mmPerPx, 2); };
  for (const Sample* s : samples) {
    middle += weightOf(*s) * s->stripe.onTargetMm;
    weights += weightOf(*s);
  }
  middle /= weights;
  double xx = 0, xy = 0, yy = 0;
  for (const Sample* s : samples) {
    const Point2 d = s->stripe.onTargetMm - middle;
    xx += weightOf(*s) * d.x() * d.x();
    xy += weightOf(*s) * d.x() * d.y();
    yy += weightOf(*s) * d.y() * d.y();
  }
  const double along = 0.5 * std::atan2(2 * xy, xx - yy);
  Straight line;
  line.normal = {-std::sin(along), std::cos(along)};
  line.offset = line.normal.dot(middle);
  return line;
}

std::vector<const Sample*> near(const Straight& line, const std::vector<Sample>& all) {
  std::vector<const Sample*> found;
  for (const Sample& s : all)
    if (std::abs(line.distance(s.stripe.onTargetMm)) < kStraightPx * s.mmPerPx) found.push_back(&s);
  return found;
}

/// From one extracted line to the straight line on the target with all that lies on it.
std::vector<const Sample*> straightened(const std::vector<Sample>& all, std::size_t line) {
  std::vector<const Sample*> members;
  for (const Sample& s : all)
    if (s.line == line) members.push_back(&s);
  if (members.size() < kLeastPoints) return {};
  // An extracted line may turn aside: the pair of its points with most others on their line begins.
  std::vector<const Sample*> best;
  const std::size_t step = std::max<std::size_t>(1, members.size() / 12);
  for (std::size_t i = 0; i < members.size(); i += step)
    for (std::size_t j = i + step; j < members.size(); j += step) {
      const Point2 along = members[j]->stripe.onTargetMm - members[i]->stripe.onTargetMm;
      if (along.norm() < 8 * members[i]->mmPerPx) continue;
      Straight trial;
      trial.normal = Point2(-along.y(), along.x()).normalized();
      trial.offset = trial.normal.dot(members[i]->stripe.onTargetMm);
      auto found = near(trial, all);
      if (found.size() > best.size()) best = std::move(found);
    }
  for (int round = 0; round < 4 && best.size() >= kLeastPoints; ++round) best = near(fitted(best), all);
  return best;
}

/// How far the longest extracted line is from straight: median distance, mm.
double bendOf(const std::vector<Sample>& samples) {
  std::map<std::size_t, std::vector<const Sample*>> lines;
  for (const Sample& s : samples) lines[s.line].push_back(&s);
  const std::vector<const Sample*>* longest = nullptr;
  for (const auto& [line, members] : lines)
    if (longest == nullptr || members.size() > longest->size()) longest = &members;
  if (longest == nullptr || longest->size() < kLeastPoints) return 0;
  const Straight straight = fitted(*longest);
  std::vector<double> distances;
  for (const Sample* s : *longest) distances.push_back(std::abs(straight.distance(s->stripe.onTargetMm)));
  return medianOf(std::move(distances));
}

/// By how much the points' standard uncertainties have to grow for what they scatter about the straight line, and for
/// what neighbours share of it: the number of points that come to one independent one.
double widening(const Straight& straight, const std::vector<const Sample*>& samples) {
  constexpr std::size_t kMostLag = 60;
  constexpr double kLeastScatter = 0.5;
  std::vector<double> errors;
  double mean = 0, square = 0;
  for (const Sample* s : samples) {
    errors.push_back(straight.distance(s->stripe.onTargetMm) / (s->stripe.sigmaPx * s->mmPerPx));
    mean += errors.back() / static_cast<double>(samples.size());
  }
  for (double& e : errors) {
    e -= mean;
    square += e * e / static_cast<double>(errors.size());
  }
  double together = 1;
  for (std::size_t lag = 1; lag <= std::min(kMostLag, errors.size() / 4); ++lag) {
    double product = 0;
    for (std::size_t i = 0; i + lag < errors.size(); ++i) product += errors[i] * errors[i + lag];
    const double correlation = product / (static_cast<double>(errors.size() - lag) * std::max(square, 1e-12));
    if (correlation < 0.05) break;
    together += 2 * correlation;
  }
  return std::max(std::sqrt(square), kLeastScatter) * std::sqrt(together);
}

TargetLine lineOf(const std::vector<const Sample*>& samples) {
  TargetLine line;
  const Straight straight = fitted(samples);
  const double wider = widening(straight, samples);
  std::vector<double> contrasts;
  double squares = 0;
  for (const Sample* s : samples) {
    line.samples.push_back(s->stripe);
    line.samples.back().sigmaPx *= wider;
    line.lengthMm += s->stepMm;
    contrasts.push_back(s->contrastDn);
    squares += std::pow(straight.distance(s->stripe.onTargetMm), 2);
  }
  line.rmsMm = std::sqrt(squares / static_cast<double>(samples.size()));
  line.contrastDn = medianOf(std::move(contrasts));
  return line;
}

class Finder {
 public:
  Finder(const ImageView& laser, const PlanarTarget& target, const Intrinsics& in, const TargetStripeSettings& settings)
      : laser_(laser), target_(target), in_(in), settings_(settings), area_(printedArea(target)) {}

  void find(TargetStripe& stripe) {
    const Window window = windowOf(area_, stripe.pose.cameraFromTarget, in_);
    if (window.x1 - window.x0 < kLeastSide || window.y1 - window.y0 < kLeastSide) {
      stripe.refusal = "the target fills too little of the picture to look for the laser on it";
      return;
    }
    const ImageView part{laser_.row(window.y0) + window.x0, window.x1 - window.x0, window.y1 - window.y0,
                         laser_.stride};
    StripeExtractor extractor(settings_.stripe);
    StripeResult extracted;
    extractor.extract(part, extracted);
    std::vector<Sample> samples = samplesOf(extracted, window, stripe.pose.cameraFromTarget);
    takeOffPrint(samples, stripe.pose.cameraFromTarget);
    collect(std::move(samples), extracted.lines.size(), stripe.lines);
    if (stripe.lines.empty())
      stripe.refusal =
          "no laser line on the target; let the laser hit it, with little other light and the line not saturated";
  }

 private:
  [[nodiscard]] std::vector<Sample> samplesOf(const StripeResult& extracted, const Window& window,
                                              const Extrinsics& pose) const {
    std::vector<Sample> samples;
    for (std::size_t l = 0; l < extracted.lines.size(); ++l) {
      const StripeLine& line = extracted.lines[l];
      Point2 last(0, 0);
      bool joined = false;  // to the point before
      for (std::uint32_t i = line.first; i < line.first + line.count; ++i) {
        const StripePoint& p = extracted.points[i];
        const Point2 px = Point2(p.x, p.y) + Point2(window.x0, window.y0), normal(p.nx, p.ny);
        const auto here = onTarget(px, pose, in_), beside = onTarget(px + normal, pose, in_);
        if ((p.flags & (kLineEnd | kGapEdge)) != 0 || !here || !beside || !inside(*here)) {
          joined = false;
          continue;
        }
        Sample s;
        s.stripe.px = px;
        s.stripe.normalPx = normal;
        s.stripe.sigmaPx = std::max(p.sigmaPx, 1e-3F);
        s.contrastDn = p.strength;
        s.line = l;
        s.stripe.onTargetMm = *here;
        s.mmPerPx = (*beside - *here).norm();
        s.stepMm = joined ? std::min((*here - last).norm(), 3 * s.mmPerPx) : s.mmPerPx;
        last = *here;
        joined = true;
        s.widthPx = settings_.printSeen ? std::hypot(settings_.stripe.sigma, p.widthPx) : p.widthPx;
        s.widthMm = s.widthPx * (*beside - *here);
        samples.push_back(s);
      }
    }
    return samples;
  }

  [[nodiscard]] std::vector<PrintAcross> printUnder(const std::vector<Sample>& samples) const {
    std::vector<PrintAcross> all;
    all.reserve(samples.size());
    for (const Sample& s : samples) all.emplace_back(target_, s.stripe.onTargetMm, s.widthMm);
    return all;
  }

  /// What black gives back of the light by how bright the line is on either.
  static double shareByContrast(const std::vector<Sample>& samples, const std::vector<PrintAcross>& print) {
    std::vector<double> white, black;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (print[i].white()) white.push_back(samples[i].contrastDn);
      if (print[i].black()) black.push_back(samples[i].contrastDn);
    }
    if (white.size() < kLeastShades || black.size() < kLeastShades) return kUsualBlack;
    return std::clamp(medianOf(std::move(black)) / medianOf(std::move(white)), 0.05, 2.0);
  }

  /// The same by what makes the line straight: a line along a border of squares is pulled to and fro.
  static double shareByStraightness(const std::vector<Sample>& samples, const std::vector<PrintAcross>& print,
                                    double byContrast) {
    double best = byContrast, leastBend = 1e300;
    for (const double share : {byContrast, 0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 0.85, 1.0, 1.2}) {
      std::vector<Sample> moved = samples;
      for (std::size_t i = 0; i < moved.size(); ++i)
        moved[i].stripe.onTargetMm -= print[i].pull(share) * moved[i].widthMm;
      const double bend = bendOf(moved);
      // The first word has the line's brightness; another must be clearly better.
      if (bend < 0.98 * leastBend) {
        leastBend = bend;
        best = share;
      }
    }
    return best;
  }

  void takeOffPrint(std::vector<Sample>& samples, const Extrinsics& pose) const {
    const std::vector<PrintAcross> print = printUnder(samples);
    const double share = shareByStraightness(samples, print, shareByContrast(samples, print));
    std::vector<Sample> kept;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      Sample s = samples[i];
      const double pull = print[i].pull(share);
      if (std::abs(pull) > kMostPull) continue;
      const double pullPx = pull * s.widthPx;
      const double uncertain = settings_.printSeen ? 1 : kPullUncertain;
      s.stripe.sigmaPx = std::hypot(s.stripe.sigmaPx, uncertain * pullPx);
      if (!settings_.printSeen) {
        s.stripe.px -= pullPx * s.stripe.normalPx;
        if (const auto there = onTarget(s.stripe.px, pose, in_)) s.stripe.onTargetMm = *there;
      }
      kept.push_back(s);
    }
    samples = std::move(kept);
  }

  [[nodiscard]] bool inside(const Point2& p) const {
    return p.x() > area_.min.x() && p.y() > area_.min.y() && p.x() < area_.max.x() && p.y() < area_.max.y();
  }

  /// Straight lines by how much bright light lies on them; each sample on one only.
  void collect(std::vector<Sample> samples, std::size_t extractedLines, std::vector<TargetLine>& lines) const {
    const Point2 size = area_.max - area_.min;
    const double leastMm = settings_.leastLengthShare * size.minCoeff();
    while (lines.size() < settings_.mostLines) {
      std::vector<const Sample*> best;
      double bestLight = 0;
      for (std::size_t l = 0; l < extractedLines; ++l) {
        const auto found = straightened(samples, l);
        double light = 0;
        for (const Sample* s : found) light += s->stepMm * s->contrastDn;
        if (light <= bestLight) continue;
        bestLight = light;
        best = found;
      }
      if (best.size() < kLeastPoints) return;
      TargetLine line = lineOf(best);
      const bool enough = line.lengthMm >= leastMm;
      std::vector<Sample> left;
      for (const Sample& s : samples)
        if (std::find(best.begin(), best.end(), &s) == best.end()) left.push_back(s);
      if (enough) lines.push_back(std::move(line));
      samples = std::move(left);
    }
  }

  ImageView laser_;
  const PlanarTarget& target_;
  const Intrinsics& in_;
  const TargetStripeSettings& settings_;
  TargetRectangle area_;
};

}  // namespace

std::optional<Eigen::Vector3d> onTargetPlane(const Point2& px, const Extrinsics& cameraFromTarget,
                                             const Intrinsics& in) {
  const Vector2T<double> u = undistortedFromPixel(lens(in), Vector2T<double>(px));
  const Eigen::Vector3d ray(u.x(), u.y(), in.focalMm), normal = cameraFromTarget.rotation.col(2);
  const double depth = normal.dot(cameraFromTarget.translationMm) / normal.dot(ray);
  if (!(depth > 0) || !std::isfinite(depth)) return std::nullopt;
  return depth * ray;
}

std::vector<std::uint8_t> laserAlone(const ImageView& laser, const ImageView& other) {
  // The print is as bright in both but for the colour of the light: their ratio where there is no laser, the median.
  constexpr int kGround = 24;  // DN, so that noise below nought is kept
  std::vector<double> ratios;
  for (int y = 0; y < laser.height; y += 4)
    for (int x = 0; x < laser.width; x += 4)
      if (other.row(y)[x] > 20 && laser.row(y)[x] < 250)
        ratios.push_back(static_cast<double>(laser.row(y)[x]) / other.row(y)[x]);
  double ratio = 1;
  if (!ratios.empty()) {
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    ratio = *middle;
  }
  std::vector<std::uint8_t> alone;
  alone.reserve(static_cast<std::size_t>(laser.width) * static_cast<std::size_t>(laser.height));
  for (int y = 0; y < laser.height; ++y)
    for (int x = 0; x < laser.width; ++x)
      alone.push_back(static_cast<std::uint8_t>(
          std::clamp(std::lround(laser.row(y)[x] - ratio * other.row(y)[x]) + kGround, 0L, 255L)));
  return alone;
}

TargetStripe findTargetStripe(const ImageView& laser, const TargetView& view, const PlanarTarget& target,
                              const Intrinsics& in, const TargetStripeSettings& settings) {
  TargetStripe stripe;
  stripe.file = view.file;
  stripe.view = view;
  stripe.refusal = view.refusal;
  if (!stripe.usable()) return stripe;
  if (laser.width != in.widthPx || laser.height != in.heightPx) {
    stripe.refusal = "the picture is " + std::to_string(laser.width) + " x " + std::to_string(laser.height) +
                     " px, the intrinsics are of " + std::to_string(in.widthPx) + " x " + std::to_string(in.heightPx) +
                     " px; take those of this camera";
    return stripe;
  }
  const auto pose = targetPose(view, target, in);
  if (!pose) {
    stripe.refusal = pose.error().what;
    return stripe;
  }
  stripe.pose = *pose;
  Finder(laser, target, in, settings).find(stripe);
  return stripe;
}

}  // namespace vignole
