#pragma once
// Placements of the pin plate before the virtual rig, as files: for `simulate plate` and `simulate campaign`.

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/simulated_files.h"
#include "engine/simulator/virtual_plate.h"

namespace CLI {
class App;
}

namespace vignole::cli {

struct PlateOptions {
  std::string plate;  ///< file; empty: the plate of 13 pins
  int placements = 4;
  std::optional<double> plateErrorUm, noisePx;
  std::vector<double> exposuresMs;
  double turnDeg = 0, tiltDeg = 0, leanMrad = 0;
  std::vector<int> missingPins;
  int spurious = 0;
  bool mirror = false;
  std::vector<std::string> effects, faults;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> rigSeed;
};

void addPlateOptions(CLI::App& command, PlateOptions& options);

/// The plate as stated, and as it stands before the rig at each exposure.
struct SimulatedPlate {
  PinPlate stated;
  std::vector<std::shared_ptr<const VirtualPlate>> atExposures;
};
[[nodiscard]] Expected<SimulatedPlate> makePlate(const PlateOptions& options);

/// plate.toml in `out`, and the pictures to be written there: placement1/camera1.png ..., below exposure5ms/ and the
/// like where there are several exposures.
[[nodiscard]] Expected<void> writeStatedPlate(const SimulatedPlate& plate, const std::filesystem::path& out);
[[nodiscard]] std::vector<PictureJob> plateJobs(const SimulatedPlate& plate, const std::filesystem::path& out);

/// Where a placement's pictures lie, relative to the output folder.
[[nodiscard]] std::string placementFolder(const SimulatedPlate& plate, std::size_t exposure, std::size_t placement);

/// True pins, placements and arcs; for truth.json.
[[nodiscard]] nlohmann::ordered_json plateTruth(const SimulatedPlate& plate);

}  // namespace vignole::cli
