#include "engine/packing/columns.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace vignole {
namespace {

std::vector<std::int64_t> thereAndBack(const std::vector<std::int64_t>& values) {
  ColumnPacker packer(9);
  packer.add(values);
  const Bytes bytes = packer.finish();
  ColumnReader reader(bytes, 9);
  auto back = reader.column(values.size());
  EXPECT_TRUE(reader.good()) << reader.error();
  return back;
}

TEST(Columns, AnyNumbersComeBack) {
  constexpr auto kMin = std::numeric_limits<std::int64_t>::min(), kMax = std::numeric_limits<std::int64_t>::max();
  const std::vector<std::vector<std::int64_t>> cases = {
      {}, {0}, {-1}, {kMin, kMax, 0, kMax, kMin, -1, 1}, std::vector<std::int64_t>(1000, 42)};
  for (const auto& values : cases) EXPECT_EQ(thereAndBack(values), values);
  std::mt19937_64 random(3);
  std::vector<std::int64_t> any(5000);
  for (auto& v : any) v = static_cast<std::int64_t>(random() >> (random() % 64));
  EXPECT_EQ(thereAndBack(any), any);
}

TEST(Columns, NoiseCostsAboutItsEntropyAndAScaleNothing) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(172'000'000, 5000);  // nm
  std::vector<std::int64_t> values(4000), scale(4000);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = std::llround(noise(random));
    scale[i] = static_cast<std::int64_t>(15'000'000 * i);
  }
  ColumnPacker noisy(1);
  noisy.add(values);
  // Entropy of a normal with sigma 5000 steps: log2(5000 sqrt(2 pi e)) = 14.3 bit.
  EXPECT_LT(static_cast<double>(noisy.finish().size()) * 8 / 4000, 14.3 * 1.1);
  ColumnPacker even(1);
  even.add(scale);
  EXPECT_LT(even.finish().size(), 128U);
}

TEST(Columns, EveryChangedOrMissingByteIsFound) {
  ColumnPacker packer(1);
  packer.addNumber(7);
  packer.addText("frame lost");
  packer.add(std::vector<std::int64_t>{5, 6, 7, 1000, -3});
  const Bytes good = packer.finish();
  for (std::size_t i = 0; i < good.size(); ++i) {
    Bytes bad = good;
    bad[i] ^= 0x10U;
    EXPECT_FALSE(ColumnReader(bad, 1).good()) << "byte " << i;
    bad = good;
    bad.resize(i);
    EXPECT_FALSE(ColumnReader(bad, 1).good()) << "cut at " << i;
  }
  EXPECT_FALSE(ColumnReader(good, 2).good());
}

TEST(Columns, ReadingMoreThanThereIsIsAnErrorAndNotMemory) {
  ColumnPacker packer(1);
  packer.add(std::vector<std::int64_t>{1, 5, 2});
  const Bytes bytes = packer.finish();
  ColumnReader reader(bytes, 1);
  EXPECT_TRUE(reader.column(4000).empty());
  EXPECT_FALSE(reader.good());
  EXPECT_EQ(reader.number(), 0U);
  EXPECT_TRUE(reader.text().empty());
}

}  // namespace
}  // namespace vignole
