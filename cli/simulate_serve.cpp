// vignole-cli simulate serve: the virtual rig as GigE Vision devices on loopback.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <array>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <poll.h>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

#include "cli/console.h"
#include "cli/interruption.h"
#include "cli/simulate.h"
#include "engine/gige_device/device_rig.h"
#include "engine/recipe/recipe.h"
#include "engine/simulator/frames_ahead.h"

namespace vignole::cli {

namespace {

using gige_device::DeviceRig;

struct ServeOptions {
  int cameras = 4;
  std::string address = "127.0.0.11", recipe = "60E1 X/A", recording, script, json;
  std::optional<double> rateHz, seconds;
  double gbps = 1, lengthM = 0, gapM = 0.6, spacingMm = 15, speedMPerS = 1, exposureMs = 15, temperatureC = 20;
  std::uint64_t rails = 0, seed = 1;
  std::optional<std::uint64_t> rigSeed;
  std::vector<std::string> faults, effects, deviations;
  bool broadcast = false, quiet = false;
};

/// Where the frames come from, and whose they are.
struct Shown {
  std::shared_ptr<FrameProvider> frames;
  std::vector<std::string> serials;
  int widthPx = 0, heightPx = 0;
};

Expected<std::vector<Fault>> readFaults(const ServeOptions& o) {
  std::vector<Fault> faults;
  for (const std::string& text : o.faults) {
    auto fault = parseDeviceFault(text);
    if (!fault) return tl::unexpected<Error>(fault.error());
    faults.push_back(*std::move(fault));
  }
  if (o.script.empty() || o.script == "-") return faults;
  std::ifstream file(o.script, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file.is_open() || file.bad()) return inputError(o.script, "cannot be read; name a file of faults, or -");
  auto scripted = parseFaultScript(text, o.script);
  if (scripted)
    faults.insert(faults.end(), scripted->begin(), scripted->end());
  else
    return scripted;
  return faults;
}

Expected<Shown> virtualRig(const ServeOptions& o, const std::vector<Fault>& faults) {
  const auto recipe = findRecipe(o.recipe);
  if (!recipe) return tl::unexpected<Error>(recipe.error());
  VirtualRigSettings settings;
  settings.section = recipe->section;
  settings.parameters = recipe->parameters;
  settings.seed = o.seed;
  settings.rigSeed = o.rigSeed;
  settings.spacingMm = o.spacingMm;
  settings.speedMmPerS = 1000 * o.speedMPerS;
  settings.exposureMs = o.exposureMs;
  settings.temperatureC = o.temperatureC;
  if (auto applied = applyWords(settings, o.effects, o.deviations, {}); !applied)
    return tl::unexpected<Error>(applied.error());
  for (const Fault& fault : faults)
    if (concernsPicture(fault)) settings.faults.push_back(fault);
  const auto rig = VirtualRig::create(std::move(settings));
  if (!rig) return tl::unexpected<Error>(rig.error());
  FramesAheadSettings ahead;
  ahead.cameras = o.cameras;
  const auto triggersOf = [&](double metres) {
    return static_cast<std::uint64_t>(std::floor(1000 * metres / o.spacingMm + 1e-9));
  };
  if (o.lengthM > 0) {
    ahead.schedule.railTriggers = triggersOf(o.lengthM);
    ahead.schedule.gapTriggers = triggersOf(o.gapM);
    ahead.schedule.rails = o.rails;
    if (ahead.schedule.railTriggers == 0) return inputError("--length", "is shorter than the spacing");
  } else if (o.rails > 0) {
    return inputError("--rails", "needs the length of a rail; give --length METRES");
  }
  auto frames = FramesAhead::create(*rig, ahead);
  if (!frames) return tl::unexpected<Error>(frames.error());
  Shown shown;
  for (const RangeFinderCalibration& finder : (*rig)->calibration().rangeFinders)
    shown.serials.push_back(finder.serial);
  shown.widthPx = (*rig)->calibration().rangeFinders[0].intrinsics.widthPx;
  shown.heightPx = (*rig)->calibration().rangeFinders[0].intrinsics.heightPx;
  shown.frames = std::move(*frames);
  return shown;
}

Expected<Shown> whatIsShown(const ServeOptions& o, const std::vector<Fault>& faults) {
  if (o.recording.empty()) return virtualRig(o, faults);
  return inputError("--recording", "cannot be served yet; measure it with inspect --source recording");
}

nlohmann::ordered_json countersOf(const DeviceRig& rig) {
  const gige_device::EncoderCounters encoder = rig.encoder();
  nlohmann::ordered_json out;
  out["version"] = VIGNOLE_VERSION;
  out["encoder"] = {{"triggers", encoder.triggers},
                    {"runs", encoder.runs},
                    {"late_ticks", encoder.lateTicks},
                    {"rate_hz", encoder.rateHz}};
  out["cameras"] = nlohmann::ordered_json::array();
  for (int c = 0; c < rig.cameras(); ++c) {
    const gige_device::DeviceCounters n = rig.counters(c);
    out["cameras"].push_back({{"camera", c + 1},
                              {"address", rig.address(c)},
                              {"pulses", n.pulses},
                              {"frames_taken", n.framesTaken},
                              {"frames_sent", n.framesSent},
                              {"frames_lost", n.framesLost},
                              {"frames_abandoned", n.framesAbandoned},
                              {"triggers_missed", n.triggersMissed},
                              {"triggers_ignored", n.triggersIgnored},
                              {"deaths", n.deaths},
                              {"commands", n.commands},
                              {"packets_sent", n.stream.packets},
                              {"packets_dropped", n.stream.packetsDropped},
                              {"resend_requests", n.stream.resendRequests},
                              {"packets_resent", n.stream.packetsResent},
                              {"resends_refused", n.stream.resendsRefused}});
  }
  return out;
}

std::string table(const nlohmann::ordered_json& counters) {
  std::string out;
  for (const auto& camera : counters["cameras"]) {
    out += "camera " + std::to_string(camera["camera"].get<int>()) + ":";
    for (const char* key :
         {"frames_sent", "frames_lost", "triggers_missed", "triggers_ignored", "packets_dropped", "packets_resent"}) {
      std::string words = key;
      words.replace(words.find('_'), 1, " ");
      out += "  " + words + " " + std::to_string(camera[key].get<std::uint64_t>());
    }
    out += "\n";
  }
  const auto& encoder = counters["encoder"];
  std::array<char, 160> line{};
  std::snprintf(line.data(), line.size(), "encoder: triggers %llu  runs %llu  late ticks %llu  %.1f Hz\n",
                static_cast<unsigned long long>(encoder["triggers"].get<std::uint64_t>()),
                static_cast<unsigned long long>(encoder["runs"].get<std::uint64_t>()),
                static_cast<unsigned long long>(encoder["late_ticks"].get<std::uint64_t>()),
                encoder["rate_hz"].get<double>());
  return out + line.data();
}

/// Lines of stdin as faults, from the next trigger on unless they say when.
void obeyStdin(const std::stop_token& stop, DeviceRig& rig) {
  std::string pending;
  for (std::size_t number = 1; !stop.stop_requested();) {
    pollfd in{STDIN_FILENO, POLLIN, 0};
    if (::poll(&in, 1, 50) <= 0) continue;
    std::array<char, 512> buffer{};
    const ssize_t bytes = ::read(STDIN_FILENO, buffer.data(), buffer.size());
    if (bytes <= 0) return;
    pending.append(buffer.data(), static_cast<std::size_t>(bytes));
    for (std::size_t end = pending.find('\n'); end != std::string::npos; end = pending.find('\n'), ++number) {
      const std::string line = pending.substr(0, end);
      pending.erase(0, end + 1);
      const std::string where = "script, line " + std::to_string(number);
      auto faults = parseFaultLine(line, rig.nextTrigger(), where);
      if (!faults) {
        fail(faults.error());
      } else if (!faults->empty() && concernsPicture(faults->front())) {
        fail({where, faults->front().kind + " is in the pictures, which are rendered ahead; give it by --fault or in a "
                                            "file"});
      } else {
        rig.addFaults(*std::move(faults));
      }
    }
  }
}

/// What this process has used: its own code, and the system's for it (on loopback also the receiving of what it sent).
nlohmann::ordered_json cpu() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return {{"user_s", seconds(usage.ru_utime)}, {"system_s", seconds(usage.ru_stime)}};
}

int serve(const ServeOptions& o) {
  std::mutex mutex;
  std::condition_variable over;
  bool interrupted = false;
  // Before any other thread is made: they inherit that they are not to be interrupted.
  const Interruption interruption([&] {
    {
      const std::scoped_lock lock(mutex);
      interrupted = true;
    }
    over.notify_all();
  });
  const auto faults = readFaults(o);
  if (!faults) return fail(faults.error());
  auto shown = whatIsShown(o, *faults);
  if (!shown) return fail(shown.error());
  gige_device::DeviceRigSettings settings;
  settings.cameras = o.cameras;
  settings.firstAddress = o.address;
  settings.serials = shown->serials;
  settings.rateHz = o.rateHz.value_or(1000 * o.speedMPerS / o.spacingMm);
  settings.spacingMm = o.spacingMm;
  settings.gbps = o.gbps;
  settings.seed = o.seed;
  settings.faults = *faults;
  settings.broadcast = o.broadcast;
  settings.widthPx = shown->widthPx;
  settings.heightPx = shown->heightPx;
  const auto rig = DeviceRig::start(settings, shown->frames);
  if (!rig) return fail(rig.error());
  const bool jsonOnly = o.json == "-";
  std::fputs("ready\n", jsonOnly ? stderr : stdout);
  std::fflush(jsonOnly ? stderr : stdout);
  {
    std::jthread listener;
    if (o.script == "-") listener = std::jthread([&rig](const std::stop_token& stop) { obeyStdin(stop, **rig); });
    std::unique_lock lock(mutex);
    const auto done = [&] { return interrupted; };
    if (o.seconds)
      over.wait_for(lock, std::chrono::duration<double>(*o.seconds), done);
    else
      over.wait(lock, done);
  }
  nlohmann::ordered_json counters = countersOf(**rig);
  counters["cpu"] = cpu();
  if (!o.json.empty())
    if (auto written = writeJson(o.json, counters); !written) return fail(written.error());
  if (!jsonOnly && !o.quiet)
    if (auto written = writeResult("-", table(counters)); !written) return fail(written.error());
  return kDone;
}

}  // namespace

void addSimulateServe(CLI::App& simulate, int& exitCode) {
  CLI::App* command = simulate.add_subcommand("serve", "The virtual rig's cameras as GigE Vision devices on loopback");
  const auto o = std::make_shared<ServeOptions>();
  command->footer(
      "Serves until stopped (Ctrl-C, --seconds), without root; prints \"ready\" when the cameras answer.\n"
      "Example: vignole-cli simulate serve --rate 20 --fault packet-loss=0.002 --fault die@3:200-260\n"
      "         arv-tool-0.8 -a 127.0.0.11 features\n"
      "\n"
      "Trigger 0 comes when all cameras are acquiring with TriggerMode On; a camera with TriggerMode Off runs freely\n"
      "at the rate, alone or not. When all have been stopped, the count begins again at 0. Every trigger shows its\n"
      "own pixels, the same as inspect --source virtual with these rail options, rendered ahead by one thread: if the\n"
      "machine is too slow for that and for sending, the encoder slows down (late ticks), and no frame is lost.\n"
      "The rate is how fast the encoder ticks; speed and spacing are what the pictures show.\n"
      "ExposureTime of a camera limits its trigger rate and changes no picture: that is --exposure.\n"
      "\n"
      "A script has a fault on each line, FROM[-TO]: KIND[=VALUE|=off][@CAMERA], without TO from then on; # begins a\n"
      "comment. From stdin (--script -) a line without FROM: acts from the next trigger on. Example:\n"
      "  100-160: die@3          # camera 3 has no power from trigger 100 to 160\n"
      "  200: packet-loss=0.01\n"
      "  300: packet-loss=off\n"
      "What a fault takes depends on seed, camera and trigger, not on time.");
  command->add_option("--cameras", o->cameras, "cameras, on consecutive addresses")
      ->check(CLI::Range(1, 4))
      ->capture_default_str();
  command->add_option("--address", o->address, "first address, in 127.0.0.0/8")->capture_default_str();
  command->add_option("--rate", o->rateHz, "triggers a second; default: speed / spacing")
      ->check(CLI::Range(0.01, 1000.0));
  command->add_option("--gbps", o->gbps, "wire of each camera, Gb/s; 0: no limit")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  command->add_option("--fault", o->faults,
                      "KIND[=VALUE][@CAMERA][:FROM-TO] (repeatable): " + faultKinds(FaultPlace::Device));
  command->add_option("--script", o->script, "file of faults, or - for stdin");
  command->add_flag("--broadcast", o->broadcast, "answer discovery broadcasts too (255.255.255.255:3956)");
  command->add_option("--recording", o->recording, "show this recording instead of the virtual rig");
  command->add_option("--recipe", o->recipe, "rail: recipe, file, or SECTION [CLASS/CLASS]")->capture_default_str();
  command->add_option("--length", o->lengthM, "length of a rail, m; 0: one rail without end")
      ->check(CLI::Range(0.0, 1e5))
      ->capture_default_str();
  command->add_option("--gap", o->gapM, "no rail for so long behind each, m; Line2 is low there")
      ->check(CLI::Range(0.0, 1e5))
      ->capture_default_str();
  command->add_option("--rails", o->rails, "rails, then the encoder rests; 0: without end (with --length)")
      ->capture_default_str();
  command->add_option("--speed", o->speedMPerS, "speed, m/s")->check(CLI::Range(0.001, 100.0))->capture_default_str();
  command->add_option("--spacing", o->spacingMm, "travel between triggers, mm")
      ->check(CLI::Range(0.01, 1e5))
      ->capture_default_str();
  command->add_option("--exposure", o->exposureMs, "exposure of the pictures, ms")
      ->check(CLI::Range(0.01, 1000.0))
      ->capture_default_str();
  command->add_option("--temperature", o->temperatureC, "temperature of the rail, degrees C")
      ->check(CLI::Range(-60.0, 1400.0))
      ->capture_default_str();
  command->add_option("--seed", o->seed, "seed of the virtual rail, its noise and the faults")->capture_default_str();
  command->add_option("--rig-seed", o->rigSeed, "draws the virtual rig itself; default: the seed");
  command->add_option("--effect", o->effects, "NAME=on|off|VALUE of the virtual rig (repeatable)");
  command->add_option("--deviation", o->deviations, "DIM=MM: constant deviation of a dimension (repeatable)");
  command->add_option("--seconds", o->seconds, "stop after that time")->check(CLI::Range(0.0, 1e9));
  command->add_option("--json", o->json, "counters at the end: file, or - for stdout");
  command->add_flag("--quiet", o->quiet, "no counters on stdout at the end");
  command->callback([o, &exitCode] { exitCode = serve(*o); });
}

}  // namespace vignole::cli
