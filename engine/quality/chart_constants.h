#pragma once
// Constants of ranges and standard deviations of n normal values (ISO 7870-2, ASTM MNL 7), computed, not copied:
// d2, d3 by quadrature of the distribution of the range, c4 in closed form, the others from them.

namespace vignole {

/// Exact: to double precision. Tabulated: rounded as the printed tables are, which published examples were worked with.
enum class ConstantPrecision { Tabulated, Exact };

struct ChartConstants {
  int n = 0;
  double d2 = 0, d3 = 0, c4 = 0;
  double a2 = 0, d3Limit = 0, d4Limit = 0;  ///< X-bar/R: A2, D3, D4
  double a3 = 0, b3Limit = 0, b4Limit = 0;  ///< X-bar/S: A3, B3, B4
};

/// 2 <= n <= 1000.
[[nodiscard]] ChartConstants chartConstants(int n, ConstantPrecision precision);

/// d2* of Duncan, by which the mean of `groups` ranges of n values is divided: sqrt(d2^2 + d3^2 / groups). Its inverse
/// for one group is the AIAG's K2 and K3; for many it goes to d2, and 1 / d2 is K1.
[[nodiscard]] double averageRangeConstant(int n, int groups);

/// `value` rounded to `decimals`, as a printed table has it.
[[nodiscard]] double rounded(double value, int decimals);

}  // namespace vignole
