// The words of the command line for effects and faults.

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "engine/simulator/virtual_rig.h"

namespace vignole {

namespace {

struct EffectWord {
  std::string_view name;
  double Effects::*value;
  double max;
};

constexpr std::array<EffectWord, 11> kEffects = {{{"read-noise", &Effects::readNoiseDn, 50},
                                                  {"shot-noise", &Effects::shotNoise, 100},
                                                  {"speckle", &Effects::speckle, 1},
                                                  {"scale", &Effects::scale, 1},
                                                  {"reflections", &Effects::reflections, 1},
                                                  {"crosstalk", &Effects::crosstalk, 1},
                                                  {"ambient", &Effects::ambientDn, 200},
                                                  {"defocus", &Effects::defocus, 5},
                                                  {"motion", &Effects::motion, 1},
                                                  {"wander", &Effects::wander, 5},
                                                  {"vibration", &Effects::vibration, 20}}};

std::optional<double> parseNumber(std::string_view text) {
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

std::optional<std::uint64_t> parseCount(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

std::string effectNames() {
  std::string names;
  for (const EffectWord& word : kEffects) names += std::string(word.name) + ", ";
  return names + "all";
}

std::string plain(double value) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

/// What a kind of fault may carry after its '='.
struct FaultWord {
  std::string_view name;
  enum class Needs { Nothing, Number, MayNumber, Text } needs;
  double min, max;
  double fallback;
};

constexpr double kRail = std::numeric_limits<double>::infinity();
using Needs = FaultWord::Needs;
constexpr std::array<FaultWord, 11> kFaults = {{{"frame-loss", Needs::Number, 0, 1, 0},
                                                {"missed-trigger", Needs::Number, 0, 1, 0},
                                                {"die", Needs::Nothing, 0, 0, 0},
                                                {"revive", Needs::Nothing, 0, 0, 0},
                                                {"slow", Needs::Number, 0, 60000, 0},
                                                {"black", Needs::Nothing, 0, 0, 0},
                                                {"saturated", Needs::Nothing, 0, 0, 0},
                                                {"move", Needs::Number, -50, 50, 0},
                                                {"turn", Needs::Number, -20, 20, 0},
                                                {"wrong-rail", Needs::Text, 0, kRail, 0},
                                                {"scale", Needs::MayNumber, 0, 1, 0.6}}};

std::string faultNames() {
  std::string names;
  for (const FaultWord& word : kFaults) {
    names += names.empty() ? "" : ", ";
    names += word.name;
    if (word.needs == Needs::Number) names += "=NUMBER";
    if (word.needs == Needs::MayNumber) names += "[=NUMBER]";
    if (word.needs == Needs::Text) names += "=NAME";
  }
  return names;
}

Expected<void> readRange(Fault& fault, std::string_view range, const std::string& where) {
  const std::size_t dash = range.find('-');
  const auto from = parseCount(range.substr(0, dash));
  std::optional<std::uint64_t> to = from;
  if (dash != std::string_view::npos)
    to = dash + 1 == range.size() ? std::optional(~std::uint64_t{0}) : parseCount(range.substr(dash + 1));
  if (!from || !to || *to < *from)
    return inputError(where, "\"" + std::string(range) + "\" is no range of triggers; write FROM-TO, such as 100-200");
  fault.from = *from;
  fault.to = *to;
  return {};
}

Expected<void> readValue(Fault& fault, const FaultWord& word, std::optional<std::string_view> value,
                         const std::string& where) {
  const std::string kind(word.name);
  if (word.needs == Needs::Text) {
    if (!value || value->empty()) return inputError(where, "needs a section; write " + kind + "=NAME");
    fault.text = *value;
    return {};
  }
  if (word.needs == Needs::Nothing && value) return inputError(where, kind + " takes no value");
  fault.value = word.fallback;
  if (word.needs == Needs::Nothing || (word.needs == Needs::MayNumber && !value)) return {};
  const auto number = value ? parseNumber(*value) : std::nullopt;
  if (!number || *number < word.min || *number > word.max)
    return inputError(
        where, "needs a number from " + plain(word.min) + " to " + plain(word.max) + "; write " + kind + "=NUMBER");
  fault.value = *number;
  return {};
}

}  // namespace

std::vector<std::pair<std::string, double>> list(const Effects& effects) {
  std::vector<std::pair<std::string, double>> out;
  out.reserve(kEffects.size());
  for (const EffectWord& word : kEffects) out.emplace_back(word.name, effects.*word.value);
  return out;
}

Expected<void> applyEffect(Effects& effects, const std::string& specification) {
  const std::string where = "effect \"" + specification + "\"";
  const std::size_t equals = specification.find('=');
  const std::string name = specification.substr(0, equals);
  if (equals == std::string::npos) return inputError(where, "lacks its value; write NAME=on, NAME=off or NAME=NUMBER");
  const std::string value = specification.substr(equals + 1);
  const auto number = parseNumber(value);
  if (value != "on" && value != "off" && !number)
    return inputError(where, "\"" + value + "\" is neither on nor off nor a number");
  bool known = false;
  for (const EffectWord& word : kEffects) {
    if (name != word.name && name != "all") continue;
    known = true;
    if (name == "all" && number)
      return inputError(where, "all effects at once can only be on or off; their numbers mean different things");
    if (number && (*number < 0 || *number > word.max))
      return inputError(where, "is out of range; allowed is 0 to " + plain(word.max));
    effects.*word.value = number ? *number : value == "on" ? Effects{}.*word.value : 0.0;
  }
  if (!known) return inputError(where, "there is no effect of this name; there are " + effectNames());
  return {};
}

namespace {

constexpr double kMaxDeviationMm = 100;

Expected<void> applyDeviation(VirtualRigSettings& settings, const std::string& specification) {
  const std::string where = "deviation \"" + specification + "\"";
  const std::size_t equals = specification.find('=');
  const auto dimension = dimensionFromName(specification.substr(0, equals));
  if (!dimension) {
    std::string names;
    for (const Dimension d : kDimensions) names += (names.empty() ? "" : ", ") + std::string(name(d));
    return inputError(where, "there is no such dimension; there are " + names);
  }
  const auto value =
      equals == std::string::npos ? std::optional<double>{} : parseNumber(specification.substr(equals + 1));
  if (!value || !(std::abs(*value) <= kMaxDeviationMm))
    return inputError(where, "needs a number of millimetres; write " + std::string(name(*dimension)) + "=MM");
  settings.deviationMm[index(*dimension)] = *value;
  return {};
}

}  // namespace

Expected<Fault> parseFault(const std::string& specification) {
  const std::string where = "fault \"" + specification + "\"";
  std::string_view rest = specification;
  Fault fault;
  // From the back, so that the name of a section may hold any other character.
  if (const std::size_t colon = rest.rfind(':'); colon != std::string_view::npos) {
    if (auto read = readRange(fault, rest.substr(colon + 1), where); !read) return tl::unexpected<Error>(read.error());
    rest = rest.substr(0, colon);
  }
  if (const std::size_t at = rest.rfind('@'); at != std::string_view::npos) {
    const auto camera = parseCount(rest.substr(at + 1));
    if (!camera || *camera < 1 || *camera > kCameraCount)
      return inputError(where, "\"" + std::string(rest.substr(at + 1)) + "\" is no camera; write @1 to @4");
    fault.camera = static_cast<int>(*camera) - 1;
    rest = rest.substr(0, at);
  }
  const std::size_t equals = rest.find('=');
  fault.kind = rest.substr(0, equals);
  const auto value =
      equals == std::string_view::npos ? std::nullopt : std::optional<std::string_view>(rest.substr(equals + 1));
  for (const FaultWord& word : kFaults)
    if (fault.kind == word.name) {
      if (auto read = readValue(fault, word, value, where); !read) return tl::unexpected<Error>(read.error());
      return fault;
    }
  return inputError(where, "there is no such fault in the virtual rig; there are " + faultNames());
}

Expected<void> applyWords(VirtualRigSettings& settings, const std::vector<std::string>& effects,
                          const std::vector<std::string>& deviations, const std::vector<std::string>& faults) {
  for (const std::string& effect : effects)
    if (auto applied = applyEffect(settings.effects, effect); !applied) return applied;
  for (const std::string& deviation : deviations)
    if (auto applied = applyDeviation(settings, deviation); !applied) return applied;
  for (const std::string& text : faults) {
    auto fault = parseFault(text);
    if (!fault) return tl::unexpected<Error>(fault.error());
    settings.faults.push_back(*std::move(fault));
  }
  return {};
}

}  // namespace vignole
