#pragma once
// A small rail of the virtual rig, recorded while it is measured, for the tests of recordings.

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#include "engine/inspection/inspection.h"
#include "engine/recipe/recipe.h"
#include "engine/recording/frame_recorder.h"
#include "engine/recording/recording.h"
#include "engine/recording/recording_source.h"
#include "engine/simulator/virtual_rig.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole::testing {

class RecordingFolder {
 public:
  RecordingFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "vignole-recording-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~RecordingFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  RecordingFolder(const RecordingFolder&) = delete;
  RecordingFolder& operator=(const RecordingFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return path_ / name; }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  std::filesystem::path path_;
};

inline const Recipe& recipe60() {
  static const Recipe recipe = *findRecipe("60E1");
  return recipe;
}

inline std::shared_ptr<const VirtualRig> makeRig(const std::vector<std::string>& faults = {}) {
  VirtualRigSettings settings;
  settings.section = recipe60().section;
  settings.parameters = recipe60().parameters;
  settings.seed = 5;
  EXPECT_TRUE(applyWords(settings, {}, {}, faults));
  return *VirtualRig::create(settings);
}

inline RecordedSetup setupOf(const VirtualRig& rig) {
  return {"test", stripeSimdTarget(), "virtual", "{\"seed\":5}", false, recipe60(), rig.calibration()};
}

/// What a run gave, as comparable words.
struct RunResult {
  std::vector<std::string> profiles;
  std::vector<std::string> rails;
  TriggerLedger triggers;
  std::string error;
  bool operator==(const RunResult& other) const {
    return profiles == other.profiles && rails == other.rails && triggers.seen == other.triggers.seen &&
           triggers.measured == other.triggers.measured && triggers.incomplete == other.triggers.incomplete &&
           triggers.lost == other.triggers.lost && triggers.reasons == other.triggers.reasons && error == other.error;
  }
};

inline std::string wordOf(const ProfileResult& r) {
  std::string word = std::to_string(r.profile.trigger) + "@" + std::to_string(r.profile.positionMm) + " " +
                     std::to_string(r.profile.points.size());
  char buffer[64];
  for (const DimensionResult& d : r.measurement.dimensions) {
    std::snprintf(buffer, sizeof buffer, " %a/%a", d.valueMm.value_or(-1), d.uMm);
    word += buffer;
  }
  for (const std::string& missing : r.profile.missing) word += "|" + missing;
  return word;
}

/// `also`: told of every observation before it is noted.
inline RunResult run(FrameSource& source, const Recipe& recipe, const RigCalibration& calibration,
                     const std::shared_ptr<FrameRecorder>& recorder = nullptr,
                     const std::function<void(const ProfileResult&)>& also = {},
                     const std::function<void(const RailBegin&)>& ended = {}) {
  RunResult result;
  InspectionObserver observer;
  observer.railBegan = [&](const RailBegin& rail) { result.rails.push_back("began " + rail.id); };
  observer.profileMeasured = [&](const ProfileResult& r) {
    if (also) also(r);
    result.profiles.push_back(wordOf(r));
  };
  observer.railEnded = [&](const RailBegin& rail, const TriggerLedger&) {
    result.rails.push_back("ended " + rail.id);
    if (ended) ended(rail);
  };
  observer.ended = [&](const std::string& error) { result.error = error; };
  if (recorder) observer = tapped(std::move(observer), recorder);
  Inspection inspection(source, recipe, calibration, std::move(observer));
  inspection.start();
  inspection.wait();
  result.triggers = inspection.triggers();
  return result;
}

/// Rails of so many triggers recorded in one file.
inline RunResult record(const std::filesystem::path& file, const std::shared_ptr<const VirtualRig>& rig, int rails,
                        int triggers, bool whole = false) {
  auto recorder = std::make_shared<FrameRecorder>(FrameRecorderSettings{.live = false});
  RecordingOrder order;
  order.path = file;
  order.whole = whole;
  order.setup = setupOf(*rig);
  EXPECT_TRUE(recorder->start(std::move(order)));
  auto source = tapped(makeVirtualSource(rig, {rails, 15.0 * triggers, false}), recorder);
  RunResult result = run(*source, recipe60(), rig->calibration(), recorder);
  const auto stopped = recorder->stop();
  EXPECT_TRUE(stopped) << (stopped ? "" : stopped.error().message());
  EXPECT_EQ(recorder->state().dropped, 0U);
  return result;
}

inline std::shared_ptr<const Recording> opened(const std::filesystem::path& file) {
  auto recording = Recording::open(file);
  EXPECT_TRUE(recording) << (recording ? "" : recording.error().message());
  return recording ? *recording : nullptr;
}

inline RunResult replay(const std::filesystem::path& file) {
  const auto recording = opened(file);
  if (!recording || !recording->setup()) return {};
  const auto source = makeRecordingSource(recording);
  return run(*source, recording->setup()->recipe, recording->setup()->calibration);
}

}  // namespace vignole::testing
