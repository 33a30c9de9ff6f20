// Rendered campaigns through extraction, association and adjustment: the goals of the optics design on ten of them,
// with limits that ten campaigns can be held to (95 % of chi^2), and what bad input gets.

#include <cmath>
#include <gtest/gtest.h>

#include "calibration/range_finders/association.h"
#include "tests/calibration/campaigns/virtual_campaign.h"

namespace vignole {

namespace {

constexpr int kCampaigns = 10;
constexpr double kChi2Of10At97 = 20.48;
// Nine dimensions are asked at once: 95 % for all of them together (Bonferroni).
constexpr double kChi2Highest = 27.1, kChi2Lowest = 1.9;

struct Goal {
  Dimension dimension;
  double roughUm, fineUm;  // plate of +-50 um, of +-3 um; optics design, goal table
};
constexpr std::array<Goal, 9> kGoals = {
    Goal{Dimension::HW, 12, 4},   Goal{Dimension::FW, 25, 5},   Goal{Dimension::RH, 32, 5},
    Goal{Dimension::WT, 5, 4},    Goal{Dimension::FTl, 5, 6},   Goal{Dimension::FTr, 5, 6},
    Goal{Dimension::RASl, 20, 8}, Goal{Dimension::RASr, 20, 8}, Goal{Dimension::FC, 2, 2}};

std::vector<CampaignOutcome> campaigns(double plateErrorMm, std::uint64_t firstSeed) {
  std::vector<CampaignOutcome> outcomes;
  for (int i = 0; i < kCampaigns; ++i) {
    CampaignSettings settings;
    settings.seed = firstSeed + static_cast<std::uint64_t>(i);
    settings.rigSeed = settings.seed;
    settings.plateErrorMm = plateErrorMm;
    Campaign campaign = renderCampaign(settings);
    outcomes.push_back(calibrated(campaign, {}));
    EXPECT_EQ(outcomes.back().refusal, "") << "seed " << settings.seed;
  }
  return outcomes;
}

double meanSquare(const std::vector<CampaignOutcome>& outcomes, Dimension d) {
  double sum = 0;
  for (const CampaignOutcome& o : outcomes) sum += o.errorMm[index(d)] * o.errorMm[index(d)];
  return sum / kCampaigns;
}

Campaign onePlacement(CampaignSettings settings = {}) {
  settings.placements = 1;
  return renderCampaign(settings);
}

std::string refusalsOf(const Campaign& campaign) {
  std::string all;
  for (const PlacementLines& placement : campaign.inputs.placements)
    for (const PinPicture& picture : placement.pictures) all += picture.refusal + "\n";
  return all;
}

}  // namespace

TEST(Campaign, PlateAsDrawnMeetsTheGoals) {
  const auto outcomes = campaigns(0.05, 301);
  double cd = 0, rd = 0, pd = 0;
  for (const CampaignOutcome& o : outcomes) {
    cd += o.cdMm / kCampaigns;
    rd += o.rdMm / kCampaigns;
    pd += o.pdMm / kCampaigns;
  }
  EXPECT_LE(cd, 0.06);
  EXPECT_LE(rd, 0.03);
  EXPECT_LE(pd, 0.04);
  for (const Goal& goal : kGoals) {
    const double rmsUm = 1000 * std::sqrt(meanSquare(outcomes, goal.dimension));
    EXPECT_LE(rmsUm, goal.roughUm * std::sqrt(kChi2Of10At97 / kCampaigns)) << name(goal.dimension);
  }
}

TEST(Campaign, MeasuredPlateMeetsTheGoalsAndStatesItsUncertainty) {
  const auto outcomes = campaigns(0.003, 401);
  for (const Goal& goal : kGoals) {
    const double rmsUm = 1000 * std::sqrt(meanSquare(outcomes, goal.dimension));
    EXPECT_LE(rmsUm, goal.fineUm * std::sqrt(kChi2Of10At97 / kCampaigns)) << name(goal.dimension);
    double chi2 = 0;
    for (const CampaignOutcome& o : outcomes) {
      const double u = o.uMm[index(goal.dimension)];
      chi2 += std::pow(o.errorMm[index(goal.dimension)] / u, 2);
    }
    EXPECT_LE(chi2, kChi2Highest) << name(goal.dimension);
    EXPECT_GE(chi2, kChi2Lowest) << name(goal.dimension);
  }
}

TEST(Campaign, PinsAreToldApartWithSomeMissingAndArcsThatAreNone) {
  int right = 0, all = 0;
  for (int i = 0; i < 12; ++i) {
    CampaignSettings settings;
    settings.seed = 501 + static_cast<std::uint64_t>(i);
    settings.rigSeed = settings.seed;
    settings.missingPins = {1 + i % 13, 1 + (i + 4) % 13, 1 + (i + 9) % 13};
    settings.spurious = 2;
    settings.turnDeg = 3;
    settings.placements = 2;
    Campaign campaign = renderCampaign(settings);
    associate(campaign.inputs);
    const auto [good, pictures] = rightlyAssociated(campaign);
    right += good;
    all += pictures;
  }
  EXPECT_GE(right, all - 1) << right << " of " << all;
}

TEST(Campaign, PaperMethodComesToThePapersErrors) {
  Campaign campaign = onePlacement();
  RigAdjustmentSettings settings;
  settings.method = RigMethod::Paper;
  settings.paper.fourSteps = false;
  const CampaignOutcome outcome = calibrated(campaign, settings);
  ASSERT_EQ(outcome.refusal, "");
  EXPECT_GT(outcome.cdMm, 0.06) << "ellipses of short arcs shrink";
  EXPECT_LT(outcome.cdMm, 0.4);
  settings.paper.fourSteps = true;
  const CampaignOutcome steps = calibrated(campaign, settings);
  EXPECT_NE(steps.refusal.find("wrong pins"), std::string::npos) << steps.refusal;
}

TEST(Campaign, CancelledLeavesNothing) {
  Campaign campaign = onePlacement();
  associate(campaign.inputs);
  std::stop_source stop;
  stop.request_stop();
  const auto adjusted = adjustRig(campaign.inputs, {}, Job{{}, stop.get_token()});
  ASSERT_FALSE(adjusted);
  EXPECT_EQ(adjusted.error().what, "cancelled");
}

TEST(BadPlate, SwappedCamerasAreNamed) {
  Campaign campaign = onePlacement();
  auto& pictures = campaign.inputs.placements.front().pictures;
  std::swap(pictures[0], pictures[1]);
  associate(campaign.inputs);
  EXPECT_NE(refusalsOf(campaign).find("swapped"), std::string::npos) << refusalsOf(campaign);
}

TEST(BadPlate, MirroredPlateIsNamed) {
  Campaign campaign = onePlacement();
  for (Pin& pin : campaign.inputs.plate.pins) pin.centreMm.x() = -pin.centreMm.x();
  associate(campaign.inputs);
  EXPECT_NE(refusalsOf(campaign).find("mirror"), std::string::npos) << refusalsOf(campaign);
}

TEST(BadPlate, PlateOfAnotherFileIsRefused) {
  Campaign campaign = onePlacement();
  for (std::size_t i = 0; i < campaign.inputs.plate.pins.size(); ++i) {
    Pin& pin = campaign.inputs.plate.pins[i];
    pin.centreMm += Point2(11 * std::sin(3.0 * static_cast<double>(i)), 13 * std::cos(5.0 * static_cast<double>(i)));
  }
  associate(campaign.inputs);
  for (const PinPicture& picture : campaign.inputs.placements.front().pictures)
    EXPECT_NE(picture.refusal, "") << "a plate that is not that of the file";
}

TEST(BadPlate, NoLightIsRefusedForThatCameraAlone) {
  Campaign campaign = onePlacement();
  campaign.inputs.placements.front().pictures[2].arcs.clear();
  associate(campaign.inputs);
  EXPECT_NE(campaign.inputs.placements.front().pictures[2].refusal, "");
  EXPECT_EQ(campaign.inputs.placements.front().pictures[0].refusal, "");
  const auto adjusted = adjustRig(campaign.inputs, {}, {});
  ASSERT_TRUE(adjusted);
  ASSERT_FALSE(adjusted->refusals.empty());
  EXPECT_NE(adjusted->refusals.front().find("camera 3"), std::string::npos) << adjusted->refusals.front();
}

}  // namespace vignole
