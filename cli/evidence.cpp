// vignole-cli evidence: a rail with all that proves it in one file, and the proof.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/archived_rail.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "engine/evidence/evidence_pack.h"
#include "engine/files/atomic_file.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole::cli {

namespace {

struct Options {
  std::string url, rail, file, json;
  bool quiet = false;
};

EvidenceBy thisProgram() { return {VIGNOLE_VERSION, stripeSimdTarget()}; }

nlohmann::ordered_json toJson(const EvidenceCheck& check) {
  return {{"proved", check.findings.empty()},
          {"digest", check.digest},
          {"rail", check.rail.summary.rail.id},
          {"uid", check.rail.uid},
          {"verdict", name(check.verdict)},
          {"profiles", check.profiles},
          {"profiles_with_points", check.profilesWithPoints},
          {"exact_points", check.exactPoints},
          {"same_machine", check.sameMachine},
          {"last_bit", check.lastBit},
          {"findings", check.findings}};
}

int tell(const EvidenceCheck& check, const Options& o) {
  std::string text;
  for (const std::string& finding : check.findings) text += finding + "\n";
  text += std::string(check.findings.empty() ? "proved" : "NOT PROVED") + ": rail " + check.rail.summary.rail.id +
          ", " + std::string(name(check.verdict)) + "; " + std::to_string(check.profilesWithPoints) + " of " +
          std::to_string(check.profiles) + " profiles measured again" +
          (check.lastBit ? ", every number to the last bit" : "") + "\ndigest " + check.digest + "\n";
  if (!o.json.empty())
    if (const auto written = writeJson(o.json, toJson(check)); !written) return fail(written.error());
  if (o.json != "-")
    if (const auto written = writeResult("-", text); !written) return fail(written.error());
  return check.findings.empty() ? kDone : kVerdictFail;
}

int pack(const Options& o) {
  const auto archive = Archive::open(o.url);
  if (!archive) return fail(archive.error());
  RailArchive rails(*archive);
  const auto key = findRail(rails, o.rail);
  if (!key) return fail(key.error());
  std::optional<Progress> progress(std::in_place, o.quiet, "measuring again");
  const auto made = packEvidence(rails, *key, thisProgram(), [&](double share) { progress->update(share); });
  progress.reset();
  if (!made) return fail(made.error());
  if (const auto written = writeFile(o.file, made->bytes); !written) return fail(written.error());
  const char* user = std::getenv("USER");
  const auto held = rails.setHold(*key, "evidence pack " + made->check.digest,
                                  user != nullptr && *user != '\0' ? user : "command line", "evidence was handed out");
  return held ? tell(made->check, o) : fail(held.error());
}

int verify(const Options& o) {
  const auto bytes = readFile(o.file);
  if (!bytes) return fail(bytes.error());
  std::optional<Progress> progress(std::in_place, o.quiet, "measuring again");
  const auto check = verifyEvidence(*bytes, thisProgram(), [&](double share) { progress->update(share); });
  progress.reset();
  return check ? tell(*check, o) : fail({o.file, check.error().message(), check.error().kind});
}

}  // namespace

void addEvidence(CLI::App& app, int& exitCode) {
  CLI::App* evidence = app.add_subcommand("evidence", "A rail with all that proves it in one file, and the proof");
  evidence->require_subcommand(1);
  evidence->footer("Example: vignole-cli evidence verify G100007.evidence");
  const auto o = std::make_shared<Options>();
  CLI::App* packed = evidence->add_subcommand(
      "pack", "Points, profiles, recipe, calibration and versions of a rail; it is held in the archive from then on");
  packed->add_option("URL", o->url, kArchiveUrlHelp)->required();
  packed->add_option("--rail", o->rail, "id of the rail, or its key in the archive")->required();
  packed->add_option("--out", o->file, "the pack, a tar archive")->required();
  CLI::App* verified = evidence->add_subcommand(
      "verify",
      "Measure and judge the rail of a pack again. Exit code 1 if it does not come out, 2 if a byte was changed");
  verified->add_option("FILE", o->file, "the pack")->required();
  for (CLI::App* command : {packed, verified}) {
    command->add_option("--json", o->json, "file, or - for stdout");
    command->add_flag("--quiet", o->quiet, "no progress on the terminal");
  }
  packed->footer("Example: vignole-cli evidence pack rails.db --rail G100007 --out G100007.evidence");
  verified->footer("Example: vignole-cli evidence verify G100007.evidence");
  packed->callback([o, &exitCode] { exitCode = pack(*o); });
  verified->callback([o, &exitCode] { exitCode = verify(*o); });
}

}  // namespace vignole::cli
