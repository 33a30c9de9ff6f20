#pragma once
// What is particular to one line: which camera is which range finder, how it is reached, triggered and exposed, and
// with which calibration it measures. Everything is told apart by the cameras' serial numbers.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/gige_camera/gige_source.h"
#include "engine/optics/calibration.h"

namespace vignole {

struct Site {
  std::string name = "line 1";
  std::filesystem::path file;         ///< empty: not from a file
  std::filesystem::path calibration;  ///< empty: none is named
  /// Range finders 1 to 4. An empty address is looked for by serial number.
  std::array<GigeCameraSettings, kCameraCount> cameras;
  double mmPerEncoderCount = 0.05;
  int encoderDivider = 300;  ///< counts of the encoder between two triggers
  TriggerLineSettings line;  ///< but for what a run says: rails, length, temperature
  RailPresenceSettings presence;
  CameraWatchSettings watch;

  [[nodiscard]] double spacingMm() const { return mmPerEncoderCount * encoderDivider; }
};

/// TOML, format = 1 (its keys stand in `vignole-cli site new --help`). Refuses unknown keys, values out of range, a
/// serial number or an address given twice; a calibration's path is relative to the file.
[[nodiscard]] Expected<Site> loadSite(const std::filesystem::path& file);
[[nodiscard]] Expected<Site> parseSite(std::string_view text, const std::filesystem::path& nameInErrors);
[[nodiscard]] std::string toToml(const Site& site);
[[nodiscard]] Expected<void> saveSite(const Site& site, const std::filesystem::path& file);
/// $VIGNOLE_SITE, else vignole/site.toml in the user's folder for configuration.
[[nodiscard]] std::filesystem::path defaultSiteFile();

/// Four cameras at consecutive addresses, whatever their serial numbers; everything else as a site has it by default.
[[nodiscard]] Expected<Site> siteFrom(const std::string& firstAddress);
/// Fills in the addresses that are empty, by asking the networks once; errors name the camera that did not answer.
[[nodiscard]] Expected<void> findAddresses(Site& site);

/// Whether the calibration is of these cameras, in this order; `found` are their serial numbers.
[[nodiscard]] Expected<void> checkBelongs(const RigCalibration& calibration,
                                          const std::array<std::string, kCameraCount>& found,
                                          const std::string& nameInErrors);

[[nodiscard]] GigeSourceSettings sourceSettings(const Site& site);

}  // namespace vignole
