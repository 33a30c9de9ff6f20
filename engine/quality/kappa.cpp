#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include "engine/quality/agreement.h"
#include "engine/quality/distributions.h"

namespace vignole {

namespace {

/// Numbers before words, numbers by value.
std::vector<std::string> categoriesOf(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  std::map<std::pair<double, std::string>, int> found;
  const auto note = [&](const std::string& category) {
    double value = std::numeric_limits<double>::infinity();
    const auto [end, error] = std::from_chars(category.data(), category.data() + category.size(), value);
    if (error != std::errc() || end != category.data() + category.size())
      value = std::numeric_limits<double>::infinity();
    found[{value, category}] = 0;
  };
  for (const std::string& c : a) note(c);
  for (const std::string& c : b) note(c);
  std::vector<std::string> names;
  names.reserve(found.size());
  for (const auto& [key, unused] : found) names.push_back(key.second);
  return names;
}

double weight(std::size_t i, std::size_t j, std::size_t count, KappaWeights weights) {
  if (weights == KappaWeights::None) return i == j ? 1 : 0;
  const double apart = std::abs(static_cast<double>(i) - static_cast<double>(j)) / static_cast<double>(count - 1);
  return 1 - (weights == KappaWeights::Linear ? apart : apart * apart);
}

/// Shares of the cells and of the margins, with the weights and their means over the margins.
struct Table {
  std::size_t size = 0;
  std::vector<double> cell, w;              // [i * size + j]
  std::vector<double> row, column;          // margins
  std::vector<double> rowMean, columnMean;  // of the weights
};

Table tableOf(const Kappa& k, KappaWeights weights) {
  Table t;
  t.size = k.categories.size();
  t.row.assign(t.size, 0);
  t.column.assign(t.size, 0);
  for (std::size_t i = 0; i < t.size; ++i)
    for (std::size_t j = 0; j < t.size; ++j) {
      t.cell.push_back(static_cast<double>(k.counts[i][j]) / static_cast<double>(k.n));
      t.w.push_back(weight(i, j, t.size, weights));
      t.row[i] += t.cell.back();
      t.column[j] += t.cell.back();
    }
  t.rowMean.assign(t.size, 0);
  t.columnMean.assign(t.size, 0);
  for (std::size_t i = 0; i < t.size; ++i)
    for (std::size_t j = 0; j < t.size; ++j) {
      t.rowMean[i] += t.w[i * t.size + j] * t.column[j];
      t.columnMean[j] += t.w[i * t.size + j] * t.row[i];
    }
  return t;
}

/// Fleiss, Cohen, Everitt 1969.
void addErrors(Kappa& k, const Table& t) {
  const double rest = 1 - k.expected, n = static_cast<double>(k.n);
  double sum = 0, sum0 = 0;
  for (std::size_t i = 0; i < t.size; ++i)
    for (std::size_t j = 0; j < t.size; ++j) {
      const double w = t.w[i * t.size + j], means = t.rowMean[i] + t.columnMean[j];
      sum += t.cell[i * t.size + j] * (w - means * (1 - k.kappa)) * (w - means * (1 - k.kappa));
      sum0 += t.row[i] * t.column[j] * (w - means) * (w - means);
    }
  const double mean = k.kappa - k.expected * (1 - k.kappa);
  k.se = std::sqrt(std::max(0.0, sum - mean * mean) / n) / rest;
  k.se0 = std::sqrt(std::max(0.0, sum0 - k.expected * k.expected) / n) / rest;
}

}  // namespace

Expected<Kappa> kappaStudy(const std::vector<std::string>& a, const std::vector<std::string>& b, KappaWeights weights,
                           double alpha) {
  if (a.size() != b.size() || a.size() < 2) return inputError("", "kappa needs at least two pairs");
  Kappa k;
  k.categories = categoriesOf(a, b);
  k.n = a.size();
  if (k.categories.size() < 2) return inputError("", "kappa needs at least two categories; all say '" + a[0] + "'");
  k.counts.assign(k.categories.size(), std::vector<std::size_t>(k.categories.size(), 0));
  const auto at = [&](const std::string& c) {
    return static_cast<std::size_t>(std::find(k.categories.begin(), k.categories.end(), c) - k.categories.begin());
  };
  for (std::size_t i = 0; i < a.size(); ++i) ++k.counts[at(a[i])][at(b[i])];

  const Table t = tableOf(k, weights);
  for (std::size_t i = 0; i < t.size; ++i)
    for (std::size_t j = 0; j < t.size; ++j) {
      k.observed += t.w[i * t.size + j] * t.cell[i * t.size + j];
      k.expected += t.w[i * t.size + j] * t.row[i] * t.column[j];
    }
  k.kappa = (k.observed - k.expected) / (1 - k.expected);
  addErrors(k, t);
  const double half = normalQuantile(1 - alpha / 2) * k.se;
  k.interval = {k.kappa - half, k.kappa + half};
  k.z = k.se0 > 0 ? k.kappa / k.se0 : 0;
  k.p = 2 * normalProbability(-std::abs(k.z));
  k.notes.formulas = {"kappa = (p_o - p_e) / (1 - p_e), weighted: p = sum w_ij p_ij",
                      weights == KappaWeights::None     ? "w_ij = 1 where i = j, else 0"
                      : weights == KappaWeights::Linear ? "w_ij = 1 - |i - j| / (c - 1)"
                                                        : "w_ij = 1 - (i - j)^2 / (c - 1)^2",
                      "standard error: Fleiss, Cohen, Everitt 1969; z against kappa = 0"};
  k.notes.constants = {{"alpha", alpha}};
  return k;
}

}  // namespace vignole
