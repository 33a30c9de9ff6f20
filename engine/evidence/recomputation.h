#pragma once
// What a pack holds, measured and judged again. For this room alone.

#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>

#include "engine/archive/rail_record.h"
#include "engine/optics/calibration.h"
#include "engine/packing/profile_record.h"
#include "engine/profile/profile.h"
#include "engine/recipe/recipe.h"

namespace vignole {

struct EvidenceContent {
  StoredRail rail;
  Recipe recipe;
  RigCalibration calibration;
  std::vector<ProfileRecord> profiles;
  std::map<std::uint64_t, Profile> points;  ///< by number of the profile
  bool exact = false;
};

struct Recomputed {
  std::string measured;  ///< JSON: every profile with points, then the rail; the same numbers, the same text
  std::vector<std::string> findings;  ///< where it contradicts what the archive had
  Verdict verdict = Verdict::NotMeasured;
};

/// Content that was checked by refusal().
[[nodiscard]] Recomputed recompute(const EvidenceContent& content, const std::function<void(double)>& progress);
/// Empty, or why this cannot be measured: numbers that no rail has.
[[nodiscard]] std::string refusal(const EvidenceContent& content);

[[nodiscard]] nlohmann::ordered_json toJson(const RailSummary& summary);
/// Everything of a stored rail but its keys, tracks and profiles.
[[nodiscard]] nlohmann::ordered_json toJson(const StoredRail& rail);
/// Throws nlohmann's exceptions.
[[nodiscard]] StoredRail railFromJson(const nlohmann::ordered_json& json);

}  // namespace vignole
