#pragma once
// Registration (paper section II-F and its reference [18]): ICP of profile points to the section's primitives with
// analytic nearest points. It assigns points to primitives and gives the pose; dimensions come later, from the data.

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/geometry/transform2.h"
#include "engine/profile/profile.h"
#include "engine/rail/section.h"

namespace vignole {

struct RegistrationSettings {
  double startScaleMm = 60;     ///< Tukey scale of the first pass without a starting pose
  double trackScaleMm = 6;      ///< the same with one
  double inlierMm = 0.1;        ///< a point is an inlier below max(3 sigma, this)
  double assignMm = 3.0;        ///< points further from their primitive are not assigned
  double maxRmsMm = 1.0;        ///< registration fails above
  double minInlierShare = 0.3;  ///< and below
};

struct PrimitiveResidual {
  int points = 0;
  double rmsMm = 0;
  double meanMm = 0;
  double chi2 = 0;  ///< per point
};

/// A section that explains a profile where the expected one does not.
struct OtherSection {
  std::string name;
  double chi2 = 0, chi2OfExpected = 0;   ///< ShapeMisfit: per place, smooth deviations allowed for
  std::vector<std::int16_t> primitives;  ///< of the expected section: those that differ
};

struct Registration {
  bool valid = false;
  std::string reason;                                    ///< why not valid
  Transform2 worldFromSection;                           ///< the pose: data from section
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< x, y (mm), angle (rad) about the section centre
  double rmsMm = 0;                                      ///< over inliers, |r| < max(3 sigma, 0.1 mm)
  int inliers = 0;
  int points = 0;
  int iterations = 0;
  double timeUs = 0;                           ///< registration alone
  double chi2 = 0;                             ///< per inlier-or-near point, robust
  std::vector<std::int16_t> primitiveOfPoint;  ///< index into Section::primitives, -1 outlier
  std::vector<float> residualMm;               ///< signed, > 0 outside the section
  std::vector<PrimitiveResidual> primitives;   ///< one per primitive of the section
  std::optional<OtherSection> looksLike;       ///< RailMatcher::check; then it is not valid
};

/// One per thread and section. Same points, same bits.
class Registrar {
 public:
  Registrar(const Section& section, const RegistrationSettings& settings);
  ~Registrar();
  Registrar(Registrar&&) noexcept;
  Registrar& operator=(Registrar&&) noexcept;

  /// `start`: expected worldFromSection (never taken from an earlier profile: determinism), or none.
  /// `correlatedPoints`: Profile::correlatedPoints, widens the covariance.
  void registerProfile(std::span<const ProfilePoint> points, Registration& result,
                       const std::optional<Transform2>& start = {}, double correlatedPoints = 1);
  /// From this start or not at all: a quarter of the time where the section does not fit. `scaleMm`: how far off the
  /// start may leave the points.
  void registerFrom(const Transform2& start, double scaleMm, std::span<const ProfilePoint> points,
                    Registration& result);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// How well a registered profile fits: mean over all points of min(distance, 1 mm)^2 / sigma^2, so that points which a
/// wrong rail leaves far away count against it. 1 on the right rail without outliers.
[[nodiscard]] double chi2OfAllPoints(std::span<const ProfilePoint> points, const Registration& registration);

/// Which way the axes of a record run.
struct AxisFlip {
  bool x = false, y = false;
};
/// Records by others have y down, or look against the rail's motion: tries what a section without symmetry can tell
/// apart (a symmetric one only y), turns the points accordingly and registers them. As given wins unless another way
/// fits clearly better.
AxisFlip registerEitherWay(std::vector<ProfilePoint>& points, const Section& section, Registrar& registrar,
                           Registration& result);

}  // namespace vignole
