#pragma once
// A section whose dimensions are off by chosen amounts. Primitives on which a dimension is taken stay exact segments
// and arcs (moved, re-bent or re-joined tangentially); the fillets between them are carried along by a displacement
// that is once continuously differentiable along the outline.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/rail/dimension.h"
#include "engine/rail/section.h"

namespace vignole::simulator {

/// Point of a sampled outline, section frame, mm.
struct OutlineVertex {
  Point2 point{0, 0};
  double alongMm = 0;         ///< arc length of the nominal outline: where on the surface this is
  std::size_t primitive = 0;  ///< index in the section
};

/// What is asked for. HWA is not among what can be steered: it follows HW.
struct OutlineDeviation {
  PerDimension<double> mm{};
  bool headAtArema = false;  ///< HW is held at the AREMA depth, i.e. it is HWA that was asked for
  double headShiftMm = 0;    ///< of both head sides to the right: RAS_l + this, RAS_r - this
};

/// One primitive of the displaced outline.
struct OutlinePiece {
  Primitive base;
  // Displacement added to the base: cubic Hermite over a chain of pieces, of which this is the share [from, to].
  bool carried = false;
  Point2 d0{0, 0}, m0{0, 0}, d1{0, 0}, m1{0, 0};
  double from = 0, to = 1;
  [[nodiscard]] Point2 at(double share) const;  ///< share 0..1 of the piece
};

/// How far a crown can be varied without losing its shape: small radii beside a wide AHT leave little room.
struct CrownLatitude {
  double hfShare = 1;  ///< of the HF that a crown of wide shoulders takes
  double hrMm = 0;     ///< change of the radius that moves the ends of AHT by 3.5 um
};

/// Knows the section's parts; makes displaced outlines. Immutable.
class OutlineShaper {
 public:
  /// Refuses a section without the primitives that the dimensions need.
  [[nodiscard]] static Expected<OutlineShaper> create(const Section& section, const DimensionParameters& parameters);

  /// One piece per primitive of the section, in its order. Fails where no tangent outline has these deviations.
  [[nodiscard]] Expected<std::vector<OutlinePiece>> displaced(const OutlineDeviation& deviation) const;

  /// Vertices such that no chord leaves the outline by more than sagittaMm or is longer than maxStepMm; the number is
  /// the same for all deviations. Closed: the last vertex joins the first, which is not repeated.
  void sample(std::span<const OutlinePiece> pieces, double sagittaMm, double maxStepMm,
              std::vector<OutlineVertex>& vertices) const;

  [[nodiscard]] const Section& section() const { return section_; }
  /// HF can be chosen where the crown has one shoulder arc between AHT and the corner arc of each side. With more of
  /// them the outer arcs stay with the head side and the innermost is carried between it and AHT.
  [[nodiscard]] bool canSteerCrown() const { return right_.crown.size() == 2 && left_.crown.size() == 2; }
  [[nodiscard]] CrownLatitude latitude() const;

 private:
  struct Side {
    double sign = 1;  ///< +1 right, -1 left
    std::size_t edge = 0, lowerFishing = 0, upperFishing = 0, headSide = 0;
    std::vector<std::size_t> footTop;  ///< moves with FT
    std::vector<std::size_t> web;      ///< moves with WT
    std::vector<std::size_t> crown;    ///< from the neighbour of AHT to the neighbour of the head side
  };

  [[nodiscard]] Expected<void> findParts();
  [[nodiscard]] Expected<Side> findSide(char letter) const;
  [[nodiscard]] std::vector<std::size_t> walk(std::size_t from, std::size_t to, double sign) const;
  [[nodiscard]] double edgeX(const Side& side) const;
  void moveSide(const Side& side, const OutlineDeviation& deviation, double bottomMm, std::vector<OutlinePiece>& pieces,
                std::vector<char>& placed) const;
  [[nodiscard]] static bool carriesShoulder(const Side& side) { return side.crown.size() > 2; }
  [[nodiscard]] double summitY() const;
  [[nodiscard]] std::optional<double> headX(const Side& side, const std::vector<OutlinePiece>& pieces, double y) const;
  [[nodiscard]] Expected<void> joinHead(const Side& side, const OutlineDeviation& deviation,
                                        std::vector<OutlinePiece>& pieces) const;
  [[nodiscard]] Expected<void> bendCrown(const Side& side, const OutlineDeviation& deviation,
                                         std::vector<OutlinePiece>& pieces) const;
  [[nodiscard]] bool buildCrown(const Side& side, double extraCurvature, std::vector<OutlinePiece>& pieces) const;
  void carryTheRest(std::vector<OutlinePiece>& pieces, std::vector<char>& placed) const;

  Section section_;
  DimensionParameters parameters_;
  std::size_t bottom_ = 0, top_ = 0;
  double axisX_ = 0;
  double waistY_ = 0;
  Side right_, left_;
};

}  // namespace vignole::simulator
