#pragma once
// Points of a registered profile, sorted by the fit that wants them and freed of those too near to the end of their
// primitive.

#include <string>
#include <vector>

#include "engine/measurement/chain_fit.h"
#include "engine/measurement/measurement.h"

namespace vignole {

class PointGroups {
 public:
  static constexpr int kNoFit = -1;

  /// Fit c is that of chains[c]; the foot bottom is the one after the last chain.
  PointGroups(const Section& section, std::size_t footBottom, const std::vector<ChainFit>& chains,
              const MeasurementSettings& settings);

  /// Sorts the points that the registration assigned, as they are when the rail's lengths are `cold` times what they
  /// were: the places where dimensions are taken are places of the cold rail.
  void gather(const Profile& profile, const Registration& registration, double cold);
  /// Points of a primitive that are left for its fit.
  [[nodiscard]] int pointsOf(std::size_t primitive) const { return coverage_[primitive].points; }
  /// The points of a fit on the primitives `first` .. `last` of its chain. Once after each gather.
  const FitPoints& select(std::size_t fit, std::size_t first, std::size_t last);

  /// The fit of a primitive or kNoFit, and its place in the chain.
  [[nodiscard]] int fitOf(std::size_t primitive) const { return borders_[primitive].fit; }
  [[nodiscard]] std::size_t placeOf(std::size_t primitive) const { return borders_[primitive].place; }
  /// How far beyond its own ends a primitive's selected points reach (negative: how far they stay within), as arc
  /// length: at its start and at its end.
  [[nodiscard]] std::array<double, 2> reachOf(std::size_t primitive) const;

 private:
  /// Where a primitive ends and which of its ends are left out of its fit.
  struct Border {
    Point2 start{0, 0}, startTangent{1, 0}, end{0, 0}, endTangent{1, 0}, chord{1, 0};
    double lengthMm = 0, chordMm = 0, curvature = 0;
    bool trimStart = true, trimEnd = true;
    int fit = kNoFit;
    std::size_t place = 0;
  };
  struct Coverage {
    int points = 0;
    double trimMm = 0;
    Interval alongMm{1e30F, -1e30F};  ///< along the chord
  };
  /// Neighbouring points of one primitive and camera, at from .. to of the group.
  struct Stride {
    std::size_t primitive = 0, from = 0, to = 0;
    std::uint8_t camera = 0;
    std::size_t kept = 0;  ///< of them, far enough from the ends
  };
  struct Group {
    Vec origin;
    FitPoints points;
    std::vector<float> marginMm;  ///< to the nearest end that is trimmed
    std::vector<float> alongMm;   ///< along the chord of the primitive
    std::vector<Stride> strides;
  };
  void makeBorders(const Section& section, std::size_t footBottom, const std::vector<ChainFit>& chains);
  void take(const ProfilePoint* points, std::size_t count, std::size_t primitive, const Transform2& fromWorld,
            double cold);
  void measureStride(Group& group, const Stride& stride) const;
  void chooseTrims();
  static void move(Group& group, std::size_t from, std::size_t to, std::size_t count);
  [[nodiscard]] double arcLengthAt(const Border& border, double alongChordMm) const;

  MeasurementSettings settings_;
  std::vector<Border> borders_;
  std::vector<Coverage> coverage_;
  std::vector<Group> groups_;  ///< one a fit
};

}  // namespace vignole
