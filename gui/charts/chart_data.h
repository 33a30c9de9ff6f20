#pragma once
// What the charts show, read from the archive: one rail's profiles, and the rails before it.

#include <QVector>
#include <vector>

#include "engine/archive/rail_archive.h"

namespace vignole {

inline constexpr std::size_t kBandRails = 20;  ///< fewer make no band
inline constexpr std::size_t kRecentRails = 60;

struct ChartData {
  StoredRail rail;                      ///< that is charted
  std::vector<ProfileRecord> profiles;  ///< all of it
  std::vector<StoredRail> recent;       ///< of the same section, oldest first, the charted one among them if it is
};

/// Reader's thread. `key` 0: the newest rail that has passed; without any the error says so.
[[nodiscard]] Expected<ChartData> chartData(const Archive& archive, std::int64_t key);

/// 10 % and 90 % of the means of the latest kBandRails other rails, over the share of the length.
struct ChartBand {
  QVector<double> xM, low, high;  ///< empty: fewer rails than that
  std::size_t rails = 0;
};
[[nodiscard]] ChartBand bandOf(const ChartData& data, Dimension dimension);

struct ChartFigures {
  std::size_t count = 0, beyond = 0, guard = 0, missing = 0;  ///< profiles
  double mean = 0, sd = 0, smallest = 0, largest = 0, uMm = 0;
  std::optional<double> roomMm;  ///< to the nearer limit, of any value; negative: beyond
};
[[nodiscard]] ChartFigures figuresOf(const ChartData& data, Dimension dimension);

}  // namespace vignole
