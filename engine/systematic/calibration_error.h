#pragma once
// What an error of the calibration does to every dimension of a section: the part of its uncertainty that no number of
// profiles averages out. The nominal section, as the cameras see it, is mapped back by another rig, registered and
// measured as any profile is.

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>

#include "engine/geometry/expected.h"
#include "engine/optics/rig_uncertainty.h"
#include "engine/rail/dimension.h"
#include "engine/rail/section.h"
#include "engine/systematic/seen_section.h"

namespace vignole {

/// Derivative of each dimension (rows in the order of kDimensions) by each parameter of the rig, mm per unit, at the
/// nominal section in its nominal place. NaN rows for dimensions that the section does not have or the rig does not
/// see. HF, an extreme, has no derivative on a nominal crown: its row is that of the deviation at one end of the
/// compared width, the end that moves more.
using DimensionJacobian = Eigen::Matrix<double, static_cast<int>(kDimensionCount), kRigParameters>;
[[nodiscard]] Expected<DimensionJacobian> dimensionJacobian(const Section& section,
                                                            const DimensionParameters& parameters,
                                                            const RigCalibration& rig);

/// A section before a rig that is exact, measured by rigs that are not. Not for two threads at once.
class SectionBeforeRig {
 public:
  [[nodiscard]] static Expected<SectionBeforeRig> create(const Section& section, const DimensionParameters& parameters,
                                                         const RigCalibration& trueRig);
  SectionBeforeRig(SectionBeforeRig&&) noexcept;
  SectionBeforeRig& operator=(SectionBeforeRig&&) noexcept;
  ~SectionBeforeRig();

  struct Values {
    PerDimension<double> mm{};         ///< NaN where not measured
    std::array<double, 2> hfEndsMm{};  ///< deviation of the crown at the ends of the width that HF compares
  };
  /// The error says why the profile cannot be registered.
  [[nodiscard]] Expected<Values> measuredBy(const RigCalibration& assumedRig);
  [[nodiscard]] const SeenLines& seen() const;
  [[nodiscard]] const PerDimension<std::optional<double>>& nominal() const;

 private:
  struct Impl;
  explicit SectionBeforeRig(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Measured minus nominal where the outline is seen by `trueRig` and mapped back by `assumedRig`, mm, not linearised;
/// NaN where the dimension cannot be measured. Their world frames may differ by a motion in the plane (registration
/// takes it up), their lens models as they like.
[[nodiscard]] Expected<PerDimension<double>> measuredDimensions(const Section& section,
                                                                const DimensionParameters& parameters,
                                                                const RigCalibration& trueRig,
                                                                const RigCalibration& assumedRig);

/// Standard uncertainty that the rig's covariance leaves in each dimension, mm; zero without a covariance and where the
/// dimension is not measured.
[[nodiscard]] Expected<PerDimension<double>> calibrationUncertainty(const Section& section,
                                                                    const DimensionParameters& parameters,
                                                                    const RigCalibration& rig);

}  // namespace vignole
