#include "engine/rail/dimension.h"

namespace vignole {

namespace {

struct Names {
  std::string_view name, title;
};
constexpr PerDimension<Names> kNames = {{{"RH", "Rail height"},
                                         {"RFH", "Rail flange height"},
                                         {"FW", "Foot width"},
                                         {"HF", "Head form"},
                                         {"HW", "Head width"},
                                         {"HWA", "Head width (AREMA)"},
                                         {"FT_l", "Foot thickness left"},
                                         {"FT_r", "Foot thickness right"},
                                         {"RAS_l", "Rail asymmetry left"},
                                         {"RAS_r", "Rail asymmetry right"},
                                         {"WT", "Web thickness"},
                                         {"HR", "Head radius"},
                                         {"FC", "Foot concavity"}}};

}  // namespace

std::string_view name(Dimension dimension) { return kNames.at(index(dimension)).name; }
std::string_view title(Dimension dimension) { return kNames.at(index(dimension)).title; }

std::optional<Dimension> dimensionFromName(std::string_view name) {
  for (const Dimension d : kDimensions)
    if (kNames.at(index(d)).name == name) return d;
  return std::nullopt;
}

}  // namespace vignole
