// vignole-cli recording: what is in a recording, whether it is whole, pictures into one and out of one.

#include "engine/recording/recording.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/recording_options.h"
#include "cli/simulated_files.h"
#include "engine/files/atomic_file.h"
#include "engine/optics/nominal_rig.h"
#include "engine/recording/picture_import.h"
#include "engine/recording/verify_recording.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string path, out, json, recipe, calibration, missing = "refuse", id;
  double spacingMm = 15, temperatureC = 20;
  bool whole = false, quiet = false;
  std::uint64_t from = 0;
  std::optional<std::uint64_t> to;
};

std::string isoOf(std::int64_t us) {
  const std::time_t seconds = us / 1'000'000;
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc)};
}

struct Figures {
  std::uint64_t frameBytes = 0, triggers = 0, lost = 0;
  std::optional<std::int64_t> fromUs, toUs;
};

Figures figuresOf(const Recording& recording) {
  Figures f;
  for (const ChunkPlace& chunk : recording.chunks()) {
    if (chunk.head.kind == ChunkKind::Frame) f.frameBytes += chunk.head.size;
    f.fromUs = std::min(f.fromUs.value_or(chunk.head.timeUs), chunk.head.timeUs);
    f.toUs = std::max(f.toUs.value_or(chunk.head.timeUs), chunk.head.timeUs);
  }
  for (const RecordedRail& rail : recording.rails()) {
    f.triggers += rail.triggers;
    f.lost += rail.lost;
  }
  return f;
}

Json toJson(const RecordedRail& rail) {
  const RailBegin& b = rail.begin.rail;
  Json json = {{"id", b.id},
               {"heat", b.heat},
               {"section", b.sectionName},
               {"first_trigger", b.firstTrigger},
               {"end_trigger", rail.endTrigger ? Json(*rail.endTrigger) : Json(nullptr)},
               {"begins_at_m", b.beginsAtMm / 1000},
               {"triggers", rail.triggers},
               {"frames", rail.frames},
               {"lost_frames", rail.lost},
               {"dropped_triggers", rail.dropped},
               {"spacing_mm", b.spacingMm},
               {"speed_m_per_s", b.speedMmPerS / 1000},
               {"temperature_c", b.temperatureC},
               {"notes", Json::object()}};
  for (const auto& [key, value] : rail.begin.notes) json["notes"][key] = value;
  return json;
}

Json described(const RecordedSetup& setup) {
  Json cameras = Json::array();
  for (const RangeFinderCalibration& finder : setup.calibration.rangeFinders)
    cameras.push_back({{"serial", finder.serial},
                       {"width_px", finder.intrinsics.widthPx},
                       {"height_px", finder.intrinsics.heightPx}});
  return {{"program", setup.program},
          {"simd", setup.simdTarget},
          {"source", setup.source},
          {"recipe", setup.recipe.name},
          {"recipe_version", setup.recipe.version},
          {"section", setup.recipe.section.name},
          {"sigma_px", setup.recipe.stripe.sigma},
          {"calibration", setup.calibration.id},
          {"cameras", cameras}};
}

Json toJson(const Recording& recording) {
  const Figures f = figuresOf(recording);
  Json json = {{"file", recording.file().string()},
               {"bytes", recording.bytes()},
               {"closed", recording.closed()},
               {"damaged_bytes", recording.damagedBytes()},
               {"problems", recording.problems()},
               {"from", f.fromUs ? Json(isoOf(*f.fromUs)) : Json(nullptr)},
               {"to", f.toUs ? Json(isoOf(*f.toUs)) : Json(nullptr)},
               {"triggers", f.triggers},
               {"frames", recording.frames()},
               {"bytes_per_frame", recording.frames() > 0 ? f.frameBytes / recording.frames() : 0},
               {"lost_frames", f.lost},
               {"dropped_triggers", recording.dropped().size()},
               {"setup", recording.setup() ? described(*recording.setup()) : Json(nullptr)},
               {"setup_changes", recording.setupChanges()},
               {"rails", Json::array()}};
  for (const RecordedRail& rail : recording.rails()) json["rails"].push_back(toJson(rail));
  return json;
}

std::string toTable(const Recording& recording) {
  const Json j = toJson(recording);
  const auto text = [&j](const char* key) { return j[key].is_string() ? j[key].get<std::string>() : std::string("-"); };
  std::string table = recording.file().string() + ": " + std::to_string(recording.bytes()) + " bytes, " +
                      (recording.closed() ? "closed" : "not closed") + ", " + text("from") + " to " + text("to") + "\n";
  table += j["triggers"].dump() + " triggers, " + j["frames"].dump() + " frames of " + j["bytes_per_frame"].dump() +
           " bytes, " + j["lost_frames"].dump() + " frames lost, " + j["dropped_triggers"].dump() +
           " triggers not recorded\n";
  if (const auto& s = recording.setup()) {
    table += "Recorded by vignole " + s->program + " on " + s->simdTarget + " from " + s->source + "; recipe " +
             s->recipe.name + " version " + std::to_string(s->recipe.version) + ", calibration " + s->calibration.id +
             "\nCameras";
    for (const RangeFinderCalibration& finder : s->calibration.rangeFinders)
      table += " " + (finder.serial.empty() ? std::string("?") : finder.serial) + " (" +
               std::to_string(finder.intrinsics.widthPx) + " x " + std::to_string(finder.intrinsics.heightPx) + ")";
    table += "\n";
  }
  for (const RecordedRail& rail : recording.rails()) {
    const RailBegin& b = rail.begin.rail;
    table += "Rail " + b.id + ", heat " + b.heat + ", " + b.sectionName + ": triggers " +
             std::to_string(b.firstTrigger) + " to " +
             (rail.endTrigger ? std::to_string(*rail.endTrigger) : std::string("?")) + ", " +
             std::to_string(rail.triggers) + " recorded" + (rail.endTrigger ? "" : ", cut short") + "\n";
  }
  for (const std::string& problem : recording.problems()) table += "! " + problem + "\n";
  return table;
}

Expected<void> writeFindings(const Options& o, const Json& json, const std::string& table) {
  if (!o.json.empty())
    if (auto written = writeJson(o.json, json); !written) return written;
  return o.json == "-" ? Expected<void>() : writeResult("-", table);
}

int info(const Options& o) {
  const auto recording = Recording::open(o.path);
  if (!recording) return fail(recording.error());
  if (const auto told = writeFindings(o, toJson(**recording), toTable(**recording)); !told) return fail(told.error());
  return kDone;
}

int verify(const Options& o) {
  const auto recording = Recording::open(o.path);
  if (!recording) return fail(recording.error());
  std::optional<Progress> progress(std::in_place, o.quiet, "checking");
  const RecordingCheck check = verifyRecording(**recording, [&](double share) { progress->update(share); });
  progress.reset();
  const bool good = check.good() && (*recording)->closed() && (*recording)->problems().empty();
  Json json = {{"file", o.path},
               {"good", good},
               {"closed", (*recording)->closed()},
               {"chunks", check.chunks},
               {"damaged_chunks", check.damagedChunks},
               {"damaged_bytes", (*recording)->damagedBytes()},
               {"frames", check.frames},
               {"sparse_frames", check.sparseFrames},
               {"compared", check.compared},
               {"different", check.different},
               {"not_compared_because", check.whyNotCompared},
               {"problems", (*recording)->problems()},
               {"findings", Json::array()}};
  std::string table = o.path + ": " + std::to_string(check.chunks) + " chunks, " + std::to_string(check.damagedChunks) +
                      " damaged; " + std::to_string(check.frames) + " frames, " + std::to_string(check.compared) +
                      " extracted again, " + std::to_string(check.different) + " with other points than recorded\n";
  if (!check.whyNotCompared.empty()) table += "Not compared: " + check.whyNotCompared + "\n";
  for (const std::string& problem : (*recording)->problems()) table += "! " + problem + "\n";
  for (const RecordingFinding& f : check.findings) {
    json["findings"].push_back({{"where", f.where}, {"what", f.what}});
    table += "! " + f.where + ": " + f.what + "\n";
  }
  table += good ? "Good.\n" : "Not good.\n";
  if (const auto told = writeFindings(o, json, table); !told) return fail(told.error());
  return good ? kDone : kVerdictFail;
}

/// What the folder says of its rail, where `simulate rail` made it.
std::string sectionOfTruth(const std::filesystem::path& folder) {
  const auto text = readFile(folder / "truth.json");
  const Json truth = text ? Json::parse(*text, nullptr, false) : Json();
  return truth.is_object() && truth.contains("section") && truth["section"].is_string()
             ? truth["section"].get<std::string>()
             : std::string("60E1");
}

int import(const Options& o) {
  const std::filesystem::path folder = o.path;
  const auto pictures = findPictures(folder);
  if (!pictures) return fail(pictures.error());
  const auto recipe = findRecipe(o.recipe.empty() ? sectionOfTruth(folder) : o.recipe);
  if (!recipe) return fail(recipe.error());
  ImportSettings settings;
  settings.whole = o.whole;
  settings.missingIsLost = o.missing == "lost";
  settings.setup = {VIGNOLE_VERSION, stripeSimdTarget(), "pictures", {}, o.whole, *recipe, {}};
  std::error_code ignored;
  const std::filesystem::path beside = folder / "calibration.toml";
  if (!o.calibration.empty() || std::filesystem::exists(beside, ignored)) {
    auto loaded = loadCalibration(o.calibration.empty() ? beside : std::filesystem::path(o.calibration));
    if (!loaded) return fail(loaded.error());
    settings.setup.calibration = std::move(*loaded);
  } else {
    settings.setup.calibration = nominalRig();
    (void)fail({o.path,
                "has no calibration.toml and none is given: the nominal rig's is recorded; measure with "
                "inspect --calibration FILE"});
  }
  settings.rail.id = !o.id.empty() ? o.id : std::filesystem::weakly_canonical(folder, ignored).filename().string();
  settings.rail.sectionName = recipe->section.name;
  settings.rail.spacingMm = o.spacingMm;
  settings.rail.temperatureC = o.temperatureC;
  settings.rail.lengthMm = o.spacingMm * static_cast<double>(pictures->rbegin()->first - pictures->begin()->first + 1);
  std::optional<Progress> progress(std::in_place, o.quiet, "importing");
  const auto done = importPictures(*pictures, settings, o.out, [&](double share) { progress->update(share); });
  progress.reset();
  if (!done) return fail(done.error());
  const auto recording = Recording::open(o.out);
  if (!recording) return fail(recording.error());
  if (const auto told = writeResult("-", toTable(**recording)); !told) return fail(told.error());
  return kDone;
}

int exportPictures(const Options& o) {
  const auto opened = Recording::open(o.path);
  if (!opened) return fail(opened.error());
  const std::shared_ptr<const Recording> recording = *opened;
  std::vector<PictureJob> jobs;
  std::optional<Error> first;
  for (int camera = 0; camera < kCameraCount; ++camera)
    for (const RecordedEvent& event : recording->events(camera)) {
      if (event.kind != RecordedEvent::Kind::Frame || event.trigger < o.from || event.trigger > o.to.value_or(~0ULL))
        continue;
      // The good ones are still done.
      const auto frame = recording->frame(camera, event.trigger);
      if (!frame) {
        (void)fail(frame.error());
        if (!first) first = frame.error();
        continue;
      }
      jobs.push_back({std::filesystem::path(o.out) / ("trigger" + std::to_string(event.trigger)) /
                          ("camera" + std::to_string(camera + 1) + ".png"),
                      frame->image.width, frame->image.height,
                      [recording, camera, trigger = event.trigger](const MutableImageView& image) {
                        const auto again = recording->frame(camera, trigger);
                        for (int y = 0; again && y < image.height; ++y)
                          std::memcpy(image.row(y), again->image.row(y), static_cast<std::size_t>(image.width));
                      }});
    }
  if (jobs.empty() && !first) return fail({o.path, "has no frames between these triggers; see recording info"});
  Progress progress(o.quiet, "writing");
  if (const auto written = writePictures(jobs, progress); !written) return fail(written.error());
  if (recording->setup())
    if (auto saved =
            saveCalibration(recording->setup()->calibration, std::filesystem::path(o.out) / "calibration.toml");
        !saved)
      return fail(saved.error());
  return first ? kBadInput : kDone;
}

}  // namespace

void addRecording(CLI::App& app, int& exitCode) {
  CLI::App* command =
      app.add_subcommand("recording", "Recordings: what is in them, are they whole, pictures in and out");
  command->require_subcommand(1);
  command->footer(
      "A recording is made by inspect --record and measured again by inspect --source recording --recording FILE.\n"
      "Example: vignole-cli recording verify rail.vgr");
  const auto o = std::make_shared<Options>();
  const auto add = [&](const char* name, const char* what, const char* example, int (*run)(const Options&)) {
    CLI::App* sub = command->add_subcommand(name, what);
    sub->footer(std::string("Example: vignole-cli recording ") + example);
    sub->add_flag("--quiet", o->quiet, "no progress on the terminal");
    sub->callback([o, run, &exitCode] { exitCode = run(*o); });
    return sub;
  };
  const auto addFile = [&](CLI::App* sub) { sub->add_option("file", o->path, "recording")->required(); };

  CLI::App* sub = add("info", "What is in a recording", "info rail.vgr --json -", info);
  addFile(sub);
  sub->add_option("--json", o->json, "file, or - for stdout");

  sub = add("verify", "Every chunk, and that extraction gives the recorded points; exit code 1 if not",
            "verify rail.vgr", verify);
  addFile(sub);
  sub->add_option("--json", o->json, "file, or - for stdout");

  sub = add("import",
            "A folder of pictures as a recording of one rail: triggerN/cameraC.png as `simulate rail` writes them,\n"
            "cameraC_N.png, or camera1.png ... camera4.png alone (also pgm, bmp, tif, jpg)",
            "import frames --out frames.vgr --recipe 54E1 --calibration rig.toml", import);
  sub->add_option("folder", o->path, "folder of pictures")->required();
  sub->add_option("--out", o->out, "recording to write")->required();
  sub->add_option("--recipe", o->recipe, "recipe, as of inspect; default: the section in DIR/truth.json, else 60E1");
  sub->add_option("--calibration", o->calibration,
                  "of the cameras; default: DIR/calibration.toml, else the nominal rig");
  sub->add_option("--missing", o->missing, "what is missing is refused, or counted as lost: refuse, lost")
      ->check(CLI::IsMember({"refuse", "lost"}))
      ->capture_default_str();
  sub->add_option("--id", o->id, "of the rail; default: the folder's name");
  sub->add_option("--spacing", o->spacingMm, "travel between triggers, mm")
      ->check(CLI::Range(0.01, 1e5))
      ->capture_default_str();
  sub->add_option("--temperature", o->temperatureC, "temperature of the rail, degrees C")
      ->check(CLI::Range(-60.0, 1400.0))
      ->capture_default_str();
  sub->add_flag("--full", o->whole, "every pixel instead of those that extraction needs");

  sub = add("export", "Frames as PNG: DIR/triggerN/cameraC.png; of sparse frames what was left out is flat",
            "export rail.vgr --out frames --from 100 --to 110", exportPictures);
  addFile(sub);
  sub->add_option("--out", o->out, "folder")->required();
  sub->add_option("--from", o->from, "first trigger");
  sub->add_option("--to", o->to, "last trigger");
}

}  // namespace vignole::cli
