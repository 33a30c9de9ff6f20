#include "engine/profile/assembler.h"

#include <gtest/gtest.h>

namespace vignole {
namespace {

PartialContour contour(int camera, std::uint64_t trigger, int points = 2, const std::string& missing = "") {
  PartialContour c;
  c.camera = camera;
  c.trigger = trigger;
  c.missing = missing;
  c.correlatedPoints = static_cast<float>(camera + 1);
  for (int i = 0; i < points; ++i) {
    ProfilePoint p;
    p.x = static_cast<double>(trigger) + 0.01 * i;
    p.camera = static_cast<std::uint8_t>(camera);
    c.points.push_back(p);
  }
  if (points > 0) c.lineEnds.push_back(static_cast<std::uint32_t>(points));
  return c;
}

RailBegin railAt(std::uint64_t first, const std::string& id = "r") {
  RailBegin rail;
  rail.id = id;
  rail.firstTrigger = first;
  rail.spacingMm = 10;
  return rail;
}

class AssemblerTest : public ::testing::Test {
 protected:
  void frame(int camera, std::uint64_t trigger, int points = 2, const std::string& missing = "") {
    PartialContour c = contour(camera, trigger, points, missing);
    assembler.add(c);
  }
  void allCameras(std::uint64_t trigger) {
    for (int c = 0; c < 4; ++c) frame(c, trigger);
  }
  void begin(std::uint64_t first, const std::string& id = "r") {
    for (int c = 0; c < 4; ++c) assembler.add(c, railAt(first, id));
  }
  void endRail(std::uint64_t end) {
    for (int c = 0; c < 4; ++c) assembler.add(c, RailEnd{end});
  }
  void endSource() {
    for (int c = 0; c < 4; ++c) assembler.add(c, SourceEnd{});
  }
  /// What is settled now, in words.
  std::vector<std::string> settled() {
    std::vector<std::string> words;
    while (assembler.next(out)) {
      switch (out.kind) {
        case Assembly::Kind::RailBegan:
          words.push_back("begin");
          break;
        case Assembly::Kind::RailEnded:
          words.push_back("end");
          break;
        case Assembly::Kind::Profile:
          words.push_back("profile " + std::to_string(out.profile.trigger));
          break;
        case Assembly::Kind::Lost: {
          std::string text = "lost " + std::to_string(out.lost);
          for (const std::string& reason : out.reasons) text += " | " + reason;
          words.push_back(text);
        }
      }
    }
    return words;
  }
  using Words = std::vector<std::string>;
  ProfileAssembler assembler;
  Assembly out;
};

TEST_F(AssemblerTest, JoinsFourContoursCameraOneFirstWhateverTheOrderTheyCameIn) {
  begin(5);
  for (const int c : {2, 0, 3}) frame(c, 7);
  EXPECT_EQ(settled(), (Words{"begin"})) << "camera 2 has not passed anything yet";
  frame(1, 7, 3);
  ASSERT_EQ(settled(), (Words{"lost 2 | missed by all cameras", "profile 7"}));
  const Profile& p = out.profile;
  EXPECT_DOUBLE_EQ(p.positionMm, 20);
  ASSERT_EQ(p.points.size(), 9U);
  EXPECT_EQ(p.pointsOfCamera, (std::array<std::uint32_t, 4>{2, 3, 2, 2}));
  EXPECT_EQ(p.lineEnds, (std::vector<std::uint32_t>{2, 5, 7, 9}));
  EXPECT_EQ(p.points[2].camera, 1);
  EXPECT_TRUE(p.complete());
  EXPECT_NEAR(p.correlatedPoints, (1 * 2 + 2 * 3 + 3 * 2 + 4 * 2) / 9.0, 1e-6);
}

TEST_F(AssemblerTest, WaitsForACameraUntilItHasMovedPast) {
  begin(0);
  for (const int c : {0, 1, 2}) frame(c, 0);
  EXPECT_EQ(settled(), (Words{"begin"}));
  frame(3, 1);
  EXPECT_EQ(settled(), (Words{"profile 0"}));
  EXPECT_EQ(out.profile.missing[3], "no frame");
  EXPECT_FALSE(out.profile.complete());
}

TEST_F(AssemblerTest, AReasonTravelsWithTheProfile) {
  begin(0);
  frame(0, 0);
  frame(1, 0, 0, "no stripe (black?)");
  assembler.add(2, FrameLost{2, 0, "incomplete"});
  frame(3, 0);
  EXPECT_EQ(settled(), (Words{"begin", "profile 0"}));
  EXPECT_EQ(out.profile.missing[1], "no stripe (black?)");
  EXPECT_EQ(out.profile.missing[2], "incomplete");
  EXPECT_EQ(out.profile.points.size(), 4U);
}

TEST_F(AssemblerTest, NoPointsAtAllIsALostTriggerWithEveryCamerasReason) {
  begin(0);
  for (int c = 0; c < 4; ++c) frame(c, 0, 0, "no stripe");
  EXPECT_EQ(settled(), (Words{"begin",
                              "lost 1 | camera 1: no stripe | camera 2: no stripe | camera 3: no stripe | camera 4: no "
                              "stripe"}));
}

TEST_F(AssemblerTest, TheEndOfARailWaitsForEveryCamerasToken) {
  begin(0);
  allCameras(0);
  for (const int c : {0, 1, 2}) assembler.add(c, RailEnd{1});
  EXPECT_EQ(settled(), (Words{"begin", "profile 0"}));
  frame(3, 0);  // a repeated one, before the token
  assembler.add(3, RailEnd{1});
  EXPECT_EQ(settled(), (Words{"lost 0 | camera 4: repeated frame", "end"}));
}

TEST_F(AssemblerTest, TriggersMissingAtTheTailOfARailAreLost) {
  begin(0);
  allCameras(0);
  endRail(4);
  EXPECT_EQ(settled(), (Words{"begin", "profile 0", "lost 3 | missed by all cameras", "end"}));
}

TEST_F(AssemblerTest, ANewRailEndsOneWhoseEndWasNeverTold) {
  begin(0, "a");
  allCameras(0);
  begin(3, "b");
  EXPECT_EQ(settled(), (Words{"begin", "profile 0", "lost 2 | missed by all cameras", "end", "begin"}));
  EXPECT_EQ(out.rail, nullptr);
}

TEST_F(AssemblerTest, OneCameraMayBeARailAhead) {
  assembler.add(0, railAt(0, "a"));
  frame(0, 0);
  assembler.add(0, RailEnd{1});
  assembler.add(0, railAt(1, "b"));
  frame(0, 1);
  assembler.add(0, RailEnd{2});
  EXPECT_EQ(assembler.lead(0), 2U);
  EXPECT_EQ(settled(), (Words{"begin"}));
  for (int c = 1; c < 4; ++c) {
    assembler.add(c, railAt(0, "a"));
    frame(c, 0);
    assembler.add(c, RailEnd{1});
    assembler.add(c, railAt(1, "b"));
    frame(c, 1);
    assembler.add(c, RailEnd{2});
  }
  endSource();
  EXPECT_EQ(settled(), (Words{"profile 0", "end", "begin", "profile 1", "end"}));
  EXPECT_TRUE(assembler.ended());
}

TEST_F(AssemblerTest, TwoEmptyRailsAtTheSameTriggerAreTwoRails) {
  begin(4, "a");
  endRail(4);
  begin(4, "b");
  endRail(4);
  endSource();
  EXPECT_EQ(settled(), (Words{"begin", "end", "begin", "end"}));
}

TEST_F(AssemblerTest, AStopMidRailEndsItAndCountsWhatItCutThrough) {
  begin(0);
  allCameras(0);
  frame(0, 1);
  frame(1, 1);
  assembler.add(0, SourceEnd{});
  assembler.add(1, SourceEnd{});
  EXPECT_EQ(settled(), (Words{"begin", "profile 0"}));
  assembler.add(2, SourceEnd{});
  assembler.add(3, SourceEnd{});
  EXPECT_EQ(settled(), (Words{"lost 1 | camera 3: stopped | camera 4: stopped", "end"}));
  EXPECT_TRUE(assembler.ended());
}

TEST_F(AssemblerTest, ACameraThatFailsLeavesTheOthersTheirProfiles) {
  begin(0);
  assembler.add(2, SourceEnd{"camera 3: cable"});
  for (const int c : {0, 1, 3}) frame(c, 0);
  EXPECT_EQ(settled(), (Words{"begin", "profile 0"}));
  EXPECT_EQ(out.profile.missing[2], "source failed");
  EXPECT_EQ(assembler.error(), "camera 3: cable");
}

TEST_F(AssemblerTest, FramesOutsideOfARailAreLostUnderThatName) {
  for (int c = 0; c < 4; ++c) frame(c, 2);
  begin(10);
  EXPECT_EQ(settled(), (Words{"lost 1 | outside of a rail", "begin"}));
}

TEST_F(AssemblerTest, LiveGivesUpOnASilentCameraAndRefusesWhatComesTooLate) {
  assembler = ProfileAssembler({3});
  begin(0);
  for (std::uint64_t t = 0; t < 6; ++t)
    for (const int c : {0, 1, 2}) frame(c, t);
  EXPECT_EQ(settled(), (Words{"begin", "profile 0", "profile 1", "profile 2"}));
  EXPECT_EQ(out.profile.missing[3], "too late");
  frame(3, 0);
  for (std::uint64_t t = 3; t < 6; ++t) frame(3, t);
  EXPECT_EQ(settled(), (Words{"lost 0 | camera 4: late frame", "profile 3", "profile 4", "profile 5"}));
  EXPECT_TRUE(out.profile.complete());
}

TEST_F(AssemblerTest, BuffersGoRound) {
  begin(0);
  const ProfilePoint* first = nullptr;
  for (std::uint64_t t = 0; t < 3; ++t)
    for (int c = 0; c < 4; ++c) {
      PartialContour given = contour(c, t);
      if (t == 0 && c == 0) first = given.points.data();
      assembler.add(given);
      if (t == 1 && c == 0) {
        EXPECT_EQ(given.points.data(), first) << "the spent contour of the settled trigger";
      }
      (void)settled();
    }
}

}  // namespace
}  // namespace vignole
