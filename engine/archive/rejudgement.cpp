#include "engine/archive/rejudgement.h"

#include "engine/measurement/verdict.h"

namespace vignole {

Expected<RejudgedRail> rejudge(const RailArchive& rails, std::int64_t key,
                               const PerDimension<ToleranceLimits>& limits) {
  const auto stored = rails.open(key, 2);
  if (!stored) return tl::unexpected(stored.error());
  const RailSummary& was = stored->summary;
  const auto text = rails.recipeText(*stored);
  if (!text) return tl::unexpected(text.error());
  if (text->empty()) return inputError("rail " + was.rail.id, "cannot be judged again: its recipe was not kept");
  auto recipe = parseRecipe(*text, "recipe of rail " + was.rail.id);
  if (!recipe) return tl::unexpected(recipe.error());
  recipe->limits = limits;
  auto profiles = rails.profiles(key);
  if (!profiles) return tl::unexpected(profiles.error());

  RailSummariser summariser(was.rail, *recipe, was.calibrationId);
  ProfileResult result;
  for (ProfileRecord& record : *profiles) {
    result.profile.positionMm = record.positionMm;
    result.registration.valid = record.registered;
    result.registration.reason = record.whyNotRegistered;
    result.measurement.dimensions = std::move(record.dimensions);
    for (const Dimension d : kDimensions) {
      DimensionResult& dimension = result.measurement.dimensions[index(d)];
      dimension.nominalMm = was.dimensions[index(d)].nominalMm;
      judge(d, limits[index(d)], dimension);
    }
    summariser.add(result);
  }
  const RailSummary is = summariser.summary(was.triggers);
  RejudgedRail rejudged;
  rejudged.key = key;
  rejudged.id = was.rail.id;
  rejudged.before = was.verdict;
  rejudged.after = is.verdict;
  // A rail of another section stays without a verdict, whatever the limits.
  if (was.looksLike && rejudged.after != Verdict::Fail) rejudged.after = Verdict::NotMeasured;
  for (std::size_t d = 0; d < kDimensionCount; ++d) {
    rejudged.dimensionsBefore[d] = was.dimensions[d].verdict;
    rejudged.dimensionsAfter[d] = is.dimensions[d].verdict;
  }
  return rejudged;
}

}  // namespace vignole
