#include "engine/synchronisation/camera_watch.h"

#include <utility>

namespace vignole {

namespace {
constexpr const char* kNoAnswer = "does not answer; look at its power, its cable and the address";
constexpr const char* kNoControl = "its control channel does not answer, its frames still come";
}  // namespace

const char* name(CameraState state) {
  switch (state) {
    case CameraState::Connecting:
      return "connecting";
    case CameraState::Connected:
      return "connected";
    case CameraState::Degraded:
      return "degraded";
    case CameraState::Lost:
      return "lost";
  }
  return "lost";
}

void CameraWatch::become(CameraState state, std::string why) {
  state_ = state;
  why_ = std::move(why);
  if (state == CameraState::Lost) silent_ = true;
}

void CameraWatch::opened(double nowS) {
  controlLost_ = false;
  silent_ = false;
  lastS_ = nowS;
  become(CameraState::Connected, {});
}

void CameraWatch::frame(double nowS) {
  lastS_ = nowS;
  if (!silent_ || state_ != CameraState::Degraded) return;
  silent_ = false;
  if (controlLost_) {
    become(CameraState::Degraded, kNoControl);
  } else {
    become(CameraState::Connected, {});
  }
}

void CameraWatch::controlLost() {
  controlLost_ = true;
  if (state_ == CameraState::Lost || state_ == CameraState::Connecting) return;
  if (silent_) {
    become(CameraState::Lost, kNoAnswer);
  } else {
    become(CameraState::Degraded, kNoControl);
  }
}

void CameraWatch::failed(std::string why) { become(CameraState::Lost, std::move(why)); }

void CameraWatch::doesNotAnswer() {
  if (state_ == CameraState::Lost) why_ = kNoAnswer;
}

void CameraWatch::look(double nowS, std::uint64_t ahead) {
  if (state_ == CameraState::Lost || state_ == CameraState::Connecting) return;
  const double quietS = nowS - lastS_;
  if (controlLost_ && quietS >= settings_.lostS) return become(CameraState::Lost, kNoAnswer);
  if (ahead >= settings_.lostTriggers && quietS >= settings_.lostS)
    return become(CameraState::Lost, "no frames for " + std::to_string(ahead) + " triggers");
  if (!silent_ && ahead >= settings_.silentTriggers && quietS >= settings_.silentS) {
    silent_ = true;
    become(CameraState::Degraded, "no frames for " + std::to_string(ahead) + " triggers");
  }
}

bool CameraWatch::toBeOpenedAgain(bool railInView) const {
  if (state_ == CameraState::Lost) return true;
  return state_ == CameraState::Degraded && controlLost_ && !silent_ && !railInView;
}

}  // namespace vignole
