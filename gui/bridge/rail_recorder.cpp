#include "gui/bridge/rail_recorder.h"

#include <utility>

namespace vignole {

InspectionObserver recorded(InspectionObserver watch, RailWriter& writer, std::shared_ptr<const MeasuringSetup> setup,
                            std::function<RailPapers(const RailBegin&)> papers,
                            std::function<std::vector<StageStatistics>()> stages) {
  InspectionObserver both;
  both.railBegan = [began = std::move(watch.railBegan), &writer, setup = std::move(setup),
                    papers = std::move(papers)](const RailBegin& rail) {
    writer.begin(rail, papers ? papers(rail) : RailPapers{}, setup);
    if (began) began(rail);
  };
  both.profileMeasured = [measured = std::move(watch.profileMeasured), &writer](const ProfileResult& profile) {
    writer.add(profile);
    if (measured) measured(profile);
  };
  both.railEnded = [ended = std::move(watch.railEnded), &writer, stages = std::move(stages)](
                       const RailBegin& rail, const TriggerLedger& ledger) {
    writer.end(ledger, stages());
    if (ended) ended(rail, ledger);
  };
  both.ended = std::move(watch.ended);
  both.frameExtracted = std::move(watch.frameExtracted);
  return both;
}

}  // namespace vignole
