#include "gui/bridge/calibration_in_force.h"

#include "engine/archive/calibration_history.h"

namespace vignole {

bool ofTheSameRig(const RigCalibration& a, const RigCalibration& b) {
  for (std::size_t c = 0; c < a.rangeFinders.size(); ++c)
    if (a.rangeFinders[c].serial != b.rangeFinders[c].serial) return false;
  return true;
}

Expected<std::optional<RigCalibration>> calibrationInForce(const Archive& archive, const RigCalibration& lines) {
  const CalibrationHistory history(archive);
  const auto uses = history.uses();
  if (!uses) return tl::unexpected<Error>(uses.error());
  for (const CalibrationUse& use : *uses) {
    const auto text = history.text(use.calibration);
    if (!text) return tl::unexpected<Error>(text.error());
    auto calibration = parseCalibration(*text, use.id);
    if (!calibration) return tl::unexpected<Error>(calibration.error());
    if (ofTheSameRig(*calibration, lines)) return std::optional(*std::move(calibration));
  }
  return std::optional<RigCalibration>{};
}

}  // namespace vignole
