#include "engine/registration/shape_misfit.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace vignole {
namespace {

constexpr double kPlaceMm = 2;
constexpr std::size_t kEnoughPoints = 2000;
constexpr std::size_t kLeastPoints = 3;
constexpr double kOfMedian = 1.57;  // variance of a median, in that of a mean
// Over 40 mm the displacement strays 0.1 mm from a straight line: the tolerances of a rail, not its corners.
constexpr double kRoughness = 5e-7;   // mm2 per mm3
constexpr double kModelMm = 0.02;     // what calibration and extraction leave, shared by a whole place
constexpr double kStartMm = 1;        // the first displacement is anyone's guess,
constexpr double kStartSlope = 0.01;  // and its change along the outline
constexpr float kFallbackSigmaMm = 0.03F;

/// Displacement of the outline and its change along it, x and y.
struct Displacement {
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();  // x, dx/ds, y, dy/ds
  Eigen::Matrix4d covariance =
      Eigen::Vector4d(kStartMm * kStartMm, kStartSlope* kStartSlope, kStartMm* kStartMm, kStartSlope* kStartSlope)
          .asDiagonal();

  void advance(double s) {
    for (const int a : {0, 2}) {
      mean(a) += s * mean(a + 1);
      covariance.row(a) += s * covariance.row(a + 1);
    }
    for (const int a : {0, 2}) covariance.col(a) += s * covariance.col(a + 1);
    for (const int a : {0, 2}) {
      covariance(a, a) += kRoughness * s * s * s / 3;
      covariance(a, a + 1) += kRoughness * s * s / 2;
      covariance(a + 1, a) += kRoughness * s * s / 2;
      covariance(a + 1, a + 1) += kRoughness * s;
    }
  }

  /// Takes a distance along the normal in; returns its chi2, limited. What is beyond the limit moves little.
  double observe(double distance, double variance, double nx, double ny) {
    const Eigen::Vector4d normal(nx, 0, ny, 0), gain = covariance * normal;
    const double surprise = distance - normal.dot(mean);
    double total = normal.dot(gain) + variance;
    const double chi2 = surprise * surprise / total;
    if (chi2 > Misfit::kWorst) total *= chi2 / Misfit::kWorst;
    mean += gain * (surprise / total);
    covariance -= gain * gain.transpose() / total;
    return std::min(chi2, Misfit::kWorst);
  }
};

}  // namespace

ShapeMisfit::ShapeMisfit(const Section& section) {
  for (const NamedPrimitive& p : section.primitives) {
    const double all = length(p.shape);
    const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(all / kPlaceMm)));
    const double each = all / static_cast<double>(count);
    first_.push_back(outline_.size());
    for (std::size_t b = 0; b < count; ++b) {
      const Point2 n = normalAt(p.shape, (static_cast<double>(b) + 0.5) * each);
      outline_.push_back({n.x(), n.y(), each, 0});
    }
    shapes_.push_back(p.shape);
  }
  first_.push_back(outline_.size());
}

void ShapeMisfit::gather(std::span<const ProfilePoint> points, const Registration& registration, std::size_t stride) {
  const Transform2 sectionFromWorld = registration.worldFromSection.inverse();
  const double c = std::cos(sectionFromWorld.angleRad), s = std::sin(sectionFromWorld.angleRad);
  placeOf_.clear();
  found_.clear();
  strays_ = 0;
  variance_ = 0;
  for (Place& place : outline_) place.end = 0;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    if (registration.primitiveOfPoint[i] < 0) {
      ++strays_;
      continue;
    }
    const auto k = static_cast<std::size_t>(registration.primitiveOfPoint[i]);
    const ProfilePoint& p = points[i];
    const Point2 at(c * p.x - s * p.y + sectionFromWorld.xMm, s * p.x + c * p.y + sectionFromWorld.yMm);
    const double along = nearest(shapes_[k], at).arcLengthMm / outline_[first_[k]].lengthMm;
    const std::size_t place = std::min(first_[k] + static_cast<std::size_t>(along), first_[k + 1] - 1);
    const double sigma = static_cast<double>(p.sigmaMm > 0 ? p.sigmaMm : kFallbackSigmaMm);
    variance_ += sigma * sigma;
    placeOf_.push_back(static_cast<std::uint32_t>(place));
    found_.push_back(registration.residualMm[i]);
    ++outline_[place].end;
  }
  variance_ /= std::max(1.0, static_cast<double>(found_.size()));
  std::size_t end = 0;
  for (Place& place : outline_) {  // first where each begins; filling it moves that to where it ends
    const std::size_t count = place.end;
    place.end = end;
    end += count;
  }
  residuals_.resize(found_.size());
  for (std::size_t i = 0; i < found_.size(); ++i) residuals_[outline_[placeOf_[i]].end++] = found_[i];
}

Misfit ShapeMisfit::measure(std::span<const ProfilePoint> points, const Registration& registration,
                            double correlatedPoints) {
  const std::size_t stride = std::max<std::size_t>(1, points.size() / kEnoughPoints);
  const double correlated = std::max(1.0, correlatedPoints / static_cast<double>(stride));
  gather(points, registration, stride);
  Misfit misfit;
  Displacement displacement;
  double sum = 0, sinceLast = 0;
  std::size_t begin = 0;
  for (std::size_t k = 0; k < shapes_.size(); ++k)
    for (std::size_t b = first_[k]; b < first_[k + 1]; ++b) {
      const Place& place = outline_[b];
      const std::size_t count = place.end - begin;
      float* of = residuals_.data() + begin;
      begin = place.end;
      sinceLast += place.lengthMm;
      if (count < kLeastPoints) continue;
      displacement.advance(sinceLast);
      sinceLast = 0;
      std::nth_element(of, of + count / 2, of + count);  // the median: strays near the outline do not move it
      const double variance = variance_ * std::min(1.0, kOfMedian * correlated / static_cast<double>(count));
      sum +=
          displacement.observe(static_cast<double>(of[count / 2]), variance + kModelMm * kModelMm, place.nx, place.ny);
      ++misfit.places;
    }
  misfit.chi2 = misfit.places > 0 ? sum / misfit.places : Misfit::kWorst;
  misfit.strayShare =
      static_cast<double>(strays_) / static_cast<double>(std::max<std::size_t>(1, strays_ + found_.size()));
  return misfit;
}

}  // namespace vignole
