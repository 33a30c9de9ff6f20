#pragma once
// A lattice of points in a picture, grown from neighbour to neighbour: perspective and the lens may bend it, points may
// be missing, other things may lie about.

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "calibration/detection/point_index.h"
#include "engine/geometry/transform2.h"

namespace vignole {

/// Place in a lattice: steps u, v from its first point. Turning from u to v is turning from x to y in the picture.
using LatticePlace = std::pair<int, int>;

struct LatticeSteps {
  Point2 u{0, 0}, v{0, 0};  ///< px
};

struct LatticeSeed {
  std::size_t candidate = 0;
  LatticeSteps steps;
};

/// Points of a lattice by their places; what a point is, is the caller's.
template <typename T>
using ByPlace = std::map<LatticePlace, T>;

/// Whether candidate b may lie one step from candidate a.
using MayBeNeighbours = std::function<bool(std::size_t a, std::size_t b)>;

/// Indices of candidates by place. `points`: where the candidates are, `index`: over them.
[[nodiscard]] ByPlace<std::size_t> growLattice(std::span<const Point2> points, const PointIndex& index,
                                               const LatticeSeed& seed, const MayBeNeighbours& mayBeNeighbours);

/// Where a lattice's point at `place` should be by its neighbours, and the steps there; nothing where none is near.
struct LatticePrediction {
  Point2 px{0, 0};
  LatticeSteps steps;
  LatticePlace neighbour{0, 0};  ///< the point of the lattice that is nearest
};
[[nodiscard]] std::optional<LatticePrediction> predicted(const ByPlace<Point2>& lattice, const LatticePlace& place);

/// Takes away what does not lie evenly between its neighbours.
void dropUneven(ByPlace<Point2>& lattice);

/// Places without a point next to points, inside or around the lattice.
[[nodiscard]] std::vector<LatticePlace> openPlaces(const ByPlace<Point2>& lattice);

}  // namespace vignole
