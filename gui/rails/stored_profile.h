#pragma once
// A profile of a stored rail as it can be shown: its kept figures, and where its points were kept, the profile itself,
// registered and measured again so that it can be drawn.

#include <memory>
#include <optional>

#include "engine/archive/rail_archive.h"
#include "engine/recipe/recipe.h"

namespace vignole {

struct OpenedRail {
  StoredRail stored;
  std::optional<Recipe> recipe;  ///< that it was measured with; none where it cannot be read
  std::string recipeProblem;
  std::vector<std::uint64_t> withPoints;  ///< profiles whose points were kept, in order
};

struct StoredProfile {
  std::uint64_t number = 0;
  ProfileRecord record;
  std::shared_ptr<const ProfileResult> drawn;  ///< null: no points of it, or of one nearby, were kept
  std::uint64_t drawnNumber = 0;
};

/// Reader's thread.
[[nodiscard]] Expected<OpenedRail> openRail(const Archive& archive, std::int64_t key);
/// Draws the profile nearest to `number` whose points were kept. The nominals and limits are those of the rail.
[[nodiscard]] Expected<StoredProfile> storedProfile(const Archive& archive, const OpenedRail& rail,
                                                    std::uint64_t number);

}  // namespace vignole
