#pragma once
// The virtual rig, measured by the whole pipeline in real time, as a Line.

#include <memory>

#include "engine/archive/rail_writer.h"
#include "engine/geometry/expected.h"
#include "engine/simulator/virtual_rig.h"
#include "gui/bridge/line.h"

namespace vignole {

struct VirtualLineSettings {
  Recipe recipe;
  VirtualRigSettings rig;  ///< its section is what is rendered
  double railLengthMm = 60000;
};

class VirtualLine : public Line {
 public:
  /// Builds the rig; the error tells what it refuses.
  [[nodiscard]] static Expected<std::unique_ptr<VirtualLine>> create(const VirtualLineSettings& settings);
  ~VirtualLine() override;  ///< stops and joins

  /// What is measured from the next start on is kept by the writer, which outlives the line; null: by none.
  void record(RailWriter* writer);

  void start() override;
  void stop() override;
  [[nodiscard]] bool running() const override;
  [[nodiscard]] const LineSnapshot& pull(PullDetail detail) override;
  [[nodiscard]] std::shared_ptr<LatestFrames> frames() override;
  [[nodiscard]] PictureAgain pictureAgain() override;
  [[nodiscard]] std::optional<double> exposureMs() const override;
  void useExposure(double exposureMs) override;
  /// The exact one of the rig until another is to be used
  [[nodiscard]] RigCalibration calibration() override;
  void useCalibration(const RigCalibration& calibration) override;
  [[nodiscard]] std::optional<std::uint64_t> virtualRigSeed() const override;
  void useStripeSettings(const StripeSettings& settings) override;
  /// The rail that the rig renders becomes the recipe's section, unless it was another one before (a wrong rail).
  [[nodiscard]] Expected<void> useRecipe(const Recipe& recipe) override;
  [[nodiscard]] RailAnnouncements* announcements() override;

 private:
  struct Impl;
  explicit VirtualLine(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace vignole
