#pragma once
// What `vignole-cli inspect` tells: a table for people, JSON and CSV for programs (commands.md is the contract).

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calibration/drift/drift_watch.h"
#include "cli/accuracy.h"
#include "cli/live_line.h"
#include "engine/gige_camera/gige_source.h"
#include "engine/inspection/inspection.h"
#include "engine/inspection/rail_summary.h"
#include "engine/optics/calibration_age.h"
#include "engine/recording/frame_recorder.h"

namespace vignole::cli {

/// A rail as it is told: the summary, and the section that it was measured against.
struct InspectedRail {
  RailSummary summary;
  std::string section;
};

struct InspectionOutcome {
  std::vector<InspectedRail> rails;
  TriggerLedger triggers;
  std::vector<StageStatistics> stages;
  std::uint64_t profiles = 0;
  double wallS = 0;
  RigCalibration calibration;
  CalibrationAge calibrationAge;
  DriftIndicators drift;
  std::optional<std::uint64_t> firstDriftRail;  ///< the rail, from 1, after which a camera was first said to have moved
  std::vector<std::pair<std::string, double>> effects;  ///< empty unless the source is the virtual rig
  const Accuracy* accuracy = nullptr;                   ///< null without truth
  std::optional<RecorderState> recorded;                ///< what was recorded meanwhile
  std::vector<CameraReport> cameras;                    ///< empty unless the source are cameras
  TriggerLineCounts line;                               ///< of the cameras
  ReceptionCost reception;                              ///< of the cameras' frames
};

[[nodiscard]] nlohmann::ordered_json toJson(const InspectedRail& rail);
[[nodiscard]] nlohmann::ordered_json toJson(const StageStatistics& stage);
[[nodiscard]] std::string toTable(const InspectedRail& rail);
[[nodiscard]] nlohmann::ordered_json toJson(const InspectionOutcome& outcome);
[[nodiscard]] std::string toTable(const InspectionOutcome& outcome);

/// First line of the CSV, and one row. Numbers are written so that reading them back gives the same bits.
[[nodiscard]] std::string csvHeader();
[[nodiscard]] std::string csvRow(const ProfileResult& result, std::uint64_t profile);

}  // namespace vignole::cli
