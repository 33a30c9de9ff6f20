#pragma once
// Worked examples with published answers, beside the checkout.

#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/files/atomic_file.h"
#include "engine/files/csv_table.h"

namespace vignole::testing {

inline const std::filesystem::path kQualityData = std::filesystem::path(VIGNOLE_SHARED_DATA) / "quality";

/// One case of published.json: what must come out, and to how many digits.
class Published {
 public:
  explicit Published(const std::string& name) {
    const auto text = readFile(kQualityData / "published.json");
    if (!text) return;
    case_ = nlohmann::json::parse(*text).at(name);
    left_ = case_.at("expected");
  }
  [[nodiscard]] bool here() const { return !case_.is_null(); }
  [[nodiscard]] CsvTable table() const {
    auto table = CsvTable::load(kQualityData / case_.at("file").get<std::string>());
    EXPECT_TRUE(table) << (table ? "" : table.error().message());
    return std::move(*table);
  }
  void expect(const std::string& key, double value) {
    ASSERT_TRUE(left_.contains(key)) << key;
    const auto& e = left_.at(key);
    EXPECT_NEAR(value, e.at("value").get<double>(), e.at("abs_tol").get<double>() * (1 + 1e-9) + 1e-12) << key;
    left_.erase(key);
  }
  /// Every published figure was looked at.
  void expectNothingLeft() const { EXPECT_TRUE(left_.empty()) << left_.dump(); }

 private:
  nlohmann::json case_, left_;
};

}  // namespace vignole::testing

#define SKIP_WITHOUT(published) \
  if (!(published).here()) GTEST_SKIP() << "no published examples at " << ::vignole::testing::kQualityData
