// vignole-cli calibrate light-plane: the laser's plane in the frame of one camera, from a flat target that shows its
// line.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <stop_token>

#include "calibration/lens_files/lens_files.h"
#include "calibration/light_plane/light_plane_calibration.h"
#include "calibration/parallel_for.h"
#include "cli/calibrate.h"
#include "cli/console.h"
#include "cli/interruption.h"
#include "engine/acquisition/picture_file.h"
#include "engine/files/atomic_file.h"

namespace vignole::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Options {
  std::string intrinsics, pairs, target, channel = "auto", json;
  std::vector<std::string> images;
  double pixelUm = 7.4;
  bool lightDots = false, quiet = false;
};

/// The same file twice where one picture shows both.
struct PicturePair {
  std::string plate, stripe;
};

std::string trimmed(std::string text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '"'; };
  while (!text.empty() && blank(text.back())) text.pop_back();
  std::size_t first = 0;
  while (first < text.size() && blank(text[first])) ++first;
  return text.substr(first);
}

/// Names in a list are relative to it.
std::string besideList(const std::string& name, const fs::path& list) {
  std::error_code error;
  const fs::path beside = list.parent_path() / name;
  return fs::path(name).is_absolute() || (!fs::exists(beside, error) && fs::exists(name, error)) ? name
                                                                                                 : beside.string();
}

Expected<std::vector<PicturePair>> readPairs(const std::string& file) {
  const auto content = readFile(file);
  if (!content) return tl::unexpected(content.error());
  std::vector<PicturePair> pairs;
  int line = 0;
  for (std::size_t from = 0; from < content->size();) {
    const std::size_t to = std::min(content->find('\n', from), content->size());
    const std::string row = trimmed(content->substr(from, to - from));
    from = to + 1;
    ++line;
    if (row.empty() || row.front() == '#') continue;
    const std::string where = file + ", line " + std::to_string(line);
    const std::size_t comma = row.find(',');
    if (comma == std::string::npos || row.find(',', comma + 1) != std::string::npos)
      return inputError(where, "must have two columns: plate image, stripe image");
    const std::string plate = trimmed(row.substr(0, comma)), stripe = trimmed(row.substr(comma + 1));
    if (plate.empty() || stripe.empty()) return inputError(where, "a picture's name is missing");
    // A header names no files.
    const bool header = pairs.empty() && !fs::path(plate).has_extension() && !fs::path(stripe).has_extension();
    if (!header) pairs.push_back({besideList(plate, file), besideList(stripe, file)});
  }
  if (pairs.empty()) return inputError(file, "lists no pictures");
  return pairs;
}

Expected<std::vector<PicturePair>> pairsOf(const Options& options) {
  if (!options.pairs.empty()) return readPairs(options.pairs);
  std::vector<PicturePair> pairs;
  for (const std::string& image : options.images) pairs.push_back({image, image});
  return pairs;
}

Expected<CalibratedIntrinsics> intrinsicsOf(const Options& options) {
  auto lens = importLens(options.intrinsics, options.pixelUm * 1e-3);
  if (!lens) return tl::unexpected(lens.error());
  return std::move(lens->camera);
}

/// A channel that sees the print as well and the laser least.
Channel besideLaser(Channel laser) { return laser == Channel::Red ? Channel::Green : Channel::Red; }

/// Decoding waits its turn (picture_file.h).
class Reader {
 public:
  Expected<Picture> operator()(const std::string& file, Channel channel) {
    const std::scoped_lock lock(mutex_);
    return readPicture(file, channel);
  }

 private:
  std::mutex mutex_;
};

Expected<TargetStripe> lookAtPair(const PicturePair& pair, Channel channel, const PlanarTarget& target,
                                  const Intrinsics& in, Reader& read) {
  const auto plate = read(pair.plate, Channel::Grey);
  if (!plate) return tl::unexpected(plate.error());
  const auto laser = read(pair.stripe, channel);
  if (!laser) return tl::unexpected(laser.error());
  TargetView view = findTarget(plate->view(), target);
  view.file = pair.plate;
  TargetStripe stripe = findTargetStripe(laser->view(), view, target, in);
  stripe.file = pair.stripe;
  return stripe;
}

/// One picture with both: the target by the channel in which the laser is least, the line by the difference.
Expected<TargetStripe> lookAtBoth(const std::string& file, Channel channel, const PlanarTarget& target,
                                  const Intrinsics& in, Reader& read) {
  const auto laser = read(file, channel);
  if (!laser) return tl::unexpected(laser.error());
  if (laser->channel == Channel::Grey) return lookAtPair({file, file}, Channel::Grey, target, in, read);
  const auto other = read(file, besideLaser(laser->channel));
  if (!other) return tl::unexpected(other.error());
  TargetView view = findTarget(other->view(), target);
  if (!view.usable() || view.partial) {
    const TargetView again = findTarget(laser->view(), target);
    if (again.points.size() > view.points.size()) view = again;
  }
  view.file = file;
  const std::vector<std::uint8_t> alone = laserAlone(laser->view(), other->view());
  return findTargetStripe({alone.data(), laser->width, laser->height, laser->width}, view, target, in);
}

/// The channel of the laser, the same in all pictures.
Channel commonChannel(const std::vector<PicturePair>& pairs, Channel asked, Reader& read) {
  if (asked != Channel::Auto) return asked;
  std::array<std::size_t, 5> votes{};
  for (const PicturePair& pair : pairs)
    if (const auto picture = read(pair.stripe, Channel::Auto)) ++votes[static_cast<std::size_t>(picture->channel)];
  return static_cast<Channel>(std::max_element(votes.begin(), votes.end()) - votes.begin());
}

struct SeenStripes {
  std::vector<TargetStripe> stripes;
  std::vector<Error> errors;
};

SeenStripes lookAtAll(const std::vector<PicturePair>& pairs, Channel asked, const PlanarTarget& target,
                      const Intrinsics& in, const std::stop_token& stop, Progress& progress) {
  Reader read;
  const Channel channel = commonChannel(pairs, asked, read);
  std::vector<std::optional<Expected<TargetStripe>>> all(pairs.size());
  std::mutex telling;
  std::size_t done = 0;
  parallelFor(pairs.size(), [&](std::size_t i) {
    if (stop.stop_requested()) return;
    const PicturePair& pair = pairs[i];
    all[i] = pair.plate == pair.stripe ? lookAtBoth(pair.stripe, channel, target, in, read)
                                       : lookAtPair(pair, channel, target, in, read);
    const std::scoped_lock lock(telling);
    progress.update(0.9 * static_cast<double>(++done) / static_cast<double>(pairs.size()), "target and line");
  });
  SeenStripes seen;
  for (auto& one : all) {
    if (!one) continue;
    if (*one)
      seen.stripes.push_back(std::move(**one));
    else
      seen.errors.push_back(one->error());
  }
  return seen;
}

Json toJson(const LightPlaneCalibration& c) {
  Json views = Json::array(), covariance = Json::array();
  for (const LightPlaneView& v : c.views) {
    const bool fitted = v.points > 0;
    views.push_back({{"file", v.file},
                     {"used", v.used},
                     {"reason", v.reason},
                     {"rms_mm", fitted ? Json(v.rmsMm) : Json()},
                     {"offset_mm", fitted ? Json(v.offsetMm) : Json()},
                     {"points", v.points}});
  }
  for (int row = 0; row < 4; ++row) {
    Json entries = Json::array();
    for (int column = 0; column < 4; ++column) entries.push_back(c.covariance(row, column));
    covariance.push_back(std::move(entries));
  }
  const bool found = c.points > 0;
  return {{"normal", found ? Json{c.normal.x(), c.normal.y(), c.normal.z()} : Json()},
          {"distance_mm", found ? Json(c.distanceMm) : Json()},
          {"rms_mm", found ? Json(c.rmsMm) : Json()},
          {"points", c.points},
          {"u", {{"normal_mrad", c.uNormalMrad}, {"distance_mm", c.uDistanceMm}, {"plane_at_lines_mm", c.uAtTargetMm}}},
          {"covariance", std::move(covariance)},
          {"chi2_per_dof", c.chi2PerDof},
          {"accepted", c.accepted()},
          {"refusals", c.refusals},
          {"views", std::move(views)}};
}

template <typename... Values>
std::string printed(const char* format, Values... values) {
  std::array<char, 512> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

std::string toTable(const LightPlaneCalibration& c) {
  std::string text;
  for (const LightPlaneView& v : c.views)
    text +=
        v.used ? printed("%s: %d points, rms %.4f mm, offset %+.4f mm\n", v.file.c_str(), v.points, v.rmsMm, v.offsetMm)
               : v.file + ": " + v.reason + "\n";
  if (c.points > 0)
    text += printed(
        "plane in the camera's frame: (%.6f, %.6f, %.6f) . p = %.4f mm\n"
        "u %.3f mrad of the normal, %.4f mm of the distance, %.4f mm of the plane where the lines are; rms %.4f mm of "
        "%zu points\n",
        c.normal.x(), c.normal.y(), c.normal.z(), c.distanceMm, c.uNormalMrad, c.uDistanceMm, c.uAtTargetMm, c.rmsMm,
        c.points);
  for (const std::string& refusal : c.refusals) text += refusal + "\n";
  return text;
}

int run(const Options& options) {
  auto target = parseTarget(options.target);
  if (!target) return fail(target.error());
  target->lightDots = options.lightDots;
  const auto camera = intrinsicsOf(options);
  if (!camera) return fail(camera.error());
  const auto pairs = pairsOf(options);
  if (!pairs) return fail(pairs.error());

  std::stop_source stop;
  const Interruption interruption([&stop] { stop.request_stop(); });
  SeenStripes seen;
  const auto calibration = [&]() -> Expected<LightPlaneCalibration> {
    Progress progress(options.quiet, "light plane");
    seen = lookAtAll(*pairs, channelNamed(options.channel).value_or(Channel::Auto), *target, camera->intrinsics,
                     stop.get_token(), progress);
    const Job job{[&](double share, std::string_view doing) { progress.update(0.9 + share / 10, std::string(doing)); },
                  stop.get_token()};
    return calibrateLightPlane(seen.stripes, *target, *camera, {}, job);
  }();
  int code = kDone;
  for (const Error& error : seen.errors) code = std::max(code, fail(error));
  if (!calibration) return fail(calibration.error());
  if (seen.stripes.empty()) return code;
  if (!calibration->accepted() && code == kDone) code = kVerdictFail;
  if (!options.json.empty())
    if (const auto done = writeJson(options.json, toJson(*calibration)); !done) return fail(done.error());
  if (options.json != "-")
    if (const auto done = writeResult("-", toTable(*calibration)); !done) return fail(done.error());
  return code;
}

constexpr const char* kFooter =
    "normal . p = distance for the points p of the plane, mm, in the camera's frame: x right, y down, z forward.\n"
    "Each view gives one line in space; two different poses of the target at least, better five, nearer and farther\n"
    "and tilted. LIST has two columns, plate image and stripe image of the same pose, names relative to the list.\n"
    "In colour pictures that show both, the print is taken off by the difference of two channels. Uncertainties count\n"
    "the lines' noise, the target's poses and the intrinsics' covariance. Refused: exit code 1.\n\n"
    "Example: vignole-cli calibrate light-plane --intrinsics camera1.toml --pairs pairs.csv --target dotplate:13x9:10";

}  // namespace

void addCalibrateLightPlane(CLI::App& calibrate, int& exitCode) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      calibrate.add_subcommand("light-plane", "The laser's plane in one camera's frame, from a target with its line");
  command->footer(kFooter);
  command->add_option("--intrinsics", options->intrinsics, "FILE.toml; .yaml OpenCV, .dat HALCON, .cameramodel mrcal")
      ->required();
  auto* pairs = command->add_option("--pairs", options->pairs, "CSV: plate image, stripe image");
  auto* images =
      command->add_option("--images", options->images, "pictures that show the target and the line on it at once");
  pairs->excludes(images);
  images->excludes(pairs);
  command
      ->add_option("--target", options->target,
                   "chessboard:COLSxROWS:MM, circles:COLSxROWS:PITCH[:DIAMETER], acircles:..., dotplate:...")
      ->required();
  command->add_flag("--light-dots", options->lightDots, "circles are light on dark");
  command->add_option("--channel", options->channel, "of the laser in colour pictures (default auto)")
      ->check(CLI::IsMember({"auto", "red", "green", "blue", "grey"}));
  command->add_option("--pixel-um", options->pixelUm, "width of a pixel where the intrinsics do not say, um")
      ->check(CLI::Range(0.1, 100.0));
  command->add_option("--json", options->json, "JSON to a file, or - for stdout");
  command->add_flag("--quiet", options->quiet, "no progress");
  command->callback([options, &exitCode] {
    if (options->pairs.empty() && options->images.empty())
      exitCode = fail(Error{"calibrate light-plane", "give --pairs LIST or --images IMAGE...", ErrorKind::Input});
    else
      exitCode = run(*options);
  });
}

}  // namespace vignole::cli
