#pragma once
// What a rig's calibration is worth in millimetres: the uncertainty of every dimension of a section, and who is to
// blame.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "calibration/job.h"
#include "engine/systematic/calibration_error.h"

namespace vignole {

struct Contribution {
  std::string source;
  double uMm = 0;  ///< standard uncertainty that this source alone would leave
};
struct DimensionUncertainty {
  Dimension dimension{};
  double uMm = 0;                           ///< standard uncertainty
  std::vector<Contribution> contributions;  ///< largest first; their squares sum up to uMm^2
};
/// Of the dimensions that the Jacobian has, in the order of kDimensions; first order (JCGM 100 5.1.2).
[[nodiscard]] std::vector<DimensionUncertainty> dimensionUncertainty(const DimensionJacobian& jacobian,
                                                                     std::span<const ErrorSource> sources);

/// Propagation beside what drawn errors do to the measurement itself (JCGM 101).
struct MonteCarloDimension {
  Dimension dimension{};
  double uMm = 0;        ///< propagated
  double drawnMm = 0;    ///< standard deviation of the drawn errors; of HF, an extreme, their root mean square
  double biasMm = 0;     ///< mean of the drawn errors
  double relativeU = 0;  ///< of drawnMm, standard, by the number of draws
};
/// Draws normal errors of all sources, measures the section by the rig so changed. The same seed, the same numbers.
[[nodiscard]] Expected<std::vector<MonteCarloDimension>> monteCarlo(const Section& section,
                                                                    const DimensionParameters& parameters,
                                                                    const RigCalibration& rig,
                                                                    std::span<const ErrorSource> sources, int draws,
                                                                    std::uint64_t seed, const Job& job = {});

}  // namespace vignole
