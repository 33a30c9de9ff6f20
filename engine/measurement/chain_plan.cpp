#include "engine/measurement/chain_plan.h"

#include <algorithm>

namespace vignole {
namespace {

class Planner {
 public:
  Planner(const Section& section, std::vector<ChainPlan>& chains)
      : section_(section), chains_(chains), taken_(section.primitives.size(), false) {}

  [[nodiscard]] bool taken(std::size_t primitive) const { return taken_[primitive]; }
  [[nodiscard]] bool isLongArc(std::size_t primitive) const {
    const Primitive& shape = section_.primitives[primitive].shape;
    return std::holds_alternative<Arc>(shape) && length(shape) >= kShortArcMm;
  }
  void add(ChainPlan chain) {
    for (const std::size_t p : chain.primitives)
      if (taken_[p]) return;
    for (const std::size_t p : chain.primitives) taken_[p] = true;
    chains_.push_back(std::move(chain));
  }
  void addAlone(std::size_t primitive) { add({{primitive}, 0}); }

 private:
  const Section& section_;
  std::vector<ChainPlan>& chains_;
  std::vector<bool> taken_;
};

/// The head's side with the arcs above it, up to the first one long enough to show its radius.
ChainPlan headSideChain(const Planner& planner, const std::vector<std::size_t>& upwards, bool counterClockwise) {
  ChainPlan chain;
  for (const std::size_t p : upwards) {
    chain.primitives.push_back(p);
    if (planner.isLongArc(p)) break;
  }
  if (!counterClockwise) {
    std::reverse(chain.primitives.begin(), chain.primitives.end());
    chain.anchor = chain.primitives.size() - 1;
  }
  return chain;
}

}  // namespace

std::vector<ChainPlan> planChains(const Section& section, const SectionPlan& plan) {
  std::vector<ChainPlan> chains;
  Planner planner(section, chains);
  planner.add(headSideChain(planner, plan.headSide[kRight], true));
  planner.add(headSideChain(planner, plan.headSide[kLeft], false));

  ChainPlan crown{{plan.headTop}, 0};
  const std::size_t n = section.primitives.size();
  const std::size_t before = (plan.headTop + n - 1) % n, after = (plan.headTop + 1) % n;
  if (planner.isLongArc(before) && !planner.taken(before)) {
    crown.primitives.insert(crown.primitives.begin(), before);
    crown.anchor = 1;
  }
  if (planner.isLongArc(after) && !planner.taken(after)) crown.primitives.push_back(after);
  planner.add(crown);
  for (const CrownSample& sample : plan.crown)
    if (!planner.taken(sample.primitive)) planner.addAlone(sample.primitive);

  for (const std::size_t side : {kLeft, kRight}) {
    if (!plan.web[side].empty()) planner.add({plan.web[side], 0});
    planner.addAlone(plan.footEdge[side]);
    planner.addAlone(plan.footTop[side]);
    planner.addAlone(plan.fishingLower[side]);
    planner.addAlone(plan.fishingUpper[side]);
  }
  return chains;
}

}  // namespace vignole
