// vignole-cli calibrate intrinsics: one camera's intrinsic parameters from pictures of a flat target.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stop_token>

#include "calibration/intrinsics/intrinsics_calibration.h"
#include "calibration/lens_files/lens_files.h"
#include "calibration/next_pose/next_pose.h"
#include "calibration/parallel_for.h"
#include "cli/calibrate.h"
#include "cli/console.h"
#include "cli/interruption.h"
#include "cli/intrinsics_output.h"
#include "cli/report_files.h"
#include "engine/acquisition/picture_file.h"
#include "engine/measurement/measurement.h"
#include "engine/rail/catalogue.h"
#ifdef VIGNOLE_REPORT
#include "report/intrinsics_report.h"
#endif

namespace vignole::cli {
namespace {

struct Options {
  std::vector<std::string> images, exports;
  std::string target, model = "auto", out, report, json, serial, rail = "60E1";
  double pixelUm = 7.4, toleranceUm = 0, focalMm = 0;
  bool lightDots = false, quiet = false;
};

Expected<PlanarTarget> targetOf(const Options& options) {
  auto target = parseTarget(options.target);
  if (!target) return target;
  target->lightDots = options.lightDots;
  target->uMm = options.toleranceUm * 1e-3 / std::sqrt(3.0);  // rectangular, JCGM 100 4.3.7
  return target;
}

/// What was seen in the pictures, and what could not be read.
struct SeenPictures {
  std::vector<TargetView> views;
  std::vector<Picture> pictures;  ///< as the views; kept for a report only
  std::vector<Error> errors;
};

/// On all cores; decoding waits its turn (picture_file.h).
SeenPictures findInAll(const Options& options, const PlanarTarget& target, Progress& progress) {
  const std::size_t count = options.images.size();
  std::vector<std::optional<TargetView>> views(count);
  std::vector<Picture> pictures(count);
  std::vector<std::optional<Error>> errors(count);
  std::mutex decoding, telling;
  std::size_t done = 0;
  parallelFor(count, [&](std::size_t i) {
    Expected<Picture> picture = [&] {
      const std::scoped_lock lock(decoding);
      return readPicture(options.images[i], Channel::Grey);
    }();
    if (picture) {
      views[i] = findTarget(picture->view(), target);
      views[i]->file = options.images[i];
      if (!options.report.empty()) pictures[i] = std::move(*picture);
    } else {
      errors[i] = picture.error();
    }
    const std::scoped_lock lock(telling);
    progress.update(0.5 * static_cast<double>(++done) / static_cast<double>(count), "finding the target");
  });
  SeenPictures seen;
  for (std::size_t i = 0; i < count; ++i) {
    if (views[i]) {
      seen.views.push_back(std::move(*views[i]));
      seen.pictures.push_back(std::move(pictures[i]));
    }
    if (errors[i]) seen.errors.push_back(std::move(*errors[i]));
  }
  return seen;
}

IntrinsicsSettings settingsOf(const Options& options) {
  IntrinsicsSettings settings;
  settings.pixelMm = options.pixelUm * 1e-3;
  settings.nominalFocalMm = options.focalMm;
  settings.serial = options.serial;
  if (options.model == "division") settings.model = DistortionModel::Division;
  if (options.model == "polynomial") settings.model = DistortionModel::Polynomial;
  return settings;
}

/// By the dimensions of the rail if the camera is one of the rig's, by the picture otherwise.
std::optional<NextPose> adviceFor(const IntrinsicsCalibration& calibration, const PlanarTarget& target,
                                  const Section& section) {
  auto worth = worthInDimensions(calibration.camera.intrinsics, section, defaultParameters(section));
  if (!worth) worth = worthInPicture(calibration.camera.intrinsics, usualDistanceMm(calibration, target));
  if (auto next = nextPose(calibration, target, *worth)) return std::move(*next);
  return {};
}

/// Nothing that was refused is written: a silent bad calibration is worse than none.
Expected<std::vector<ExportedLens>> write(const IntrinsicsCalibration& calibration, const Options& options) {
  std::vector<std::string> files = options.exports;
  if (!options.out.empty()) files.insert(files.begin(), options.out);
  std::vector<ExportedLens> written;
  for (const std::string& file : files) {
    const auto residual = exportLens(calibration.camera, file);
    if (!residual) return tl::unexpected(residual.error());
    written.push_back({file, *residual});
  }
  return written;
}

Expected<void> checkNames(const Options& options) {
  for (const std::string& file : options.exports)
    if (const auto format = lensFormatOf(file); !format) return tl::unexpected(format.error());
  if (options.out.empty()) return {};
  if (const auto format = lensFormatOf(options.out); !format) return tl::unexpected(format.error());
  return {};
}

#ifdef VIGNOLE_REPORT
Expected<void> report(const IntrinsicsCalibration& calibration, const PlanarTarget& target, const SeenPictures& seen,
                      const std::optional<NextPose>& next, const std::string& file) {
  IntrinsicsReport content{&calibration, &target, {}, next ? next->words : std::string()};
  for (const Picture& picture : seen.pictures) content.pictures.push_back(&picture);
  return writeDocumentReport(intrinsicsDocument(content), file);
}
#else
Expected<void> report(const IntrinsicsCalibration&, const PlanarTarget&, const SeenPictures&,
                      const std::optional<NextPose>&, const std::string& file) {
  return writeDocumentReport({}, file);
}
#endif

int run(const Options& options) {
  if (!options.report.empty())
    if (const auto possible = checkDocumentFile(options.report); !possible) return fail(possible.error());
  const auto target = targetOf(options);
  if (!target) return fail(target.error());
  if (const auto named = checkNames(options); !named) return fail(named.error());
  const auto section = findSection(options.rail);
  if (!section) return fail(section.error());

  std::stop_source stop;
  const Interruption interruption([&stop] { stop.request_stop(); });
  SeenPictures seen;
  auto calibration = [&]() -> Expected<IntrinsicsCalibration> {
    Progress progress(options.quiet, "intrinsics");
    seen = findInAll(options, *target, progress);
    const Job job{[&](double share, std::string_view doing) { progress.update(0.5 + share / 2, std::string(doing)); },
                  stop.get_token()};
    if (job.cancelled()) return cancelledError();
    return calibrateIntrinsics(seen.views, *target, settingsOf(options), job);
  }();
  int code = kDone;
  for (const Error& error : seen.errors) code = fail(error);
  if (!calibration) return fail(calibration.error());
  if (seen.views.empty()) return code;
  calibration->camera.created = isoTimeUtc();

  std::vector<ExportedLens> exported;
  if (calibration->accepted()) {
    auto written = write(*calibration, options);
    if (!written) return fail(written.error());
    exported = std::move(*written);
  } else if (code == kDone) {
    code = kVerdictFail;
  }
  const std::optional<NextPose> next = adviceFor(*calibration, *target, *section);
  if (!options.report.empty())
    if (const auto done = report(*calibration, *target, seen, next, options.report); !done) return fail(done.error());
  if (!options.json.empty())
    if (const auto done = writeJson(options.json, toJson(*calibration, next, exported)); !done)
      return fail(done.error());
  if (options.json != "-")
    if (const auto done = writeResult("-", toTable(*calibration, next)); !done) return fail(done.error());
  return code;
}

constexpr const char* kFooter =
    "Columns and rows are inner corners of a chessboard, circles of a grid.\n\n"
    "The lens model is the simplest that predicts pictures it has not seen no worse than the best does (Student's t,\n"
    "99.5 %): division (kappa), or polynomial with k1; k1 k2; k1 k2 k3; k1 k2 p1 p2; k1 k2 k3 p1 p2. Pixels are as\n"
    "high as wide unless the pictures say otherwise. The numbers run from distorted to undistorted, on the sensor in\n"
    "mm, as HALCON's do: kappa and k1 in 1/mm^2, k2 in 1/mm^4, k3 in 1/mm^6, p1 and p2 in 1/mm. In the JSON "
    "\"opencv\"\n"
    "is the same lens in OpenCV's terms, \"opencv_reference\" what OpenCV's calibrateCamera makes of the same points "
    "of\n"
    "pictures and target with as many parameters.\n\n"
    "Errors are RMS and mean of the distances of all points used. Points that all pictures show out of place are the\n"
    "target's error: they are estimated with the camera where other pictures are predicted better so, in the target's\n"
    "plane and, of a target that is bent, out of it. A calibration that is refused is not written; exit code 1.\n\n"
    "Example: vignole-cli calibrate intrinsics dots/*.png --target dotplate:13x9:10 --out camera1.toml --json -";

}  // namespace

void addCalibrateIntrinsics(CLI::App& calibrate, int& exitCode) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      calibrate.add_subcommand("intrinsics", "One camera's intrinsic parameters from pictures of a flat target");
  command->footer(kFooter);
  command->add_option("IMAGE", options->images, "pictures of the target, 10 to 20, moved and tilted")->required();
  command
      ->add_option("--target", options->target,
                   "chessboard:COLSxROWS:MM, circles:COLSxROWS:PITCH[:DIAMETER], acircles:..., dotplate:...")
      ->required();
  command->add_flag("--light-dots", options->lightDots, "circles are light on dark");
  command
      ->add_option("--target-tolerance-um", options->toleranceUm,
                   "each coordinate of the target's points lies within +- this; they are estimated as well (default: "
                   "found out from the pictures)")
      ->check(CLI::Range(0.0, 1e4));
  command->add_option("--pixel-um", options->pixelUm, "width of a pixel, um (default 7.4)")
      ->check(CLI::Range(0.1, 100.0));
  command->add_option("--focal-mm", options->focalMm, "nominal focal length, one more place to start from")
      ->check(CLI::Range(1.0, 1000.0));
  command->add_option("--model", options->model, "auto, division or polynomial (default auto)")
      ->check(CLI::IsMember({"auto", "division", "polynomial"}));
  command->add_option("--serial", options->serial, "of the camera, kept in the file");
  command->add_option("--rail", options->rail, "section whose dimensions the next pose is chosen for (default 60E1)");
  command->add_option("--out", options->out, "FILE.toml; .yaml OpenCV, .dat HALCON, .cameramodel mrcal");
  command->add_option("--export", options->exports, "one more file, by its end as --out (repeatable)");
  command->add_option("--report", options->report, "FILE.pdf: verdict, Table III, parameters, coverage, views");
  command->add_option("--json", options->json, "JSON to a file, or - for stdout");
  command->add_flag("--quiet", options->quiet, "no progress");
  command->callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace vignole::cli
