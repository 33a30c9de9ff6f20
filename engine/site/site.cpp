#include "engine/site/site.h"

#include <arpa/inet.h>
#include <cstdlib>
#include <cstring>
#include <map>

#include "engine/files/atomic_file.h"

namespace vignole {

namespace {

std::string cameraName(std::size_t c) { return "camera " + std::to_string(c + 1); }

}  // namespace

Expected<Site> loadSite(const std::filesystem::path& file) {
  const auto text = readFile(file);
  if (!text) return tl::unexpected(text.error());
  return parseSite(*text, file);
}

Expected<void> saveSite(const Site& site, const std::filesystem::path& file) {
  return writeFile(file, toToml(site), true);
}

std::filesystem::path defaultSiteFile() {
  if (const char* chosen = std::getenv("VIGNOLE_SITE"); chosen != nullptr && *chosen != '\0') return chosen;
  if (const char* config = std::getenv("XDG_CONFIG_HOME"); config != nullptr && *config != '\0')
    return std::filesystem::path(config) / "vignole" / "site.toml";
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home == nullptr ? "." : home) / ".config" / "vignole" / "site.toml";
}

Expected<Site> siteFrom(const std::string& firstAddress) {
  in_addr first{};
  if (inet_pton(AF_INET, firstAddress.c_str(), &first) != 1)
    return inputError("--address", "\"" + firstAddress + "\" is no IPv4 address; give one like 192.168.1.11");
  const std::uint32_t begin = ntohl(first.s_addr);
  if ((begin & 0xffU) > 0xffU - kCameraCount)
    return inputError("--address", "four addresses from " + firstAddress + " leave their network; begin lower");
  Site site;
  for (std::size_t c = 0; c < site.cameras.size(); ++c) {
    const in_addr address{htonl(begin + static_cast<std::uint32_t>(c))};
    std::array<char, INET_ADDRSTRLEN> text{};
    site.cameras[c].address = inet_ntop(AF_INET, &address, text.data(), text.size());
  }
  return site;
}

Expected<void> findAddresses(Site& site) {
  bool any = false;
  for (const GigeCameraSettings& camera : site.cameras) any = any || camera.address.empty();
  if (!any) return {};
  std::map<std::string, std::string> addressOf;
  for (const GigeIdentity& found : discover()) addressOf[found.serial] = found.address;
  for (std::size_t c = 0; c < site.cameras.size(); ++c) {
    GigeCameraSettings& camera = site.cameras[c];
    if (!camera.address.empty()) continue;
    const auto found = addressOf.find(camera.serial);
    if (found == addressOf.end())
      return worldError(cameraName(c), "with serial number " + camera.serial +
                                           " answers on no network; look at its power and cable, or give its address");
    camera.address = found->second;
  }
  return {};
}

Expected<void> checkBelongs(const RigCalibration& calibration, const std::array<std::string, kCameraCount>& found,
                            const std::string& nameInErrors) {
  for (std::size_t c = 0; c < found.size(); ++c) {
    const std::string& calibrated = calibration.rangeFinders[c].serial;
    if (calibrated.empty() || found[c].empty() || calibrated == found[c]) continue;
    for (std::size_t other = 0; other < found.size(); ++other)
      if (calibration.rangeFinders[other].serial == found[c])
        return inputError(nameInErrors, cameraName(c) + " is " + found[c] + ", which was calibrated as " +
                                            cameraName(other) + "; swap the cables back or calibrate again");
    return inputError(nameInErrors, cameraName(c) + " is " + found[c] + " but the calibration is of " + calibrated +
                                        "; use the calibration of these cameras");
  }
  return {};
}

GigeSourceSettings sourceSettings(const Site& site) {
  GigeSourceSettings settings;
  settings.cameras = site.cameras;
  settings.line = site.line;
  settings.line.spacingMm = site.spacingMm();
  settings.presence = site.presence;
  settings.watch = site.watch;
  return settings;
}

}  // namespace vignole
