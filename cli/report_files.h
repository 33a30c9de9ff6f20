#pragma once
// Reports: of inspected rails as PDF or PNG by the extension, of everything else as PDF. Built without Qt, asking for
// one is an error that says so.

#include <filesystem>
#include <optional>

#include "engine/inspection/rail_summary.h"
#include "report/document.h"

namespace vignole::cli {

/// Whether the file can be written at all: known extension, a program built with reports.
[[nodiscard]] Expected<void> checkReportFile(const std::filesystem::path& file);

/// Makes a QGuiApplication without a display where there is none.
[[nodiscard]] Expected<void> writeReport(const RailSummary& summary, const Recipe& recipe,
                                         const std::optional<ProfileResult>& example, bool simulation,
                                         const std::filesystem::path& file);

/// The same for a report that its results composed: .pdf.
[[nodiscard]] Expected<void> checkDocumentFile(const std::filesystem::path& file);
[[nodiscard]] Expected<void> writeDocumentReport(const Document& document, const std::filesystem::path& file);

}  // namespace vignole::cli
