#pragma once
// What is told of a camera on the Diagnostics page and in the JSON of a run.

#include <cstdint>
#include <map>
#include <string>

#include "engine/gige_camera/gige_settings.h"
#include "engine/synchronisation/camera_watch.h"

namespace vignole {

/// Since the source was opened, over all streams of the camera.
struct CameraCounters {
  std::uint64_t framesOk = 0;
  std::map<std::string, std::uint64_t> failed;                ///< frames that arrived damaged, by Aravis' word for it
  std::uint64_t framesLost = 0;                               ///< gaps: sent by the camera but never arrived
  std::uint64_t missedTriggers = 0;                           ///< gaps: not answered by the camera
  std::uint64_t repeated = 0, implausible = 0, restarts = 0;  ///< frames; a camera that counted from anew
  std::uint64_t overflow = 0;                                 ///< frames that nobody took in time
  std::uint64_t unaligned = 0;                                ///< frames whose trigger was not known (yet)
  std::uint64_t resendRequests = 0, resentPackets = 0, missingPackets = 0, underrunPackets = 0;
  std::uint64_t reconnections = 0, failedOpenings = 0;
};

struct CameraReport {
  int camera = 0;
  GigeIdentity identity;
  CameraState state = CameraState::Connecting;
  std::string why;  ///< empty if connected
  CountSource countSource = CountSource::FrameId;
  std::string cannotTell;  ///< what the count source cannot detect; empty: nothing
  int packetBytes = 0;
  double lastFrameAgeS = -1;  ///< -1: none yet
  CameraCounters counters;
};

}  // namespace vignole
