#pragma once
// What is measured goes into the archive as well, from the engine's last stage, which never waits for the disk.

#include <functional>
#include <memory>
#include <vector>

#include "engine/archive/rail_writer.h"
#include "engine/inspection/inspection.h"

namespace vignole {

/// `watch`, and everything it is told goes to the writer too. `papers` is asked when a rail begins, `stages` when it
/// has ended, in the engine's thread. Writer, and what the two refer to, outlive the inspection.
[[nodiscard]] InspectionObserver recorded(InspectionObserver watch, RailWriter& writer,
                                          std::shared_ptr<const MeasuringSetup> setup,
                                          std::function<RailPapers(const RailBegin&)> papers,
                                          std::function<std::vector<StageStatistics>()> stages);

}  // namespace vignole
