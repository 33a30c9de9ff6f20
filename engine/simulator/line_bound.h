#pragma once
// The physical limit of the virtual rig: how well the place of a laser line can be told from the light and the noise
// that were rendered, by whatever method. Nothing is known here of how lines are extracted.

#include <vector>

#include "engine/simulator/virtual_rig.h"

namespace vignole::simulator {

/// Noise of the picture as it is rendered (light_kernels.h): variance groundDn2 + shotPerDn * light of each pixel by
/// itself, and the speckle, which multiplies the light and is correlated over its grain.
struct PictureNoise {
  double groundDn2 = 0;  ///< read noise, shot noise of the ambient light, rounding (1/12)
  double shotPerDn = 0;
  double speckle = 0;     ///< contrast
  double clipDn = 1e300;  ///< light from which a pixel is clipped and tells nothing
};
[[nodiscard]] PictureNoise pictureNoise(const Effects& effects);

/// Gaussian profile of the light across the line.
struct LineLight {
  double contrastDn = 0;
  double sigmaPx = 0;
};

/// Fisher information on the shift of a straight line along its normal, px^-2 per px of its length. The covariance of
/// the noise is taken as known, which leaves out nothing that speckle (gamma) knows of the shift and next to nothing of
/// what shot noise does. Contrast, width and ground as unknowns change nothing, by symmetry. White noise n and no
/// speckle: sqrt(pi) contrast^2 / (2 sigma n^2) (stripe design, section 5).
[[nodiscard]] double informationPerPx(const LineLight& light, const PictureNoise& noise);

/// A place on the visible line of one camera, px.
struct LinePlace {
  Point2 px{0, 0};
  Point2 normal{0, 1};
  double lengthPx = 0;  ///< of the line that this place stands for
  LineLight light;      ///< contrast 0 where the line is too faint to be read
};

/// Reads the light along a line off a picture without noise; the line's points lie about 1 px apart.
[[nodiscard]] std::vector<LinePlace> readPlaces(const std::vector<Point2>& line, const ImageView& picture,
                                                double ambientDn);

/// Reads the light off a twin of the rig that renders the same scene without noise and secondary reflections: the bound
/// is that of lines on a ground without structure. Immutable.
class RenderedLines {
 public:
  [[nodiscard]] static Expected<RenderedLines> create(const VirtualRigSettings& settings);
  [[nodiscard]] const RigCalibration& calibration() const { return twin_->calibration(); }
  /// Along every visible line in order, one vector a line; about 1 px apart.
  [[nodiscard]] std::vector<std::vector<LinePlace>> at(int camera, std::uint64_t trigger) const;

 private:
  explicit RenderedLines(std::shared_ptr<const VirtualRig> twin) : twin_(std::move(twin)) {}
  std::shared_ptr<const VirtualRig> twin_;
};

}  // namespace vignole::simulator
