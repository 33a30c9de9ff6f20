#pragma once
// Recipes with their versions: draft, approved, retired. Every decision has a name and a reason, and goes into the
// audit trail.

#include <optional>
#include <string>
#include <vector>

#include "engine/archive/archive.h"
#include "engine/archive/rail_record.h"

namespace vignole {

/// Measured: a rail was measured with it, but it was never entered here.
enum class RecipeState { Draft, Approved, Retired, Measured };
[[nodiscard]] std::string_view name(RecipeState state);

struct RecipeVersion {
  std::int64_t key = 0;
  std::string name;
  int version = 0;  ///< 0 for Measured
  RecipeState state = RecipeState::Draft;
  TimeUs createdUs = 0;
  std::string createdBy, note;
  std::optional<TimeUs> decidedUs;  ///< approved or retired: when, by whom, why
  std::string decidedBy, reason;
};

class RecipeHistory {
 public:
  explicit RecipeHistory(const Archive& archive);
  [[nodiscard]] Expected<std::vector<std::string>> names() const;  ///< of those entered, sorted
  [[nodiscard]] Expected<std::vector<RecipeVersion>> versions(const std::string& name) const;  ///< newest first
  [[nodiscard]] Expected<int> nextVersion(const std::string& name) const;
  [[nodiscard]] Expected<std::string> text(std::int64_t key) const;
  /// `recipe.version` must be new for its name. Refuses a recipe that is the same as one that is there.
  [[nodiscard]] Expected<RecipeVersion> addDraft(const Recipe& recipe, const std::string& user,
                                                 const std::string& note);
  /// A draft of somebody else; earlier approved versions of the name are retired by it.
  [[nodiscard]] Expected<void> approve(std::int64_t key, const std::string& user, const std::string& reason);
  [[nodiscard]] Expected<void> retire(std::int64_t key, const std::string& user, const std::string& reason);
  /// Empty: no version of it is approved.
  [[nodiscard]] Expected<std::optional<RecipeVersion>> approved(const std::string& name) const;

 private:
  std::shared_ptr<Database> database_;
};

}  // namespace vignole
