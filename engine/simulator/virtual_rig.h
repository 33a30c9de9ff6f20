#pragma once
// The virtual rig: rig C of optics.md with the lasers at 480 mm, a moving rail whose dimensions vary by a documented
// law, and the frames that the four cameras see of it. Everything is a pure function of (settings, camera, trigger).

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/acquisition/frame.h"
#include "engine/geometry/expected.h"
#include "engine/geometry/image_view.h"
#include "engine/geometry/transform2.h"
#include "engine/optics/calibration.h"
#include "engine/rail/dimension.h"
#include "engine/rail/section.h"

namespace vignole {

/// Amplitudes of the effects; --effect NAME=on|off|VALUE changes each (off is 0, on its default).
struct Effects {
  double readNoiseDn = 3;     ///< read-noise: standard deviation
  double shotNoise = 1;       ///< shot-noise: multiple of 10,000 electrons at 60 DN ... see virtual_rig.cpp
  double speckle = 0.22;      ///< speckle: contrast; grain 2 px
  double scale = 0.15;        ///< scale: share of the length covered by mill scale (reflectance x 0.3-0.7)
  double reflections = 0.15;  ///< reflections: strength of secondary reflections
  double crosstalk = 0.03;    ///< crosstalk: share of the other wavelength that passes the filter
  double ambientDn = 12;      ///< ambient: background
  double defocus = 1;         ///< defocus: multiple of the thin lens' blur at f/8
  double motion = 1;          ///< motion: share of the exposure over which movement is integrated
  double wander = 1;          ///< wander: multiple of +-5 mm, +-1 deg below 0.3 Hz
  double vibration = 1;       ///< vibration: multiple of 0.05 mm rms at 5-30 Hz
};
/// Name (as on the command line) and value of each effect, for the JSON.
[[nodiscard]] std::vector<std::pair<std::string, double>> list(const Effects& effects);
/// "speckle=off", "ambient=20", "all=off"; the error lists the names.
[[nodiscard]] Expected<void> applyEffect(Effects& effects, const std::string& specification);

/// "frame-loss=0.01@2:100-200" and the other kinds of commands.md that make sense without a network:
/// frame-loss, missed-trigger, die, revive, slow, black, saturated, move, turn, wrong-rail, scale.
struct Fault {
  std::string kind;
  double value = 0;
  std::string text;                    ///< for wrong-rail: the section
  int camera = -1;                     ///< 0..3, -1 all
  std::uint64_t from = 0, to = ~0ULL;  ///< triggers, inclusive
};
[[nodiscard]] Expected<Fault> parseFault(const std::string& specification);

struct VirtualRigSettings {
  Section section;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> rigSeed;  ///< draws the rig itself; default: the seed
  /// Draws how the rail passes and what the cameras add: wander, vibration, scale, speckle, noise. Another one is
  /// another inspection of the same rail by the same rig; default: the seed.
  std::optional<std::uint64_t> passSeed;
  double spacingMm = 15;
  double speedMmPerS = 1000;
  double exposureMs = 15;    ///< scales the light, and the ambient; what moves within it is blurred
  double temperatureC = 20;  ///< the rail is that much longer than at 15 degrees C
  Effects effects;
  PerDimension<std::optional<double>> deviationMm{};  ///< constant deviation from nominal in place of the law's
  bool varyDimensions = true;                         ///< false: nominal but for deviationMm
  std::vector<Fault> faults;
  DimensionParameters parameters;  ///< where the truth is taken
};

/// The words of a command line: effects as applyEffect, deviations as "HW=0.3" (DIM=MM from nominal), faults as
/// parseFault. The first that is wrong is the error.
[[nodiscard]] Expected<void> applyWords(VirtualRigSettings& settings, const std::vector<std::string>& effects,
                                        const std::vector<std::string>& deviations,
                                        const std::vector<std::string>& faults);

/// Dimensions of the section that was rendered, at 15 degrees C, by code of its own. HF: the signed value of HF_max.
struct Truth {
  PerDimension<double> valueMm{};
  double hfMinMm = 0;
  Transform2 worldFromSection;  ///< mean pose over the exposure
};

/// Immutable after create; every member function may be called from any thread.
class VirtualRig {
 public:
  [[nodiscard]] static Expected<std::shared_ptr<const VirtualRig>> create(VirtualRigSettings settings);
  ~VirtualRig();
  VirtualRig(const VirtualRig&) = delete;
  VirtualRig& operator=(const VirtualRig&) = delete;

  [[nodiscard]] const VirtualRigSettings& settings() const;
  /// The exact calibration of this rig.
  [[nodiscard]] const RigCalibration& calibration() const;
  /// image: as large as the camera's sensor. Same (camera, trigger), same bytes, in any thread and order.
  void render(int camera, std::uint64_t trigger, const MutableImageView& image) const;
  [[nodiscard]] Truth truth(std::uint64_t trigger) const;
  /// The outline that is rendered, world frame, closed polyline, at the mean pose; about 0.2 mm apart.
  [[nodiscard]] std::vector<Point2> outline(std::uint64_t trigger) const;
  /// Centre of the visible laser line in one camera, px, in order along the outline; breaks start a new line.
  [[nodiscard]] std::vector<std::vector<Point2>> visibleLines(int camera, std::uint64_t trigger) const;

 private:
  struct Impl;
  explicit VirtualRig(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// The virtual rig as a source of frames: rails one after the other, as fast as they are taken or paced in real time.
/// Frames are rendered in next(), i.e. in the acquire elements; buffers come from a pool.
struct VirtualSourceSettings {
  int rails = 1;
  double lengthMm = 60000;
  bool paced = false;        ///< real time by speed and spacing: live, drops when late
  std::size_t buffers = 24;  ///< per camera
};
[[nodiscard]] std::unique_ptr<FrameSource> makeVirtualSource(std::shared_ptr<const VirtualRig> rig,
                                                             const VirtualSourceSettings& settings);

}  // namespace vignole
