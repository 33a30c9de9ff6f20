#include "engine/target/pin_plate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/files/atomic_file.h"
#include "engine/files/toml_reader.h"

namespace vignole {

namespace {

constexpr double kFarthestMm = 1000, kLargestRadiusMm = 100, kLargestUncertaintyMm = 5;
constexpr std::size_t kFewestPins = 4;
constexpr double kStraightMm = 1;  // pins within this of one line say nothing across it

/// What makes a set of pins unfit to calibrate with; empty if nothing does.
std::string flaw(const std::vector<Pin>& pins) {
  if (pins.size() < kFewestPins)
    return "has " + std::to_string(pins.size()) + " pins; at least " + std::to_string(kFewestPins) + " are needed";
  for (std::size_t i = 0; i < pins.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const std::string both = std::to_string(pins[j].number) + " and " + std::to_string(pins[i].number);
      if (pins[i].number == pins[j].number)
        return "has pin number " + std::to_string(pins[i].number) + " twice; give each pin its own";
      if ((pins[i].centreMm - pins[j].centreMm).norm() <= pins[i].radiusMm + pins[j].radiusMm)
        return "has pins " + both + " overlapping; correct their centres or radii";
    }
  Point2 mean(0, 0);
  for (const Pin& pin : pins) mean += pin.centreMm / static_cast<double>(pins.size());
  double xx = 0, xy = 0, yy = 0;
  for (const Pin& pin : pins) {
    const Point2 d = pin.centreMm - mean;
    xx += d.x() * d.x(), xy += d.x() * d.y(), yy += d.y() * d.y();
  }
  const double narrow = (xx + yy) / 2 - std::hypot((xx - yy) / 2, xy);
  if (narrow / static_cast<double>(pins.size()) < kStraightMm * kStraightMm)
    return "has all its pins on one line; they must spread over the plane";
  return {};
}

double standardUncertainty(double toleranceMm) { return toleranceMm / std::sqrt(3.0); }

Expected<PinPlate> readToml(const std::filesystem::path& file) {
  auto toml = TomlReader::load(file);
  if (!toml) return tl::unexpected<Error>(toml.error());
  PinPlate plate;
  plate.id = toml->text("id", file.stem().string());
  plate.measured = toml->boolean("measured", false);
  plate.protrusionMm = toml->number("protrusion_mm", 0, kFarthestMm, plate.protrusionMm);
  plate.surfaceMm = toml->number("surface_mm", 0, kFarthestMm, plate.surfaceMm);
  const double uMm = standardUncertainty(toml->number("tolerance_mm", 0, kLargestUncertaintyMm, 0.0));
  const double uRadiusMm = standardUncertainty(toml->number("radius_tolerance_mm", 0, kLargestUncertaintyMm, 0.0));
  const std::size_t count = toml->size("pin");
  for (std::size_t i = 0; i < count; ++i) {
    const std::string at = "pin." + std::to_string(i) + ".";
    Pin pin;
    pin.number = toml->integer(at + "number", 1, 9999);
    pin.centreMm = {toml->number(at + "x_mm", -kFarthestMm, kFarthestMm),
                    toml->number(at + "y_mm", -kFarthestMm, kFarthestMm)};
    pin.radiusMm = toml->number(at + "radius_mm", 0.1, kLargestRadiusMm);
    pin.uCentreMm = toml->number(at + "u_mm", 0, kLargestUncertaintyMm, uMm);
    pin.uRadiusMm = toml->number(at + "u_radius_mm", 0, kLargestUncertaintyMm, uRadiusMm);
    plate.pins.push_back(pin);
  }
  if (const auto read = toml->finish(); !read) return tl::unexpected<Error>(read.error());
  return plate;
}

Expected<PinPlate> readJson(const std::filesystem::path& file) {
  const auto text = readFile(file);
  if (!text) return tl::unexpected<Error>(text.error());
  const auto document = nlohmann::json::parse(*text, nullptr, false);
  const auto refuse = [&](const std::string& what) { return inputError(file.string(), what); };
  if (!document.is_array()) return refuse("is no JSON list of pins; write [[x, y, radius], ...] in mm");
  PinPlate plate;
  plate.id = file.stem().string();
  for (const auto& entry : document) {
    Pin pin;
    pin.number = static_cast<int>(plate.pins.size()) + 1;
    const std::string where = "pin " + std::to_string(pin.number);
    if (!entry.is_array() || entry.size() != 3 ||
        !std::all_of(entry.begin(), entry.end(), [](const auto& v) { return v.is_number(); }))
      return refuse(where + " is not [x, y, radius] in mm; correct it");
    pin.centreMm = {entry[0].get<double>(), entry[1].get<double>()};
    pin.radiusMm = entry[2].get<double>();
    if (!(pin.centreMm.cwiseAbs().maxCoeff() <= kFarthestMm && pin.radiusMm >= 0.1 && pin.radiusMm <= kLargestRadiusMm))
      return refuse(where + " lies beyond 1,000 mm or has no radius from 0.1 to 100 mm; correct it");
    plate.pins.push_back(pin);
  }
  return plate;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text)
    if (static_cast<unsigned char>(c) >= 0x20)
      out += (c == '"' || c == '\\') ? std::string("\\") + c : std::string(1, c);
  return out + "\"";
}

}  // namespace

Expected<PinPlate> loadPinPlate(const std::filesystem::path& file) {
  auto plate = file.extension() == ".json" ? readJson(file) : readToml(file);
  if (!plate) return plate;
  if (const std::string wrong = flaw(plate->pins); !wrong.empty()) return inputError(file.string(), wrong);
  return plate;
}

Expected<void> savePinPlate(const PinPlate& plate, const std::filesystem::path& file) {
  const auto number = [](double value) {
    std::string text = nlohmann::json(value).dump();  // the shortest that reads back as the same number
    return text;
  };
  std::string text = "format = 1\nid = " + quoted(plate.id) + "\nmeasured = " + (plate.measured ? "true" : "false") +
                     "\nprotrusion_mm = " + number(plate.protrusionMm) + "\nsurface_mm = " + number(plate.surfaceMm) +
                     "\n";
  for (const Pin& pin : plate.pins)
    text += "\n[[pin]]\nnumber = " + std::to_string(pin.number) + "\nx_mm = " + number(pin.centreMm.x()) +
            "\ny_mm = " + number(pin.centreMm.y()) + "\nradius_mm = " + number(pin.radiusMm) +
            "\nu_mm = " + number(pin.uCentreMm) + "\nu_radius_mm = " + number(pin.uRadiusMm) + "\n";
  return writeFile(file, text, true);
}

PinPlate plate13() {
  struct Place {
    double x, y, radius;
  };
  constexpr std::array<Place, 13> kPlaces = {{{0, 86, 8},
                                              {-40, 40, 5},
                                              {-31, 123, 4},
                                              {40, 77, 4},
                                              {66, 152, 5},
                                              {-48, 171, 6},
                                              {20, -2, 4},
                                              {-79, 117, 5},
                                              {79, 106, 5},
                                              {-76, -5, 5},
                                              {78, 2, 5},
                                              {-73, 175, 6},
                                              {79, 177, 5}}};
  PinPlate plate;
  plate.id = "plate13";
  for (const Place& place : kPlaces)
    plate.pins.push_back({static_cast<int>(plate.pins.size()) + 1, {place.x, place.y}, place.radius, 0, 0});
  return plate;
}

}  // namespace vignole
