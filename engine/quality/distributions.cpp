#include "engine/quality/distributions.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

namespace vignole {

namespace {

namespace policies = boost::math::policies;
/// NaN in place of exceptions; double throughout, so that machines with and without a longer type agree.
using Quiet =
    policies::policy<policies::domain_error<policies::ignore_error>, policies::pole_error<policies::ignore_error>,
                     policies::overflow_error<policies::ignore_error>,
                     policies::evaluation_error<policies::ignore_error>,
                     policies::rounding_error<policies::ignore_error>, policies::promote_double<false>>;
using Normal = boost::math::normal_distribution<double, Quiet>;
using Student = boost::math::students_t_distribution<double, Quiet>;
using NoncentralStudent = boost::math::non_central_t_distribution<double, Quiet>;
using ChiSquare = boost::math::chi_squared_distribution<double, Quiet>;
using Fisher = boost::math::fisher_f_distribution<double, Quiet>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

bool isProbability(double p) { return p > 0 && p < 1; }

}  // namespace

double normalProbability(double z) { return std::isnan(z) ? kNan : 0.5 * std::erfc(-z / std::sqrt(2.0)); }

double normalQuantile(double p) { return isProbability(p) ? quantile(Normal(), p) : kNan; }

double studentProbability(double t, double degreesOfFreedom) {
  if (std::isnan(t) || !(degreesOfFreedom >= 1)) return kNan;
  if (std::isinf(t)) return t > 0 ? 1 : 0;
  return cdf(Student(degreesOfFreedom), t);
}

double studentQuantile(double p, double degreesOfFreedom) {
  if (!isProbability(p) || !(degreesOfFreedom >= 1)) return kNan;
  return quantile(Student(degreesOfFreedom), p);
}

double studentTwoSided(double t, double degreesOfFreedom) {
  return 2 * studentProbability(-std::abs(t), degreesOfFreedom);
}

double noncentralStudentQuantile(double p, double degreesOfFreedom, double delta) {
  if (!isProbability(p) || !(degreesOfFreedom >= 1) || !std::isfinite(delta)) return kNan;
  return quantile(NoncentralStudent(degreesOfFreedom, delta), p);
}

double chiSquareQuantile(double p, double degreesOfFreedom) {
  if (!isProbability(p) || !(degreesOfFreedom > 0) || std::isinf(degreesOfFreedom)) return kNan;
  return quantile(ChiSquare(degreesOfFreedom), p);
}

double fisherUpperTail(double f, double numeratorDegrees, double denominatorDegrees) {
  if (!(f >= 0) || !(numeratorDegrees > 0) || !(denominatorDegrees > 0)) return kNan;
  if (std::isinf(f)) return 0;
  return cdf(complement(Fisher(numeratorDegrees, denominatorDegrees), f));
}

double fisherQuantile(double p, double numeratorDegrees, double denominatorDegrees) {
  if (!isProbability(p) || !(numeratorDegrees > 0) || !(denominatorDegrees > 0)) return kNan;
  return quantile(Fisher(numeratorDegrees, denominatorDegrees), p);
}

}  // namespace vignole
