#include "gui/rails/stored_profile.h"

#include <algorithm>

namespace vignole {

Expected<OpenedRail> openRail(const Archive& archive, std::int64_t key) {
  const RailArchive rails(archive);
  OpenedRail opened;
  auto stored = rails.open(key);
  if (!stored) return tl::unexpected(stored.error());
  opened.stored = std::move(*stored);
  const auto text = rails.recipeText(opened.stored);
  if (!text) return tl::unexpected(text.error());
  if (text->empty()) {
    opened.recipeProblem = "its recipe was not kept";
  } else if (auto recipe = parseRecipe(*text, "recipe of rail " + opened.stored.summary.rail.id)) {
    opened.recipe = std::move(*recipe);
  } else {
    opened.recipeProblem = recipe.error().message();
  }
  auto kept = rails.profilesWithPoints(key);
  if (!kept) return tl::unexpected(kept.error());
  opened.withPoints = std::move(*kept);
  return opened;
}

namespace {

std::shared_ptr<const ProfileResult> measuredAgain(const OpenedRail& rail, Profile profile) {
  const Recipe& recipe = *rail.recipe;
  auto result = std::make_shared<ProfileResult>();
  result->profile = std::move(profile);
  Registrar registrar(recipe.section, recipe.registration);
  registrar.registerProfile(result->profile.points, result->registration);
  Measurer measurer(recipe.section, recipe.parameters, recipe.limits, recipe.measurement);
  measurer.measure(result->profile, result->registration, {}, result->measurement);
  return result;
}

}  // namespace

Expected<StoredProfile> storedProfile(const Archive& archive, const OpenedRail& rail, std::uint64_t number) {
  const RailArchive rails(archive);
  auto records = rails.profiles(rail.stored.key, number, 1);
  if (!records) return tl::unexpected(records.error());
  if (records->empty())
    return inputError("rail " + rail.stored.summary.rail.id, "has no profile " + std::to_string(number + 1));
  StoredProfile profile;
  profile.number = number;
  profile.record = std::move(records->front());
  if (!rail.recipe || rail.withPoints.empty()) return profile;
  auto after = std::lower_bound(rail.withPoints.begin(), rail.withPoints.end(), number);
  if (after == rail.withPoints.end() || (after != rail.withPoints.begin() && number - *(after - 1) < *after - number))
    --after;
  auto points = rails.points(rail.stored.key, *after);
  if (!points) return tl::unexpected(points.error());
  if (!*points) return profile;
  profile.drawnNumber = *after;
  profile.drawn = measuredAgain(rail, std::move(**points));
  return profile;
}

}  // namespace vignole
