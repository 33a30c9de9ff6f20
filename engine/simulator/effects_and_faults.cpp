// The words of the command line for effects and deviations; those for faults are in engine/faults.

#include <array>
#include <charconv>
#include <cmath>
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

std::string effectNames() {
  std::string names;
  for (const EffectWord& word : kEffects) names += std::string(word.name) + ", ";
  return names + "all";
}

std::string plain(double value) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
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
