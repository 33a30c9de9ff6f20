#include "engine/faults/camera_fault.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace vignole {

namespace {

constexpr std::uint64_t kCameras = 4;

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

std::string plain(double value) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

/// What a kind of fault may carry after its '=', and where it makes sense.
struct FaultWord {
  std::string_view name;
  enum class Needs { Nothing, Number, MayNumber, Count, Text } needs;
  double min, max;
  double fallback;
  enum class Of { Picture, Stream, Network } of;
};

using Needs = FaultWord::Needs;
using Of = FaultWord::Of;
constexpr double kAny = std::numeric_limits<double>::infinity();
constexpr double kMaxFrameId = 9007199254740992;  // up to where a double counts every number
constexpr std::array<FaultWord, 19> kFaults = {{{"packet-loss", Needs::Number, 0, 1, 0, Of::Network},
                                                {"frame-loss", Needs::Number, 0, 1, 0, Of::Stream},
                                                {"missed-trigger", Needs::Number, 0, 1, 0, Of::Stream},
                                                {"no-resend", Needs::Nothing, 0, 0, 0, Of::Network},
                                                {"ignore-resend", Needs::Nothing, 0, 0, 0, Of::Network},
                                                {"mute-control", Needs::Nothing, 0, 0, 0, Of::Network},
                                                {"die", Needs::Nothing, 0, 0, 0, Of::Stream},
                                                {"revive", Needs::Nothing, 0, 0, 0, Of::Stream},
                                                {"start-id", Needs::Count, 1, kMaxFrameId, 0, Of::Network},
                                                {"ids-64", Needs::Nothing, 0, 0, 0, Of::Network},
                                                {"reset-ids", Needs::Nothing, 0, 0, 0, Of::Network},
                                                {"corrupt-leader", Needs::MayNumber, 0, 1, 1, Of::Network},
                                                {"slow", Needs::Number, 0, 60000, 0, Of::Stream},
                                                {"black", Needs::Nothing, 0, 0, 0, Of::Picture},
                                                {"saturated", Needs::Nothing, 0, 0, 0, Of::Picture},
                                                {"move", Needs::Number, -50, 50, 0, Of::Picture},
                                                {"turn", Needs::Number, -20, 20, 0, Of::Picture},
                                                {"wrong-rail", Needs::Text, 0, kAny, 0, Of::Picture},
                                                {"scale", Needs::MayNumber, 0, 1, 0.6, Of::Picture}}};

const FaultWord* wordOf(std::string_view kind) {
  const auto* found = std::find_if(kFaults.begin(), kFaults.end(), [&](const FaultWord& w) { return w.name == kind; });
  return found == kFaults.end() ? nullptr : found;
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
  if (value && *value == "off") {
    fault.off = true;
    return {};
  }
  if (word.needs == Needs::Text) {
    if (!value || value->empty()) return inputError(where, "needs a section; write " + kind + "=NAME");
    fault.text = *value;
    return {};
  }
  if (word.needs == Needs::Nothing && value) return inputError(where, kind + " takes no value");
  fault.value = word.fallback;
  if (word.needs == Needs::Nothing || (word.needs == Needs::MayNumber && !value)) return {};
  const auto number = value ? parseNumber(*value) : std::nullopt;
  const bool whole = word.needs != Needs::Count || (number && *number == std::floor(*number));
  if (!number || *number < word.min || *number > word.max || !whole)
    return inputError(where, std::string("needs a ") + (word.needs == Needs::Count ? "whole number" : "number") +
                                 " from " + plain(word.min) + " to " + plain(word.max) + "; write " + kind + "=NUMBER");
  fault.value = *number;
  return {};
}

Expected<Fault> parse(const std::string& specification, FaultPlace place) {
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
    if (!camera || *camera < 1 || *camera > kCameras)
      return inputError(where, "\"" + std::string(rest.substr(at + 1)) + "\" is no camera; write @1 to @4");
    fault.camera = static_cast<int>(*camera) - 1;
    rest = rest.substr(0, at);
  }
  const std::size_t equals = rest.find('=');
  fault.kind = rest.substr(0, equals);
  const auto value =
      equals == std::string_view::npos ? std::nullopt : std::optional<std::string_view>(rest.substr(equals + 1));
  const FaultWord* word = wordOf(fault.kind);
  if (word != nullptr && place == FaultPlace::Rig && word->of == Of::Network)
    return inputError(where, "happens on a network only; serve the rig with vignole-cli simulate serve");
  if (word == nullptr)
    return inputError(where, std::string("there is no such fault ") +
                                 (place == FaultPlace::Rig ? "in the virtual rig" : "of a camera") + "; there are " +
                                 faultKinds(place));
  if (auto read = readValue(fault, *word, value, where); !read) return tl::unexpected<Error>(read.error());
  return fault;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace

std::string faultKinds(FaultPlace place) {
  std::string names;
  for (const FaultWord& word : kFaults) {
    if (place == FaultPlace::Rig && word.of == Of::Network) continue;
    names += names.empty() ? "" : ", ";
    names += word.name;
    if (word.needs == Needs::Number || word.needs == Needs::Count) names += "=NUMBER";
    if (word.needs == Needs::MayNumber) names += "[=NUMBER]";
    if (word.needs == Needs::Text) names += "=NAME";
  }
  return names;
}

Expected<Fault> parseFault(const std::string& specification) { return parse(specification, FaultPlace::Rig); }
Expected<Fault> parseDeviceFault(const std::string& specification) { return parse(specification, FaultPlace::Device); }

Expected<std::vector<Fault>> parseFaultLine(const std::string& line, std::uint64_t now, const std::string& where) {
  std::string_view rest = trimmed(std::string_view(line).substr(0, line.find('#')));
  if (rest.empty()) return std::vector<Fault>();
  std::uint64_t from = now, to = ~std::uint64_t{0};
  if (const std::size_t colon = rest.find(':'); colon != std::string_view::npos) {
    const std::string_view range = trimmed(rest.substr(0, colon));
    rest = trimmed(rest.substr(colon + 1));
    Fault times;
    if (auto read = readRange(times, range, where); !read) return tl::unexpected<Error>(read.error());
    from = times.from;
    if (range.find('-') != std::string_view::npos) to = times.to;
    if (rest.find(':') != std::string_view::npos)
      return inputError(where, "the line begins with its triggers; write FROM-TO there and no second ':'");
  }
  auto fault = parse(std::string(rest), FaultPlace::Device);
  if (!fault) return inputError(where, fault.error().message());
  fault->from = from;
  fault->to = to;
  return std::vector<Fault>{*std::move(fault)};
}

Expected<std::vector<Fault>> parseFaultScript(const std::string& text, const std::string& where) {
  std::vector<Fault> faults;
  std::size_t begin = 0, number = 1;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    auto read = parseFaultLine(line, 0, where + ":" + std::to_string(number));
    if (!read) return read;
    const std::string_view meat = trimmed(std::string_view(line).substr(0, line.find('#')));
    if (!read->empty() && meat.find(':') == std::string_view::npos)
      return inputError(where + ":" + std::to_string(number), "lacks its trigger; write FROM: KIND[=VALUE][@CAMERA]");
    faults.insert(faults.end(), read->begin(), read->end());
    begin = end + 1;
    ++number;
  }
  return faults;
}

bool concernsPicture(const Fault& fault) {
  const FaultWord* word = wordOf(fault.kind);
  return word != nullptr && word->of == Of::Picture;
}

const Fault* activeFault(std::span<const Fault> faults, std::string_view kind, int camera, std::uint64_t trigger) {
  const Fault* found = nullptr;
  for (const Fault& f : faults)
    if (f.kind == kind && (f.camera < 0 || camera < 0 || f.camera == camera) && trigger >= f.from && trigger <= f.to)
      found = &f;
  return found == nullptr || found->off ? nullptr : found;
}

bool cameraDead(std::span<const Fault> faults, int camera, std::uint64_t trigger) {
  const Fault* die = activeFault(faults, "die", camera, trigger);
  if (die == nullptr) return false;
  return std::none_of(faults.begin(), faults.end(), [&](const Fault& f) {
    return f.kind == "revive" && !f.off && (f.camera < 0 || f.camera == camera) && f.from > die->from &&
           f.from <= trigger;
  });
}

}  // namespace vignole
