// vignole-cli archive: what is in an archive, out of it, and whether it is whole.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <charconv>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/archive_output.h"
#include "cli/archive_retention.h"
#include "cli/archived_rail.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "engine/archive/generated_rails.h"
#include "engine/archive/rail_archive.h"
#include "engine/archive/verify_archive.h"

namespace vignole::cli {

namespace {

struct Options {
  std::string url, rail, from, to, id, heat, section, recipe, json, csv, out;
  std::vector<std::string> verdicts, exceeds;
  std::size_t limit = 100;
  std::optional<std::uint64_t> points;
  GeneratedRails generated;
  bool quiet = false;
};

Expected<Verdict> verdictOf(const std::string& word) {
  for (const Verdict v : {Verdict::Pass, Verdict::Near, Verdict::Fail, Verdict::NotMeasured, Verdict::NoLimit})
    if (word == name(v)) return v;
  return inputError("--verdict " + word, "is none; use pass, near, fail, \"not measured\" or \"no limit\"");
}

/// "HW" (out of tolerance) or "HW=0.05" (by more than that, mm).
Expected<DimensionQuery> dimensionQueryOf(const std::string& text) {
  const std::size_t equals = text.find('=');
  DimensionQuery query;
  const auto dimension = dimensionFromName(text.substr(0, equals));
  if (!dimension) return inputError("--exceeds " + text, "names no dimension; use RH, HW, FT_l ...");
  query.dimension = *dimension;
  query.excessAboveMm = 0;
  if (equals == std::string::npos) return query;
  double value = 0;
  const char *begin = text.data() + equals + 1, *end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end) return inputError("--exceeds " + text, "write DIM or DIM=MM");
  query.excessAboveMm = value;
  return query;
}

Expected<RailQuery> queryOf(const Options& o) {
  RailQuery query;
  query.railId = o.id;
  query.heat = o.heat;
  query.section = o.section;
  query.recipe = o.recipe;
  query.limit = o.limit;
  const auto time = [](const std::string& text, std::optional<TimeUs>& into) -> Expected<void> {
    if (text.empty()) return {};
    const auto read = timeFromIso(text);
    if (!read) return tl::unexpected(read.error());
    into = *read;
    return {};
  };
  if (const auto read = time(o.from, query.fromUs); !read) return tl::unexpected(read.error());
  if (const auto read = time(o.to, query.toUs); !read) return tl::unexpected(read.error());
  for (const std::string& word : o.verdicts) {
    const auto verdict = verdictOf(word);
    if (!verdict) return tl::unexpected(verdict.error());
    query.verdicts.push_back(*verdict);
  }
  for (const std::string& text : o.exceeds) {
    const auto dimension = dimensionQueryOf(text);
    if (!dimension) return tl::unexpected(dimension.error());
    query.dimensions.push_back(*dimension);
  }
  return query;
}

int list(const Options& o) {
  const auto query = queryOf(o);
  if (!query) return fail(query.error());
  const auto archive = Archive::open(o.url);
  if (!archive) return fail(archive.error());
  const auto rails = RailArchive(*archive).search(*query);
  if (!rails) return fail(rails.error());
  if (!o.json.empty())
    if (const auto written = writeJson(o.json, toJson(*rails)); !written) return fail(written.error());
  if (o.json != "-")
    if (const auto written = writeResult("-", toTable(*rails)); !written) return fail(written.error());
  return kDone;
}

int show(const Options& o) {
  const auto archive = Archive::open(o.url);
  if (!archive) return fail(archive.error());
  const RailArchive rails(*archive);
  const auto key = findRail(rails, o.rail);
  if (!key) return fail(key.error());
  const auto rail = rails.open(*key);
  if (!rail) return fail(rail.error());
  const auto points = rails.profilesWithPoints(*key);
  if (!points) return fail(points.error());
  if (!o.json.empty())
    if (const auto written = writeJson(o.json, toJson(*rail, points->size())); !written) return fail(written.error());
  if (o.json != "-")
    if (const auto written = writeResult("-", toTable(*rail, points->size())); !written) return fail(written.error());
  return kDone;
}

int exportRail(const Options& o) {
  if (o.csv.empty() && o.json.empty()) return fail({"archive export", "names nothing to write; give --csv or --json"});
  const auto archive = Archive::open(o.url);
  if (!archive) return fail(archive.error());
  const RailArchive rails(*archive);
  const auto key = findRail(rails, o.rail);
  if (!key) return fail(key.error());
  const auto rail = rails.open(*key);
  if (!rail) return fail(rail.error());
  if (o.points) {
    const auto profile = rails.points(*key, *o.points);
    if (!profile) return fail(profile.error());
    if (!*profile)
      return fail(
          {"profile " + std::to_string(*o.points), "its points were not kept; archive show tells how many were"});
    if (const auto written = writeResult(o.csv, pointsCsv(**profile)); !written) return fail(written.error());
    return kDone;
  }
  if (!o.csv.empty()) {
    const auto profiles = rails.profiles(*key);
    if (!profiles) return fail(profiles.error());
    if (const auto written = writeResult(o.csv, profilesCsv(*rail, *profiles)); !written) return fail(written.error());
  }
  if (!o.json.empty())
    if (const auto written = writeJson(o.json, toJson(*rail, {})); !written) return fail(written.error());
  return kDone;
}

int verify(const Options& o) {
  const auto archive = Archive::open(o.url);
  if (!archive) return fail(archive.error());
  std::optional<Progress> progress(std::in_place, o.quiet, "verifying");
  const auto check = verifyArchive(*archive, [&](double share) {
    progress->update(share);
    return true;
  });
  progress.reset();
  if (!check) return fail(check.error());
  if (!o.json.empty())
    if (const auto written = writeJson(o.json, toJson(*check)); !written) return fail(written.error());
  if (o.json != "-")
    if (const auto written = writeResult("-", toTable(*check)); !written) return fail(written.error());
  return check->findings.empty() ? kDone : kVerdictFail;
}

int backUp(const Options& o) {
  auto archive = Archive::open(o.url);
  if (!archive) return fail(archive.error());
  const auto done = archive->backUpTo(o.out);
  return done ? kDone : fail(done.error());
}

int generate(const Options& o) {
  const auto recipe = findRecipe(o.recipe.empty() ? "60E1 X/A" : o.recipe);
  if (!recipe) return fail(recipe.error());
  Progress progress(o.quiet, "generating");
  const auto done = generateRails(o.url, *recipe, o.generated, [&](std::size_t rails) {
    progress.update(static_cast<double>(rails) / static_cast<double>(o.generated.rails),
                    std::to_string(rails) + " rails");
    return true;
  });
  return done ? kDone : fail(done.error());
}

CLI::App* add(CLI::App& archive, const std::shared_ptr<Options>& o, int& exitCode, const std::string& name,
              const std::string& what, int (*work)(const Options&)) {
  CLI::App* command = archive.add_subcommand(name, what);
  command->add_option("URL", o->url, kArchiveUrlHelp)->required();
  command->callback([o, &exitCode, work] { exitCode = work(*o); });
  return command;
}

void addGenerate(CLI::App& archive, const std::shared_ptr<Options>& o, int& exitCode) {
  CLI::App* command =
      add(archive, o, exitCode, "generate", "Fill an archive with made-up rails, to try it out", generate);
  command->add_option("--rails", o->generated.rails, "how many")->check(CLI::Range(1, 10000000))->capture_default_str();
  command->add_option("--length", o->generated.lengthM, "of a rail, m")
      ->check(CLI::Range(0.001, 1e4))
      ->capture_default_str();
  command->add_option("--spacing", o->generated.spacingMm, "between profiles, mm")
      ->check(CLI::Range(0.1, 1e5))
      ->capture_default_str();
  command->add_option("--failing", o->generated.failingShare, "share of rails out of tolerance somewhere")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command->add_option("--seed", o->generated.seed, "the same seed gives the same rails")->capture_default_str();
  command->add_option("--recipe", o->recipe, "recipe: name, file, or SECTION [CLASS/CLASS]; default 60E1 X/A");
  command->add_flag("--quiet", o->quiet, "no progress on the terminal");
  command->footer("Example: vignole-cli archive generate trial.db --rails 1000");
}

}  // namespace

void addArchive(CLI::App& app, int& exitCode) {
  CLI::App* archive = app.add_subcommand("archive", "Rails that were measured: find, show, export, verify");
  archive->require_subcommand(1);
  archive->footer("Example: vignole-cli archive list rails.db --verdict fail --from 2025-03-01");
  const auto o = std::make_shared<Options>();

  CLI::App* found = add(*archive, o, exitCode, "list", "Rails, the newest first", list);
  found->add_option("--id", o->id, "beginning of the rail's id");
  found->add_option("--heat", o->heat, "beginning of the heat");
  found->add_option("--section", o->section, "section, as 60E1");
  found->add_option("--recipe", o->recipe, "recipe and version, as \"60E1 X/A v1\"");
  found->add_option("--from", o->from, "measured at or after, UTC: 2025-03-07 or 2025-03-07T14:05:09");
  found->add_option("--to", o->to, "measured before");
  found->add_option("--verdict", o->verdicts, "pass, near, fail, \"not measured\" (repeatable)");
  found->add_option("--exceeds", o->exceeds, "DIM[=MM]: out of tolerance somewhere, by more than MM (repeatable)");
  found->add_option("--limit", o->limit, "at most so many")->check(CLI::Range(1, 10000000))->capture_default_str();
  found->add_option("--json", o->json, "file, or - for stdout");
  found->footer("Example: vignole-cli archive list rails.db --heat H50 --exceeds HW=0.05");

  CLI::App* shown = add(*archive, o, exitCode, "show", "One rail: its dimensions, exceptions, triggers", show);
  shown->add_option("RAIL", o->rail, "id of the rail (the newest of that name), or its key in the archive")->required();
  shown->add_option("--json", o->json, "file, or - for stdout");
  shown->footer("Example: vignole-cli archive show rails.db G100007");

  CLI::App* exported =
      add(*archive, o, exitCode, "export", "One rail as CSV or JSON, or the points of a profile", exportRail);
  exported->add_option("RAIL", o->rail, "id of the rail, or its key in the archive")->required();
  exported->add_option("--csv", o->csv, "file (- is stdout): a row a profile, as inspect --csv writes it");
  exported->add_option("--json", o->json, "file, or - for stdout");
  exported->add_option("--points", o->points, "number of a profile: its points x_mm,y_mm into --csv, for measure")
      ->needs(exported->get_option("--csv"));
  exported->footer("Example: vignole-cli archive export rails.db G100007 --csv rail.csv");

  CLI::App* verified =
      add(*archive, o, exitCode, "verify", "Is everything as it was written? Exit code 1 if not", verify);
  verified->add_option("--json", o->json, "file, or - for stdout");
  verified->add_flag("--quiet", o->quiet, "no progress on the terminal");
  verified->footer("Example: vignole-cli archive verify rails.db");

  CLI::App* backup = add(*archive, o, exitCode, "backup", "A whole copy, while measuring goes on", backUp);
  backup->add_option("FILE", o->out, "new file")->required();
  backup->footer("Example: vignole-cli archive backup rails.db /media/stick/rails.db");

  addGenerate(*archive, o, exitCode);
  addRetention(*archive, exitCode);
}

}  // namespace vignole::cli
