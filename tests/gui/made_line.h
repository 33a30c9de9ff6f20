#pragma once
// A line made by hand: a rail whose every dimension the test decides, and a fake that counts its commands.

#include <map>
#include <memory>
#include <string>

#include "gui/bridge/line.h"

namespace vignole::test {

/// 60E1 under class X/A.
[[nodiscard]] const Recipe& recipe();

/// What one profile of a made rail shows.
struct MadeProfile {
  double positionM = 41.37;
  std::map<Dimension, double> deviationMm = {};   ///< others 0.1 of the way to their upper limit
  std::map<Dimension, std::string> missing = {};  ///< not measured, because ...
  int lostCamera = -1;                            ///< 0..3: without points
};

[[nodiscard]] std::shared_ptr<const RailBegin> madeRail(const std::string& id = "V1-0007");
[[nodiscard]] ProfileResult makeProfile(const MadeProfile& profile, std::shared_ptr<const RailBegin> rail = madeRail());

/// A snapshot of a rail of 60 m measured with the same profile from its head to `profile.positionM`.
[[nodiscard]] LineSnapshot makeSnapshot(const MadeProfile& profile = {});
/// The same before the first rail.
[[nodiscard]] LineSnapshot emptySnapshot(LineState state = LineState::Armed);
/// The source stopped so long ago.
[[nodiscard]] LineSnapshot heldSnapshot(double ageS, const MadeProfile& profile = {});

class FakeLine : public Line {
 public:
  LineSnapshot snapshot = emptySnapshot();
  int starts = 0, stops = 0;
  bool isRunning = true;
  std::shared_ptr<LatestFrames> pictures;  ///< null: hands out none
  RigCalibration rig;
  std::optional<StripeSettings> used;  ///< what was last asked for the next rail
  std::optional<Recipe> asked;         ///< for the next rail

  void start() override { ++starts, isRunning = true; }
  void stop() override { ++stops, isRunning = false; }
  [[nodiscard]] bool running() const override { return isRunning; }
  [[nodiscard]] Expected<void> useRecipe(const Recipe& recipe) override {
    asked = recipe;
    return {};
  }
  [[nodiscard]] const LineSnapshot& pull(PullDetail /*detail*/) override { return snapshot; }
  [[nodiscard]] std::shared_ptr<LatestFrames> frames() override { return pictures; }
  [[nodiscard]] RigCalibration calibration() override { return rig; }
  void useStripeSettings(const StripeSettings& settings) override { used = settings; }
};

}  // namespace vignole::test
