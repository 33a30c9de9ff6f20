#include "engine/simulator/rail_motion.h"

#include <array>
#include <numbers>

#include "engine/simulator/hashing.h"

namespace vignole::simulator {

namespace {
constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr double kWanderMm = 5, kWanderRad = std::numbers::pi / 180, kVibrationRmsMm = 0.05;
constexpr std::array<double, 3> kWanderShares = {0.5, 0.3, 0.2};  // sum 1: the limit is never passed
constexpr int kVibrationSines = 5;
constexpr int kExposureSteps = 8;
}  // namespace

RailMotion::RailMotion(std::uint64_t seed, const MotionSettings& settings) : exposureS_(settings.exposureS) {
  Draws wander(seed, Stream::Wander);
  Draws vibration(seed, Stream::Vibration);
  const auto addWander = [&](Sines& sines, double amplitude) {
    for (const double share : kWanderShares)
      sines.push_back({amplitude * share, kTwoPi * wander.uniform(0.05, 0.3), kTwoPi * wander.uniform()});
  };
  addWander(x_, settings.wander * kWanderMm);
  addWander(y_, settings.wander * kWanderMm);
  addWander(angle_, settings.wander * kWanderRad);
  for (Sines* sines : {&x_, &y_})
    for (int i = 0; i < kVibrationSines; ++i)
      sines->push_back({settings.vibration * kVibrationRmsMm * std::sqrt(2.0 / kVibrationSines),
                        kTwoPi * vibration.uniform(5, 30), kTwoPi * vibration.uniform()});
}

double RailMotion::sum(const Sines& sines, double timeS) {
  double value = 0;
  for (const Sine& sine : sines) value += sine.amplitude * std::sin(sine.omega * timeS + sine.phase);
  return value;
}

Transform2 RailMotion::at(double timeS) const { return {sum(x_, timeS), sum(y_, timeS), sum(angle_, timeS)}; }

ExposedPose RailMotion::exposed(double timeS) const {
  std::array<Eigen::Vector3d, kExposureSteps> poses;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int i = 0; i < kExposureSteps; ++i) {
    const Transform2 pose = at(timeS + exposureS_ * (i + 0.5) / kExposureSteps);
    poses[static_cast<std::size_t>(i)] = {pose.xMm, pose.yMm, pose.angleRad};
    mean += poses[static_cast<std::size_t>(i)] / kExposureSteps;
  }
  ExposedPose exposed;
  exposed.worldFromSection = {mean.x(), mean.y(), mean.z()};
  for (const Eigen::Vector3d& pose : poses) exposed.covariance += (pose - mean) * (pose - mean).transpose();
  exposed.covariance /= kExposureSteps;
  return exposed;
}

}  // namespace vignole::simulator
