#pragma once
// The definitions of rails.md, written once: evaluated on a section's own primitives (nominals) and on primitives
// fitted to data (measured values, with how they move with the fits).

#include <array>
#include <bitset>
#include <optional>
#include <string>
#include <vector>

#include "engine/measurement/curve_piece.h"
#include "engine/measurement/reading.h"
#include "engine/measurement/section_plan.h"

namespace vignole {

inline constexpr std::size_t kMaxPrimitives = 256;
using PrimitiveSet = std::bitset<kMaxPrimitives>;

/// Foot bottom y = c0 + c1 x + c2 x^2 in the frame of the shapes.
struct Parabola {
  double c0 = 0, c1 = 0, c2 = 0;
  [[nodiscard]] double at(double x) const { return c0 + x * (c1 + x * c2); }
  [[nodiscard]] double slopeAt(double x) const { return c1 + 2 * x * c2; }
};

/// What a section or the data are made of; indices are those of Section::primitives.
struct Shapes {
  std::vector<CurvePiece> pieces;
  std::vector<std::string> missing;  ///< per primitive: empty, or why there is no piece: "no points on SBL"
  Parabola footBottom;
};

/// One dimension as evaluated; HF carries its extremes and the ends of the crown, WT the smallest distance as `second`.
struct DefinedValue {
  std::optional<Reading> value;
  std::optional<Reading> second;
  double left = 0, right = 0;
  bool hasParts = false;
  /// HF: deviation at the ends of the compared width and on both sides of every change from one fit to another: where
  /// an extreme may lie besides where it was found.
  std::vector<Reading> candidates;
  std::string reason;  ///< why there is no value
  PrimitiveSet used;
  std::array<Vec, 4> anchors{};  ///< datum frame
  std::size_t anchorCount = 0;
};

/// Base line and axis: origin where they meet, unit vector along the base line, both in the frame of the shapes.
struct Datum {
  Vec origin;
  Vec along{1, 0};
  bool fromFoot = false;  ///< false: the foot is missing and the frame of the shapes stands in
  std::string reason;     ///< what of the foot is missing
};

class Definitions {
 public:
  /// `jointSlackMm`: how far a fitted joint may lie from where the section has it, before a point beside it is refused.
  Definitions(const SectionPlan& plan, const DimensionParameters& parameters, double jointSlackMm)
      : plan_(plan), parameters_(parameters), jointSlackMm_(jointSlackMm) {}

  /// All thirteen, as readings that primitives and foot bottom move; `values` is reused from call to call.
  void evaluate(const Shapes& shapes, PerDimension<DefinedValue>& values);
  [[nodiscard]] const Datum& datum() const { return datum_; }

 private:
  using Value = DefinedValue;

  void findDatum();
  [[nodiscard]] bool placeDatum();
  [[nodiscard]] bool edgesAt(std::array<double, 2>& edge);
  void linearizeDatum();
  void settle(Reading& reading) const;
  [[nodiscard]] Vec footBottomPoint(double x) const;
  [[nodiscard]] CurvePiece inDatum(std::size_t primitive) const;

  [[nodiscard]] Reading displacement(std::size_t primitive, const Vec& at, const Vec& normal) const;
  [[nodiscard]] Reading ordinateOf(std::size_t primitive, const Reading& x, double y) const;
  [[nodiscard]] Reading abscissaOf(std::size_t primitive, double x, const Reading& y) const;
  [[nodiscard]] Reading footBottomHeight(const Reading& x) const;
  [[nodiscard]] std::optional<double> plainOrdinate(std::size_t primitive, double x) const;
  [[nodiscard]] std::optional<double> plainAbscissa(std::size_t primitive, double y) const;

  [[nodiscard]] bool present(std::size_t primitive) const { return shapes_->missing[primitive].empty(); }
  bool need(std::size_t primitive, Value& v) const;
  bool needBaseLine(Value& v) const;
  bool needCrown(Value& v) const;
  [[nodiscard]] std::optional<Reading> ordinate(std::size_t primitive, const Reading& x, Value* v) const;
  [[nodiscard]] std::optional<Reading> headSide(std::size_t side, double depth, Value& v) const;
  [[nodiscard]] std::optional<Reading> webFace(std::size_t side, double y) const;
  [[nodiscard]] std::optional<double> plainWebFace(std::size_t side, double y) const;
  [[nodiscard]] Reading crownDeviation(const CrownSample& sample) const;

  void railHeight(Value& v) const;
  void fishingHeight(Value& v) const;
  void footWidth(Value& v) const;
  void headForm(Value& v) const;
  void headWidth(Value& v, double depth) const;
  void footThickness(Value& v, std::size_t side, double inside) const;
  void asymmetry(Value& v, std::size_t side, double depth) const;
  void webThickness(Value& v) const;
  void headRadius(Value& v) const;
  void footConcavity(Value& v) const;

  const SectionPlan& plan_;
  const DimensionParameters& parameters_;
  double jointSlackMm_;
  const Shapes* shapes_ = nullptr;
  std::vector<CurvePiece> pieces_;  ///< datum frame
  Datum datum_;
  std::array<Reading, 2> edge_;   ///< abscissa of the foot edges at their mid height
  std::array<Reading, 3> shift_;  ///< how the datum moves with the foot: along, up, turn
  std::optional<Reading> crownHeight_;
};

}  // namespace vignole
