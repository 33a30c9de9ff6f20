#pragma once
// What checks, comparisons and uncertainties of a calibration look like as JSON and as text.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "calibration/assessment/existing_calibration.h"

namespace vignole::cli {

/// [{"name","value","limit","unit","pass": true|false|null,"words","remedy"}]; null: could not be made.
[[nodiscard]] nlohmann::ordered_json checksJson(const std::vector<Check>& checks);
/// [{"name","u_mm","contributors":[{"source","u_mm"}]}], the worst `most` contributors.
[[nodiscard]] nlohmann::ordered_json uncertaintyJson(const std::vector<DimensionUncertainty>& dimensions,
                                                     std::size_t most = 5);
[[nodiscard]] nlohmann::ordered_json comparisonJson(const Comparison& comparison);
[[nodiscard]] nlohmann::ordered_json seamsJson(const std::vector<PairSeam>& seams);
[[nodiscard]] nlohmann::ordered_json foldsJson(const std::vector<Fold>& folds);

[[nodiscard]] nlohmann::ordered_json assessmentJson(const RigCalibration& calibration,
                                                    const ExistingCalibration& judged,
                                                    const std::optional<Comparison>& withPrevious,
                                                    const Section& section);
[[nodiscard]] std::string assessmentText(const RigCalibration& calibration, const ExistingCalibration& judged,
                                         const std::optional<Comparison>& withPrevious);

}  // namespace vignole::cli
