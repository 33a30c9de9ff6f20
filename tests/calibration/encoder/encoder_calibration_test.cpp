#include "calibration/encoder/encoder_calibration.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <unistd.h>

namespace vignole {
namespace {

/// A body that travels `lengthMm` while it drifts; counters round down, the second one slips.
struct Travel {
  double lengthMm = 2000, mmPerPulse = 0.0500123, driftX = 1e-4, driftY = -2e-4, slip = 0, noiseMm = 0, startMm = 0.3;
  int readings = 21;
  bool falling = false, second = false;
  std::uint64_t seed = 1;

  [[nodiscard]] std::vector<EncoderReading> read() const {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<EncoderReading> all;
    for (int i = 0; i < readings; ++i) {
      const double z = lengthMm * i / (readings - 1);
      EncoderReading r;
      r.count = std::floor((startMm + z) / mmPerPulse) * (falling ? -1 : 1);
      r.xMm = 3 + driftX * z + noiseMm * normal(random);
      r.yMm = 80 + driftY * z + noiseMm * normal(random);
      if (second) r.count2 = 5000 + std::floor(2 * (startMm + z) * (1 + slip) / mmPerPulse);
      all.push_back(r);
    }
    return all;
  }
};

EncoderSettings over(double lengthMm, double uMm = 0) { return {lengthMm, uMm, {}}; }

TEST(Encoder, GivesMillimetresAPulse) {
  const Travel travel;
  const auto c = calibrateEncoder(travel.read(), over(travel.lengthMm, 0.05));
  ASSERT_TRUE(c) << c.error().message();
  EXPECT_NEAR(c->vz.mm, travel.mmPerPulse, 4 * *c->vz.uMm);
  const double counts = c->counts;
  EXPECT_NEAR(*c->vz.uMm, std::sqrt(0.05 * 0.05 + 2 * c->vz.mm * c->vz.mm / 12) / counts, 1e-15);
  EXPECT_NEAR(c->vx.mm, travel.driftX * travel.mmPerPulse, 1e-9);
  EXPECT_NEAR(c->vy.mm, travel.driftY * travel.mmPerPulse, 1e-9);
  EXPECT_FALSE(c->slip.has_value());
}

TEST(Encoder, CountsThatFallGiveTheSameMillimetres) {
  Travel travel;
  const auto rising = calibrateEncoder(travel.read(), over(travel.lengthMm));
  travel.falling = true;
  const auto falling = calibrateEncoder(travel.read(), over(travel.lengthMm));
  ASSERT_TRUE(rising && falling);
  EXPECT_EQ(rising->vz.mm, falling->vz.mm);
  EXPECT_TRUE(falling->falling);
  EXPECT_NEAR(falling->vx.mm, rising->vx.mm, 1e-12);
}

/// The reported uncertainties are those of the errors over many travels that start anywhere within a pulse.
TEST(Encoder, UncertaintiesAreThoseOfTheErrors) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> start(0, 1);
  double z = 0, x = 0, s = 0;
  constexpr int kTravels = 1000;
  for (int k = 0; k < kTravels; ++k) {
    Travel travel;
    travel.lengthMm = 100;  // 2,000 pulses
    travel.startMm = start(random);
    travel.lengthMm += start(random);
    travel.noiseMm = 0.02;
    travel.second = true;
    travel.slip = 4e-4;
    travel.seed = static_cast<std::uint64_t>(k);
    const auto c = calibrateEncoder(travel.read(), over(travel.lengthMm));
    ASSERT_TRUE(c) << c.error().message();
    z += std::pow((c->vz.mm - travel.mmPerPulse) / *c->vz.uMm, 2) / kTravels;
    x += std::pow((c->vx.mm - travel.driftX * travel.mmPerPulse) / *c->vx.uMm, 2) / kTravels;
    s += std::pow((c->slip->ppm - 400) / c->slip->uPpm, 2) / kTravels;
  }
  EXPECT_NEAR(z, 1, 0.15);
  EXPECT_NEAR(x, 19 / 17.0, 0.2);  // Student's t with 19 degrees of freedom
  EXPECT_NEAR(s, 1, 0.15);
}

TEST(Encoder, ASecondOneTellsTheSlipAndWhereItJumped) {
  Travel travel;
  travel.second = true;
  std::vector<EncoderReading> readings = travel.read();
  for (std::size_t i = 12; i < readings.size(); ++i) *readings[i].count2 += 60;
  const auto c = calibrateEncoder(readings, over(travel.lengthMm));
  ASSERT_TRUE(c) << c.error().message();
  ASSERT_TRUE(c->slip.has_value());
  EXPECT_EQ(c->slip->ratio, 2);
  EXPECT_NEAR(c->slip->ppm, 1e6 * 60 / 79980, 4 * c->slip->uPpm);
  EXPECT_EQ(c->slip->worstRow, 12U);
  EXPECT_NEAR(c->slip->worstJump, 30, 3);
}

TEST(Encoder, TwoReadingsGiveNoUncertaintyOfTheDrift) {
  const auto c = calibrateEncoder({{0, 1, 2, {}}, {1000, 1.5, 2, {}}}, over(50));
  ASSERT_TRUE(c) << c.error().message();
  EXPECT_DOUBLE_EQ(c->vx.mm, 0.0005);
  EXPECT_FALSE(c->vx.uMm.has_value());
}

TEST(Encoder, RefusesWhatIsNoTravel) {
  const std::vector<EncoderReading> good = Travel{}.read();
  const auto why = [](const std::vector<EncoderReading>& readings, const EncoderSettings& settings) {
    const auto c = calibrateEncoder(readings, settings);
    EXPECT_FALSE(c.has_value());
    return c ? std::string() : c.error().message();
  };
  EXPECT_NE(why(good, over(0)).find("--length"), std::string::npos);
  EXPECT_NE(why(good, over(-5)).find("--length"), std::string::npos);
  EXPECT_NE(why(good, over(std::nan(""))).find("--length"), std::string::npos);
  EXPECT_NE(why(good, over(1, -1)).find("--length-u"), std::string::npos);
  EXPECT_NE(why({good.front()}, over(1)).find("at least two"), std::string::npos);
  EXPECT_NE(why({}, over(1)).find("at least two"), std::string::npos);
  EXPECT_NE(why({{0, 0, 0, {}}, {99, 0, 0, {}}}, over(1)).find("at least 100"), std::string::npos);
  EXPECT_NE(why({{0, 0, 0, {}}, {900, 0, 0, {}}, {800, 0, 0, {}}}, over(1)).find("turns round at reading 3"),
            std::string::npos);
  std::vector<EncoderReading> odd = good;
  odd[3].xMm = std::nan("");
  EXPECT_NE(why(odd, over(1)).find("reading 4"), std::string::npos);
  EXPECT_NE(why({{0, 0, 0, 0}, {900, 0, 0, 1500}}, over(1)).find("--ratio"), std::string::npos);
}

class EncoderFile : public testing::Test {
 protected:
  void SetUp() override {
    file_ = std::filesystem::temp_directory_path() / ("vignole_encoder_" + std::to_string(::getpid()) + ".csv");
  }
  void TearDown() override { std::filesystem::remove(file_); }
  Expected<std::vector<EncoderReading>> load(const std::string& text) {
    std::ofstream(file_) << text;
    return loadEncoderReadings(file_);
  }
  std::string errorOf(const std::string& text) {
    const auto r = load(text);
    EXPECT_FALSE(r.has_value()) << text;
    return r ? std::string() : r.error().message();
  }
  std::filesystem::path file_;
};

TEST_F(EncoderFile, ReadsColumnsInAnyOrder) {
  const auto r = load("# travel\ny_mm,count,x_mm,count2\n80.5,0,1,7\n\n80.25, 12000 ,-1.5,9\r\n");
  ASSERT_TRUE(r) << r.error().message();
  ASSERT_EQ(r->size(), 2U);
  EXPECT_EQ((*r)[1].count, 12000);
  EXPECT_EQ((*r)[1].xMm, -1.5);
  EXPECT_EQ((*r)[1].yMm, 80.25);
  EXPECT_EQ((*r)[1].count2, 9);
}

TEST_F(EncoderFile, NamesLineAndColumnOfWhatIsWrong) {
  EXPECT_NE(errorOf("").find("count,x_mm,y_mm"), std::string::npos);
  EXPECT_NE(errorOf("count,x_mm\n0,1\n").find("y_mm"), std::string::npos);
  EXPECT_NE(errorOf("count,x_mm,y_mm\n0,1,2\n5,a,2\n").find(":3: x_mm"), std::string::npos);
  EXPECT_NE(errorOf("count,x_mm,y_mm\n0,1,2\n5,1\n").find("truncated"), std::string::npos);
  EXPECT_NE(errorOf("count,x_mm,y_mm\n0,nan,2\n").find("nan"), std::string::npos);
  EXPECT_NE(errorOf("count,x_mm,y_mm\n0.5,1,2\n").find("whole number"), std::string::npos);
  EXPECT_FALSE(loadEncoderReadings("absent.csv").has_value());
}

}  // namespace
}  // namespace vignole
