#include "tests/synthetic/stripe_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

namespace vignole::synthetic {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kStepPx = 0.25;
constexpr int kWidth = 1400, kHeight = 1024;
using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

struct Recipe {
  bool sine = false, uneven = false, gaps = false, saturated = false, reflections = false;
  double sigma = 3, low = 150, high = 150, noiseDn = 4, speckle = 0;
};

Recipe recipeOf(const std::string& name) {
  if (name == "clean") return {.sine = true};
  if (name == "rail") return {.uneven = true, .low = 36};
  if (name == "narrow") return {.uneven = true, .sigma = 2, .low = 22, .high = 90, .noiseDn = 3};
  if (name == "wide")
    return {.uneven = true, .gaps = true, .sigma = 4, .low = 43, .high = 180, .noiseDn = 6, .speckle = 0.22};
  if (name == "sat") return {.uneven = true, .saturated = true, .low = 48, .high = 200, .noiseDn = 5};
  if (name == "hard")
    return {.uneven = true,
            .gaps = true,
            .saturated = true,
            .reflections = true,
            .low = 34,
            .high = 140,
            .noiseDn = 8,
            .speckle = 0.22};
  throw std::invalid_argument("no scene " + name);
}

/// Samples every 0.25 px of arc of y = a sin(k x + phase), slopes up to about 50 degrees.
std::vector<TruthSample> sineCurve(Random& random) {
  const double length = uniform(random, 640, 760), a = std::tan(50 * kPi / 180) * length / (2 * kPi);
  const double k = 2 * kPi / length, phase = uniform(random, 0, 2 * kPi), level = uniform(random, 440, 580);
  std::vector<TruthSample> curve;
  for (double x = 60; x < kWidth - 60;) {
    const double slope = a * k * std::cos(k * x + phase), ds = std::hypot(1.0, slope);
    curve.push_back({.x = x, .y = level + a * std::sin(k * x + phase), .nx = -slope / ds, .ny = 1 / ds});
    x += kStepPx / ds;
  }
  return curve;
}

/// Tangent arcs and lines like the outline of a rail: radii of 63 to 1000 px, up to 70 degrees steep.
std::vector<TruthSample> railCurve(Random& random) {
  struct Part {
    double lengthPx, radiusPx, turnDeg;  // a line if radius is 0
  };
  const double j = uniform(random, 0.85, 1.15);
  const std::array<Part, 12> parts{{{130 * j, 0, 0},
                                    {0, 1000, 14},
                                    {70, 0, 0},
                                    {0, 260 * j, 30},
                                    {0, 95, 32 * j},
                                    {170, 0, 0},
                                    {0, 63, -78 * j},
                                    {120 * j, 0, 0},
                                    {0, 420, -28},
                                    {0, 160 * j, -30},
                                    {90, 0, 0},
                                    {0, 120, 48}}};
  std::vector<TruthSample> curve;
  double x = 0, y = 0, heading = uniform(random, -14, -4) * kPi / 180;
  for (const Part& part : parts) {
    const double length = part.radiusPx > 0 ? part.radiusPx * std::abs(part.turnDeg) * kPi / 180 : part.lengthPx;
    const auto steps = static_cast<int>(std::lround(length / kStepPx));
    const double turn = part.turnDeg * kPi / 180 / steps;
    const double chord = part.radiusPx > 0 ? 2 * part.radiusPx * std::sin(std::abs(turn) / 2) : kStepPx;
    for (int i = 0; i < steps; ++i) {
      curve.push_back({.x = x, .y = y, .nx = -std::sin(heading), .ny = std::cos(heading)});
      x += chord * std::cos(heading + turn / 2);
      y += chord * std::sin(heading + turn / 2);
      heading += turn;
    }
  }
  // Placed in the middle of the picture, a little off by the seed.
  const auto [left, right] =
      std::minmax_element(curve.begin(), curve.end(), [](auto& a, auto& b) { return a.x < b.x; });
  const auto [top, bottom] =
      std::minmax_element(curve.begin(), curve.end(), [](auto& a, auto& b) { return a.y < b.y; });
  const double dx = (kWidth - left->x - right->x) / 2 + uniform(random, -40, 40);
  const double dy = (kHeight - top->y - bottom->y) / 2 + uniform(random, -40, 40);
  for (TruthSample& s : curve) {
    s.x += dx;
    s.y += dy;
  }
  return curve;
}

void lightUp(std::vector<TruthSample>& curve, const Recipe& recipe, Random& random) {
  const double phase = uniform(random, 0, 2 * kPi), phase2 = uniform(random, 0, 2 * kPi);
  const double wave = uniform(random, 380, 520), wave2 = uniform(random, 150, 210);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double s = kStepPx * static_cast<double>(i);
    const double bright =
        0.5 + 0.35 * std::sin(2 * kPi * s / wave + phase) + 0.15 * std::sin(2 * kPi * s / wave2 + phase2);
    curve[i].contrast = recipe.uneven ? recipe.low + (recipe.high - recipe.low) * bright : recipe.high;
    curve[i].sigma = recipe.sigma * (recipe.uneven ? 1 + 0.1 * std::sin(2 * kPi * s / 310 + phase2) : 1);
  }
}

/// `count` stretches of `low` to `high` px that keep away from each other and from the ends.
std::vector<std::pair<std::size_t, std::size_t>> stretches(std::size_t samples, int count, double low, double high,
                                                           Random& random) {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  const double share = static_cast<double>(samples) / count;
  for (int k = 0; k < count; ++k) {
    const double length = uniform(random, low, high) / kStepPx;
    const auto first = static_cast<std::size_t>(share * (k + 0.5) + uniform(random, -0.15, 0.15) * share - length / 2);
    result.emplace_back(first, first + static_cast<std::size_t>(length));
  }
  return result;
}

void measureEdges(std::vector<TruthSample>& curve) {
  double way = 0;
  for (TruthSample& s : curve) {
    way = s.visible ? way + kStepPx : 0;
    s.edgePx = way;
  }
  way = 0;
  for (auto s = curve.rbegin(); s != curve.rend(); ++s) {
    way = s->visible ? way + kStepPx : 0;
    s->edgePx = std::min(s->edgePx, way);
  }
}

using Light = std::vector<double>;

void addLine(Light& light, const std::vector<TruthSample>& curve) {
  std::vector<double> nearest(light.size(), std::numeric_limits<double>::max());
  std::vector<std::uint32_t> sample(light.size(), 0);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const int reach = static_cast<int>(std::ceil(5 * curve[i].sigma));
    const int cx = static_cast<int>(std::lround(curve[i].x)), cy = static_cast<int>(std::lround(curve[i].y));
    for (int y = std::max(0, cy - reach); y <= std::min(kHeight - 1, cy + reach); ++y)
      for (int x = std::max(0, cx - reach); x <= std::min(kWidth - 1, cx + reach); ++x) {
        const double d = (x - curve[i].x) * (x - curve[i].x) + (y - curve[i].y) * (y - curve[i].y);
        const auto at = static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
        if (d >= nearest[at]) continue;
        nearest[at] = d;
        sample[at] = static_cast<std::uint32_t>(i);
      }
  }
  for (std::size_t at = 0; at < light.size(); ++at) {
    if (nearest[at] > 1e300) continue;
    const TruthSample& s = curve[sample[at]];
    const double dx = static_cast<double>(at % kWidth) - s.x, dy = static_cast<double>(at / kWidth) - s.y;
    const double across = dx * s.nx + dy * s.ny, along = dx * s.ny - dy * s.nx;
    if (s.visible && std::abs(along) < 0.5)  // no light beyond the ends
      light[at] += s.contrast * std::exp(-across * across / (2 * s.sigma * s.sigma));
  }
}

/// Lognormal field of mean 1 and the given contrast; grains of 2.2 px (width at half height of the correlation).
std::vector<double> speckleField(double contrast, Random& random) {
  constexpr double kSd = 0.67;
  constexpr int kReach = 3;
  std::normal_distribution<double> normal;
  std::vector<double> field(static_cast<std::size_t>(kWidth) * kHeight), other(field.size());
  for (double& v : field) v = normal(random);
  std::array<double, 2 * kReach + 1> taps{};
  double squares = 0;
  for (int k = -kReach; k <= kReach; ++k) {
    taps[static_cast<std::size_t>(k + kReach)] = std::exp(-k * k / (2 * kSd * kSd));
    squares += std::exp(-k * k / (kSd * kSd));
  }
  const auto smooth = [&](const std::vector<double>& in, std::vector<double>& out, int step, int count, int across) {
    for (int line = 0; line < across; ++line)
      for (int i = 0; i < count; ++i) {
        double sum = 0;
        for (int k = -kReach; k <= kReach; ++k) {
          const int wrapped = (i + k + count) % count;
          const int index = step == 1 ? line * kWidth + wrapped : wrapped * kWidth + line;
          sum += taps[static_cast<std::size_t>(k + kReach)] * in[static_cast<std::size_t>(index)];
        }
        out[static_cast<std::size_t>(step == 1 ? line * kWidth + i : i * kWidth + line)] = sum;
      }
  };
  smooth(field, other, 1, kWidth, kHeight);
  smooth(other, field, kWidth, kHeight, kWidth);
  const double spread = std::sqrt(std::log(1 + contrast * contrast));
  for (double& v : field) v = std::exp(spread * v / squares - spread * spread / 2);
  return field;
}

/// Three blobs and a ghost of 180 px beside the line, 24 px off, weak and broad.
void addReflections(Light& light, const std::vector<TruthSample>& curve, Random& random) {
  for (int k = 0; k < 3; ++k) {
    const double cx = uniform(random, 150, kWidth - 150), cy = uniform(random, 60, 200) + (k == 1 ? 760 : 0);
    const double sx = uniform(random, 8, 20), sy = uniform(random, 8, 20), bright = uniform(random, 80, 140);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        light[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)] +=
            bright * std::exp(-0.5 * ((x - cx) * (x - cx) / (sx * sx) + (y - cy) * (y - cy) / (sy * sy)));
  }
  const auto brightest = std::max_element(curve.begin() + 800, curve.end() - 800,
                                          [](auto& a, auto& b) { return a.contrast < b.contrast; });
  std::vector<TruthSample> ghost(brightest - 360, brightest + 360);
  for (TruthSample& s : ghost) {
    s.x += 24 * s.nx;
    s.y += 24 * s.ny;
    s.contrast = 35;
    s.sigma = 4;
    s.visible = true;
  }
  addLine(light, ghost);
}

std::uint8_t digitised(double dn) { return static_cast<std::uint8_t>(std::clamp(std::lround(dn), 0L, 255L)); }

}  // namespace

StripeScene stripeScene(const std::string& name, std::uint64_t seed) {
  const Recipe recipe = recipeOf(name);
  Random random(seed * 7919 + std::hash<std::string>{}(name));
  StripeScene scene{name, kWidth, kHeight, {}, recipe.sine ? sineCurve(random) : railCurve(random)};
  lightUp(scene.truth, recipe, random);
  if (recipe.gaps)
    for (const auto& [first, last] : stretches(scene.truth.size(), 6, 6, 40, random))
      for (std::size_t i = first; i < last; ++i) scene.truth[i].visible = false;
  if (recipe.saturated)
    for (const auto& [first, last] : stretches(scene.truth.size(), 3, 60, 120, random))
      for (std::size_t i = first; i < last; ++i) {
        // Brightness rises and falls over 20 px, as reflectance does.
        const double ramp = std::min(1.0, static_cast<double>(std::min(i - first, last - i)) * kStepPx / 20);
        scene.truth[i].contrast += ramp * (380 - scene.truth[i].contrast);
      }
  measureEdges(scene.truth);
  Light light(static_cast<std::size_t>(kWidth) * kHeight, 0.0);
  addLine(light, scene.truth);
  if (recipe.reflections) addReflections(light, scene.truth, random);
  if (recipe.speckle > 0) {
    const std::vector<double> field = speckleField(recipe.speckle, random);
    for (std::size_t i = 0; i < light.size(); ++i) light[i] *= field[i];
  }
  std::normal_distribution<double> noise(0, recipe.noiseDn);
  scene.pixels.resize(light.size());
  for (std::size_t i = 0; i < light.size(); ++i) {
    const double ambient = 20 + 5 * static_cast<double>(i % kWidth) / kWidth;
    scene.pixels[i] = digitised(ambient + light[i] + noise(random));
  }
  return scene;
}

std::vector<std::uint8_t> straightLinePicture(const StraightLine& line, std::uint64_t seed) {
  Random random(seed);
  std::normal_distribution<double> noise(0, std::max(line.noiseDn, 1e-12));
  const double nx = std::cos(line.angleRad), ny = std::sin(line.angleRad);
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < line.height; ++y)
    for (int x = 0; x < line.width; ++x) {
      const double across = (x - line.x0) * nx + (y - line.y0) * ny, along = (x - line.x0) * ny - (y - line.y0) * nx;
      const bool lit = along >= line.firstPx && along <= line.lastPx;
      const double light = lit ? line.contrast * std::exp(-across * across / (2 * line.sigma * line.sigma)) : 0;
      pixels.push_back(digitised(line.backgroundDn + light + (line.noiseDn > 0 ? noise(random) : 0)));
    }
  return pixels;
}

}  // namespace vignole::synthetic
