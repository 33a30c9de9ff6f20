#include "engine/simulator/line_bound.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/simulator/sensor.h"
#include "engine/simulator/surface.h"

namespace vignole::simulator {

namespace {

constexpr double kWhite = 255;
constexpr double kReachSigmas = 5;
constexpr double kNothingKnown = 1e12;  // DN^2

/// A Gaussian through the pixels about a place: the logarithm of its light is a straight line over the squared distance
/// from the centre, which is known.
LineLight readLight(const ImageView& picture, double ambientDn, const Point2& at, const Point2& normal) {
  constexpr int kReachPx = 14;
  constexpr double kAlongPx = 1.5, kFaintest = 3, kBrightest = kWhite - 1;
  const auto light = [&](int x, int y) { return static_cast<double>(picture.row(y)[x]) - ambientDn; };
  const int cx = static_cast<int>(std::lround(at.x())), cy = static_cast<int>(std::lround(at.y()));
  double s0 = 0, s1 = 0, s2 = 0, l0 = 0, l1 = 0;
  int used = 0;
  for (int y = std::max(0, cy - kReachPx); y <= std::min(picture.height - 1, cy + kReachPx); ++y)
    for (int x = std::max(0, cx - kReachPx); x <= std::min(picture.width - 1, cx + kReachPx); ++x) {
      const Point2 d = Point2(x, y) - at;
      const double across = d.dot(normal), along = normal.x() * d.y() - normal.y() * d.x();
      const double dn = light(x, y);
      if (std::abs(along) > kAlongPx || dn < kFaintest || dn + ambientDn > kBrightest) continue;
      const double w = dn * dn, q = across * across, l = std::log(dn);
      s0 += w;
      s1 += w * q;
      s2 += w * q * q;
      l0 += w * l;
      l1 += w * q * l;
      ++used;
    }
  const double det = s0 * s2 - s1 * s1;
  if (used < 6 || !(det > 0)) return {};
  const double slope = (s0 * l1 - s1 * l0) / det, peak = (l0 - slope * s1) / s0;
  if (!(slope < 0)) return {};
  return {std::exp(peak), std::sqrt(-0.5 / slope)};
}

}  // namespace

PictureNoise pictureNoise(const Effects& effects) {
  const double shot = effects.shotNoise * kShotPerDn;
  return {effects.readNoiseDn * effects.readNoiseDn + shot * effects.ambientDn + 1.0 / 12, shot, effects.speckle,
          kWhite - effects.ambientDn};
}

// A line along the rows of pixels without end: neither the light nor its slope changes along it, so only the sum of the
// noise along it counts, and the covariance of two pixels across becomes their covariance summed over all lags along.
// Grain and noise are the same in all directions, so it serves for every direction once the phase of the pixels is
// averaged out.
double informationPerPx(const LineLight& light, const PictureNoise& noise) {
  constexpr int kPhases = 4;
  static const std::vector<double> correlation = speckleCorrelation();
  double alongLine = -1;
  for (const double c : correlation) alongLine += 2 * c;
  if (!(light.contrastDn > 0) || !(light.sigmaPx > 0)) return 0;
  const int reach = static_cast<int>(std::ceil(kReachSigmas * light.sigmaPx));
  const double s2 = light.sigmaPx * light.sigmaPx;
  double information = 0;
  std::vector<double> mean, slope;
  for (int phase = 0; phase < kPhases; ++phase) {
    mean.clear();
    slope.clear();
    for (int i = -reach; i <= reach; ++i) {
      const double d = i + static_cast<double>(phase) / kPhases;
      const double dn = light.contrastDn * std::exp(-d * d / (2 * s2));
      mean.push_back(dn);
      slope.push_back(dn < noise.clipDn ? dn * d / s2 : 0);
    }
    const auto n = static_cast<Eigen::Index>(mean.size());
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j <= i; ++j) {
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j), lag = a - b;
        if (lag < correlation.size())
          covariance(i, j) = noise.speckle * noise.speckle * alongLine * correlation[lag] * mean[a] * mean[b];
        if (i == j) covariance(i, j) += noise.groundDn2 + noise.shotPerDn * mean[a];
        if (i == j && mean[a] >= noise.clipDn) covariance(i, j) = kNothingKnown;
      }
    const Eigen::Map<const Eigen::VectorXd> j(slope.data(), n);
    information += j.dot(covariance.selfadjointView<Eigen::Lower>().llt().solve(j)) / kPhases;
  }
  return information;
}

std::vector<LinePlace> readPlaces(const std::vector<Point2>& line, const ImageView& picture, double ambientDn) {
  std::vector<LinePlace> places;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Point2 &before = line[i == 0 ? 0 : i - 1], &after = line[std::min(i + 1, line.size() - 1)];
    const Point2 chord = after - before;
    LinePlace place;
    place.px = line[i];
    place.lengthPx = ((line[i] - before).norm() + (after - line[i]).norm()) / 2;
    if (!(chord.norm() > 0)) continue;
    place.normal = Point2(-chord.y(), chord.x()) / chord.norm();
    place.light = readLight(picture, ambientDn, place.px, place.normal);
    places.push_back(place);
  }
  return places;
}

Expected<RenderedLines> RenderedLines::create(const VirtualRigSettings& settings) {
  VirtualRigSettings twin = settings;
  twin.effects.readNoiseDn = twin.effects.shotNoise = twin.effects.speckle = twin.effects.reflections = 0;
  auto rig = VirtualRig::create(std::move(twin));
  if (!rig) return tl::unexpected<Error>(rig.error());
  return RenderedLines(*rig);
}

std::vector<std::vector<LinePlace>> RenderedLines::at(int camera, std::uint64_t trigger) const {
  const Intrinsics& in = twin_->calibration().rangeFinders[static_cast<std::size_t>(camera)].intrinsics;
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(in.widthPx) * static_cast<std::size_t>(in.heightPx));
  twin_->render(camera, trigger, {pixels.data(), in.widthPx, in.heightPx, in.widthPx});
  const ImageView picture{pixels.data(), in.widthPx, in.heightPx, in.widthPx};
  std::vector<std::vector<LinePlace>> lines;
  for (const std::vector<Point2>& line : twin_->visibleLines(camera, trigger))
    lines.push_back(readPlaces(line, picture, twin_->settings().effects.ambientDn));
  return lines;
}

}  // namespace vignole::simulator
