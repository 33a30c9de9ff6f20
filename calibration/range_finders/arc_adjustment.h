#pragma once
// Arcs fitted in the light plane: cameras, pins and placements by least squares, and what every cause of error does to
// the result.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "calibration/job.h"
#include "calibration/range_finders/arc_prediction.h"

namespace vignole {

/// Which of the unknowns move; all cameras of the problem do.
struct ArcFreedom {
  bool pins = true;        ///< with their uncertainty as priors; false: as stated
  bool intrinsics = true;  ///< with theirs
};

/// All unknowns in a row: 16 a camera (10 of the intrinsics in standard deviations, 6 of the pose), 3 a pin, 3 a
/// placement.
class UnknownOrder {
 public:
  UnknownOrder(std::size_t pins, std::size_t placements) : pins_(pins), placements_(placements) {}
  [[nodiscard]] Eigen::Index intrinsics(int camera) const { return camera * kCameraParameters; }
  [[nodiscard]] Eigen::Index pose(int camera) const { return intrinsics(camera) + kIntrinsicsUnknowns; }
  [[nodiscard]] Eigen::Index pin(int index) const { return kRigParameters + index * kPinUnknowns; }
  [[nodiscard]] Eigen::Index placement(int index) const {
    return kRigParameters + static_cast<Eigen::Index>(pins_) * kPinUnknowns + index * kPlacementUnknowns;
  }
  [[nodiscard]] Eigen::Index size() const { return placement(static_cast<int>(placements_)); }

 private:
  std::size_t pins_, placements_;
};

/// The problem about its solution: per camera, the information of its points on all unknowns, and the covariance of
/// what their noise does to the gradient.
struct ArcNormals {
  std::array<Eigen::MatrixXd, kCameraCount> information, noise;
};

/// How the estimate answers to one standard deviation of each independent cause: rows as RigChange, then pins (3 each,
/// mm).
struct Influence {
  Eigen::MatrixXd covariance;                              ///< of RigChange and pins, all causes
  std::vector<Eigen::MatrixXd> ofPin;                      ///< columns: x, y, radius
  std::array<Eigen::MatrixXd, kCameraCount> ofIntrinsics;  ///< columns: the ten factors
  std::array<Eigen::MatrixXd, kCameraCount> ofLines;
  std::array<double, kCameraCount> parameters{};  ///< how many of them each camera's points determine
};

struct ArcAdjustment {
  RigState state;
  std::array<CameraLight, kCameraCount> lights;
  std::array<CameraBase, kCameraCount> base;                          ///< the intrinsics as stated, and their factor
  std::array<Eigen::Matrix<double, 10, 1>, kCameraCount> intrinsics;  ///< found, in stated standard deviations
  std::vector<ArcObservation> arcs;
  ArcNormals normals;
  ArcFreedom freedom;
  int referencePlacement = 0;
  double chi2PerDof = 0;  ///< of independent points and priors
};

struct ArcStart {
  RigState state;
  std::array<CameraLight, kCameraCount> lights;
  int referencePlacement = 0;
};

/// Lower triangular L with L L^T = covariance, columns in the order of the parameters; zero where nothing is uncertain.
[[nodiscard]] Eigen::Matrix<double, 10, 10> intrinsicsFactor(const Eigen::Matrix<double, 10, 10>& covariance);

/// Error: cancelled.
[[nodiscard]] Expected<ArcAdjustment> adjustArcs(const RigInputs& inputs, const ArcStart& start,
                                                 std::vector<ArcObservation> arcs, const ArcFreedom& freedom,
                                                 const RigAdjustmentSettings& settings, const Job& job);

/// `cameras`: those that the problem has.
[[nodiscard]] Influence influence(const ArcAdjustment& adjustment, const PinPlate& plate, std::span<const int> cameras,
                                  const ArcFreedom& freedom);

}  // namespace vignole
