#include "engine/evidence/evidence_pack.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sodium.h>
#include <toml++/toml.h>

#include "engine/evidence/recomputation.h"
#include "engine/evidence/tape.h"
#include "engine/files/atomic_file.h"
#include "engine/packing/point_pack.h"
#include "engine/rail/catalogue.h"

namespace vignole {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;
constexpr std::size_t kBlockProfiles = 4096;
constexpr std::size_t kMaxProfiles = 1U << 20U;
constexpr const char* kSectionFile = "section.json";
constexpr int kMaxDepth = 32;
constexpr double kOtherMachine = 1e-6;  ///< mm, and relative

std::string digestOfBytes(std::string_view bytes) {
  std::array<unsigned char, crypto_generichash_BYTES> digest{};
  crypto_generichash(digest.data(), digest.size(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                     nullptr, 0);
  std::array<char, 2 * crypto_generichash_BYTES + 1> text{};
  sodium_bin2hex(text.data(), text.size(), digest.data(), digest.size());
  return text.data();
}

std::string numbered(const char* folder, std::uint64_t number) {
  std::array<char, 64> name{};
  std::snprintf(name.data(), name.size(), "%s/%07llu.bin", folder, static_cast<unsigned long long>(number));
  return name.data();
}

std::string_view textOf(const Bytes& bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }
std::span<const std::uint8_t> bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::string dumped(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

/// A recipe names its section; one that is no standard one lies beside it. Only from a folder of its own.
Expected<Recipe> recipeFrom(std::string_view recipe, std::string_view section) {
  struct Folder {
    std::string path = (std::filesystem::temp_directory_path() / "vignole-evidence-XXXXXX").string();
    Folder() {
      if (::mkdtemp(path.data()) == nullptr) path.clear();
    }
    ~Folder() {
      std::error_code ignored;
      if (!path.empty()) std::filesystem::remove_all(path, ignored);
    }
  } const folder;
  if (folder.path.empty()) return worldError("evidence", "no folder for temporary files can be made");
  try {
    const toml::table table = toml::parse(recipe);
    const auto named = table["section"].value<std::string>();
    // Nothing that a stranger's file names is read but what it brings along.
    if (!named || (named->find('/') != std::string::npos) || named->find('\\') != std::string::npos)
      return inputError("recipe.toml", "names no section");
  } catch (const toml::parse_error&) {
    return inputError("recipe.toml", "is no TOML");
  }
  const std::filesystem::path in = folder.path;
  if (auto written = writeFile(in / "recipe.toml", recipe); !written) return tl::unexpected(written.error());
  if (auto written = writeFile(in / kSectionFile, section); !written) return tl::unexpected(written.error());
  auto loaded = loadRecipe(in / "recipe.toml");
  if (!loaded) return tl::unexpected(Error{"recipe.toml", loaded.error().what, ErrorKind::Input});
  return loaded;
}

/// As text that does not depend on where this machine keeps its sections.
std::string portable(Recipe recipe) {
  if (recipe.sectionSource.find('/') != std::string::npos) recipe.sectionSource = kSectionFile;
  return toToml(recipe);
}

/// Where two documents differ by more than the numbers of another processor may; empty: nowhere.
std::string difference(const Json& a, const Json& b, const std::string& where, int depth) {
  if (a.is_number() && b.is_number()) {
    const double x = a.get<double>(), y = b.get<double>();
    return std::abs(x - y) <= kOtherMachine * std::max(1.0, std::abs(x)) ? "" : where;
  }
  if (depth > kMaxDepth || a.type() != b.type() || a.size() != b.size()) return where;
  if (!a.is_structured()) return a == b ? "" : where;
  for (auto one = a.begin(), other = b.begin(); one != a.end(); ++one, ++other) {
    std::string at = where;
    if (a.is_object()) {
      if (one.key() != other.key()) return where;
      at += (at.empty() ? "" : ", ") + one.key();
    } else {
      at += " " + std::to_string(std::distance(a.begin(), one));
    }
    if (std::string found = difference(*one, *other, at, depth + 1); !found.empty()) return found;
  }
  return {};
}

struct Unpacked {
  Json manifest;
  EvidenceContent content;
  std::string_view measured;
  std::string sectionFinding;
};

Expected<Json> jsonOf(const TapeEntry& entry) {
  Json json = Json::parse(entry.content, nullptr, false);
  if (json.is_discarded()) return inputError(entry.name, "is no JSON");
  return json;
}

/// Entries in their order; whatever is not as packEvidence makes it is refused.
class Entries {
 public:
  explicit Entries(const std::vector<TapeEntry>& all) : all_(all) {}
  Expected<TapeEntry> next(const std::string& name) {
    if (at_ >= all_.size() || all_[at_].name != name) return inputError(name, "is missing from the evidence pack");
    return all_[at_++];
  }

 private:
  const std::vector<TapeEntry>& all_;
  std::size_t at_ = 0;
};

Expected<void> unpackProfilesOf(Entries& entries, std::uint64_t count, EvidenceContent& content) {
  for (std::uint64_t first = 0; first < count; first += kBlockProfiles) {
    const auto entry = entries.next(numbered("profiles", first));
    if (!entry) return tl::unexpected(entry.error());
    auto block = unpackProfiles(bytesOf(entry->content));
    if (!block) return tl::unexpected(Error{entry->name, block.error().what, ErrorKind::Input});
    if (block->size() != std::min<std::uint64_t>(kBlockProfiles, count - first))
      return inputError(entry->name, "holds other profiles than it should");
    std::move(block->begin(), block->end(), std::back_inserter(content.profiles));
  }
  return {};
}

Expected<void> unpackPointsOf(Entries& entries, const Json& numbers, EvidenceContent& content) {
  content.exact = !numbers.empty();
  for (const Json& number : numbers) {
    const auto profile = number.get<std::uint64_t>();
    const auto entry = entries.next(numbered("points", profile));
    if (!entry) return tl::unexpected(entry.error());
    auto points = unpackPoints(bytesOf(entry->content));
    if (!points) return tl::unexpected(Error{entry->name, points.error().what, ErrorKind::Input});
    content.exact = content.exact && codingOf(bytesOf(entry->content)) == PointCoding::Exact;
    content.points.emplace(profile, std::move(*points));
  }
  return {};
}

/// May throw Json's exceptions.
Expected<Unpacked> unpack(const std::vector<TapeEntry>& all) {
  Entries entries(all);
  Unpacked pack;
  const auto manifest = entries.next("manifest.json").and_then(jsonOf);
  if (!manifest) return tl::unexpected(manifest.error());
  pack.manifest = *manifest;
  if (pack.manifest.at("format").get<int>() != kFormat)
    return inputError("manifest.json", "is of another format than this program knows; use a newer one");
  const auto profiles = pack.manifest.at("profiles").get<std::uint64_t>();
  if (profiles > kMaxProfiles) return inputError("manifest.json", "more profiles than a rail has");
  const auto rail = entries.next("rail.json").and_then(jsonOf);
  if (!rail) return tl::unexpected(rail.error());
  pack.content.rail = railFromJson(*rail);
  const auto recipe = entries.next("recipe.toml"), section = entries.next(kSectionFile),
             calibration = entries.next("calibration.toml");
  for (const auto* entry : {&recipe, &section, &calibration})
    if (!*entry) return tl::unexpected(entry->error());
  auto readRecipe = recipeFrom(recipe->content, section->content);
  if (!readRecipe) return tl::unexpected(readRecipe.error());
  pack.content.recipe = std::move(*readRecipe);
  if (toJson(pack.content.recipe.section) != section->content)
    pack.sectionFinding = "the section " + pack.content.recipe.section.name +
                          " of this program is not the one that the rail was measured against";
  auto readCalibration = parseCalibration(calibration->content, "calibration.toml");
  if (!readCalibration) return tl::unexpected(readCalibration.error());
  pack.content.calibration = std::move(*readCalibration);
  if (auto done = unpackProfilesOf(entries, profiles, pack.content); !done) return tl::unexpected(done.error());
  for (ProfileRecord& record : pack.content.profiles)
    for (const Dimension d : kDimensions) {
      const DimensionSummary& of = pack.content.rail.summary.dimensions[index(d)];
      record.dimensions[index(d)].nominalMm = of.nominalMm;
      record.dimensions[index(d)].lowerMm = of.lowerMm;
      record.dimensions[index(d)].upperMm = of.upperMm;
    }
  if (auto done = unpackPointsOf(entries, pack.manifest.at("points"), pack.content); !done)
    return tl::unexpected(done.error());
  const auto measured = entries.next("measured.json");
  if (!measured) return tl::unexpected(measured.error());
  pack.measured = measured->content;
  const auto digest = entries.next("digest.txt");
  if (!digest || digest->at != all.back().at) return inputError("digest.txt", "is not the last of the evidence pack");
  if (const std::string why = refusal(pack.content); !why.empty()) return inputError("evidence pack", why);
  return pack;
}

void compareMeasured(const Unpacked& pack, const Recomputed& again, EvidenceCheck& check) {
  check.lastBit = again.measured == pack.measured;
  if (check.lastBit) return;
  const Json was = Json::parse(pack.measured, nullptr, false), is = Json::parse(again.measured, nullptr, false);
  const std::string where = was.is_discarded() ? "measured.json" : difference(was, is, "", 0);
  if (check.sameMachine)
    check.findings.push_back("measured again it is not the same to the last bit" +
                             (where.empty() ? std::string() : ": " + where));
  else if (!where.empty())
    check.findings.push_back("measured again it is not the same: " + where);
}

/// The archive's texts, points and profiles of a rail.
struct Sources {
  EvidenceContent content;
  std::string recipe, calibration;
  std::map<std::uint64_t, Bytes> points;
};

Expected<Sources> sourcesOf(const RailArchive& rails, std::int64_t key) {
  Sources s;
  auto rail = rails.open(key, 1);
  if (!rail) return tl::unexpected(rail.error());
  s.content.rail = std::move(*rail);
  for (DimensionSummary& d : s.content.rail.summary.dimensions) d.track.clear();
  const std::string where = "rail " + s.content.rail.summary.rail.id;
  if (s.content.rail.state == RailState::Running) return inputError(where, "is still passing");
  const auto recipe = rails.recipeText(s.content.rail), calibration = rails.calibrationText(s.content.rail);
  if (!recipe) return tl::unexpected(recipe.error());
  if (!calibration) return tl::unexpected(calibration.error());
  if (recipe->empty() || calibration->empty()) return inputError(where, "its recipe or calibration was not kept");
  auto readRecipe = parseRecipe(*recipe, "recipe of " + where);
  if (!readRecipe) return tl::unexpected(readRecipe.error());
  s.content.recipe = std::move(*readRecipe);
  s.recipe = portable(s.content.recipe);
  s.calibration = *calibration;
  auto readCalibration = parseCalibration(*calibration, "calibration of " + where);
  if (!readCalibration) return tl::unexpected(readCalibration.error());
  s.content.calibration = std::move(*readCalibration);
  auto profiles = rails.profiles(key);
  if (!profiles) return tl::unexpected(profiles.error());
  s.content.profiles = std::move(*profiles);
  auto points = rails.packedPoints(key);
  if (!points) return tl::unexpected(points.error());
  if (points->empty())
    return inputError(where, "has no points in the archive, so that nothing of it can be measured again");
  s.points = std::move(*points);
  s.content.exact = true;
  for (const auto& [number, bytes] : s.points) {
    auto profile = unpackPoints(bytes);
    if (!profile)
      return tl::unexpected(
          Error{where + ", profile " + std::to_string(number), profile.error().what, ErrorKind::World});
    s.content.exact = s.content.exact && codingOf(bytes) == PointCoding::Exact;
    s.content.points.emplace(number, std::move(*profile));
  }
  return s;
}

std::string tapeOf(const Sources& s, const Recomputed& measured, const EvidenceBy& by) {
  Json numbers = Json::array();
  for (const auto& [number, bytes] : s.points) numbers.push_back(number);
  TapeWriter tape;
  tape.add("manifest.json", dumped({{"format", kFormat},
                                    {"what", "Evidence of one rail: vignole-cli evidence verify FILE"},
                                    {"packed", isoTime(systemTimeUs())},
                                    {"program", by.program},
                                    {"machine", by.machine},
                                    {"points_are", s.content.exact ? "exact" : "compact"},
                                    {"profiles", s.content.profiles.size()},
                                    {"points", numbers}}));
  tape.add("rail.json", dumped(toJson(s.content.rail)));
  tape.add("recipe.toml", s.recipe);
  tape.add(kSectionFile, toJson(s.content.recipe.section));
  tape.add("calibration.toml", s.calibration);
  for (std::size_t first = 0; first < s.content.profiles.size(); first += kBlockProfiles) {
    const std::size_t count = std::min(kBlockProfiles, s.content.profiles.size() - first);
    tape.add(numbered("profiles", first), textOf(packProfiles(std::span(s.content.profiles).subspan(first, count))));
  }
  for (const auto& [number, bytes] : s.points) tape.add(numbered("points", number), textOf(bytes));
  tape.add("measured.json", measured.measured);
  tape.add("digest.txt", digestOfBytes(tape.soFar()) + "\n");
  return tape.finish();
}

EvidenceCheck checkOf(const EvidenceContent& content) {
  EvidenceCheck check;
  check.rail = content.rail;
  check.profiles = content.profiles.size();
  check.profilesWithPoints = content.points.size();
  check.exactPoints = content.exact;
  return check;
}

}  // namespace

Expected<EvidencePack> packEvidence(const RailArchive& rails, std::int64_t key, const EvidenceBy& by,
                                    const std::function<void(double)>& progress) {
  if (sodium_init() < 0) return worldError("evidence", "the system gives no random numbers");
  const auto sources = sourcesOf(rails, key);
  if (!sources) return tl::unexpected(sources.error());
  const std::string where = "rail " + sources->content.rail.summary.rail.id;
  if (const std::string why = refusal(sources->content); !why.empty()) return inputError(where, why);
  const Recomputed measured = recompute(sources->content, progress);
  if (!measured.findings.empty())
    return worldError(where, "does not come out as it was measured (by version " + sources->content.rail.place.program +
                                 " on " + sources->content.rail.place.machine + "; this is " + by.program + " on " +
                                 by.machine + "): " + measured.findings.front());
  EvidencePack pack;
  pack.bytes = tapeOf(*sources, measured, by);
  pack.check = checkOf(sources->content);
  pack.check.digest = digestOfBytes(pack.bytes);
  pack.check.packedBy = by.program;
  pack.check.sameMachine = pack.check.lastBit = true;
  pack.check.verdict = measured.verdict;
  return pack;
}

Expected<EvidenceCheck> verifyEvidence(std::string_view bytes, const EvidenceBy& by,
                                       const std::function<void(double)>& progress) {
  if (sodium_init() < 0) return worldError("evidence", "the system gives no random numbers");
  const auto entries = readTape(bytes);
  if (!entries) return tl::unexpected(entries.error());
  if (entries->empty() || entries->back().name != "digest.txt")
    return inputError("digest.txt", "is not the last of the evidence pack");
  const TapeEntry& last = entries->back();
  if (last.content != digestOfBytes(bytes.substr(0, last.at)) + "\n")
    return inputError("digest.txt", "does not fit: the pack was changed or damaged");
  try {
    const auto pack = unpack(*entries);
    if (!pack) return tl::unexpected(pack.error());
    const Recomputed again = recompute(pack->content, progress);
    EvidenceCheck check = checkOf(pack->content);
    check.digest = digestOfBytes(bytes);
    check.packedAt = pack->manifest.at("packed").get<std::string>();
    check.packedBy = pack->manifest.at("program").get<std::string>();
    check.sameMachine = pack->manifest.at("machine").get<std::string>() == by.machine && check.packedBy == by.program;
    check.verdict = again.verdict;
    check.findings = again.findings;
    if (!pack->sectionFinding.empty()) check.findings.insert(check.findings.begin(), pack->sectionFinding);
    compareMeasured(*pack, again, check);
    return check;
  } catch (const Json::exception& failure) {
    return inputError("evidence pack", "holds a document that is none of it (" + std::string(failure.what()) + ")");
  } catch (const std::exception& failure) {
    return inputError("evidence pack", failure.what());
  }
}

}  // namespace vignole
