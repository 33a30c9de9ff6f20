#include "cli/recording_options.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>

#include "cli/console.h"
#include "engine/recording/recording_source.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole::cli {

namespace {

Expected<KeepPolicy> policyOf(const std::string& words) {
  KeepPolicy policy{.all = false};
  std::istringstream in(words);
  for (std::string word; std::getline(in, word, '|');) {
    std::uint64_t n = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), n);
    if (word == "all")
      policy.all = true;
    else if (word == "rejected")
      policy.rejected = true;
    else if (error == std::errc() && end == word.data() + word.size() && n > 0)
      policy.everyNth = n;
    else
      return inputError("--record-keep " + words, "is no choice; use all, rejected, N (every N-th rail) or rejected|N");
  }
  return policy;
}

}  // namespace

void addRecordOptions(CLI::App& command, std::string& record, RecordOptions& options) {
  command.add_option(
      "--record", record,
      "file to record the frames in, or a folder that exists: a file for each rail, kept as --record-keep "
      "says");
  command.add_flag("--record-full", options.whole, "record every pixel instead of those that extraction needs");
  command
      .add_option("--record-keep", options.keep,
                  "whose recordings stay in the folder: all, rejected (failed or not measured), N (every N-th), "
                  "rejected|N")
      ->capture_default_str();
  command
      .add_option("--record-file-mb", options.fileMb, "a file that has grown so large goes on in a next one; 0: never")
      ->capture_default_str();
  command
      .add_option("--record-folder-mb", options.folderMb,
                  "the oldest recordings of the folder are removed beyond that; 0: never")
      ->capture_default_str();
}

Expected<void> checkRecordOptions(const RecordOptions& o, const std::string& record) {
  if (record.empty()) {
    if (o.whole) return inputError("--record-full", "needs --record FILE");
    return {};
  }
  const auto policy = policyOf(o.keep);
  if (!policy) return tl::unexpected(policy.error());
  std::error_code ignored;
  const bool folder = std::filesystem::is_directory(record, ignored);
  if (!folder && !policy->all)
    return inputError("--record-keep", "needs a folder that exists (" + record + " is none): a file for each rail");
  if (!folder && o.folderMb > 0) return inputError("--record-folder-mb", "needs a folder; " + record + " is none");
  return {};
}

RecordingOrder recordingOrder(const RecordOptions& o, const std::string& record, RecordedSetup setup) {
  RecordingOrder order;
  order.path = record;
  order.whole = o.whole;
  order.keep = policyOf(o.keep).value_or(KeepPolicy{});
  order.mostMbOfFile = o.fileMb;
  order.mostMbOfFolder = o.folderMb;
  order.setup = std::move(setup);
  return order;
}

std::string otherMachine(const RecordedSetup& setup) {
  const std::string here = stripeSimdTarget();
  if (setup.simdTarget == here) return {};
  return "was recorded on " + setup.simdTarget + ", this machine works with " + here +
         ": numbers agree to 1e-6 mm, not to the last bit";
}

Expected<RecordedRun> RecordedRun::open(const std::string& file, bool paced) {
  auto recording = Recording::open(file);
  if (!recording) return tl::unexpected(recording.error());
  return RecordedRun(std::move(*recording), paced);
}

Expected<Recipe> RecordedRun::recipe() const {
  if (setup() != nullptr) return setup()->recipe;
  return inputError(recording_->file().string(),
                    "does not say any more with which recipe it was recorded; give --recipe and --calibration");
}

std::unique_ptr<FrameSource> RecordedRun::source() const { return makeRecordingSource(recording_, {.paced = paced_}); }

double RecordedRun::triggers() const {
  double triggers = 0;
  for (const RecordedRail& rail : recording_->rails()) triggers += static_cast<double>(rail.triggers + rail.dropped);
  return std::max(1.0, triggers);
}

void RecordedRun::warn() const {
  const std::string file = recording_->file().string();
  for (const std::string& problem : recording_->problems()) (void)fail({file, problem});
  if (setup() == nullptr) return;
  if (const std::string other = otherMachine(*setup()); !other.empty()) (void)fail({file, other});
  if (recording_->setupChanges())
    (void)fail({file, "changes its recipe or calibration between rails; all are measured with those of the first"});
}

}  // namespace vignole::cli
