#pragma once
// A model of grey values fitted to the pixels of a patch: weighted, robust least squares by Levenberg-Marquardt.

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace vignole {

struct PatchPixel {
  double x = 0, y = 0;  ///< px, from the patch's origin
  double value = 0;     ///< DN
  double weight = 1;    ///< 0..1: fades towards the patch's edge, so that no pixel enters with a jump
};

template <int N>
struct PatchFit {
  Eigen::Matrix<double, N, 1> parameters = Eigen::Matrix<double, N, 1>::Zero();
  /// From the residuals themselves, pixel by pixel: holds whatever the noise depends on, as long as it is independent.
  Eigen::Matrix<double, N, N> covariance = Eigen::Matrix<double, N, N>::Zero();
  double noiseDn = 0;  ///< standard deviation of the residuals, by their median
  double rmsDn = 0;    ///< of all residuals
  bool converged = false;
};

enum class PatchEffort { Rough, Full };  ///< Rough: a start for another patch

namespace patch_fit {

constexpr double kHuber = 2.5;          // standard deviations; beyond, a pixel counts less
constexpr double kLeastNoiseDn = 0.29;  // 1/sqrt(12): the steps of 8 bits
constexpr double kSettled = 1e-4;       // of chi2: a hundredth of a standard deviation
constexpr double kRoughGain = 1e-3;     // of the cost by a step
constexpr double kRidge = 1e-13;        // of the normal equations, for what a patch does not show at all
constexpr int kRoughSteps = 15, kMaxSteps = 40, kScaleSteps = 8;

inline double median(std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

inline double huberWeight(double residual, double noise) {
  const double share = std::abs(residual) / (kHuber * noise);
  return share > 1 ? 1 / share : 1.0;
}
inline double huberCost(double residual, double noise) {
  const double bound = kHuber * noise, size = std::abs(residual);
  return size > bound ? bound * (2 * size - bound) : size * size;
}

/// Residuals and derivatives of all pixels at one set of parameters.
template <int N>
class State {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Square = Eigen::Matrix<double, N, N>;
  explicit State(std::size_t count) : residuals_(count), derivatives_(count) {}

  template <typename Model>
  void evaluate(std::span<const PatchPixel> pixels, const Vector& parameters, const Model& model) {
    const auto value = model(parameters);
    for (std::size_t i = 0; i < pixels.size(); ++i)
      residuals_[i] = pixels[i].value - value(pixels[i].x, pixels[i].y, derivatives_[i]);
  }
  [[nodiscard]] double noise(std::span<const PatchPixel> pixels) {
    magnitudes_.clear();
    for (std::size_t i = 0; i < pixels.size(); ++i)
      if (pixels[i].weight > 0.5) magnitudes_.push_back(std::abs(residuals_[i]));
    return std::max(1.4826 * median(magnitudes_), kLeastNoiseDn);
  }
  [[nodiscard]] double cost(std::span<const PatchPixel> pixels, double noise) const {
    double total = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) total += pixels[i].weight * huberCost(residuals_[i], noise);
    return total;
  }
  [[nodiscard]] Vector gradient(std::span<const PatchPixel> pixels, double noise) const {
    Vector sum = Vector::Zero();
    for (std::size_t i = 0; i < pixels.size(); ++i)
      sum += derivatives_[i] * (pixels[i].weight * huberWeight(residuals_[i], noise) * residuals_[i]);
    return sum;
  }
  /// Sum of the derivatives' products, each times weightOf(residual) and the pixel's weight to the given power.
  template <typename WeightOf>
  [[nodiscard]] Square weighted(std::span<const PatchPixel> pixels, const WeightOf& weightOf, int power = 1) const {
    Square sum = Square::Zero();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const double w = power == 1 ? pixels[i].weight : pixels[i].weight * pixels[i].weight;
      const Vector scaled = derivatives_[i] * (w * weightOf(residuals_[i]));
      sum.noalias() += scaled * derivatives_[i].transpose();
    }
    return sum;
  }
  [[nodiscard]] double weights(std::span<const PatchPixel> pixels) const {
    double sum = 0;
    for (const PatchPixel& pixel : pixels) sum += pixel.weight;
    return sum;
  }
  [[nodiscard]] double rms(std::span<const PatchPixel> pixels) const {
    double sum = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) sum += pixels[i].weight * residuals_[i] * residuals_[i];
    return std::sqrt(sum / weights(pixels));
  }

 private:
  std::vector<double> residuals_, magnitudes_;
  std::vector<Vector> derivatives_;
};

}  // namespace patch_fit

/// `model(parameters)` returns what gives the grey value and its derivatives by the parameters at a point:
/// double(x, y, derivatives). `hold(parameters)` is called after every step and may hold them within their range.
template <int N, typename Model, typename Held>
[[nodiscard]] PatchFit<N> fitPatch(std::span<const PatchPixel> pixels, const Eigen::Matrix<double, N, 1>& start,
                                   const Model& model, const Held& hold, PatchEffort effort) {
  using namespace patch_fit;
  using Vector = Eigen::Matrix<double, N, 1>;
  using Square = Eigen::Matrix<double, N, N>;
  PatchFit<N> fit;
  fit.parameters = start;
  if (pixels.size() < 2 * N) return fit;
  State<N> now(pixels.size()), next(pixels.size());
  now.evaluate(pixels, fit.parameters, model);
  double damping = 1e-3, noise = 0, gain = 1;
  const int steps = effort == PatchEffort::Rough ? kRoughSteps : kMaxSteps;
  for (int step = 0; step < steps && !fit.converged; ++step) {
    // A scale that changed with every step might never come to rest.
    if (step < kScaleSteps) noise = now.noise(pixels);
    const Square normal = now.weighted(pixels, [noise](double r) { return huberWeight(r, noise); });
    const Vector gradient = now.gradient(pixels, noise);
    const double cost = now.cost(pixels, noise);
    bool better = false;
    for (; !better && damping < 1e8; damping *= 10) {
      Square damped = normal;
      damped.diagonal() *= 1 + damping;
      damped.diagonal().array() += kRidge * damped.diagonal().maxCoeff();
      Vector parameters = fit.parameters + damped.ldlt().solve(gradient);
      if (!parameters.allFinite()) continue;
      hold(parameters);
      next.evaluate(pixels, parameters, model);
      const double nextCost = next.cost(pixels, noise);
      if (!(nextCost <= cost)) continue;
      better = true;
      gain = (cost - nextCost) / cost;
      fit.converged = cost - nextCost < kSettled * noise * noise || (effort == PatchEffort::Rough && gain < kRoughGain);
      fit.parameters = parameters;
      std::swap(now, next);
      damping = std::max(damping * 1e-2, 1e-10);
    }
    // Where no step is any better this is the minimum, to within rounding.
    fit.converged = fit.converged || !better;
  }

  fit.converged = fit.converged || gain < kRoughGain || effort == PatchEffort::Rough;
  fit.noiseDn = noise = now.noise(pixels);
  fit.rmsDn = now.rms(pixels);
  const Square normal = now.weighted(pixels, [noise](double r) { return huberWeight(r, noise); });
  const Square scatter = now.weighted(
      pixels,
      [noise](double r) {
        const double score = huberWeight(r, noise) * r;
        return score * score;
      },
      2);
  Square held = normal;
  held.diagonal().array() += kRidge * normal.diagonal().maxCoeff();
  const Eigen::LDLT<Square> solver(held);
  const Square inverse = solver.solve(Square::Identity());
  const double weights = now.weights(pixels);
  if (solver.info() != Eigen::Success || !inverse.allFinite() || !solver.isPositive()) fit.converged = false;
  fit.covariance = inverse * scatter * inverse * (weights / std::max(weights - N, 1.0));
  return fit;
}

}  // namespace vignole
