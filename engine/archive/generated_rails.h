#pragma once
// Rails made up from numbers, without pictures: for tests, for trying out an archive of years.

#include <functional>
#include <random>

#include "engine/archive/rail_writer.h"

namespace vignole {

struct GeneratedRails {
  std::size_t rails = 100;
  double lengthM = 60;
  double spacingMm = 15;
  std::uint64_t seed = 1;
  double failingShare = 0.05;  ///< rails with one dimension out of tolerance over a stretch
  std::size_t railsPerHeat = 24;
  TimeUs firstUs = 1'735'689'600'000'000;  ///< 2025-01-01
  double everyS = 90;
  PointsPolicy points{false, 0, 0, PointCoding::Compact};
};

/// The same seed and number give the same rail.
class RailGenerator {
 public:
  /// A recipe whose nominal dimensions are defined (makeRecipe).
  RailGenerator(const Recipe& recipe, const GeneratedRails& settings);
  [[nodiscard]] RailBegin begin(std::size_t rail);
  [[nodiscard]] std::size_t profiles() const { return profiles_; }
  /// Profile `profile` of the rail that was begun last; asked for in order.
  void measure(std::size_t profile, ProfileResult& result);
  [[nodiscard]] TriggerLedger ledger() const;

 private:
  struct Course {
    double nominalMm = 0, offsetMm = 0, waveMm = 0, wavePhase = 0, uMm = 0, bumpMm = 0;
    bool defined = false;
  };
  Recipe recipe_;
  GeneratedRails settings_;
  std::size_t profiles_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_{0, 1};
  PerDimension<Course> courses_{};
  std::size_t bumpFrom_ = 0, bumpTo_ = 0;
};

/// Writes them into the archive, after those that are there. `progress` is told the rails done; false stops.
[[nodiscard]] Expected<void> generateRails(std::string_view url, const Recipe& recipe, const GeneratedRails& settings,
                                           const std::function<bool(std::size_t)>& progress = {});

}  // namespace vignole
