// vignole-cli extract: pictures of a laser stripe -> sub-pixel centre lines as CSV and as drawings.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <array>
#include <charconv>
#include <filesystem>
#include <map>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <set>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/console.h"
#include "engine/acquisition/picture_file.h"
#include "engine/files/atomic_file.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole::cli {
namespace {

namespace fs = std::filesystem;

struct Region {
  int x = 0, y = 0, width = 0, height = 0;
};

struct Options {
  std::vector<std::string> images;
  StripeSettings settings;
  std::string channel = "auto", roi, csv, overlay;
  bool quiet = false;
};

constexpr int kLeastSide = 32;  // px; what the extraction needs
constexpr const char* kHeader = "image,line,x,y,nx,ny,sigma_px,strength,width_px,flags,rejected_because\n";

constexpr const char* kFooter =
    "Thresholds. A line of contrast A (DN above its surroundings) and standard deviation s (px) has the second\n"
    "derivative A s / (s^2 + sigma^2)^1.5 after smoothing. --low and --high are contrasts of a line as wide as the\n"
    "filter (s = sigma), so they stand for second derivatives of T / (2 sqrt(2) sigma^2) DN/px^2. Noise of sn DN a\n"
    "pixel (measured in every picture) gives the second derivative a standard deviation of\n"
    "sn sqrt(3/(16 pi)) / sigma^3, that is 0.69 sn / sigma in DN of line contrast; --low is never taken below 4 "
    "times,\n"
    "--high never below 7 times that. The defaults 6 and 14 so hold up to a noise of about 6.5 sigma/3 DN.\n\n"
    "Example: vignole-cli extract camera1.png camera2.png --sigma 3 --csv points.csv --overlay drawings\n";

Expected<Region> regionOf(const std::string& text) {
  Region region;
  std::array<int*, 4> parts{&region.x, &region.y, &region.width, &region.height};
  const char *at = text.data(), *end = at + text.size();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto [next, error] = std::from_chars(at, end, *parts[i]);
    const bool closed = i + 1 < parts.size() ? next != end && *next == ',' : next == end;
    if (error != std::errc() || !closed) return inputError("--roi", "'" + text + "' is not X,Y,W,H in whole pixels");
    at = next + 1;
  }
  if (region.x < 0 || region.y < 0 || region.width < kLeastSide || region.height < kLeastSide)
    return inputError("--roi", "'" + text + "' must begin at 0,0 or further and be at least 32 x 32 px");
  return region;
}

/// The field of a StripeSettings error in the words of this command.
Error inOptionWords(Error error) {
  static const std::map<std::string, std::string> words{{"stripe.sigma", "--sigma"},
                                                        {"stripe.low", "--low"},
                                                        {"stripe.high", "--high"},
                                                        {"stripe.gapDistance", "--gap-distance"},
                                                        {"stripe.gapAngle", "--gap-angle"}};
  if (const auto word = words.find(error.where); word != words.end()) error.where = word->second;
  return error;
}

Expected<ImageView> cropped(const Picture& picture, const Region& region, const std::string& file) {
  const ImageView all = picture.view();
  if (all.width < kLeastSide || all.height < kLeastSide)
    return inputError(file, "is " + std::to_string(all.width) + " x " + std::to_string(all.height) +
                                " px; at least 32 x 32 are needed");
  if (region.width == 0) return all;
  if (region.x > all.width - region.width || region.y > all.height - region.height)
    return inputError(
        file, "--roi reaches beyond its " + std::to_string(all.width) + " x " + std::to_string(all.height) + " px");
  return ImageView{all.row(region.y) + region.x, region.width, region.height, all.stride};
}

std::string flagWords(std::uint8_t flags) {
  static constexpr std::array<std::pair<StripeFlag, const char*>, 5> words{{{kSaturated, "saturated"},
                                                                            {kLineEnd, "end"},
                                                                            {kGapEdge, "gap"},
                                                                            {kCrosstalk, "crosstalk"},
                                                                            {kRejected, "rejected"}}};
  std::string text;
  for (const auto& [flag, word] : words)
    if ((flags & flag) != 0) text += (text.empty() ? "" : "|") + std::string(word);
  return text;
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

/// Shortest digits that give the same float again.
void append(std::string& text, float value) {
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), end).push_back(',');
}

void appendRows(std::string& text, const std::string& image, const StripeResult& result, const Region& region) {
  const std::string name = quoted(image);
  for (std::size_t l = 0; l < result.lines.size(); ++l) {
    const StripeLine& line = result.lines[l];
    const std::string reason = quoted(reasonOf(line.rejection));
    for (std::uint32_t i = line.first; i < line.first + line.count; ++i) {
      const StripePoint& p = result.points[i];
      text += name + "," + std::to_string(l + 1) + ",";
      for (const float value : {p.x + static_cast<float>(region.x), p.y + static_cast<float>(region.y), p.nx, p.ny,
                                p.sigmaPx, p.strength, p.widthPx})
        append(text, value);
      text += flagWords(p.flags) + "," + reason + "\n";
    }
  }
}

/// Green: a point of the line; yellow: at an end, a gap or clipped; red: of a rejected line. Blue dashes bridge gaps.
cv::Mat drawing(const Picture& picture, const StripeResult& result, const Region& region) {
  const cv::Mat grey(picture.height, picture.width, CV_8UC1, const_cast<std::uint8_t*>(picture.pixels.data()));
  cv::Mat canvas;
  cv::cvtColor(grey, canvas, cv::COLOR_GRAY2BGR);
  constexpr int kShift = 4;  // sixteenths of a pixel
  const auto at = [&](const StripePoint& p) {
    return cv::Point(cvRound((p.x + static_cast<float>(region.x)) * (1 << kShift)),
                     cvRound((p.y + static_cast<float>(region.y)) * (1 << kShift)));
  };
  for (const StripeLine& line : result.lines)
    for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i) {
      const StripePoint &a = result.points[i - 1], &b = result.points[i];
      const bool bridge = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y) > 9;
      const cv::Scalar colour = (b.flags & kRejected) != 0 ? cv::Scalar(60, 60, 255)
                                : bridge                   ? cv::Scalar(255, 160, 60)
                                : b.flags != 0             ? cv::Scalar(0, 220, 255)
                                                           : cv::Scalar(80, 255, 0);
      cv::line(canvas, at(a), at(b), colour, 1, cv::LINE_AA, kShift);
    }
  if (region.width > 0)
    cv::rectangle(canvas, cv::Rect(region.x, region.y, region.width, region.height), cv::Scalar(200, 200, 200));
  return canvas;
}

/// Files in a folder, one an image and named after it; a second image of the same name gets a number.
class NamesInFolder {
 public:
  NamesInFolder(fs::path folder, std::string extension)
      : folder_(std::move(folder)), extension_(std::move(extension)) {}
  Expected<fs::path> next(const std::string& image) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error || !fs::is_directory(folder_)) return worldError(folder_.string(), "cannot be made a folder");
    const std::string stem = fs::path(image).stem().string();
    std::string name = stem;
    for (int number = 2; !taken_.insert(name).second; ++number) name = stem + "_" + std::to_string(number);
    return folder_ / (name + extension_);
  }

 private:
  fs::path folder_;
  std::string extension_;
  std::set<std::string> taken_;
};

Expected<void> writeDrawing(const fs::path& file, const cv::Mat& picture) {
  std::vector<std::uint8_t> png;
  if (!cv::imencode(".png", picture, png)) return worldError(file.string(), "cannot be encoded as PNG");
  return writeFile(file, std::string_view(reinterpret_cast<const char*>(png.data()), png.size()));
}

bool isFolder(const std::string& csv) {
  std::error_code error;
  const fs::path path(csv);
  return !csv.empty() && csv != "-" && (fs::is_directory(path, error) || !path.has_filename() || !path.has_extension());
}

std::string summary(const std::string& image, const Picture& picture, const StripeResult& result) {
  std::size_t rejected = 0;
  for (const StripeLine& line : result.lines) rejected += line.rejected() ? 1 : 0;
  return image + ": channel " + std::string(channelName(picture.channel)) + ", " + std::to_string(result.lines.size()) +
         " lines (" + std::to_string(rejected) + " rejected), " + std::to_string(result.points.size()) + " points" +
         (result.overloaded ? ", overloaded" : "") + "\n";
}

int run(const Options& options) {
  const auto settings = checked(options.settings);
  if (!settings) return fail(inOptionWords(settings.error()));
  Region region;
  if (!options.roi.empty()) {
    const auto parsed = regionOf(options.roi);
    if (!parsed) return fail(parsed.error());
    region = *parsed;
  }
  const Channel channel = channelNamed(options.channel).value_or(Channel::Auto);
  const bool inFolder = isFolder(options.csv);
  NamesInFolder tables(options.csv, ".csv"), drawings(options.overlay, ".png");
  StripeExtractor extractor(*settings);
  StripeResult result;
  std::string rows, summaries;
  int exitCode = kDone;
  bool any = false;
  const auto note = [&exitCode](const Error& error) { exitCode = std::max(exitCode, fail(error)); };
  const auto writeTo = [&note](Expected<fs::path> file, const auto& write) {
    const Expected<void> done = file ? write(*file) : Expected<void>(tl::unexpected(file.error()));
    if (!done) note(done.error());
  };
  Progress progress(options.quiet, "extract");
  for (std::size_t i = 0; i < options.images.size(); ++i) {
    const std::string& image = options.images[i];
    progress.update(static_cast<double>(i) / static_cast<double>(options.images.size()), image);
    const auto picture = readPicture(image, channel);
    const auto view = picture ? cropped(*picture, region, image) : Expected<ImageView>(tl::unexpected(picture.error()));
    if (!view) {
      note(view.error());
      continue;
    }
    any = true;
    extractor.extract(*view, result);
    if (result.overloaded && !options.quiet)
      std::fprintf(
          stderr,
          "vignole-cli: %s: overloaded: texture everywhere, only the brightest blocks were worked on; choose a --roi\n",
          image.c_str());
    summaries += summary(image, *picture, result);
    if (inFolder) rows.clear();
    appendRows(rows, image, result, region);
    if (inFolder) writeTo(tables.next(image), [&](const fs::path& file) { return writeFile(file, kHeader + rows); });
    if (!options.overlay.empty())
      writeTo(drawings.next(image),
              [&](const fs::path& file) { return writeDrawing(file, drawing(*picture, result, region)); });
  }
  if (!any) return exitCode;
  const bool summariesOnly = options.csv.empty() && !options.overlay.empty();
  const auto written = summariesOnly || inFolder ? writeResult("-", summaries)
                                                 : writeResult(options.csv.empty() ? "-" : options.csv, kHeader + rows);
  if (!written) note(written.error());
  return exitCode;
}

}  // namespace

void addExtract(CLI::App& app, int& exitCode) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("extract", "Finds the laser stripe in pictures: sub-pixel centre lines.");
  StripeSettings& s = options->settings;
  command->add_option("IMAGE", options->images, "Pictures (PNG, JPEG, BMP, TIFF, PGM)")->required();
  command->add_option("--sigma", s.sigma, "Standard deviation of the Gaussian, px")->capture_default_str();
  command->add_option("--low", s.low, "t_l: weaker points are rejected, DN of line contrast")->capture_default_str();
  command
      ->add_option("--high", s.high,
                   "t_h: stronger points are accepted, and what is connected to them, DN of line contrast")
      ->capture_default_str();
  command->add_option("--gap-distance", s.gapDistance, "d: widest gap that is bridged, px")->capture_default_str();
  command
      ->add_option("--gap-angle", s.gapAngle,
                   "alpha: largest angle between the regression lines of two pieces, degrees")
      ->capture_default_str();
  command
      ->add_option_function<std::string>(
          "--correction", [options](const std::string& word) { options->settings.correction = word == "on"; },
          "on: the pull of bends is taken off and the points are smoothed along the line; off: the ridge as it is")
      ->check(CLI::IsMember({"on", "off"}))
      ->default_str("on");
  command->add_option("--channel", options->channel, "Of colour pictures; auto: where the laser stands out most")
      ->check(CLI::IsMember({"auto", "red", "green", "blue", "grey"}))
      ->capture_default_str();
  command->add_option("--roi", options->roi, "X,Y,W,H: look only there, px");
  command->add_option("--csv", options->csv,
                      "Points as CSV: one FILE, a DIR (no extension) with one file an image, - is stdout (the default "
                      "without --overlay)");
  command->add_option("--overlay", options->overlay, "DIR: pictures with the lines drawn in");
  command->add_flag("--quiet", options->quiet, "No progress, no remarks");
  command->footer(kFooter);
  command->callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace vignole::cli
