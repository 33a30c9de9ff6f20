#include "engine/packing/point_pack.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace vignole {

namespace {

constexpr std::uint8_t kExactKind = 2, kCompactKind = 3;
constexpr std::uint64_t kMaxPoints = 1U << 20U;  // some two hundred times what a rig gives
constexpr double kPerMm = 1e5, kPerRad = 1e4, kPerDn = 2;

std::int64_t bitsOf(double value) { return std::bit_cast<std::int64_t>(value); }
std::int64_t bitsOf(float value) { return std::bit_cast<std::int32_t>(value); }
double doubleOf(std::int64_t bits) { return std::bit_cast<double>(bits); }
float floatOf(std::int64_t bits) { return std::bit_cast<float>(static_cast<std::int32_t>(bits)); }

std::int64_t steps(double value, double perUnit) {
  const double scaled = value * perUnit;
  return std::abs(scaled) < 9e18 ? std::llround(scaled) : 0;
}
/// What is there stays more than nothing: an uncertainty of 0 would mean another thing.
std::int64_t stepsAboveNothing(double value, double perUnit) {
  return value > 0 ? std::max<std::int64_t>(1, steps(value, perUnit)) : 0;
}

template <typename Value>
void addColumn(ColumnPacker& packer, std::vector<std::int64_t>& column, const Profile& profile, Value value) {
  column.clear();
  for (const ProfilePoint& p : profile.points) column.push_back(static_cast<std::int64_t>(value(p)));
  packer.add(column);
}

template <typename Set>
void readColumn(ColumnReader& reader, Profile& profile, Set set) {
  const auto column = reader.column(profile.points.size());
  for (std::size_t i = 0; i < column.size(); ++i) set(profile.points[i], column[i]);
}

void packExact(ColumnPacker& packer, const Profile& profile) {
  std::vector<std::int64_t> column;
  addColumn(packer, column, profile, [](const ProfilePoint& p) { return bitsOf(p.x); });
  addColumn(packer, column, profile, [](const ProfilePoint& p) { return bitsOf(p.y); });
  for (float ProfilePoint::*field :
       {&ProfilePoint::nx, &ProfilePoint::ny, &ProfilePoint::sigmaMm, &ProfilePoint::strength, &ProfilePoint::shiftMm,
        &ProfilePoint::ridgeSigmaMm, &ProfilePoint::smoothingMm})
    addColumn(packer, column, profile, [field](const ProfilePoint& p) { return bitsOf(p.*field); });
}

void readExact(ColumnReader& reader, Profile& profile) {
  readColumn(reader, profile, [](ProfilePoint& p, std::int64_t v) { p.x = doubleOf(v); });
  readColumn(reader, profile, [](ProfilePoint& p, std::int64_t v) { p.y = doubleOf(v); });
  for (float ProfilePoint::*field :
       {&ProfilePoint::nx, &ProfilePoint::ny, &ProfilePoint::sigmaMm, &ProfilePoint::strength, &ProfilePoint::shiftMm,
        &ProfilePoint::ridgeSigmaMm, &ProfilePoint::smoothingMm})
    readColumn(reader, profile, [field](ProfilePoint& p, std::int64_t v) { p.*field = floatOf(v); });
}

void packCompact(ColumnPacker& packer, const Profile& profile) {
  std::vector<std::int64_t> column;
  addColumn(packer, column, profile, [](const ProfilePoint& p) { return steps(p.x, kPerMm); });
  addColumn(packer, column, profile, [](const ProfilePoint& p) { return steps(p.y, kPerMm); });
  addColumn(packer, column, profile, [](const ProfilePoint& p) { return steps(std::atan2(p.ny, p.nx), kPerRad); });
  addColumn(packer, column, profile, [](const ProfilePoint& p) { return stepsAboveNothing(p.sigmaMm, kPerMm); });
  addColumn(packer, column, profile, [](const ProfilePoint& p) { return steps(p.strength, kPerDn); });
  addColumn(packer, column, profile, [](const ProfilePoint& p) { return steps(p.shiftMm, kPerMm); });
  addColumn(packer, column, profile, [](const ProfilePoint& p) { return stepsAboveNothing(p.ridgeSigmaMm, kPerMm); });
  addColumn(packer, column, profile, [](const ProfilePoint& p) { return stepsAboveNothing(p.smoothingMm, kPerMm); });
}

void readCompact(ColumnReader& reader, Profile& profile) {
  const auto value = [](std::int64_t v, double perUnit) { return static_cast<double>(v) / perUnit; };
  const auto mm = [value](std::int64_t v) { return static_cast<float>(value(v, kPerMm)); };
  readColumn(reader, profile, [&](ProfilePoint& p, std::int64_t v) { p.x = value(v, kPerMm); });
  readColumn(reader, profile, [&](ProfilePoint& p, std::int64_t v) { p.y = value(v, kPerMm); });
  readColumn(reader, profile, [&](ProfilePoint& p, std::int64_t v) {
    p.nx = static_cast<float>(std::cos(value(v, kPerRad)));
    p.ny = static_cast<float>(std::sin(value(v, kPerRad)));
  });
  readColumn(reader, profile, [&](ProfilePoint& p, std::int64_t v) { p.sigmaMm = mm(v); });
  readColumn(reader, profile,
             [&](ProfilePoint& p, std::int64_t v) { p.strength = static_cast<float>(value(v, kPerDn)); });
  readColumn(reader, profile, [&](ProfilePoint& p, std::int64_t v) { p.shiftMm = mm(v); });
  readColumn(reader, profile, [&](ProfilePoint& p, std::int64_t v) { p.ridgeSigmaMm = mm(v); });
  readColumn(reader, profile, [&](ProfilePoint& p, std::int64_t v) { p.smoothingMm = mm(v); });
}

}  // namespace

std::string_view name(PointCoding coding) { return coding == PointCoding::Exact ? "exact" : "compact"; }

Bytes packPoints(const Profile& profile, PointCoding coding) {
  ColumnPacker packer(coding == PointCoding::Exact ? kExactKind : kCompactKind);
  packer.addNumber(profile.trigger);
  packer.addNumber(static_cast<std::uint64_t>(bitsOf(profile.positionMm)));
  packer.addNumber(static_cast<std::uint64_t>(bitsOf(static_cast<double>(profile.correlatedPoints))));
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    packer.addNumber(profile.pointsOfCamera[c]);
    packer.addNumber(profile.overloaded[c] ? 1 : 0);
    packer.addText(profile.missing[c]);
  }
  packer.addNumber(profile.lineEnds.size());
  for (const std::uint32_t end : profile.lineEnds) packer.addNumber(end);
  packer.addNumber(profile.points.size());
  std::vector<std::int64_t> column;
  addColumn(packer, column, profile, [](const ProfilePoint& p) { return p.camera; });
  addColumn(packer, column, profile, [](const ProfilePoint& p) { return p.flags; });
  if (coding == PointCoding::Exact)
    packExact(packer, profile);
  else
    packCompact(packer, profile);
  return packer.finish();
}

PointCoding codingOf(std::span<const std::uint8_t> bytes) {
  return bytes.size() > 1 && bytes[1] == kExactKind ? PointCoding::Exact : PointCoding::Compact;
}

Expected<Profile> unpackPoints(std::span<const std::uint8_t> bytes) {
  const bool exact = codingOf(bytes) == PointCoding::Exact;
  ColumnReader reader(bytes, exact ? kExactKind : kCompactKind);
  Profile profile;
  profile.trigger = reader.number();
  profile.positionMm = doubleOf(static_cast<std::int64_t>(reader.number()));
  profile.correlatedPoints = static_cast<float>(doubleOf(static_cast<std::int64_t>(reader.number())));
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    profile.pointsOfCamera[c] = static_cast<std::uint32_t>(reader.number());
    profile.overloaded[c] = reader.number() != 0;
    profile.missing[c] = reader.text();
  }
  const std::uint64_t lines = reader.number();
  if (lines > bytes.size()) reader.refuse("more lines than there can be");
  for (std::uint64_t i = 0; i < lines && reader.good(); ++i)
    profile.lineEnds.push_back(static_cast<std::uint32_t>(reader.number()));
  const std::uint64_t points = reader.number();
  if (points > kMaxPoints) reader.refuse("more points than a profile holds");
  if (!reader.good()) return inputError("points", reader.error());
  profile.points.resize(static_cast<std::size_t>(points));
  readColumn(reader, profile, [](ProfilePoint& p, std::int64_t v) { p.camera = static_cast<std::uint8_t>(v); });
  readColumn(reader, profile, [](ProfilePoint& p, std::int64_t v) { p.flags = static_cast<std::uint8_t>(v); });
  if (exact)
    readExact(reader, profile);
  else
    readCompact(reader, profile);
  const bool inOrder = std::is_sorted(profile.lineEnds.begin(), profile.lineEnds.end()) &&
                       (profile.lineEnds.empty() || profile.lineEnds.back() <= points) &&
                       std::all_of(profile.points.begin(), profile.points.end(),
                                   [](const ProfilePoint& p) { return p.camera < kCameraCount; });
  if (!inOrder) reader.refuse("lines or cameras that cannot be");
  if (!reader.good()) return inputError("points", reader.error());
  return profile;
}

}  // namespace vignole
