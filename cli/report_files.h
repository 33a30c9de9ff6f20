#pragma once
// Reports of inspected rails: PDF or PNG by the extension. Built without Qt, asking for one is an error that says so.

#include <filesystem>
#include <optional>

#include "engine/inspection/rail_summary.h"

namespace vignole::cli {

/// Whether the file can be written at all: known extension, a program built with reports.
[[nodiscard]] Expected<void> checkReportFile(const std::filesystem::path& file);

/// Makes a QGuiApplication without a display where there is none.
[[nodiscard]] Expected<void> writeReport(const RailSummary& summary, const Recipe& recipe,
                                         const std::optional<ProfileResult>& example, bool simulation,
                                         const std::filesystem::path& file);

}  // namespace vignole::cli
