#pragma once
// The points of one profile as bytes: exact, so that measuring them again gives the same bits, or compact.

#include <span>

#include "engine/packing/columns.h"
#include "engine/profile/profile.h"

namespace vignole {

/// Compact: coordinates, uncertainties and shifts to 10 nm, normals to 1e-4 rad, contrast to 0.5 DN, all far below the
/// noise of a point (a few um, some DN).
enum class PointCoding : std::uint8_t { Exact = 1, Compact = 2 };

[[nodiscard]] std::string_view name(PointCoding coding);  ///< "exact", "compact"

[[nodiscard]] Bytes packPoints(const Profile& profile, PointCoding coding);
/// How they were packed; Compact of what are no points.
[[nodiscard]] PointCoding codingOf(std::span<const std::uint8_t> bytes);
/// The whole profile. Refuses what is damaged.
[[nodiscard]] Expected<Profile> unpackPoints(std::span<const std::uint8_t> bytes);

}  // namespace vignole
