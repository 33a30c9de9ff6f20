#include "cli/camera_health.h"

#include <cmath>

#include "engine/stripe/stripe.h"

namespace vignole::cli {

namespace {
std::string cameraName(std::size_t camera) { return "camera " + std::to_string(camera + 1); }
}  // namespace

void CameraHealth::add(const Profile& profile) {
  ++profiles_;
  for (std::size_t c = 0; c < cameras_.size(); ++c) {
    if (profile.missing[c].empty())
      ++cameras_[c].contours;
    else
      cameras_[c].missing = profile.missing[c];
  }
  for (const ProfilePoint& point : profile.points) {
    Camera& camera = cameras_[point.camera];
    ++camera.points;
    if ((point.flags & kSaturated) != 0) ++camera.saturated;
  }
}

std::vector<Error> CameraHealth::blind() const {
  std::vector<Error> found;
  if (profiles_ == 0) return found;
  for (std::size_t c = 0; c < cameras_.size(); ++c)
    if (cameras_[c].contours == 0)
      found.push_back({cameraName(c),
                       cameras_[c].missing + " in all of " + std::to_string(profiles_) +
                           " profiles; look at its power, its cable, its laser and its window",
                       ErrorKind::World});
  return found;
}

std::vector<Error> CameraHealth::overexposed() const {
  constexpr double kMost = 0.5;
  std::vector<Error> found;
  for (std::size_t c = 0; c < cameras_.size(); ++c) {
    const Camera& camera = cameras_[c];
    if (camera.points == 0) continue;
    const double share = static_cast<double>(camera.saturated) / static_cast<double>(camera.points);
    if (share > kMost)
      found.push_back({cameraName(c),
                       std::to_string(std::lround(100 * share)) +
                           " % of its line is saturated; shorten its exposure or close its aperture",
                       ErrorKind::World});
  }
  return found;
}

}  // namespace vignole::cli
