#include "engine/packing/profile_record.h"

#include <cmath>
#include <functional>
#include <optional>
#include <unordered_map>

namespace vignole {

namespace {

constexpr std::uint8_t kKind = 1;
constexpr double kStepsPerMm = 1e6, kStepsPerRad = 1e9;
/// Larger than that is no length of a rail, and its steps would not fit into 64 bits.
constexpr double kLargest = 9e18;

/// Empty where there is no number.
std::optional<std::int64_t> steps(double value, double perUnit) {
  const double scaled = value * perUnit;
  if (!(std::abs(scaled) < kLargest)) return {};
  return std::llround(scaled);
}

/// Texts that repeat from profile to profile, by number.
class TextTable {
 public:
  std::int64_t numberOf(const std::string& text) {
    const auto [place, isNew] = numbers_.emplace(text, static_cast<std::int64_t>(texts_.size()));
    if (isNew) texts_.push_back(text);
    return place->second;
  }
  [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::unordered_map<std::string, std::int64_t> numbers_;
  std::vector<std::string> texts_;
};

/// Columns of one block, each written by a function of the record.
class BlockPacker {
 public:
  explicit BlockPacker(std::span<const ProfileRecord> records) : records_(records), packer_(kKind) {
    packer_.addNumber(records.size());
  }
  template <typename Value>
  void whole(Value value) {
    column_.clear();
    for (const ProfileRecord& r : records_) column_.push_back(static_cast<std::int64_t>(value(r)));
    packer_.add(column_);
  }
  /// A number that may be missing: first where it is there, then the numbers.
  template <typename Value>
  void steps(Value value, double perUnit = kStepsPerMm) {
    column_.clear();
    there_.clear();
    for (const ProfileRecord& r : records_) {
      const std::optional<double> number = value(r);
      const auto stepsOfIt = number ? vignole::steps(*number, perUnit) : std::nullopt;
      there_.push_back(stepsOfIt ? 1 : 0);
      if (stepsOfIt) column_.push_back(*stepsOfIt);
    }
    packer_.add(there_);
    packer_.add(column_);
  }
  template <typename Text>
  void text(Text text) {
    TextTable table;
    column_.clear();
    for (const ProfileRecord& r : records_) column_.push_back(table.numberOf(text(r)));
    packer_.addNumber(table.texts().size());
    for (const std::string& t : table.texts()) packer_.addText(t);
    packer_.add(column_);
  }
  Bytes finish() { return packer_.finish(); }

 private:
  std::span<const ProfileRecord> records_;
  ColumnPacker packer_;
  std::vector<std::int64_t> column_, there_;
};

/// The same calls in the same order give the records back.
class BlockReader {
 public:
  explicit BlockReader(std::span<const std::uint8_t> block) : reader_(block, kKind) {
    const std::uint64_t count = reader_.number();
    if (count > kMaxBlockProfiles)
      reader_.refuse("more profiles than a block holds");
    else
      records_.resize(static_cast<std::size_t>(count));
  }
  template <typename Set>
  void whole(Set set) {
    const auto column = reader_.column(records_.size());
    for (std::size_t i = 0; i < column.size(); ++i) set(records_[i], column[i]);
  }
  template <typename Set>
  void steps(Set set, double perUnit = kStepsPerMm) {
    const auto there = reader_.column(records_.size());
    std::size_t count = 0;
    for (const std::int64_t t : there) count += t != 0 ? 1 : 0;
    const auto column = reader_.column(count);
    if (column.size() != count) return;
    for (std::size_t i = 0, next = 0; i < there.size(); ++i)
      if (there[i] != 0) set(records_[i], static_cast<double>(column[next++]) / perUnit);
  }
  template <typename Set>
  void text(Set set) {
    const std::uint64_t size = reader_.number();
    if (size > records_.size()) {
      reader_.refuse("more texts than profiles");
      return;
    }
    std::vector<std::string> texts;
    for (std::uint64_t i = 0; i < size; ++i) texts.push_back(reader_.text());
    const auto column = reader_.column(records_.size());
    for (std::size_t i = 0; i < column.size(); ++i) {
      if (column[i] < 0 || static_cast<std::uint64_t>(column[i]) >= size) {
        reader_.refuse("a text that is not there");
        return;
      }
      set(records_[i], texts[static_cast<std::size_t>(column[i])]);
    }
  }
  Expected<std::vector<ProfileRecord>> finish() {
    if (!reader_.good()) return inputError("profiles", reader_.error());
    return std::move(records_);
  }

 private:
  ColumnReader reader_;
  std::vector<ProfileRecord> records_;
};

Verdict verdictFrom(std::int64_t number) {
  const bool known = number >= 0 && number <= static_cast<std::int64_t>(Verdict::NoLimit);
  return known ? static_cast<Verdict>(number) : Verdict::NotMeasured;
}

}  // namespace

ProfileRecord recordOf(const Profile& profile, const Registration& registration, const Measurement& measurement) {
  ProfileRecord record;
  record.trigger = profile.trigger;
  record.positionMm = profile.positionMm;
  record.missing = profile.missing;
  record.overloaded = profile.overloaded;
  record.registered = registration.valid;
  record.whyNotRegistered = registration.reason;
  record.worldFromSection = registration.worldFromSection;
  record.rmsMm = registration.rmsMm;
  record.inliers = registration.inliers;
  record.points = profile.points.empty() ? registration.points : static_cast<int>(profile.points.size());
  record.dimensions = measurement.dimensions;
  for (DimensionResult& d : record.dimensions) d.anchors.clear();
  return record;
}

Bytes packProfiles(std::span<const ProfileRecord> records) {
  BlockPacker block(records);
  block.whole([](const ProfileRecord& r) { return r.trigger; });
  block.steps([](const ProfileRecord& r) { return std::optional(r.positionMm); });
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    block.text([c](const ProfileRecord& r) -> const std::string& { return r.missing[c]; });
    block.whole([c](const ProfileRecord& r) { return r.overloaded[c] ? 1 : 0; });
  }
  block.whole([](const ProfileRecord& r) { return r.registered ? 1 : 0; });
  block.text([](const ProfileRecord& r) -> const std::string& { return r.whyNotRegistered; });
  block.steps([](const ProfileRecord& r) { return std::optional(r.worldFromSection.xMm); });
  block.steps([](const ProfileRecord& r) { return std::optional(r.worldFromSection.yMm); });
  block.steps([](const ProfileRecord& r) { return std::optional(r.worldFromSection.angleRad); }, kStepsPerRad);
  block.steps([](const ProfileRecord& r) { return std::optional(r.rmsMm); });
  block.whole([](const ProfileRecord& r) { return r.inliers; });
  block.whole([](const ProfileRecord& r) { return r.points; });
  for (std::size_t d = 0; d < kDimensionCount; ++d) {
    const auto at = [d](const ProfileRecord& r) -> const DimensionResult& { return r.dimensions[d]; };
    const auto ifMeasured = [](const DimensionResult& m, double u) {
      return m.valueMm ? std::optional(u) : std::nullopt;
    };
    block.steps([&](const ProfileRecord& r) { return at(r).valueMm; });
    block.steps([&](const ProfileRecord& r) { return ifMeasured(at(r), at(r).uMm); });
    block.steps([&](const ProfileRecord& r) { return ifMeasured(at(r), at(r).uCalibrationMm); });
    block.steps([&](const ProfileRecord& r) { return at(r).secondMm; });
    block.steps([&](const ProfileRecord& r) { return at(r).secondMm ? std::optional(at(r).secondUMm) : std::nullopt; });
    block.steps([&](const ProfileRecord& r) { return at(r).leftMm; });
    block.steps([&](const ProfileRecord& r) { return at(r).rightMm; });
    block.whole([&](const ProfileRecord& r) { return at(r).points; });
    block.whole([&](const ProfileRecord& r) { return static_cast<int>(at(r).verdict); });
    block.text([&](const ProfileRecord& r) -> const std::string& { return at(r).reason; });
  }
  return block.finish();
}

Expected<std::vector<ProfileRecord>> unpackProfiles(std::span<const std::uint8_t> bytes) {
  BlockReader block(bytes);
  block.whole([](ProfileRecord& r, std::int64_t v) { r.trigger = static_cast<std::uint64_t>(v); });
  block.steps([](ProfileRecord& r, double v) { r.positionMm = v; });
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    block.text([c](ProfileRecord& r, const std::string& text) { r.missing[c] = text; });
    block.whole([c](ProfileRecord& r, std::int64_t v) { r.overloaded[c] = v != 0; });
  }
  block.whole([](ProfileRecord& r, std::int64_t v) { r.registered = v != 0; });
  block.text([](ProfileRecord& r, const std::string& text) { r.whyNotRegistered = text; });
  block.steps([](ProfileRecord& r, double v) { r.worldFromSection.xMm = v; });
  block.steps([](ProfileRecord& r, double v) { r.worldFromSection.yMm = v; });
  block.steps([](ProfileRecord& r, double v) { r.worldFromSection.angleRad = v; }, kStepsPerRad);
  block.steps([](ProfileRecord& r, double v) { r.rmsMm = v; });
  block.whole([](ProfileRecord& r, std::int64_t v) { r.inliers = static_cast<int>(v); });
  block.whole([](ProfileRecord& r, std::int64_t v) { r.points = static_cast<int>(v); });
  for (std::size_t d = 0; d < kDimensionCount; ++d) {
    const auto at = [d](ProfileRecord& r) -> DimensionResult& { return r.dimensions[d]; };
    block.steps([&](ProfileRecord& r, double v) { at(r).valueMm = v; });
    block.steps([&](ProfileRecord& r, double v) { at(r).uMm = v; });
    block.steps([&](ProfileRecord& r, double v) { at(r).uCalibrationMm = v; });
    block.steps([&](ProfileRecord& r, double v) { at(r).secondMm = v; });
    block.steps([&](ProfileRecord& r, double v) { at(r).secondUMm = v; });
    block.steps([&](ProfileRecord& r, double v) { at(r).leftMm = v; });
    block.steps([&](ProfileRecord& r, double v) { at(r).rightMm = v; });
    block.whole([&](ProfileRecord& r, std::int64_t v) { at(r).points = static_cast<int>(v); });
    block.whole([&](ProfileRecord& r, std::int64_t v) { at(r).verdict = verdictFrom(v); });
    block.text([&](ProfileRecord& r, const std::string& text) { at(r).reason = text; });
  }
  return block.finish();
}

}  // namespace vignole
