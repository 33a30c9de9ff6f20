#pragma once
// A recording as a source of frames: what the cameras gave is given once more, in the same order.

#include <memory>

#include "engine/acquisition/frame.h"
#include "engine/recording/recording.h"

namespace vignole {

struct RecordingSourceSettings {
  bool paced = false;  ///< at the times at which it was recorded, from the first frame on; else as fast as it is taken
  std::size_t buffers = 24;  ///< of each camera
};

/// Never live: a full queue holds it back, so nothing is lost that was recorded. A trigger whose recording was given up
/// comes as lost ("not recorded"), a damaged frame too ("damaged recording"). Packed frames are unpacked in next(),
/// that is by the acquire elements, four at once.
[[nodiscard]] std::unique_ptr<FrameSource> makeRecordingSource(std::shared_ptr<const Recording> recording,
                                                               const RecordingSourceSettings& settings = {});

}  // namespace vignole
