#pragma once
// Is a recording whole, and does it still say what it said: every chunk, and for every frame that extraction gives the
// points whose digest was recorded.

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/recording/recording.h"

namespace vignole {

struct RecordingFinding {
  std::string where, what;  ///< "camera 2, trigger 17"
};

struct RecordingCheck {
  std::uint64_t chunks = 0, damagedChunks = 0;
  std::uint64_t frames = 0, sparseFrames = 0;
  std::uint64_t compared = 0;              ///< frames whose points were extracted again
  std::uint64_t different = 0;             ///< of them: other points than those that were recorded
  std::string whyNotCompared;              ///< of frames that were not; empty: all were
  std::vector<RecordingFinding> findings;  ///< the first hundred
  [[nodiscard]] bool good() const { return damagedChunks == 0 && different == 0; }
};

/// Extraction with the recorded recipe and calibration. `progress` is told the share that is done.
[[nodiscard]] RecordingCheck verifyRecording(const Recording& recording, const std::function<void(double)>& progress,
                                             const std::stop_token& stop = {});

}  // namespace vignole
