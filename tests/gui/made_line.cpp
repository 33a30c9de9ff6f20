#include "tests/gui/made_line.h"

#include <algorithm>
#include <cmath>

#include "engine/measurement/measurement.h"
#include "engine/rail/catalogue.h"

namespace vignole::test {

namespace {

Recipe makeTestRecipe() {
  Recipe recipe;
  recipe.name = "60E1 X/A";
  recipe.section = *findSection("60E1");
  recipe.limits = *toleranceLimits(recipe.section, "X", "A");
  return recipe;
}

const PerDimension<std::optional<double>>& nominals() {
  static const auto values = *nominalDimensions(recipe().section, recipe().parameters);
  return values;
}

Verdict judged(double deviation, double expandedU, const ToleranceLimits& limits) {
  if (!limits.lowerMm && !limits.upperMm) return Verdict::NoLimit;
  const double margin = std::min(limits.upperMm.value_or(1e9) - deviation, deviation - limits.lowerMm.value_or(-1e9));
  return std::abs(margin) < expandedU ? Verdict::Near : margin < 0 ? Verdict::Fail : Verdict::Pass;
}

DimensionResult makeResult(Dimension d, const MadeProfile& made) {
  const ToleranceLimits& limits = recipe().limits[index(d)];
  DimensionResult result;
  result.nominalMm = nominals()[index(d)].value_or(0);
  result.uMm = d == Dimension::HR ? 0.9 : 0.012;
  if (limits.lowerMm) result.lowerMm = result.nominalMm + *limits.lowerMm;
  if (limits.upperMm) result.upperMm = result.nominalMm + *limits.upperMm;
  if (const auto missing = made.missing.find(d); missing != made.missing.end()) {
    result.reason = missing->second;
    return result;
  }
  const auto given = made.deviationMm.find(d);
  const double deviation = given != made.deviationMm.end() ? given->second : 0.1 * limits.upperMm.value_or(1);
  result.valueMm = result.nominalMm + deviation;
  result.points = 100;
  result.verdict = judged(deviation, 2 * result.uMm, limits);
  return result;
}

/// Points every 0.7 mm on the outline, shared out among the cameras by quadrant.
void fillPoints(ProfileResult& result, int lostCamera) {
  const auto& primitives = recipe().section.primitives;
  std::array<std::vector<std::pair<ProfilePoint, std::int16_t>>, kCameraCount> cameras;
  for (std::size_t i = 0; i < primitives.size(); ++i)
    for (double s = 0; s < length(primitives[i].shape); s += 0.7) {
      const Point2 at = pointAt(primitives[i].shape, s), normal = normalAt(primitives[i].shape, s);
      ProfilePoint point;
      const double off = 0.02 * std::sin(0.3 * s);
      point.x = at.x() + off * normal.x();
      point.y = at.y() + off * normal.y();
      point.nx = static_cast<float>(normal.x());
      point.ny = static_cast<float>(normal.y());
      point.sigmaMm = 0.02F;
      point.camera = static_cast<std::uint8_t>((at.x() > 0 ? 1 : 0) + (at.y() > 86 ? 0 : 2));
      cameras[point.camera].emplace_back(point, static_cast<std::int16_t>(i));
    }
  for (int c = 0; c < kCameraCount; ++c) {
    const auto camera = static_cast<std::size_t>(c);
    if (c == lostCamera) {
      result.profile.missing[camera] = "frame lost";
      continue;
    }
    for (const auto& [point, primitive] : cameras[camera]) {
      result.profile.points.push_back(point);
      result.registration.primitiveOfPoint.push_back(primitive);
      result.registration.residualMm.push_back(0.01F);
    }
    result.profile.pointsOfCamera[camera] = static_cast<std::uint32_t>(cameras[camera].size());
    result.profile.lineEnds.push_back(static_cast<std::uint32_t>(result.profile.points.size()));
  }
}

std::vector<StageStatistics> madeStages() {
  std::vector<StageStatistics> stages;
  const auto add = [&](const std::string& name, double meanMs, std::size_t capacity) {
    stages.push_back(
        {name, 2758, meanMs, meanMs / 10, meanMs * 1.02, meanMs * 4, capacity, capacity ? 3u : 0u, 0, 0, 0});
  };
  for (int c = 1; c <= kCameraCount; ++c) {
    add("acquire." + std::to_string(c), 14.1, 0);
    add("extract." + std::to_string(c), 1.41, 16);
    add("translate." + std::to_string(c), 0.032, 16);
  }
  add("profile", 0.052, 16);
  add("measure", 0.394, 16);
  return stages;
}

}  // namespace

const Recipe& recipe() {
  static const Recipe made = makeTestRecipe();
  return made;
}

std::shared_ptr<const RailBegin> madeRail(const std::string& id) {
  RailBegin rail;
  rail.id = id;
  rail.heat = "263417";
  rail.sectionName = "60E1";
  rail.lengthMm = 60000;
  rail.speedMmPerS = 1000;
  return std::make_shared<const RailBegin>(rail);
}

ProfileResult makeProfile(const MadeProfile& made, std::shared_ptr<const RailBegin> rail) {
  ProfileResult result;
  result.rail = std::move(rail);
  result.profile.positionMm = made.positionM * 1000;
  fillPoints(result, made.lostCamera);
  result.registration.valid = true;
  result.registration.points = result.registration.inliers = static_cast<int>(result.profile.points.size());
  for (const Dimension d : kDimensions) result.measurement.dimensions[index(d)] = makeResult(d, made);
  return result;
}

LineSnapshot emptySnapshot(LineState state) {
  LineSnapshot line;
  line.state = state;
  line.recipe = &recipe();
  line.calibrationMethod = "exact (virtual rig)";
  line.expectedPerS = 66.7;
  return line;
}

LineSnapshot makeSnapshot(const MadeProfile& made) {
  LineSnapshot line = emptySnapshot(LineState::Measuring);
  line.latest = std::make_shared<const ProfileResult>(makeProfile(made));
  RailSummariser summariser(*line.latest->rail, recipe(), "made");
  TriggerLedger ledger;
  ProfileResult along = *line.latest;
  for (double m = 0; m <= made.positionM; m += 0.15) {
    along.profile.positionMm = m * 1000;
    summariser.add(along);
    ++ledger.seen;
    ++(along.profile.complete() ? ledger.measured : ledger.incomplete);
  }
  line.rail = std::make_shared<const RailSummary>(summariser.summary(ledger));
  if (made.lostCamera >= 0) line.lostCameras.push_back({made.lostCamera, 23.18, "frame lost"});
  for (const auto& [dimension, reason] : made.missing) line.unmeasured.push_back({dimension, 23.18, reason});
  line.passed = {{"V1-0002", Verdict::Pass},
                 {"V1-0003", Verdict::Near},
                 {"V1-0004", Verdict::Pass},
                 {"V1-0005", Verdict::Fail},
                 {"V1-0006", Verdict::Pass}};
  line.railsPassed = 6;
  line.railsGood = 4;
  line.profilesPerS = 66.7;
  line.triggers = ledger;
  if (ledger.incomplete > 0) line.triggers.reasons["camera 3: frame lost"] = ledger.incomplete;
  line.recentIncomplete = ledger.incomplete;
  line.stages = madeStages();
  return line;
}

LineSnapshot heldSnapshot(double ageS, const MadeProfile& made) {
  LineSnapshot line = makeSnapshot(made);
  line.state = LineState::Stopped;
  line.ageS = ageS;
  line.profilesPerS = 0;
  return line;
}

}  // namespace vignole::test
