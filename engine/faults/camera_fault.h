#pragma once
// What can go wrong with a camera, in the words of the command line: the same for the virtual rig, for the cameras
// that are simulated on a network, and for training.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"

namespace vignole {

/// "frame-loss=0.01@2:100-200". The kinds are listed by faultKinds().
struct Fault {
  std::string kind;
  double value = 0;
  std::string text;                    ///< for wrong-rail: the section
  int camera = -1;                     ///< 0..3, -1 all
  std::uint64_t from = 0, to = ~0ULL;  ///< triggers, inclusive
  bool off = false;                    ///< "frame-loss=off@2:300-": ends what an earlier fault of the kind began
};

/// Where a fault can happen: faults of the picture anywhere, of the stream in a source, of the network on devices.
enum class FaultPlace { Rig, Device };

/// KIND[=VALUE|=off][@CAMERA][:FROM-TO]. parseFault: those that make sense without a network (the virtual rig);
/// parseDeviceFault: all.
[[nodiscard]] Expected<Fault> parseFault(const std::string& specification);
[[nodiscard]] Expected<Fault> parseDeviceFault(const std::string& specification);
/// The kinds with what they take, as a list for people.
[[nodiscard]] std::string faultKinds(FaultPlace place);

/// A script: one fault a line, "FROM[-TO]: KIND[=VALUE|=off][@CAMERA]" (without TO: from then on), empty lines, and
/// comments behind '#'. Errors name `where` and the line.
[[nodiscard]] Expected<std::vector<Fault>> parseFaultScript(const std::string& text, const std::string& where);
/// One line of a script; without FROM it begins at `now`. Nothing for an empty line.
[[nodiscard]] Expected<std::vector<Fault>> parseFaultLine(const std::string& line, std::uint64_t now,
                                                          const std::string& where);

/// black, saturated, move, turn, wrong-rail, scale: what the picture shows, not how it arrives.
[[nodiscard]] bool concernsPicture(const Fault& fault);

/// The last fault of a kind that is on; camera -1: any. Null if none is.
[[nodiscard]] const Fault* activeFault(std::span<const Fault> faults, std::string_view kind, int camera,
                                       std::uint64_t trigger);
/// Whether the camera is dead: from the trigger of "die" to that of a later "revive", or to die's own end.
[[nodiscard]] bool cameraDead(std::span<const Fault> faults, int camera, std::uint64_t trigger);

}  // namespace vignole
