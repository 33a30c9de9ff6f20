#include "engine/acquisition/rail_announcement.h"

#include <gtest/gtest.h>

namespace vignole {
namespace {

/// Rails without frames, each camera's stream alike.
class BareRails : public FrameSource {
 public:
  [[nodiscard]] FrameMessage next(int camera, std::stop_token /*stop*/) override {
    const auto n = rails_.at(static_cast<std::size_t>(camera))++;
    RailBegin rail;
    rail.id = "R" + std::to_string(n);
    rail.heat = "H";
    rail.firstTrigger = static_cast<std::uint64_t>(n) * 100;
    return rail;
  }
  [[nodiscard]] bool live() const override { return true; }

 private:
  std::array<int, 4> rails_{};
};

RailBegin nextRail(FrameSource& source, int camera) { return std::get<RailBegin>(source.next(camera, {})); }

TEST(RailAnnouncement, NamesTheNextRailInAllStreamsAndThatRailOnly) {
  RailAnnouncements rails;
  const auto source = announced(std::make_unique<BareRails>(), rails);
  EXPECT_TRUE(source->live());
  EXPECT_EQ(nextRail(*source, 0).id, "R0");
  rails.announce({"0412-3-07", "", "3", "A-77", 61.5});
  EXPECT_EQ(nextRail(*source, 0).id, "0412-3-07");
  EXPECT_FALSE(rails.waiting());
  // The other cameras are a rail behind: theirs was not announced, the next one was.
  for (int camera = 1; camera < 4; ++camera) {
    EXPECT_EQ(nextRail(*source, camera).id, "R0") << camera;
    const RailBegin rail = nextRail(*source, camera);
    EXPECT_EQ(rail.id, "0412-3-07") << camera;
    EXPECT_EQ(rail.heat, "H") << "what was not entered stays";
    EXPECT_EQ(rail.temperatureC, 61.5);
  }
  EXPECT_EQ(rails.taken(100).strand, "3");
  EXPECT_EQ(rails.taken(100).order, "A-77");
  EXPECT_EQ(nextRail(*source, 2).id, "R2");
}

TEST(RailAnnouncement, ALaterOneReplacesWhatWaitsAndItCanBeWithdrawn) {
  RailAnnouncements rails;
  rails.announce({"one", "", "", "", {}});
  rails.announce({"two", "", "", "", {}});
  EXPECT_EQ(rails.waiting()->id, "two");
  rails.withdraw();
  EXPECT_FALSE(rails.waiting());
  EXPECT_EQ(rails.taken(0).id, "");
  rails.announce({"three", "", "", "", {}});
  rails.restart();
  EXPECT_EQ(rails.taken(0).id, "three") << "triggers count from 0 again";
}

}  // namespace
}  // namespace vignole
