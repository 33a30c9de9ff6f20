#include "calibration/lens_files/lens_file_readers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <opencv2/core.hpp>
#include <regex>
#include <sstream>
#include <vector>

namespace vignole {

namespace {

std::string trimmed(const std::string& text) {
  const auto from = text.find_first_not_of(" \t\r\n\""), to = text.find_last_not_of(" \t\r\n\"");
  return from == std::string::npos ? std::string() : text.substr(from, to - from + 1);
}

bool parse(const std::string& text, double& value) {
  const std::string t = trimmed(text);
  const auto [end, problem] = std::from_chars(t.data(), t.data() + t.size(), value);
  return problem == std::errc{} && end == t.data() + t.size() && std::isfinite(value);
}

/// What all formats have to obey, whoever wrote them.
Expected<OpenCvLens> checked(OpenCvLens lens, const std::string& fileName) {
  constexpr double kMaxFocalPx = 1e6;
  constexpr int kMinSize = 32, kMaxSize = 20000;
  if (!(lens.fxPx > 0 && lens.fyPx > 0 && lens.fxPx < kMaxFocalPx && lens.fyPx < kMaxFocalPx))
    return inputError(fileName, "has focal lengths that are none; is it a camera's file?");
  if (lens.widthPx < kMinSize || lens.heightPx < kMinSize || lens.widthPx > kMaxSize || lens.heightPx > kMaxSize)
    return inputError(fileName, "has no size of the picture between 32 and 20,000 px");
  if (!(lens.cxPx > -0.5 && lens.cyPx > -0.5 && lens.cxPx < lens.widthPx && lens.cyPx < lens.heightPx))
    return inputError(fileName, "has a principal point outside the picture");
  return lens;
}

/// "Name:short: value;" by short name.
std::map<std::string, std::string> halconValues(const std::string& text) {
  static const std::regex parameter(R"(^\s*\w+\s*:\s*(\w+)\s*:\s*([^;]*);\s*$)");
  std::map<std::string, std::string> values;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (std::smatch match; std::regex_match(line, match, parameter)) values[match[1]] = trimmed(match[2]);
  return values;
}

/// Values asked for one by one; the first that is wrong is told.
class HalconValues {
 public:
  HalconValues(const std::string& text, std::string fileName)
      : values_(halconValues(text)), fileName_(std::move(fileName)) {}
  [[nodiscard]] bool has(const std::string& name) const { return values_.contains(name); }
  double take(const std::string& name, double min, double max) {
    const auto found = values_.find(name);
    double value = 0;
    if (found == values_.end())
      note(name, "is missing; write the file as write_cam_par does, of an area scan camera");
    else if (!parse(found->second, value))
      note(name, "is \"" + found->second + "\", which is no number");
    else if (!(value >= min && value <= max))
      note(name, "is " + found->second + ", which no camera has; lengths are in metres");
    return value;
  }
  [[nodiscard]] const std::string& problem() const { return problem_; }
  [[nodiscard]] const std::string& where() const { return where_; }

 private:
  void note(const std::string& name, const std::string& what) {
    if (!problem_.empty()) return;
    where_ = fileName_ + ": " + name;
    problem_ = what;
  }
  std::map<std::string, std::string> values_;
  std::string fileName_, where_, problem_;
};

/// The list after 'key': in a Python dictionary.
Expected<std::vector<double>> pythonList(const std::string& text, const std::string& key, const std::string& fileName) {
  const std::regex list("['\"]" + key + R"(['\"]\s*:\s*[\[\(]([^\]\)]*)[\]\)])");
  std::smatch match;
  if (!std::regex_search(text, match, list)) return inputError(fileName + ": " + key, "is missing");
  std::vector<double> values;
  std::istringstream items(match[1]);
  for (std::string item; std::getline(items, item, ',');) {
    if (trimmed(item).empty()) continue;
    double value = 0;
    if (!parse(item, value)) return inputError(fileName + ": " + key, "has \"" + trimmed(item) + "\", no number");
    values.push_back(value);
  }
  return values;
}

std::string withoutComments(const std::string& text) {
  std::string out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) out += line.substr(0, line.find('#')) + "\n";
  return out;
}

/// k1, k2, p1, p2, k3, k4, k5, k6 as far as there are.
void takeDistortion(const std::vector<double>& d, OpenCvLens& lens) {
  const std::array<double*, 8> places = {&lens.k1, &lens.k2, &lens.p1, &lens.p2,
                                         &lens.k3, &lens.k4, &lens.k5, &lens.k6};
  for (std::size_t i = 0; i < std::min(d.size(), places.size()); ++i) *places[i] = d[i];
}

std::vector<double> numbersOf(const cv::FileNode& node) {
  std::vector<double> values;
  if (node.empty()) return values;
  cv::Mat matrix;
  node >> matrix;
  if (matrix.empty()) return values;
  cv::Mat asDouble;
  matrix.convertTo(asDouble, CV_64F);
  values.assign(asDouble.begin<double>(), asDouble.end<double>());
  return values;
}

Expected<OpenCvLens> fromStorage(const cv::FileStorage& file, const std::string& fileName, double& rmsPx) {
  const std::vector<double> k = numbersOf(file["camera_matrix"]), d = numbersOf(file["distortion_coefficients"]);
  if (k.size() != 9) return inputError(fileName + ": camera_matrix", "is missing or no 3 x 3 matrix");
  if (k[1] != 0) return inputError(fileName + ": camera_matrix", "has a skew, which no camera here has");
  if (d.empty()) return inputError(fileName + ": distortion_coefficients", "is missing");
  for (std::size_t i = 8; i < d.size(); ++i)
    if (d[i] != 0)
      return inputError(fileName + ": distortion_coefficients",
                        "has thin prism or tilt coefficients; calibrate without them");
  for (const auto& values : {k, d})
    for (const double v : values)
      if (!std::isfinite(v)) return inputError(fileName, "has a number that is not finite");
  OpenCvLens lens{k[0], k[4], k[2], k[5]};
  takeDistortion(d, lens);
  lens.widthPx = static_cast<int>(file["image_width"]);
  lens.heightPx = static_cast<int>(file["image_height"]);
  const cv::FileNode error = file["avg_reprojection_error"];
  if (error.isReal() || error.isInt()) rmsPx = static_cast<double>(error);
  return checked(lens, fileName);
}

}  // namespace

Expected<Intrinsics> readHalcon(const std::string& text, const std::string& fileName) {
  HalconValues values(text, fileName);
  constexpr double kMm = 1e3;  // of a metre
  constexpr double kAnything = 1e30;
  Intrinsics in;
  in.focalMm = values.take("foc", 1e-3, 1) * kMm;
  if (values.has("kappa")) {
    in.model = DistortionModel::Division;
    in.kappa = values.take("kappa", -1e5, 1e5) / (kMm * kMm);
  } else {
    in.model = DistortionModel::Polynomial;
    in.k1 = values.take("poly1", -1e5, 1e5) / std::pow(kMm, 2);
    in.k2 = values.take("poly2", -kAnything, kAnything) / std::pow(kMm, 4);
    in.k3 = values.take("poly3", -kAnything, kAnything) / std::pow(kMm, 6);
    in.p1 = values.take("poly4", -100, 100) / kMm;
    in.p2 = values.take("poly5", -100, 100) / kMm;
  }
  in.pixelWidthMm = values.take("sx", 1e-7, 1e-4) * kMm;
  in.pixelHeightMm = values.take("sy", 1e-7, 1e-4) * kMm;
  in.cxPx = values.take("cx", -0.5, 20000);
  in.cyPx = values.take("cy", -0.5, 20000);
  in.widthPx = static_cast<int>(values.take("imgw", 32, 20000));
  in.heightPx = static_cast<int>(values.take("imgh", 32, 20000));
  if (!values.problem().empty()) return inputError(values.where(), values.problem());
  return in;
}

Expected<OpenCvLens> readMrcal(const std::string& raw, const std::string& fileName) {
  const std::string text = withoutComments(raw);
  static const std::regex model(R"(['"](?:lensmodel|lens_model)['"]\s*:\s*['"](\w+)['"])");
  std::smatch match;
  if (!std::regex_search(text, match, model)) return inputError(fileName + ": lensmodel", "is missing");
  static const std::map<std::string, std::size_t> kDistortions = {
      {"LENSMODEL_PINHOLE", 0}, {"LENSMODEL_OPENCV4", 4}, {"LENSMODEL_OPENCV5", 5}, {"LENSMODEL_OPENCV8", 8}};
  const auto known = kDistortions.find(match[1]);
  if (known == kDistortions.end())
    return inputError(fileName + ": lensmodel",
                      "is " + match[1].str() + "; convert it to LENSMODEL_OPENCV5 with mrcal-convert-lensmodel");
  const auto intrinsics = pythonList(text, "intrinsics", fileName), size = pythonList(text, "imagersize", fileName);
  if (!intrinsics) return tl::unexpected(intrinsics.error());
  if (!size) return tl::unexpected(size.error());
  if (intrinsics->size() != 4 + known->second)
    return inputError(fileName + ": intrinsics", "has " + std::to_string(intrinsics->size()) + " numbers; " +
                                                     known->first + " has " + std::to_string(4 + known->second));
  if (size->size() != 2) return inputError(fileName + ": imagersize", "is no width and height");
  OpenCvLens lens{(*intrinsics)[0], (*intrinsics)[1], (*intrinsics)[2], (*intrinsics)[3]};
  takeDistortion({intrinsics->begin() + 4, intrinsics->end()}, lens);
  lens.widthPx = static_cast<int>((*size)[0]);
  lens.heightPx = static_cast<int>((*size)[1]);
  return checked(lens, fileName);
}

Expected<OpenCvLens> readOpenCvYaml(const std::string& text, const std::string& fileName, double& rmsPx) {
  if (!text.starts_with("%YAML"))
    return inputError(fileName, "does not begin with %YAML:1.0; write it with cv::FileStorage");
  try {
    const cv::FileStorage file(text, cv::FileStorage::READ | cv::FileStorage::MEMORY | cv::FileStorage::FORMAT_YAML);
    if (!file.isOpened()) return inputError(fileName, "is no YAML that OpenCV reads");
    return fromStorage(file, fileName, rmsPx);
  } catch (const cv::Exception& e) {
    return inputError(fileName, "is no YAML that OpenCV reads: " + e.err);
  }
}

}  // namespace vignole
