#include "engine/archive/recipe_history.h"

#include "engine/archive/audit_rows.h"
#include "engine/archive/kept_texts.h"
#include "engine/database/digest.h"

namespace vignole {

namespace {

std::int64_t number(RecipeState state) { return static_cast<std::int64_t>(state); }

constexpr const char* kColumns =
    "id, name, version, state, created_us, created_by, note, decided_us, decided_by, reason";
constexpr const char* kKinds = "itiiittitt";

RecipeVersion versionFrom(const Row& row) {
  RecipeVersion v;
  v.key = row.integer(0);
  v.name = row.text(1);
  v.version = static_cast<int>(row.integer(2));
  v.state = static_cast<RecipeState>(std::clamp<std::int64_t>(row.integer(3), 0, number(RecipeState::Measured)));
  v.createdUs = row.integer(4);
  v.createdBy = row.text(5);
  v.note = row.text(6);
  v.decidedUs = row.integerOrNone(7);
  v.decidedBy = row.text(8);
  v.reason = row.text(9);
  return v;
}

std::vector<RecipeVersion> select(Database& database, const std::string& condition, const SqlValues& values) {
  std::vector<RecipeVersion> found;
  database.query(std::string("select ") + kColumns + " from recipe where " + condition, values, kKinds,
                 [&](const Row& row) { found.push_back(versionFrom(row)); });
  return found;
}

RecipeVersion versionAt(Database& database, std::int64_t key) {
  const auto found = select(database, "id = :a", {key});
  if (found.empty())
    throw DatabaseFailure({"recipe", "there is none with the key " + std::to_string(key), ErrorKind::Input});
  return found.front();
}

std::string shownName(const RecipeVersion& v) { return v.name + " v" + std::to_string(v.version); }

void decide(Database& database, const RecipeVersion& v, RecipeState state, const std::string& user,
            const std::string& reason) {
  const TimeUs now = systemTimeUs();
  database.run("update recipe set state = :a, decided_us = :b, decided_by = :c, reason = :d where id = :e",
               {number(state), now, user, reason, v.key});
  appendAudit(database, now,
              {user, "recipe " + std::string(name(state)), shownName(v), reason, "was " + std::string(name(v.state))});
}

}  // namespace

std::string_view name(RecipeState state) {
  switch (state) {
    case RecipeState::Draft:
      return "draft";
    case RecipeState::Approved:
      return "approved";
    case RecipeState::Retired:
      return "retired";
    case RecipeState::Measured:
      break;
  }
  return "measured";
}

std::int64_t keepRecipe(Database& database, const Recipe& recipe, TimeUs now) {
  const std::string text = toToml(recipe), digest = digestOf(text);
  Transaction transaction(database);
  const auto known = database.first("select id from recipe where digest = :a", {digest}, "i");
  const std::int64_t key =
      known ? known->integer(0)
            : database.insert(
                  "insert into recipe (name, version, digest, content, state, created_us, created_by, note) "
                  "values (:a, 0, :b, :c, :d, :e, '', :f)",
                  {recipe.name, digest, text, number(RecipeState::Measured), now, recipe.note});
  transaction.commit();
  return key;
}

RecipeHistory::RecipeHistory(const Archive& archive) : database_(archive.database()) {}

Expected<std::vector<std::string>> RecipeHistory::names() const {
  return guarded([&] {
    std::vector<std::string> names;
    database_->query("select distinct name from recipe where version > 0 order by name", {}, "t",
                     [&](const Row& row) { names.push_back(row.text(0)); });
    return names;
  });
}

Expected<std::vector<RecipeVersion>> RecipeHistory::versions(const std::string& name) const {
  return guarded([&] { return select(*database_, "name = :a and version > 0 order by version desc", {name}); });
}

Expected<int> RecipeHistory::nextVersion(const std::string& name) const {
  return guarded([&] {
    const auto row = database_->first("select max(version) from recipe where name = :a", {name}, "i");
    return row ? static_cast<int>(row->integer(0)) + 1 : 1;
  });
}

Expected<std::string> RecipeHistory::text(std::int64_t key) const {
  return guarded([&] {
    const auto row = database_->first("select content from recipe where id = :a", {key}, "t");
    if (!row) throw DatabaseFailure({"recipe", "there is none with the key " + std::to_string(key), ErrorKind::Input});
    return row->text(0);
  });
}

Expected<RecipeVersion> RecipeHistory::addDraft(const Recipe& recipe, const std::string& user,
                                                const std::string& note) {
  return guarded([&] {
    const std::string text = toToml(recipe), digest = digestOf(text);
    const TimeUs now = systemTimeUs();
    const std::string shownAs = recipe.name + " v" + std::to_string(recipe.version);
    if (recipe.version < 1) throw DatabaseFailure({shownAs, "versions begin at 1", ErrorKind::Input});
    Transaction transaction(*database_);
    if (!select(*database_, "name = :a and version = :b", {recipe.name, static_cast<std::int64_t>(recipe.version)})
             .empty())
      throw DatabaseFailure({shownAs, "is there already; a change is a new version", ErrorKind::Input});
    const auto same = select(*database_, "digest = :a", {digest});
    std::int64_t key = 0;
    if (same.empty()) {
      key = database_->insert(
          "insert into recipe (name, version, digest, content, state, created_us, created_by, note) "
          "values (:a, :b, :c, :d, :e, :f, :g, :h)",
          {recipe.name, static_cast<std::int64_t>(recipe.version), digest, text, number(RecipeState::Draft), now, user,
           note});
    } else if (same.front().state == RecipeState::Measured) {
      key = same.front().key;
      database_->run(
          "update recipe set version = :a, state = :b, created_us = :c, created_by = :d, note = :e "
          "where id = :f",
          {static_cast<std::int64_t>(recipe.version), number(RecipeState::Draft), now, user, note, key});
    } else {
      throw DatabaseFailure({shownAs, "is the same as " + shownName(same.front()), ErrorKind::Input});
    }
    appendAudit(*database_, now, {user, "recipe drafted", shownAs, note, "digest " + digest});
    transaction.commit();
    return versionAt(*database_, key);
  });
}

Expected<void> RecipeHistory::approve(std::int64_t key, const std::string& user, const std::string& reason) {
  return guarded([&] {
    Transaction transaction(*database_);
    const RecipeVersion v = versionAt(*database_, key);
    if (v.state != RecipeState::Draft)
      throw DatabaseFailure(
          {shownName(v), "is no draft (" + std::string(vignole::name(v.state)) + ")", ErrorKind::Input});
    if (v.createdBy == user)
      throw DatabaseFailure({shownName(v), "was drafted by " + user + "; somebody else approves it", ErrorKind::Input});
    for (const RecipeVersion& earlier :
         select(*database_, "name = :a and state = :b", {v.name, number(RecipeState::Approved)}))
      decide(*database_, earlier, RecipeState::Retired, user, "replaced by " + shownName(v));
    decide(*database_, v, RecipeState::Approved, user, reason);
    transaction.commit();
  });
}

Expected<void> RecipeHistory::retire(std::int64_t key, const std::string& user, const std::string& reason) {
  return guarded([&] {
    Transaction transaction(*database_);
    const RecipeVersion v = versionAt(*database_, key);
    if (v.state == RecipeState::Retired || v.state == RecipeState::Measured)
      throw DatabaseFailure({shownName(v), "is " + std::string(vignole::name(v.state)) + " already", ErrorKind::Input});
    decide(*database_, v, RecipeState::Retired, user, reason);
    transaction.commit();
  });
}

Expected<std::optional<RecipeVersion>> RecipeHistory::approved(const std::string& name) const {
  return guarded([&]() -> std::optional<RecipeVersion> {
    const auto found =
        select(*database_, "name = :a and state = :b order by version desc", {name, number(RecipeState::Approved)});
    return found.empty() ? std::nullopt : std::optional(found.front());
  });
}

}  // namespace vignole
