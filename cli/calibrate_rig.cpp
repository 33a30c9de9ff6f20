// vignole-cli calibrate rig: four range finders brought into one world by the pin plate.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stop_token>

#include "calibration/parallel_for.h"
#include "calibration/range_finders/association.h"
#include "cli/calibrate.h"
#include "cli/console.h"
#include "cli/interruption.h"
#include "cli/report_files.h"
#include "cli/rig_output.h"
#include "engine/acquisition/picture_file.h"
#include "engine/measurement/measurement.h"
#include "engine/rail/catalogue.h"
#include "engine/stripe/stripe_extractor.h"
#ifdef VIGNOLE_REPORT
#include "report/rig_calibration_report.h"
#endif

namespace vignole::cli {
namespace {

struct Options {
  std::string plate, method = "joint", out, report, json, rail = "60E1", previous, fit = "halir-flusser",
                     association = "four-step";
  std::vector<std::string> placements, intrinsics;
  double sigma = PinLineSettings::pinStripe().sigma;
  PaperSettings paper;
  int intervalDays = 0;
  bool quiet = false;
};

using FourPictures = std::array<Picture, kCameraCount>;

std::string pictureName(const std::string& folder, int camera) {
  return (std::filesystem::path(folder) / ("camera" + std::to_string(camera + 1) + ".png")).string();
}

Expected<RigMethod> methodOf(const Options& options) {
  for (const RigMethod method : {RigMethod::Joint, RigMethod::PerCamera, RigMethod::Paper})
    if (options.method == name(method)) return method;
  return inputError("--method", "is neither joint, per-camera nor paper");
}

/// Plate, intrinsics and the settings; pictures come later.
Expected<RigInputs> readInputs(const Options& options) {
  RigInputs inputs;
  auto plate = loadPinPlate(options.plate);
  if (!plate) return tl::unexpected(plate.error());
  inputs.plate = *std::move(plate);
  if (options.intrinsics.size() != kCameraCount)
    return inputError("--intrinsics",
                      "names " + std::to_string(options.intrinsics.size()) + " files; give four, of camera 1 to 4");
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    auto camera = loadIntrinsics(options.intrinsics[c]);
    if (!camera) return tl::unexpected(camera.error());
    inputs.cameras[c] = *std::move(camera);
  }
  for (const std::string& folder : options.placements)
    if (!std::filesystem::is_directory(folder))
      return inputError(folder, "is no folder; a placement is a folder of camera1.png ... camera4.png");
  return inputs;
}

/// Reads every picture and finds its lines, on all cores; pictures of the first placement are kept for the report.
Expected<FourPictures> findLines(const Options& options, const PinLineSettings& settings, RigInputs& inputs,
                                 const Job& job) {
  FourPictures first;
  const std::size_t count = options.placements.size() * kCameraCount;
  inputs.placements.resize(options.placements.size());
  std::vector<std::optional<Error>> errors(count);
  std::mutex decoding, telling;
  std::size_t done = 0;
  parallelFor(count, [&](std::size_t i) {
    if (job.cancelled()) return;
    const std::size_t placement = i / kCameraCount;
    const int camera = static_cast<int>(i % kCameraCount);
    const std::string file = pictureName(options.placements[placement], camera);
    auto picture = [&] {
      const std::scoped_lock lock(decoding);
      return readPicture(file);
    }();
    if (!picture) {
      errors[i] = picture.error();
      return;
    }
    const Intrinsics& in = inputs.cameras[static_cast<std::size_t>(camera)].intrinsics;
    if (picture->width != in.widthPx || picture->height != in.heightPx) {
      errors[i] = Error{file, "is " + std::to_string(picture->width) + " x " + std::to_string(picture->height) +
                                  " pixels, the intrinsics of camera " + std::to_string(camera + 1) + " are for " +
                                  std::to_string(in.widthPx) + " x " + std::to_string(in.heightPx) +
                                  "; take both at the same size"};
      return;
    }
    PinPicture& lines = inputs.placements[placement].pictures[static_cast<std::size_t>(camera)];
    lines = findPinLines(picture->view(), settings);
    lines.file = file;
    if (placement == 0) first[static_cast<std::size_t>(camera)] = *std::move(picture);
    const std::scoped_lock lock(telling);
    job.report(0.4 * static_cast<double>(++done) / static_cast<double>(count), "lines of the pins");
  });
  if (job.cancelled()) return cancelledError();
  for (std::size_t p = 0; p < options.placements.size(); ++p) inputs.placements[p].folder = options.placements[p];
  for (const auto& error : errors)
    if (error) return tl::unexpected(*error);
  return first;
}

/// From the lines to the verdict.
Expected<RigResult> calibrate(const Options& options, RigMethod method, RigInputs& inputs, const Section& section,
                              const std::optional<RigCalibration>& previous, const Job& job) {
  RigAdjustmentSettings settings;
  settings.method = method;
  settings.paper = options.paper;
  associate(inputs);  // the paper has a way of its own, but swapped cameras and mirrored plates are told here
  const auto part = [&](double from, double to) {
    return Job{
        [&job, from, to](double share, std::string_view doing) { job.report(from + (to - from) * share, doing); },
        job.stop};
  };
  auto adjustment = adjustRig(inputs, settings, part(0.4, 0.7));
  if (!adjustment) return tl::unexpected(adjustment.error());
  RigResult result;
  result.inputs = &inputs;
  result.adjustment = *std::move(adjustment);
  RigCalibration& calibration = result.adjustment.calibration;
  calibration.created = isoTimeUtc();
  calibration.id = "rig-" + calibration.created;
  calibration.intervalDays = options.intervalDays;
  result.section = section.name;
  result.refusals = result.adjustment.refusals;
  if (!result.refusals.empty()) return result;

  const DimensionParameters parameters = defaultParameters(section);
  const auto jacobian = dimensionJacobian(section, parameters, calibration);
  if (!jacobian) {
    result.refusals.push_back("refused, because a " + section.name + " cannot be measured with this calibration (" +
                              jacobian.error().message() + "); look at the pictures of the plate and calibrate again");
    return result;
  }
  result.dimensions = dimensionUncertainty(*jacobian, result.adjustment.sources);
  RigCheckSettings what;
  what.previous = previous;
  auto checks = checkRig(inputs, settings, result.adjustment, section, parameters, what, part(0.7, 1));
  if (!checks) return tl::unexpected(checks.error());
  result.checks = *std::move(checks);
  for (std::string& refusal : refusalsOf(result.checks.checks)) result.refusals.push_back(std::move(refusal));
  return result;
}

#ifdef VIGNOLE_REPORT
Expected<void> report(const RigResult& result, const FourPictures& pictures, const std::string& file) {
  RigCalibrationReport content{&result.adjustment,   result.inputs,  {}, result.section, result.dimensions,
                               result.checks.checks, result.refusals};
  for (std::size_t c = 0; c < kCameraCount; ++c) content.pictures[c] = &pictures[c];
  return writeDocumentReport(rigCalibrationDocument(content), file);
}
#else
Expected<void> report(const RigResult&, const FourPictures&, const std::string& file) {
  return writeDocumentReport({}, file);
}
#endif

Expected<void> write(const Options& options, const RigResult& result, const FourPictures& pictures) {
  // A calibration that is refused is not written: a silent bad one is worse than none.
  if (!options.out.empty() && result.refusals.empty())
    if (auto saved = saveCalibration(result.adjustment.calibration, options.out); !saved) return saved;
  if (!options.report.empty())
    if (auto reported = report(result, pictures, options.report); !reported) return reported;
  if (!options.json.empty())
    if (auto written = writeJson(options.json, toJson(result)); !written) return written;
  if (options.json != "-") return writeResult("-", toTable(result));
  return {};
}

int run(Options& options) {
  if (!options.report.empty())
    if (const auto possible = checkDocumentFile(options.report); !possible) return fail(possible.error());
  const auto method = methodOf(options);
  if (!method) return fail(method.error());
  const auto fit = ellipseFitNamed(options.fit);
  if (!fit) return fail(fit.error());
  options.paper.fit = *fit;
  options.paper.fourSteps = options.association == "four-step";
  const auto section = findSection(options.rail);
  if (!section) return fail(section.error());
  PinLineSettings lines;
  lines.stripe.sigma = options.sigma;
  if (const auto good = checked(lines.stripe); !good) return fail(good.error());
  std::optional<RigCalibration> previous;
  if (!options.previous.empty()) {
    auto loaded = loadCalibration(options.previous);
    if (!loaded) return fail(loaded.error());
    previous = *std::move(loaded);
  }
  auto inputs = readInputs(options);
  if (!inputs) return fail(inputs.error());

  std::stop_source stop;
  const Interruption interruption([&stop] { stop.request_stop(); });
  Expected<FourPictures> pictures = cancelledError();
  auto result = [&]() -> Expected<RigResult> {
    Progress progress(options.quiet, "rig");
    const Job job{[&](double share, std::string_view doing) { progress.update(share, std::string(doing)); },
                  stop.get_token()};
    pictures = findLines(options, lines, *inputs, job);
    if (!pictures) return tl::unexpected(pictures.error());
    return calibrate(options, *method, *inputs, *section, previous, job);
  }();
  if (!result) return fail(result.error());
  if (const auto written = write(options, *result, *pictures); !written) return fail(written.error());
  return result->refusals.empty() ? kDone : kVerdictFail;
}

constexpr const char* kFooter =
    "joint: the lit arcs fitted in the light plane, all cameras and placements at once, the pins unknowns that may "
    "differ\n"
    "from the plate file by its uncertainty. per-camera: each by itself, the plate as stated. paper: ellipses, their\n"
    "centres, the four-step association with t_ec. A calibration that is refused is not written; exit code 1.\n\n"
    "Example: vignole-cli calibrate rig --plate plate.toml --placement placement1 placement2 --intrinsics "
    "camera1.toml\n"
    "         camera2.toml camera3.toml camera4.toml --out rig.toml --report rig.pdf";

}  // namespace

void addCalibrateRig(CLI::App& calibrate, int& exitCode) {
  auto options = std::make_shared<Options>();
  CLI::App* command = calibrate.add_subcommand("rig", "Four range finders brought into one world by the pin plate");
  command->footer(kFooter);
  command->add_option("--plate", options->plate, "Plate file: stated or measured pins with their uncertainty")
      ->required();
  command
      ->add_option("--placement", options->placements,
                   "Folders of camera1.png ... camera4.png, one each time that the plate was placed")
      ->required();
  command->add_option("--intrinsics", options->intrinsics, "Four files of calibrate intrinsics, camera 1 to 4")
      ->required();
  command->add_option("--method", options->method, "joint, per-camera or paper (default joint)");
  command->add_option("--rail", options->rail, "Section whose dimensions are judged (default 60E1)");
  command->add_option("--sigma", options->sigma, "Line filter, px")->capture_default_str();
  command
      ->add_option("--tec", options->paper.matchDistance,
                   "paper: t_ec, largest distance of an ellipse and its pin, -1 .. 1")
      ->capture_default_str();
  command->add_option("--max-ellipses", options->paper.maxEllipses, "paper: used for the pose")->capture_default_str();
  command
      ->add_option("--association", options->association,
                   "paper: four-step, or robust, which is that of the other methods (default four-step)")
      ->check(CLI::IsMember({"four-step", "robust"}));
  command->add_option("--fit", options->fit, "paper: fitzgibbon, halir-flusser or normalised")->capture_default_str();
  command->add_option("--previous", options->previous, "The calibration so far, to compare with");
  command->add_option("--interval-days", options->intervalDays, "Days after which it is to be repeated; 0: never")
      ->check(CLI::Range(0, 36500));
  command->add_option("--out", options->out, "FILE.toml, for inspect --calibration");
  command->add_option("--report", options->report, "FILE.pdf: verdict, pictures, lines, pins, Table IV, parameters");
  command->add_option("--json", options->json, "JSON to a file, or - for stdout");
  command->add_flag("--quiet", options->quiet, "No progress");
  command->callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace vignole::cli
