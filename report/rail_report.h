#pragma once
// One rail as an A4 page (PDF, vector plots) or as a picture (PNG).

#include <chrono>
#include <filesystem>
#include <optional>

#include "engine/inspection/rail_summary.h"

namespace vignole {

struct RailReport {
  const RailSummary* summary = nullptr;
  const Recipe* recipe = nullptr;
  const ProfileResult* example = nullptr;  ///< the profile that is drawn (the worst one, or the last)
  std::string programVersion;
  bool simulation = false;  ///< says SIMULATION on every page
  /// End of the rail. Empty: the time of writing stands there instead, and is called so.
  std::optional<std::chrono::system_clock::time_point> measuredAt;
};

/// By extension: .pdf or .png; written whole or not at all. Needs a QGuiApplication.
[[nodiscard]] Expected<void> writeRailReport(const RailReport& report, const std::filesystem::path& file);

}  // namespace vignole
