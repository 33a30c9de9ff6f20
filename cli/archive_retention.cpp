#include "cli/archive_retention.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/archived_rail.h"
#include "cli/console.h"
#include "engine/archive/rail_archive.h"
#include "engine/archive/retention.h"

namespace vignole::cli {

namespace {

struct Options {
  std::string url, rail, user, reason, why, json;
  RetentionPolicy policy;
  bool dryRun = false, release = false, quiet = false;
};

std::string thisUser() {
  const char* user = std::getenv("USER");
  return user != nullptr && *user != '\0' ? user : "command line";
}

nlohmann::ordered_json toJson(const RetentionPlan& plan, bool dryRun) {
  const auto time = [](const std::optional<TimeUs>& at) {
    return at && *at != 0 ? nlohmann::ordered_json(isoTime(*at)) : nlohmann::ordered_json(nullptr);
  };
  return {
      {"dry_run", dryRun},
      {"rails", plan.rails},
      {"profiles", plan.profiles},
      {"bytes", plan.bytes},
      {"first", time(plan.firstUs)},
      {"last", time(plan.lastUs)},
      {"before", time(plan.beforeUs)},
      {"rejected_before", time(plan.rejectedBeforeUs)},
      {"points_before", time(plan.pointsBeforeUs)},
      {"kept", {{"held", plan.keptHeld}, {"rejected", plan.keptRejected}, {"with_recording", plan.keptWithRecording}}},
      {"profiles_losing_points", plan.profilesLosingPoints},
      {"bytes_of_points", plan.bytesOfPoints}};
}

std::string toText(const RetentionPlan& plan, bool dryRun) {
  const auto number = [](std::uint64_t n) { return std::to_string(n); };
  const char* verb = dryRun ? " would go" : " went";
  std::string text = number(plan.rails) + " rails" + verb + ": " + number(plan.profiles) + " profiles, " +
                     number(plan.bytes / 1'000'000) + " MB";
  if (plan.firstUs)
    text += ", measured " + isoTime(*plan.firstUs).substr(0, 10) + " to " + isoTime(*plan.lastUs).substr(0, 10);
  text += "\nOld enough and yet they stay: " + number(plan.keptHeld) + " held, " + number(plan.keptRejected) +
          " rejected, " + number(plan.keptWithRecording) + " with a recording\n";
  if (plan.pointsBeforeUs != 0)
    text += "Points of " + number(plan.profilesLosingPoints) + " profiles of rails that stay" + verb + ": " +
            number(plan.bytesOfPoints / 1'000'000) + " MB\n";
  return text;
}

int prune(const Options& o) {
  const auto archive = Archive::open(o.url);
  if (!archive) return fail(archive.error());
  std::optional<Progress> progress(std::in_place, o.quiet || o.dryRun, "removing");
  const auto plan = o.dryRun ? planRetention(*archive, o.policy, systemTimeUs())
                             : applyRetention(*archive, o.policy, systemTimeUs(), o.user, o.reason, [&](double share) {
                                 progress->update(share);
                                 return true;
                               });
  progress.reset();
  if (!plan) return fail(plan.error());
  if (!o.json.empty())
    if (const auto written = writeJson(o.json, toJson(*plan, o.dryRun)); !written) return fail(written.error());
  if (o.json != "-")
    if (const auto written = writeResult("-", toText(*plan, o.dryRun)); !written) return fail(written.error());
  return kDone;
}

int hold(const Options& o) {
  const auto archive = Archive::open(o.url);
  if (!archive) return fail(archive.error());
  RailArchive rails(*archive);
  const auto key = findRail(rails, o.rail);
  if (!key) return fail(key.error());
  if (!o.release && o.why.empty()) return fail({"archive hold", "say why with --why, or let go with --release"});
  const auto done = rails.setHold(*key, o.release ? std::string() : o.why, o.user, o.reason);
  return done ? kDone : fail(done.error());
}

void addWho(CLI::App* command, const std::shared_ptr<Options>& o) {
  command->add_option("--user", o->user, "who does it, for the audit trail")->capture_default_str();
  command->add_option("--reason", o->reason, "and why")->capture_default_str();
}

}  // namespace

void addRetention(CLI::App& archive, int& exitCode) {
  const auto o = std::make_shared<Options>();
  o->user = thisUser();
  o->reason = "retention";
  CLI::App* pruned = archive.add_subcommand(
      "prune", "Rails that are older than the mill keeps them go, except what is held or rejected");
  pruned->add_option("URL", o->url, kArchiveUrlHelp)->required();
  pruned->add_option("--keep-days", o->policy.keepDays, "rails measured earlier go")
      ->required()
      ->check(CLI::Range(1, 100000));
  pruned
      ->add_option("--keep-rejected-days", o->policy.keepRejectedDays,
                   "rails that failed or were not measured; 0: for ever")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  pruned
      ->add_option("--keep-points-days", o->policy.keepPointsDays,
                   "the points of rails that stay; 0: as long as the rail")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  pruned->add_flag("--dry-run", o->dryRun, "tell what would go, and change nothing");
  addWho(pruned, o);
  pruned->add_option("--json", o->json, "file, or - for stdout");
  pruned->add_flag("--quiet", o->quiet, "no progress on the terminal");
  pruned->footer("Example: vignole-cli archive prune rails.db --keep-days 730 --dry-run");
  pruned->callback([o, &exitCode] { exitCode = prune(*o); });

  CLI::App* held = archive.add_subcommand("hold", "A rail stays, whatever its age, until it is released");
  held->add_option("URL", o->url, kArchiveUrlHelp)->required();
  held->add_option("RAIL", o->rail, "id of the rail, or its key in the archive")->required();
  held->add_option("--why", o->why, "what for: complaint 4711");
  held->add_flag("--release", o->release, "it need not stay any longer");
  addWho(held, o);
  held->footer("Example: vignole-cli archive hold rails.db G100007 --why \"complaint 4711\"");
  held->callback([o, &exitCode] { exitCode = hold(*o); });
}

}  // namespace vignole::cli
