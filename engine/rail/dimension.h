#pragma once
// The dimensions of the paper's Table II and the parameters of their definitions.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace vignole {

enum class Dimension { RH, RFH, FW, HF, HW, HWA, FTl, FTr, RASl, RASr, WT, HR, FC };
inline constexpr std::size_t kDimensionCount = 13;
inline constexpr std::array<Dimension, kDimensionCount> kDimensions = {
    Dimension::RH,  Dimension::RFH,  Dimension::FW,   Dimension::HF, Dimension::HW, Dimension::HWA, Dimension::FTl,
    Dimension::FTr, Dimension::RASl, Dimension::RASr, Dimension::WT, Dimension::HR, Dimension::FC};

[[nodiscard]] constexpr std::size_t index(Dimension d) { return static_cast<std::size_t>(d); }

/// One value per dimension.
template <typename T>
using PerDimension = std::array<T, kDimensionCount>;

/// "RH", "FT_l" ... as in Table II and in every file.
[[nodiscard]] std::string_view name(Dimension dimension);
/// "Rail height" ...
[[nodiscard]] std::string_view title(Dimension dimension);
[[nodiscard]] std::optional<Dimension> dimensionFromName(std::string_view name);

struct LeftRight {
  double left = 0;
  double right = 0;
};

/// Parameters p of the definitions in mm; left and right may differ where the section is asymmetric.
struct DimensionParameters {
  LeftRight rfhFromAxisMm{25, 25};   ///< RFH: |x| from the axis
  LeftRight hfHalfWidthMm{25, 25};   ///< HF: crown compared between these x, every 1 mm
  double hwDepthMm = 14;             ///< HW: below the crown at the axis
  double hwaDepthMm = 15.875;        ///< HWA: the AREMA depth
  LeftRight ftInsideMm{10, 10};      ///< FT: inside the fitted foot edge
  LeftRight rasDepthMm{14, 14};      ///< RAS: head side this far below the crown
  std::optional<double> wtHeightMm;  ///< WT: height above the base line; empty: where the nominal web is thinnest
  double baseInsetMm = 5;            ///< base line: through the foot-bottom parabola this far inside the foot edges
};

}  // namespace vignole
