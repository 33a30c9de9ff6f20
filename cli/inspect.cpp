// vignole-cli inspect: whole rails through the whole pipeline.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/camera_health.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/inspect_output.h"
#include "cli/interruption.h"
#include "cli/live_line.h"
#include "cli/recording_options.h"
#include "cli/report_files.h"
#include "engine/archive/rail_writer.h"
#include "engine/files/atomic_file.h"
#include "engine/simulator/virtual_rig.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole::cli {

namespace {

using Clock = std::chrono::steady_clock;

struct Options {
  std::string source = "virtual", recording, recipe = "60E1 X/A", calibration, address, site, archive, record, csv,
              json;
  int rails = 1;
  double lengthM = 60, speedMPerS = 1, spacingMm = 15, temperatureC = 20;
  bool railsGiven = false, lengthGiven = false, spacingGiven = false;
  std::optional<double> seconds;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> rigSeed;
  std::vector<std::string> effects, deviations, faults, reports;
  RecordOptions recordOptions;
  bool paced = false, quiet = false, recipeGiven = false;
};

Expected<void> refuseWhatIsNotThere(const Options& o) {
  if (o.source != "gige" && !o.address.empty()) return inputError("--address", "is of cameras; add --source gige");
  if (o.source != "gige" && !o.site.empty()) return inputError("--site", "is of cameras; add --source gige");
  if (o.source == "gige" && !(o.effects.empty() && o.deviations.empty() && o.faults.empty()))
    return inputError(!o.effects.empty()      ? "--effect"
                      : !o.deviations.empty() ? "--deviation"
                                              : "--fault",
                      "is of the virtual rig; give it to simulate serve");
  if (o.source != "recording" && !o.recording.empty())
    return inputError("--recording", "is measured with --source recording; give that too");
  if (o.source == "recording") {
    if (o.recording.empty()) return inputError("--source recording", "needs --recording FILE");
    for (const auto& [option, words] :
         {std::pair{"--effect", &o.effects}, {"--deviation", &o.deviations}, {"--fault", &o.faults}})
      if (!words->empty()) return inputError(option, "is for the virtual rig; a recording shows what the cameras saw");
  }
  if (auto possible = checkRecordOptions(o.recordOptions, o.record); !possible) return possible;
  for (const std::string& file : o.reports)
    if (auto known = checkReportFile(file); !known) return known;
  return {};
}

Expected<std::shared_ptr<const VirtualRig>> makeRig(const Options& o, const Recipe& recipe) {
  VirtualRigSettings settings;
  settings.section = recipe.section;
  settings.parameters = recipe.parameters;
  settings.seed = o.seed;
  settings.rigSeed = o.rigSeed;
  settings.spacingMm = o.spacingMm;
  settings.speedMmPerS = 1000 * o.speedMPerS;
  settings.temperatureC = o.temperatureC;
  if (const auto applied = applyWords(settings, o.effects, o.deviations, o.faults); !applied)
    return tl::unexpected(applied.error());
  return VirtualRig::create(std::move(settings));
}

/// The words that made the virtual rig, as a recording keeps them: with them its truth is known again.
std::string originOf(const Options& o) {
  nlohmann::ordered_json words = {{"seed", o.seed},
                                  {"spacing_mm", o.spacingMm},
                                  {"speed_m_per_s", o.speedMPerS},
                                  {"temperature_c", o.temperatureC},
                                  {"effects", o.effects},
                                  {"deviations", o.deviations},
                                  {"faults", o.faults}};
  if (o.rigSeed) words["rig_seed"] = *o.rigSeed;
  return words.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Null where the recording is of another source, or of a rig that this version does not make.
std::shared_ptr<const VirtualRig> rigOfOrigin(const RecordedSetup& setup) {
  if (setup.source != "virtual") return nullptr;
  Options o;
  try {
    const auto words = nlohmann::json::parse(setup.origin);
    o.seed = words.at("seed").get<std::uint64_t>();
    if (words.contains("rig_seed")) o.rigSeed = words.at("rig_seed").get<std::uint64_t>();
    o.spacingMm = words.at("spacing_mm").get<double>();
    o.speedMPerS = words.at("speed_m_per_s").get<double>();
    o.temperatureC = words.at("temperature_c").get<double>();
    o.effects = words.at("effects").get<std::vector<std::string>>();
    o.deviations = words.at("deviations").get<std::vector<std::string>>();
    o.faults = words.at("faults").get<std::vector<std::string>>();
  } catch (const nlohmann::json::exception&) {
    return nullptr;
  }
  const auto rig = makeRig(o, setup.recipe);
  return rig ? *rig : nullptr;
}

/// A calibration of other cameras would give numbers that mean nothing.
Expected<void> checkFits(const RigCalibration& calibration, const RigCalibration& ofRig, const std::string& file) {
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    const RangeFinderCalibration& mine = calibration.rangeFinders[c];
    const RangeFinderCalibration& rigs = ofRig.rangeFinders[c];
    const std::string camera = "camera " + std::to_string(c + 1);
    if (!mine.serial.empty() && !rigs.serial.empty() && mine.serial != rigs.serial)
      return inputError(file, camera + " is " + rigs.serial + " but the calibration is of " + mine.serial +
                                  "; use this rig's calibration (or its --rig-seed)");
    const Intrinsics &a = mine.intrinsics, &b = rigs.intrinsics;
    if (a.widthPx != b.widthPx || a.heightPx != b.heightPx)
      return inputError(file, camera + " has " + std::to_string(b.widthPx) + " x " + std::to_string(b.heightPx) +
                                  " pixels but the calibration is for " + std::to_string(a.widthPx) + " x " +
                                  std::to_string(a.heightPx) + "; use this rig's calibration");
  }
  return {};
}

/// How far out a profile is, in half tolerances; the worst one is drawn in the report.
double severity(const Measurement& measurement) {
  double worst = 0;
  for (const DimensionResult& d : measurement.dimensions) {
    if (!d.valueMm || !d.lowerMm || !d.upperMm) continue;
    const double middle = (*d.lowerMm + *d.upperMm) / 2, half = (*d.upperMm - *d.lowerMm) / 2;
    if (half > 0) worst = std::max(worst, std::abs(*d.valueMm - middle) / half);
  }
  return worst;
}

/// Takes what the inspection tells, on its last stage's thread; read after the end.
class Collector {
 public:
  Collector(const Recipe& recipe, const RigCalibration& calibration, std::string calibrationWarning,
            std::shared_ptr<const VirtualRig> rig, std::optional<AtomicFile> csv, Progress& progress,
            double profilesExpected)
      : drift(recipe.section),
        recipe_(recipe),
        calibration_(calibration),
        calibrationWarning_(std::move(calibrationWarning)),
        rig_(std::move(rig)),
        csv_(std::move(csv)),
        progress_(progress),
        profilesExpected_(profilesExpected) {
    if (csv_) csv_->write(csvHeader());
  }

  InspectionObserver observer() {
    return {[this](const RailBegin& rail) { begin(rail); }, [this](const ProfileResult& result) { add(result); },
            [this](const RailBegin& rail, const TriggerLedger& ledger) { end(rail, ledger); },
            [this](const std::string& message) { finish(message); }};
  }

  /// False if the time is over first.
  bool waitUntilEnded(std::optional<Clock::time_point> until) {
    std::unique_lock lock(mutex_);
    const auto ended = [this] { return ended_; };
    if (until) return changed_.wait_until(lock, *until, ended);
    changed_.wait(lock, ended);
    return true;
  }

  std::vector<InspectedRail> rails;
  std::vector<std::optional<ProfileResult>> examples;  ///< one a rail: the profile that is furthest out
  std::uint64_t profiles = 0, registered = 0;
  Accuracy accuracy;
  CameraHealth cameras;
  std::string error, whyNotRegistered;
  Clock::time_point endedAt;
  DriftWatch drift;
  std::optional<std::uint64_t> firstDriftRail;

  /// Before the start: every rail goes into the archive as well.
  void writeInto(std::unique_ptr<RailWriter> archive, const Inspection& inspection) {
    archive_ = std::move(archive);
    inspection_ = &inspection;
    setup_ = std::make_shared<const MeasuringSetup>(MeasuringSetup{recipe_, calibration_});
  }
  /// Before the start: it is told of every rail's verdict.
  void tell(std::shared_ptr<FrameRecorder> recorder) { recorder_ = std::move(recorder); }
  /// Until all is on disk. The inspection is not asked any more.
  Expected<void> closeArchive() {
    inspection_ = nullptr;
    return archive_ ? archive_->close() : Expected<void>{};
  }
  Expected<void> closeCsv() { return csv_ ? csv_->commit() : Expected<void>{}; }

 private:
  void begin(const RailBegin& rail) {
    if (archive_) archive_->begin(rail, {}, setup_);
    summariser_.emplace(rail, recipe_, calibration_.id);
    example_.reset();
    severity_ = -1;
    profileOfRail_ = 0;
  }

  void add(const ProfileResult& result) {
    ++profiles;
    summariser_->add(result);
    cameras.add(result.profile);
    drift.add(result.profile, result.registration);
    if (csv_) csv_->write(csvRow(result, profileOfRail_));
    if (archive_) archive_->add(result);
    ++profileOfRail_;
    if (result.registration.valid) {
      ++registered;
      if (rig_) accuracy.add(result.measurement, rig_->truth(result.profile.trigger));
      if (const double s = severity(result.measurement); s > severity_) {
        severity_ = s;
        example_ = result;
      }
    } else {
      whyNotRegistered = result.registration.reason;
    }
    progress_.update(static_cast<double>(profiles) / profilesExpected_, std::to_string(profiles) + " profiles");
  }

  void end(const RailBegin& rail, const TriggerLedger& ledger) {
    if (archive_)
      archive_->end(ledger, inspection_ != nullptr ? inspection_->stages() : std::vector<StageStatistics>());
    rails.push_back({summariser_->summary(ledger), recipe_.section.name});
    rails.back().summary.calibrationWarning = calibrationWarning_;
    if (recorder_) recorder_->railPassed(rail, rails.back().summary.verdict);
    if (drift.endRail().alarm() && !firstDriftRail) firstDriftRail = rails.size();
    examples.push_back(std::move(example_));
    example_.reset();
  }

  void finish(const std::string& message) {
    const std::scoped_lock lock(mutex_);
    error = message;
    endedAt = Clock::now();
    ended_ = true;
    changed_.notify_all();
  }

  const Recipe& recipe_;
  const RigCalibration& calibration_;
  std::string calibrationWarning_;
  std::shared_ptr<const VirtualRig> rig_;
  std::optional<AtomicFile> csv_;
  std::unique_ptr<RailWriter> archive_;
  const Inspection* inspection_ = nullptr;
  std::shared_ptr<FrameRecorder> recorder_;
  std::shared_ptr<const MeasuringSetup> setup_;
  Progress& progress_;
  double profilesExpected_;
  std::optional<RailSummariser> summariser_;
  std::optional<ProfileResult> example_;
  double severity_ = -1;
  std::uint64_t profileOfRail_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
};

/// rail.pdf of the second of several rails is rail-2.pdf.
std::filesystem::path reportName(const std::filesystem::path& file, std::size_t rail, std::size_t rails) {
  if (rails < 2) return file;
  std::filesystem::path numbered = file;
  numbered.replace_filename(file.stem().string() + "-" + std::to_string(rail + 1) + file.extension().string());
  return numbered;
}

Expected<void> writeResults(const Options& o, const Recipe& recipe, Collector& collected,
                            const InspectionOutcome& outcome) {
  if (auto closed = collected.closeCsv(); !closed) return closed;
  for (const std::string& file : o.reports)
    for (std::size_t r = 0; r < outcome.rails.size(); ++r)
      if (auto written = writeReport(outcome.rails[r].summary, recipe, collected.examples[r], true,
                                     reportName(file, r, outcome.rails.size()));
          !written)
        return written;
  if (!o.json.empty())
    if (auto written = writeJson(o.json, toJson(outcome)); !written) return written;
  if (o.json != "-")
    if (auto written = writeResult("-", toTable(outcome)); !written) return written;
  return {};
}

/// The exit code, once all has been written.
int judge(const Options& o, const Collector& collected, const InspectionOutcome& outcome) {
  if (!collected.error.empty()) return fail({"source", collected.error, ErrorKind::World});
  const bool anotherRail = std::any_of(outcome.rails.begin(), outcome.rails.end(),
                                       [](const InspectedRail& rail) { return rail.summary.looksLike.has_value(); });
  if (collected.registered == 0 && outcome.triggers.seen > 0 && !anotherRail) {
    if (collected.profiles == 0)
      return fail(
          {"inspect",
           "no camera gave a contour (" + outcome.triggers.reasons.begin()->first + " ...); look at cameras and lasers",
           ErrorKind::World});
    if (!o.calibration.empty())
      return fail({o.calibration, "no profile could be registered (" + collected.whyNotRegistered +
                                      "); is it the calibration of this rig?"});
    return fail({"inspect",
                 "no profile could be registered (" + collected.whyNotRegistered +
                     "); is it this recipe's rail, and the calibration still right?",
                 ErrorKind::World});
  }
  for (const Error& warning : collected.cameras.overexposed()) fail(warning);
  for (const CameraDrift& c : collected.drift.indicators().cameras)
    if (c.alarm) fail({"drift", c.words});
  int code = kDone;
  for (const InspectedRail& rail : outcome.rails) {
    const Verdict verdict = rail.summary.verdict;  // what passed without being measured is no pass
    if (verdict == Verdict::Fail || (verdict == Verdict::NotMeasured && rail.summary.profiles > 0)) code = kVerdictFail;
  }
  for (const Error& failure : collected.cameras.blind()) code = fail(failure);
  return code;
}

/// Where the frames come from, and what they are measured with.
struct Input {
  std::unique_ptr<FrameSource> source;
  RigCalibration calibration;
  std::string calibrationName;
  std::shared_ptr<const VirtualRig> rig;  ///< null unless it is the source
  const GigeSource* cameras = nullptr;    ///< null unless they are the source
};

/// `recorded`: null unless a recording is measured.
Expected<Input> openInput(const Options& o, const Recipe& recipe, const RecordedRun* recorded) {
  Input input;
  input.calibrationName = o.calibration;
  if (o.source == "gige") {
    LiveLineOptions live;
    live.site = o.site;
    live.address = o.address;
    live.calibration = o.calibration;
    live.rails = !o.railsGiven && o.seconds ? 0 : static_cast<std::uint64_t>(o.rails);
    if (o.lengthGiven) live.lengthM = o.lengthM;
    if (o.spacingGiven) live.spacingMm = o.spacingMm;
    live.temperatureC = o.temperatureC;
    auto line = openLiveLine(live);
    if (!line) return tl::unexpected(line.error());
    input.cameras = line->source.get();
    input.source = std::move(line->source);
    input.calibration = std::move(line->calibration);
    input.calibrationName = std::move(line->calibrationName);
    return input;
  }
  if (recorded != nullptr) {
    if (const auto allowed = recorded->recording().allows(recipe.stripe); !allowed)
      return tl::unexpected(allowed.error());
    if (recorded->setup()) {
      input.rig = rigOfOrigin(*recorded->setup());
      input.calibration = recorded->setup()->calibration;
    } else if (o.calibration.empty()) {
      return inputError(o.recording,
                        "does not say any more with which calibration it was recorded; give --calibration");
    }
    recorded->warn();
    input.source = recorded->source();
  } else {
    auto rig = makeRig(o, recipe);
    if (!rig) return tl::unexpected(rig.error());
    input.rig = *rig;
    input.calibration = (*rig)->calibration();
    input.source = makeVirtualSource(*rig, {o.rails, 1000 * o.lengthM, o.paced});
  }
  if (!o.calibration.empty()) {
    auto loaded = loadCalibration(o.calibration);
    if (!loaded) return tl::unexpected(loaded.error());
    const bool known = recorded == nullptr || recorded->setup();
    if (const auto fits = known ? checkFits(*loaded, input.calibration, o.calibration) : Expected<void>(); !fits)
      return tl::unexpected(fits.error());
    input.calibration = *std::move(loaded);
  }
  return input;
}

/// None where none is asked for.
Expected<std::unique_ptr<RailWriter>> openArchive(const Options& o) {
  if (o.archive.empty()) return nullptr;
  RailWriterSettings settings;
  settings.place = {"line 1", o.source, VIGNOLE_VERSION, stripeSimdTarget()};
  settings.live = o.paced || o.source == "gige";
  return RailWriter::open(o.archive, settings);
}

/// Stops the inspection that is connected, also if it is connected after it was asked to.
class StopSwitch {
 public:
  class Connection {
   public:
    Connection(StopSwitch& stopSwitch, Inspection& inspection) : switch_(stopSwitch) { switch_.connect(&inspection); }
    ~Connection() { switch_.connect(nullptr); }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

   private:
    StopSwitch& switch_;
  };

  void stop() {
    const std::scoped_lock lock(mutex_);
    asked_ = true;
    if (inspection_ != nullptr) inspection_->stop();
  }

 private:
  void connect(Inspection* inspection) {
    const std::scoped_lock lock(mutex_);
    inspection_ = inspection;
    if (asked_ && inspection_ != nullptr) inspection_->stop();
  }
  std::mutex mutex_;
  Inspection* inspection_ = nullptr;
  bool asked_ = false;
};

int inspect(const Options& o) {
  StopSwitch stopSwitch;
  // Before any other thread is made: they inherit that they are not to be interrupted.
  const Interruption interruption([&stopSwitch] { stopSwitch.stop(); });
  if (const auto possible = refuseWhatIsNotThere(o); !possible) return fail(possible.error());
  std::optional<RecordedRun> recorded;
  if (o.source == "recording") {
    auto opened = RecordedRun::open(o.recording, o.paced);
    if (!opened) return fail(opened.error());
    recorded = std::move(*opened);
  }
  const auto recipe = recorded && !o.recipeGiven ? recorded->recipe() : findRecipe(o.recipe);
  if (!recipe) return fail(recipe.error());
  auto input = openInput(o, *recipe, recorded ? &*recorded : nullptr);
  if (!input) return fail(input.error());
  const RigCalibration& calibration = input->calibration;
  const CalibrationAge age =
      ageOf(calibration, std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()));
  const std::string warning = warningOf(calibration, age);
  if (!warning.empty()) fail({input->calibrationName, "the calibration is " + warning + "; calibrate again"});
  std::optional<AtomicFile> csv;
  if (!o.csv.empty()) {
    auto file = AtomicFile::create(o.csv);
    if (!file) return fail(file.error());
    csv = std::move(*file);
  }

  auto archive = openArchive(o);
  if (!archive) return fail(archive.error());

  InspectionOutcome outcome;
  auto& source = input->source;
  std::optional<Progress> progress(std::in_place, o.quiet, "inspecting");
  const double expected =
      recorded ? recorded->triggers() : std::max(1.0, o.rails * std::floor(1000 * o.lengthM / o.spacingMm));
  Collector collected(*recipe, calibration, warning, input->rig, std::move(csv), *progress, expected);
  InspectionObserver observer = collected.observer();
  std::shared_ptr<FrameRecorder> recorder;
  if (!o.record.empty()) {
    recorder = std::make_shared<FrameRecorder>(FrameRecorderSettings{.live = source->live()});
    RecordedSetup setup{VIGNOLE_VERSION, stripeSimdTarget(), o.source, {}, o.recordOptions.whole, *recipe, calibration};
    setup.origin = recorded ? (recorded->setup() ? recorded->setup()->origin : std::string()) : originOf(o);
    if (recorded && recorded->setup()) setup.source = recorded->setup()->source;
    if (auto started = recorder->start(recordingOrder(o.recordOptions, o.record, std::move(setup))); !started)
      return fail(started.error());
    source = tapped(std::move(source), recorder);
    observer = tapped(std::move(observer), recorder);
    collected.tell(recorder);
  }
  {
    const auto start = Clock::now();
    Inspection inspection(*source, *recipe, calibration, std::move(observer));
    const StopSwitch::Connection connection(stopSwitch, inspection);
    if (*archive) collected.writeInto(std::move(*archive), inspection);
    inspection.start();
    std::optional<Clock::time_point> until;
    if (o.seconds)
      until = start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*o.seconds));
    if (!collected.waitUntilEnded(until)) inspection.stop();
    inspection.wait();
    outcome.wallS = std::chrono::duration<double>(collected.endedAt - start).count();
    outcome.triggers = inspection.triggers();
    outcome.stages = inspection.stages();
  }
  const auto kept = recorder ? recorder->stop() : Expected<void>();
  progress.reset();
  const auto archived = collected.closeArchive();
  outcome.rails = collected.rails;
  outcome.profiles = collected.profiles;
  outcome.calibration = calibration;
  outcome.calibrationAge = age;
  outcome.drift = collected.drift.indicators();
  outcome.firstDriftRail = collected.firstDriftRail;
  if (input->rig) {
    outcome.effects = list(input->rig->settings().effects);
    outcome.accuracy = &collected.accuracy;
  }
  if (input->cameras != nullptr) {
    outcome.cameras = input->cameras->cameras();
    outcome.line = input->cameras->counts();
    outcome.reception = receptionCost();
  }
  if (recorder) outcome.recorded = recorder->state();
  if (const auto written = writeResults(o, *recipe, collected, outcome); !written) return fail(written.error());
  if (!archived) return fail(archived.error());
  if (!kept) return fail(kept.error());
  return judge(o, collected, outcome);
}

}  // namespace

void addInspect(CLI::App& app, int& exitCode) {
  CLI::App* command = app.add_subcommand("inspect", "Measure whole rails through the whole pipeline");
  const auto o = std::make_shared<Options>();
  command->footer(
      "Without options: one virtual 60E1 rail of 60 m at 15 mm and 1 m/s, seed 1, class X/A.\n"
      "Example: vignole-cli inspect --length 10 --recipe 54E1 --deviation HW=0.6 --csv rail.csv --report rail.pdf\n"
      "Verdict of a rail: fail if a dimension is out of tolerance over at least 3 consecutive profiles (or in half of\n"
      "them); near if it cannot be decided that long, or its mean is within 2 u of a limit. Exit code 1 on fail or not "
      "measured, 3 if a camera saw nothing.");
  command->add_option("--source", o->source, "virtual, gige or recording")
      ->check(CLI::IsMember({"virtual", "gige", "recording"}))
      ->capture_default_str();
  command->add_option("--recording", o->recording, "recording to measure (with --source recording)");
  const auto* recipe =
      command
          ->add_option("--recipe", o->recipe, "recipe: name, file, or SECTION [CLASS/CLASS]; of a recording: its own")
          ->capture_default_str();
  command->add_option("--calibration", o->calibration,
                      "calibration file; default: the site's, the virtual rig's exact one, a recording's own");
  const auto* rails = command->add_option("--rails", o->rails, "rails to measure")
                          ->check(CLI::Range(1, 1000000))
                          ->capture_default_str();
  const auto* length = command
                           ->add_option("--length", o->lengthM,
                                        "length of a rail, m (of cameras: where it is cut off; default: its end)")
                           ->check(CLI::Range(0.001, 1e5))
                           ->capture_default_str();
  command->add_option("--speed", o->speedMPerS, "speed, m/s")->check(CLI::Range(0.001, 100.0))->capture_default_str();
  const auto* spacing =
      command->add_option("--spacing", o->spacingMm, "travel between profiles, mm (of cameras: the site's)")
          ->check(CLI::Range(0.01, 1e5))
          ->capture_default_str();
  command->add_option("--seed", o->seed, "seed of the virtual rail and its noise")->capture_default_str();
  command->add_option("--rig-seed", o->rigSeed, "draws the virtual rig itself; default: the seed");
  command->add_option("--address", o->address, "first of four consecutive camera addresses (with --source gige)");
  command->add_option("--site", o->site, "site file of the cameras (with --source gige); default: the user's");
  command->add_option("--temperature", o->temperatureC, "temperature of the rail, degrees C")
      ->check(CLI::Range(-60.0, 1400.0))
      ->capture_default_str();
  command->add_option("--effect", o->effects, "NAME=on|off|VALUE of the virtual rig (repeatable)");
  command->add_option("--deviation", o->deviations, "DIM=MM: constant deviation of a dimension (repeatable)");
  command->add_option("--fault", o->faults, "KIND[=VALUE][@CAMERA][:FROM-TO] (repeatable)");
  command->add_option("--archive", o->archive, "file (or sqlite:FILE) of the archive to store the rails in");
  addRecordOptions(*command, o->record, o->recordOptions);
  command->add_option("--report", o->reports, "FILE.pdf or FILE.png (repeatable)");
  command->add_option("--csv", o->csv, "file: one row a profile");
  command->add_option("--json", o->json, "file, or - for stdout");
  command->add_option("--seconds", o->seconds, "stop after that time")->check(CLI::Range(0.0, 1e9));
  command->add_flag("--paced", o->paced, "in real time, as a live source");
  command->add_flag("--quiet", o->quiet, "no progress on the terminal");
  command->callback([o, recipe, rails, length, spacing, &exitCode] {
    o->recipeGiven = recipe->count() > 0;
    o->railsGiven = rails->count() > 0;
    o->lengthGiven = length->count() > 0;
    o->spacingGiven = spacing->count() > 0;
    exitCode = inspect(*o);
  });
}

}  // namespace vignole::cli
