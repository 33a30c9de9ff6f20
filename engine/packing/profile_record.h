#pragma once
// What is kept of every profile: where, how it was registered, and its dimensions. Many of them packed into one block.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/measurement/measurement.h"
#include "engine/packing/columns.h"

namespace vignole {

/// Lengths in mm come back to the nearest nm (kRecordStepMm), angles to 1e-9 rad.
inline constexpr double kRecordStepMm = 1e-6;

struct ProfileRecord {
  std::uint64_t trigger = 0;
  double positionMm = 0;                          ///< along the rail, from its head
  std::array<std::string, kCameraCount> missing;  ///< per camera: empty or the reason
  std::array<bool, kCameraCount> overloaded{};
  bool registered = false;
  std::string whyNotRegistered;
  Transform2 worldFromSection;
  double rmsMm = 0;
  int inliers = 0, points = 0;
  /// value, u and the calibration's part of it, second value, parts, points, reason and verdict are kept; nominal and limits are those of the rail and
  /// not in the block; anchors are not kept.
  PerDimension<DimensionResult> dimensions;
};

[[nodiscard]] ProfileRecord recordOf(const Profile& profile, const Registration& registration,
                                     const Measurement& measurement);

/// The most that one block holds.
inline constexpr std::size_t kMaxBlockProfiles = 1U << 16U;

/// At most kMaxBlockProfiles.
[[nodiscard]] Bytes packProfiles(std::span<const ProfileRecord> records);
/// Refuses what is damaged.
[[nodiscard]] Expected<std::vector<ProfileRecord>> unpackProfiles(std::span<const std::uint8_t> block);

}  // namespace vignole
