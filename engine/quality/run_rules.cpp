#include "engine/quality/run_rules.h"

#include <array>
#include <cmath>

namespace vignole {

namespace {

using Z = std::span<const double>;

/// At least k of the last m points beyond `sigmas` on one side.
bool manyBeyond(Z z, std::size_t i, std::size_t k, std::size_t m, double sigmas) {
  if (i + 1 < m) return false;
  for (const double side : {1.0, -1.0}) {
    std::size_t count = 0;
    for (std::size_t j = i + 1 - m; j <= i; ++j) count += side * z[j] > sigmas ? 1 : 0;
    if (count >= k && (side * z[i] > sigmas || i + 1 == m)) return true;
  }
  return false;
}

/// The last m points satisfy `holds(j)`.
template <typename Holds>
bool lastAll(std::size_t i, std::size_t m, std::size_t first, Holds holds) {
  if (i + 1 < m + first) return false;
  for (std::size_t j = i + 1 - m; j <= i; ++j)
    if (!holds(j)) return false;
  return true;
}

bool sameSide(Z z, std::size_t i, std::size_t m) {
  return lastAll(i, m, 0, [&](std::size_t j) { return z[j] > 0; }) ||
         lastAll(i, m, 0, [&](std::size_t j) { return z[j] < 0; });
}

/// m points in a row, each above (or each below) the one before: m - 1 steps.
bool trend(Z z, std::size_t i, std::size_t m) {
  return lastAll(i, m - 1, 1, [&](std::size_t j) { return z[j] > z[j - 1]; }) ||
         lastAll(i, m - 1, 1, [&](std::size_t j) { return z[j] < z[j - 1]; });
}

/// m points in a row, alternately up and down: m - 2 turns.
bool alternating(Z z, std::size_t i, std::size_t m) {
  return lastAll(i, m - 2, 2, [&](std::size_t j) { return (z[j] - z[j - 1]) * (z[j - 1] - z[j - 2]) < 0; });
}

bool within(Z z, std::size_t i, std::size_t m, double sigmas) {
  return lastAll(i, m, 0, [&](std::size_t j) { return std::abs(z[j]) < sigmas; });
}

/// m points in a row, none within `sigmas`, some on either side.
bool mixture(Z z, std::size_t i, std::size_t m, double sigmas) {
  return lastAll(i, m, 0, [&](std::size_t j) { return std::abs(z[j]) > sigmas; }) && !sameSide(z, i, m);
}

bool westernElectric(Z z, std::size_t i, int rule) {
  switch (rule) {
    case 2:
      return manyBeyond(z, i, 2, 3, 2);
    case 3:
      return manyBeyond(z, i, 4, 5, 1);
    default:
      return sameSide(z, i, 8);
  }
}

bool nelson(Z z, std::size_t i, int rule) {
  switch (rule) {
    case 2:
      return sameSide(z, i, 9);
    case 3:
      return trend(z, i, 6);
    case 4:
      return alternating(z, i, 14);
    case 5:
      return manyBeyond(z, i, 2, 3, 2);
    case 6:
      return manyBeyond(z, i, 4, 5, 1);
    case 7:
      return within(z, i, 15, 1);
    default:
      return mixture(z, i, 8, 1);
  }
}

constexpr std::array<std::string_view, 4> kWesternElectric = {
    "one point beyond the control limits", "2 of 3 points beyond 2 sigma on one side",
    "4 of 5 points beyond 1 sigma on one side", "8 points in a row on one side"};
constexpr std::array<std::string_view, 8> kNelson = {
    "one point beyond the control limits",      "9 points in a row on one side",
    "6 points in a row rising or falling",      "14 points in a row alternating",
    "2 of 3 points beyond 2 sigma on one side", "4 of 5 points beyond 1 sigma on one side",
    "15 points in a row within 1 sigma",        "8 points in a row beyond 1 sigma, on both sides"};

constexpr std::array<std::string_view, 3> kRuleSets = {"limits", "western-electric", "nelson"};

}  // namespace

std::string_view name(RuleSet rules) { return kRuleSets.at(static_cast<std::size_t>(rules)); }

std::optional<RuleSet> ruleSetNamed(std::string_view name) {
  for (std::size_t i = 0; i < kRuleSets.size(); ++i)
    if (kRuleSets.at(i) == name) return static_cast<RuleSet>(i);
  return {};
}

std::string_view describe(RuleSet rules, int rule) {
  const auto i = static_cast<std::size_t>(rule - 1);
  return rules == RuleSet::Nelson ? kNelson.at(i) : kWesternElectric.at(i);
}

std::vector<RuleSignal> ruleSignals(Z z, RuleSet rules, double limitSigmas) {
  const int last = rules == RuleSet::Nelson ? 8 : rules == RuleSet::WesternElectric ? 4 : 1;
  std::vector<RuleSignal> signals;
  for (std::size_t i = 0; i < z.size(); ++i)
    for (int rule = 1; rule <= last; ++rule) {
      const bool signal = rule == 1                  ? std::abs(z[i]) > limitSigmas
                          : rules == RuleSet::Nelson ? nelson(z, i, rule)
                                                     : westernElectric(z, i, rule);
      if (signal) signals.push_back({rule, i});
    }
  return signals;
}

}  // namespace vignole
