#include "gui/rails/rail_export.h"

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "engine/files/atomic_file.h"

namespace vignole {

namespace {

using Json = nlohmann::ordered_json;

/// A point as decimal sign whatever the language; to the nm that is stored.
std::string number(double value) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 6);
  return {text.data(), end.ptr};
}

std::string csvOf(const StoredRail& rail, const std::vector<ProfileRecord>& profiles) {
  std::string text = "profile,position_mm";
  for (const DimensionSummary& d : rail.summary.dimensions) {
    const std::string word(name(d.dimension));
    text += "," + word + "_mm," + word + "_u_mm," + word + "_verdict";
  }
  text += "\n";
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    text += std::to_string(i + 1) + "," + number(profiles[i].positionMm);
    for (const DimensionResult& r : profiles[i].dimensions) {
      text += "," + (r.valueMm ? number(*r.valueMm) : std::string());
      text += "," + (r.valueMm ? number(r.uMm) : std::string()) + "," + std::string(name(r.verdict));
    }
    text += "\n";
  }
  return text;
}

Json optional(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json jsonOf(const DimensionSummary& d) {
  Json json = {{"verdict", name(d.verdict)},      {"nominal_mm", d.nominalMm},    {"lower_mm", optional(d.lowerMm)},
               {"upper_mm", optional(d.upperMm)}, {"profiles", d.values.count()}, {"not_measured", d.notMeasured}};
  if (d.values.count() > 0) {
    json["mean_mm"] = d.meanMm();
    json["sd_mm"] = d.values.sd();
    json["min_mm"] = d.values.min();
    json["max_mm"] = d.values.max();
    json["u_mm"] = d.uMm;
  }
  json["exceptions"] = Json::array();
  for (const DimensionException& e : d.exceptions)
    json["exceptions"].push_back({{"from_m", e.fromM}, {"to_m", e.toM}, {"worst_mm", e.worstMm}});
  return json;
}

std::string jsonOf(const StoredRail& rail, const std::vector<ProfileRecord>& profiles) {
  const RailSummary& s = rail.summary;
  Json json = {{"rail", s.rail.id},
               {"heat", s.rail.heat},
               {"strand", rail.papers.strand},
               {"order", rail.papers.orderNumber},
               {"section", s.rail.sectionName},
               {"temperature_c", s.rail.temperatureC},
               {"recipe", s.recipe},
               {"calibration", s.calibrationId},
               {"source", rail.place.source},
               {"began", isoTime(rail.beganUs)},
               {"ended", isoTime(rail.endedUs)},
               {"length_m", s.lengthM},
               {"verdict", name(s.verdict)}};
  for (const DimensionSummary& d : s.dimensions) json["dimensions"][std::string(name(d.dimension))] = jsonOf(d);
  Json rows = Json::array();
  for (const ProfileRecord& profile : profiles) {
    Json row = {{"position_mm", profile.positionMm}};
    for (const Dimension d : kDimensions) {
      const DimensionResult& r = profile.dimensions[index(d)];
      Json& cell = row[std::string(name(d))];
      cell = {{"verdict", name(r.verdict)}, {"value_mm", optional(r.valueMm)}};
      if (r.valueMm)
        cell["u_mm"] = r.uMm;
      else
        cell["reason"] = r.reason;
    }
    rows.push_back(std::move(row));
  }
  json["profiles"] = std::move(rows);
  return json.dump(1) + "\n";
}

}  // namespace

Expected<void> exportRail(const StoredRail& rail, const std::vector<ProfileRecord>& profiles,
                          const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".csv") return writeFile(file, csvOf(rail, profiles));
  if (extension == ".json") return writeFile(file, jsonOf(rail, profiles));
  return inputError(file.string(), "a rail is exported as .csv or .json; give the file one of these extensions");
}

}  // namespace vignole
