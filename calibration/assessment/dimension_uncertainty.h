#pragma once
// What a rig's calibration is worth in millimetres: the uncertainty of every dimension of a section, and who is to
// blame.

#include <span>
#include <string>
#include <vector>

#include "engine/optics/rig_uncertainty.h"
#include "engine/rail/dimension.h"
#include "engine/rail/section.h"

namespace vignole {

/// Derivative of each dimension (rows in the order of kDimensions) by each parameter of the rig, mm per unit, at the
/// nominal section in its nominal place: the outline seen by each camera, mapped back by a rig that is changed,
/// registered and measured. NaN rows for dimensions that the section does not have.
using DimensionJacobian = Eigen::Matrix<double, static_cast<int>(kDimensionCount), kRigParameters>;
[[nodiscard]] Expected<DimensionJacobian> dimensionJacobian(const Section& section,
                                                            const DimensionParameters& parameters,
                                                            const RigCalibration& rig);

struct Contribution {
  std::string source;
  double uMm = 0;  ///< standard uncertainty that this source alone would leave
};
struct DimensionUncertainty {
  Dimension dimension{};
  double uMm = 0;                           ///< standard uncertainty
  std::vector<Contribution> contributions;  ///< largest first; their squares sum up to uMm^2
};
[[nodiscard]] std::vector<DimensionUncertainty> dimensionUncertainty(const DimensionJacobian& jacobian,
                                                                     std::span<const ErrorSource> sources);

}  // namespace vignole
