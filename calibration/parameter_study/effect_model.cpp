#include "calibration/parameter_study/effect_model.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>

namespace vignole {
namespace {

constexpr double kSingular = 1e-9;  // eigenvalue over the largest; the coding itself leaves nothing below 1e-4

/// Pseudo-inverse of a symmetric positive semi-definite matrix, and its rank.
std::pair<Eigen::MatrixXd, int> pseudoInverse(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  const double least = kSingular * solver.eigenvalues().cwiseAbs().maxCoeff();
  int rank = 0;
  Eigen::VectorXd inverted = solver.eigenvalues();
  for (double& value : inverted) {
    const bool kept = value > least;
    rank += kept ? 1 : 0;
    value = kept ? 1 / value : 0;
  }
  return {solver.eigenvectors() * inverted.asDiagonal() * solver.eigenvectors().transpose(), rank};
}

/// Column `column` of the sum-to-zero code of a level.
double code(int level, int levels, int column) {
  if (level == EffectModel::kAveraged) return 0;
  if (level == levels - 1) return -1;
  return level == column ? 1 : 0;
}

}  // namespace

std::vector<EffectTerm> effectTerms(int factors, int order) {
  std::vector<EffectTerm> all, last{{}};
  for (int size = 1; size <= order; ++size) {
    std::vector<EffectTerm> next;
    for (const EffectTerm& term : last)
      for (int f = term.empty() ? 0 : term.back() + 1; f < factors; ++f) {
        next.push_back(term);
        next.back().push_back(f);
      }
    all.insert(all.end(), next.begin(), next.end());
    last = std::move(next);
  }
  return all;
}

EffectModel::EffectModel(std::vector<int> levels, int blocks, std::vector<EffectTerm> terms)
    : levels_(std::move(levels)), blocks_(blocks), terms_(std::move(terms)) {
  int columns = blocks_;  // the mean, and one less than there are blocks
  for (const EffectTerm& term : terms_) {
    firstColumn_.push_back(columns);
    int width = 1;
    for (const int f : term) width *= levels_[static_cast<std::size_t>(f)] - 1;
    columns += width;
  }
  firstColumn_.push_back(columns);
  gram_ = Eigen::MatrixXd::Zero(columns, columns);
  moment_ = Eigen::VectorXd::Zero(columns);
}

Eigen::VectorXd EffectModel::regressors(std::span<const int> combination, int block) const {
  assert(combination.size() == levels_.size());
  Eigen::VectorXd row = Eigen::VectorXd::Zero(gram_.rows());
  row[0] = 1;
  for (int column = 0; column + 1 < blocks_; ++column) row[1 + column] = code(block, blocks_, column);
  for (std::size_t t = 0; t < terms_.size(); ++t)
    for (int column = firstColumn_[t]; column < firstColumn_[t + 1]; ++column) {
      double product = 1;
      int rest = column - firstColumn_[t];  // one digit a factor, in the base of its columns
      for (const int f : terms_[t]) {
        const int n = levels_[static_cast<std::size_t>(f)];
        product *= code(combination[static_cast<std::size_t>(f)], n, rest % (n - 1));
        rest /= n - 1;
      }
      row[column] = product;
    }
  return row;
}

Eigen::VectorXd EffectModel::row(std::span<const int> combination) const { return regressors(combination, kAveraged); }

void EffectModel::add(std::span<const int> combination, int block, double value) {
  const Eigen::VectorXd x = regressors(combination, block);
  if (observations_ == 0) centre_ = value;  // keeps the sums of squares from drowning in a large mean
  const double y = value - centre_;
  gram_.selfadjointView<Eigen::Lower>().rankUpdate(x);
  moment_ += y * x;
  sum_ += y;
  squares_ += y * y;
  ++observations_;
  solved_ = false;
}

double EffectModel::totalSquares() const {
  return observations_ == 0 ? 0 : std::max(0.0, squares_ - sum_ * sum_ / observations_);
}

EffectModel::Fit EffectModel::fit(const std::vector<bool>& keep, bool blocks) const {
  std::vector<int> columns{0};
  for (int column = 1; blocks && column < blocks_; ++column) columns.push_back(column);
  for (std::size_t t = 0; t < terms_.size(); ++t)
    for (int column = firstColumn_[t]; keep[t] && column < firstColumn_[t + 1]; ++column) columns.push_back(column);
  const Eigen::MatrixXd all = gram_.selfadjointView<Eigen::Lower>();
  const Eigen::MatrixXd part = all(columns, columns);
  const Eigen::VectorXd moment = moment_(columns);
  const auto [inverse, rank] = pseudoInverse(part);
  return {rank, std::max(0.0, squares_ - moment.dot(inverse * moment))};
}

EffectModel::Estimate EffectModel::estimate(const Eigen::VectorXd& row) const {
  if (!solved_) {
    const Eigen::MatrixXd all = gram_.selfadjointView<Eigen::Lower>();
    inverse_ = pseudoInverse(all).first;
    coefficients_ = inverse_ * moment_;
    solved_ = true;
  }
  const Eigen::VectorXd through = inverse_ * row;
  const Eigen::VectorXd back = gram_.selfadjointView<Eigen::Lower>() * through;
  Estimate estimate;
  estimate.value = row.dot(coefficients_) + centre_ * row[0];
  estimate.gain = row.dot(through);
  estimate.estimable = (back - row).norm() < 1e-6 * row.norm();
  return estimate;
}

}  // namespace vignole
