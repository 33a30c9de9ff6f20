#pragma once
// The cameras of a site as the source of an inspection, and what is told of them.

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "engine/gige_camera/gige_source.h"
#include "engine/optics/calibration.h"
#include "engine/site/site.h"

namespace vignole::cli {

struct LiveLineOptions {
  std::string site;         ///< file; empty: the user's
  std::string address;      ///< of the first of four cameras; takes the place of the site
  std::string calibration;  ///< file; empty: the site's
  std::uint64_t rails = 1;  ///< 0: without end
  double lengthM = 0;       ///< 0: as long as they are
  std::optional<double> spacingMm, temperatureC;
};

struct LiveLine {
  std::unique_ptr<GigeSource> source;
  RigCalibration calibration;
  std::string calibrationName;  ///< file, or what else it is
  double spacingMm = 0;
};

/// The site that the options name; without any, the user's site file must be there.
[[nodiscard]] Expected<Site> chosenSite(const LiveLineOptions& options);
[[nodiscard]] Expected<LiveLine> openLiveLine(const LiveLineOptions& options);

/// CPU time of this process so far, and of it that of the threads that receive frames.
struct ReceptionCost {
  double processS = 0, receptionS = 0;
};
[[nodiscard]] ReceptionCost receptionCost();

[[nodiscard]] nlohmann::ordered_json toJson(const ReceptionCost& cost, const std::vector<CameraReport>& reports);
[[nodiscard]] nlohmann::ordered_json toJson(const CameraReport& report);
[[nodiscard]] nlohmann::ordered_json toJson(const TriggerLineCounts& counts);
/// One line a camera, and what it cannot tell.
[[nodiscard]] std::string toTable(const std::vector<CameraReport>& reports);

}  // namespace vignole::cli
