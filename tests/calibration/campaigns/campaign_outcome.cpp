#include <stdexcept>

#include "calibration/assessment/dimension_uncertainty.h"
#include "calibration/range_finders/association.h"
#include "engine/measurement/measurement.h"
#include "engine/rail/catalogue.h"
#include "engine/systematic/calibration_error.h"
#include "tests/calibration/campaigns/virtual_campaign.h"

namespace vignole {

CampaignOutcome calibrated(Campaign& campaign, const RigAdjustmentSettings& settings) {
  CampaignOutcome outcome;
  associate(campaign.inputs);
  const auto adjusted = adjustRig(campaign.inputs, settings, {});
  if (!adjusted) throw std::runtime_error(adjusted.error().message());
  outcome.solveS = adjusted->solveS;
  if (!adjusted->refusals.empty()) {
    outcome.refusal = adjusted->refusals.front();
    return outcome;
  }
  const auto section = findSection("60E1");
  if (!section) throw std::runtime_error(section.error().message());
  const DimensionParameters parameters = defaultParameters(*section);
  const auto errors = measuredDimensions(*section, parameters, campaign.plate->calibration(), adjusted->calibration);
  const auto jacobian = dimensionJacobian(*section, parameters, adjusted->calibration);
  if (!errors || !jacobian) {
    outcome.refusal = "the section cannot be measured";
    return outcome;
  }
  outcome.errorMm = *errors;
  for (const DimensionUncertainty& d : dimensionUncertainty(*jacobian, adjusted->sources))
    outcome.uMm[index(d.dimension)] = d.uMm;
  for (const RangeFinderFit& fit : adjusted->finders) {
    outcome.cdMm += fit.cd.mean / kCameraCount;
    outcome.rdMm += fit.rd.mean / kCameraCount;
    outcome.pdMm += fit.pd.mean / kCameraCount;
    outcome.reprojectionPx += fit.reprojectionPx / kCameraCount;
  }
  return outcome;
}

std::pair<int, int> rightlyAssociated(const Campaign& campaign) {
  Campaign truth = campaign;
  for (PlacementLines& placement : truth.inputs.placements)
    for (PinPicture& picture : placement.pictures)
      for (PinArc& arc : picture.arcs) arc.pin = 0;
  associateByTruth(truth);
  int right = 0, all = 0;
  for (std::size_t m = 0; m < truth.inputs.placements.size(); ++m)
    for (std::size_t c = 0; c < kCameraCount; ++c) {
      const auto& told = campaign.inputs.placements[m].pictures[c].arcs;
      const auto& known = truth.inputs.placements[m].pictures[c].arcs;
      int pins = 0;
      bool wrong = false;
      for (std::size_t a = 0; a < told.size(); ++a) {
        if (told[a].pin == 0 || !told[a].usable()) continue;
        ++pins;
        if (told[a].pin != known[a].pin) wrong = true;
      }
      ++all;
      if (pins >= 6 && !wrong) ++right;
    }
  return {right, all};
}

}  // namespace vignole
