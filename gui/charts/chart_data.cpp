#include "gui/charts/chart_data.h"

#include <algorithm>
#include <cmath>

#include "engine/quality/running_statistics.h"

namespace vignole {

namespace {
constexpr std::size_t kBandBins = 64;
}

Expected<ChartData> chartData(const Archive& archive, std::int64_t key) {
  const RailArchive rails(archive);
  RailQuery query;
  query.limit = kRecentRails + 1;
  query.state = RailState::Finished;
  auto newest = rails.search(query);
  if (!newest) return tl::unexpected(newest.error());
  if (key == 0) {
    if (newest->empty()) return inputError("", "no rail has been measured yet");
    key = newest->front().key;
  }
  ChartData data;
  auto rail = rails.open(key);
  if (!rail) return tl::unexpected(rail.error());
  data.rail = std::move(*rail);
  auto profiles = rails.profiles(key);
  if (!profiles) return tl::unexpected(profiles.error());
  data.profiles = std::move(*profiles);
  for (const RailLine& line : *newest) {
    if (line.section != data.rail.summary.rail.sectionName || data.recent.size() >= kRecentRails) continue;
    auto other = rails.open(line.key, kBandBins);
    if (!other) return tl::unexpected(other.error());
    data.recent.push_back(std::move(*other));
  }
  std::reverse(data.recent.begin(), data.recent.end());
  return data;
}

ChartBand bandOf(const ChartData& data, Dimension dimension) {
  std::vector<std::vector<double>> bins(kBandBins);
  ChartBand band;
  for (auto it = data.recent.rbegin(); it != data.recent.rend() && band.rails < kBandRails; ++it) {
    if (it->key == data.rail.key || it->summary.lengthM <= 0) continue;
    ++band.rails;
    for (const TrackBin& bin : it->summary.dimensions[index(dimension)].track) {
      if (bin.count == 0) continue;
      const double share = std::clamp(bin.positionM / it->summary.lengthM, 0.0, 1.0);
      bins[std::min(kBandBins - 1, static_cast<std::size_t>(share * kBandBins))].push_back(bin.meanMm);
    }
  }
  if (band.rails < kBandRails) return band;
  for (std::size_t b = 0; b < kBandBins; ++b) {
    std::vector<double>& values = bins[b];
    if (values.size() < kBandRails / 2) continue;
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
      return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
    };
    band.xM.append((static_cast<double>(b) + 0.5) / kBandBins * data.rail.summary.lengthM);
    band.low.append(at(0.1));
    band.high.append(at(0.9));
  }
  return band;
}

ChartFigures figuresOf(const ChartData& data, Dimension dimension) {
  ChartFigures figures;
  RunningStatistics values, u;
  for (const ProfileRecord& profile : data.profiles) {
    const DimensionResult& r = profile.dimensions[index(dimension)];
    if (!r.valueMm) {
      ++figures.missing;
      continue;
    }
    values.add(*r.valueMm);
    u.add(r.uMm);
    if (r.verdict == Verdict::Fail) ++figures.beyond;
    if (r.verdict == Verdict::Near) ++figures.guard;
    if (const auto excess = excessMm(dimension, r)) {
      const double room = -*excess;
      if (!figures.roomMm || room < *figures.roomMm) figures.roomMm = room;
    }
  }
  figures.count = values.count();
  figures.mean = values.mean();
  figures.sd = values.sd();
  figures.smallest = values.min();
  figures.largest = values.max();
  figures.uMm = u.mean();
  return figures;
}

}  // namespace vignole
