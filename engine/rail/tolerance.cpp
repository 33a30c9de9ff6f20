#include "engine/rail/tolerance.h"

#include "engine/files/toml_reader.h"
#include "engine/rail/catalogue.h"

namespace vignole {

namespace {

constexpr double kWidestMm = 100;

std::filesystem::path toleranceFile() { return resourceDirectory() / "rails" / "tolerances.toml"; }

struct Line {
  std::optional<Dimension> dimension;
  ToleranceLimits limits;
  bool applies = true;
};

Line readLine(TomlReader& file, const std::string& key, double heightMm, double massKgPerM) {
  Line line;
  const std::string name = file.text(key + ".dimension");
  line.dimension = dimensionFromName(name);
  if (!line.dimension) file.refuse(key + ".dimension", "is \"" + name + "\", which is no dimension");

  const auto below = [&](const char* condition, double value) {
    return !file.has(key + condition) || value < file.number(key + condition, 0, 1000);
  };
  const auto from = [&](const char* condition, double value) {
    return !file.has(key + condition) || value >= file.number(key + condition, 0, 1000);
  };
  // Every condition is read, whatever the others say: the file is checked whole.
  const bool height = below(".height_below_mm", heightMm), heightFrom = from(".height_from_mm", heightMm);
  const bool mass = below(".mass_below_kg_per_m", massKgPerM), massFrom = from(".mass_from_kg_per_m", massKgPerM);
  line.applies = height && heightFrom && mass && massFrom;

  if (file.has(key + ".lower_mm")) line.limits.lowerMm = file.number(key + ".lower_mm", -kWidestMm, kWidestMm);
  if (file.has(key + ".upper_mm")) line.limits.upperMm = file.number(key + ".upper_mm", -kWidestMm, kWidestMm);
  if (line.limits.lowerMm && line.limits.upperMm && *line.limits.lowerMm > *line.limits.upperMm)
    file.refuse(key + ".lower_mm", "is above upper_mm; exchange them");
  const std::string confidence = file.text(key + ".confidence");
  if (confidence != "S" && confidence != "K") file.refuse(key + ".confidence", "is not \"S\" or \"K\"");
  return line;
}

/// Reads all classes of a kind ("profile", "straightness"), so that the file is checked whole, and uses the wanted one.
Expected<void> readClasses(TomlReader& file, const std::string& kind, std::string_view wanted, double heightMm,
                           double massKgPerM, PerDimension<ToleranceLimits>& result) {
  std::string there;
  bool found = false;
  for (const std::string& name : file.keys(kind)) {
    const std::string key = kind + "." + name;
    there += there.empty() ? "" : ", ";
    there += name;
    found = found || name == wanted;
    (void)file.text(key + ".title");
    const std::size_t lines = file.size(key + ".limits");
    for (std::size_t i = 0; i < lines; ++i) {
      const Line line = readLine(file, key + ".limits." + std::to_string(i), heightMm, massKgPerM);
      if (name == wanted && line.applies && line.dimension) result.at(index(*line.dimension)) = line.limits;
    }
  }
  if (!found) return inputError(kind + " class \"" + std::string(wanted) + "\"", "does not exist; there are " + there);
  return {};
}

}  // namespace

Expected<PerDimension<ToleranceLimits>> toleranceLimits(const Section& section, std::string_view profileClass,
                                                        std::string_view straightnessClass) {
  auto file = TomlReader::load(toleranceFile());
  if (!file) return tl::unexpected(file.error());
  (void)file->text("note");
  const double height = section.heightMm(), mass = properties(section).massKgPerM;
  PerDimension<ToleranceLimits> limits;
  const auto profile = readClasses(*file, "profile", profileClass, height, mass, limits);
  const auto straightness = readClasses(*file, "straightness", straightnessClass, height, mass, limits);
  if (auto good = file->finish(); !good) return tl::unexpected(good.error());
  if (!profile) return tl::unexpected(profile.error());
  if (!straightness) return tl::unexpected(straightness.error());
  return limits;
}

std::string toleranceNote() {
  auto file = TomlReader::load(toleranceFile());
  return file ? file->text("note", "") : "";
}

}  // namespace vignole
