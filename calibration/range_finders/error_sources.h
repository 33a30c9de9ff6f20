#pragma once
// The adjustment's answers to causes of error, by name.

#include <span>
#include <vector>

#include "calibration/range_finders/arc_adjustment.h"
#include "engine/optics/rig_uncertainty.h"

namespace vignole {

/// "pin 7": its stated place and radius; "camera 3 focal length", "camera 3 principal point u_0" ...: the intrinsics as
/// stated, in the order of CameraParameter, what is correlated going to the first of its parameters (Cholesky);
/// "camera 2 lines": the scatter of the ridge. Causes that move nothing are left out.
[[nodiscard]] std::vector<ErrorSource> errorSources(const Influence& influence, const PinPlate& plate,
                                                    std::span<const int> cameras);

/// Causes of the same name are one: what it does to different cameras is added up.
void addSources(std::vector<ErrorSource>& all, std::vector<ErrorSource> more);

[[nodiscard]] Eigen::MatrixXd covarianceOf(std::span<const ErrorSource> sources);

/// Fewer columns with the same covariance.
[[nodiscard]] Eigen::Matrix<double, kRigParameters, Eigen::Dynamic> compressed(const Eigen::MatrixXd& effects);

}  // namespace vignole
