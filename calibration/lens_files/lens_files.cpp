#include "calibration/lens_files/lens_files.h"

#include <array>
#include <cmath>

#include "calibration/lens_files/lens_file_readers.h"
#include "calibration/lens_files/opencv_lens.h"
#include "engine/files/atomic_file.h"
#include "engine/optics/intrinsics_toml.h"

namespace vignole {

namespace {

std::string halconParameter(const std::string& name, const std::string& brief, const std::string& value,
                            const std::string& range, const std::string& description) {
  return name + ":" + brief + ": " + value + ";\n  " + range + ";\n  \"" + description + "\";\n\n";
}

constexpr double kMetre = 1e-3;  // mm

std::string halconDistortion(const Intrinsics& in) {
  const std::string any = "DOUBLE::";
  if (in.model == DistortionModel::Division)
    return halconParameter("Kappa", "kappa", number(in.kappa / (kMetre * kMetre)), any,
                           "Radial distortion coefficient [1/(meter*meter)]");
  const std::array<double, 5> values = {in.k1 / std::pow(kMetre, 2), in.k2 / std::pow(kMetre, 4),
                                        in.k3 / std::pow(kMetre, 6), in.p1 / kMetre, in.p2 / kMetre};
  const std::array<const char*, 5> ordinals = {"1st", "2nd", "3rd", "4th", "5th"};
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += halconParameter("Poly" + std::to_string(i + 1), "poly" + std::to_string(i + 1), number(values[i]), any,
                            std::string(ordinals[i]) + " polynomial distortion coefficient");
  return text;
}

}  // namespace

Expected<LensFormat> lensFormatOf(const std::filesystem::path& file) {
  const std::string end = file.extension().string();
  if (end == ".toml") return LensFormat::Vignole;
  if (end == ".yaml" || end == ".yml") return LensFormat::OpenCv;
  if (end == ".dat") return LensFormat::Halcon;
  if (end == ".cameramodel") return LensFormat::Mrcal;
  return inputError(file.string(),
                    "ends in none of .toml, .yaml, .yml (OpenCV), .dat (HALCON), .cameramodel (mrcal); name it so");
}

std::string toHalcon(const Intrinsics& in) {
  const std::string positive = "DOUBLE:0.0:", size = "INT:1:32767";
  return "# INTERNAL CAMERA PARAMETERS\n\nParGroup: Camera: Parameter;\n  \"Internal camera parameters\";\n\n" +
         halconParameter("Focus", "foc", number(in.focalMm * kMetre), positive, "Focal length of the lens [meter]") +
         halconDistortion(in) +
         halconParameter("Sx", "sx", number(in.pixelWidthMm * kMetre), positive,
                         "Width of a cell on the sensor [meter]") +
         halconParameter("Sy", "sy", number(in.pixelHeightMm * kMetre), positive,
                         "Height of a cell on the sensor [meter]") +
         halconParameter("Cx", "cx", number(in.cxPx), positive, "X-coordinate of the image center [pixel]") +
         halconParameter("Cy", "cy", number(in.cyPx), positive, "Y-coordinate of the image center [pixel]") +
         halconParameter("ImageWidth", "imgw", std::to_string(in.widthPx), size, "Width of the images [pixel]") +
         halconParameter("ImageHeight", "imgh", std::to_string(in.heightPx), size, "Height of the images [pixel]");
}

std::string toMrcal(const Intrinsics& in) {
  const OpenCvLens l = toOpenCv(in).lens;
  std::string text = "{\n    'lensmodel':  'LENSMODEL_OPENCV5',\n\n";
  text += "    # intrinsics are fx,fy,cx,cy,distortion0,distortion1,....\n    'intrinsics': [ ";
  for (const double v : {l.fxPx, l.fyPx, l.cxPx, l.cyPx, l.k1, l.k2, l.p1, l.p2, l.k3}) text += number(v) + ", ";
  text.pop_back();
  return text + "],\n\n    'rt_cam_ref': [ 0, 0, 0, 0, 0, 0,],\n" +
         "    'extrinsics': [ 0, 0, 0, 0, 0, 0,], # for compatibility with mrcal < 2.5\n\n    'imagersize': [ " +
         std::to_string(l.widthPx) + ", " + std::to_string(l.heightPx) + ",],\n}\n";
}

std::string toOpenCvYaml(const CalibratedIntrinsics& camera) {
  const OpenCvLens l = toOpenCv(camera.intrinsics).lens;
  const auto matrix = [](const std::string& name, int rows, int columns, const std::string& data) {
    return name + ": !!opencv-matrix\n   rows: " + std::to_string(rows) + "\n   cols: " + std::to_string(columns) +
           "\n   dt: d\n   data: [ " + data + " ]\n";
  };
  std::string text = "%YAML:1.0\n---\n";
  if (!camera.created.empty()) text += "calibration_time: \"" + camera.created + "\"\n";
  text +=
      "image_width: " + std::to_string(l.widthPx) + "\nimage_height: " + std::to_string(l.heightPx) + "\nflags: 0\n";
  text += matrix(
      "camera_matrix", 3, 3,
      number(l.fxPx) + ", 0., " + number(l.cxPx) + ", 0., " + number(l.fyPx) + ", " + number(l.cyPx) + ", 0., 0., 1.");
  text += matrix("distortion_coefficients", 5, 1,
                 number(l.k1) + ", " + number(l.k2) + ", " + number(l.p1) + ", " + number(l.p2) + ", " + number(l.k3));
  return text + "avg_reprojection_error: " + number(camera.rmsPx) + "\n";
}

Expected<double> exportLens(const CalibratedIntrinsics& camera, const std::filesystem::path& file) {
  const auto format = lensFormatOf(file);
  if (!format) return tl::unexpected(format.error());
  double residualPx = 0;
  std::string text;
  switch (*format) {
    case LensFormat::Vignole:
      text = toToml(camera);
      break;
    case LensFormat::Halcon:
      text = toHalcon(camera.intrinsics);
      break;
    case LensFormat::Mrcal:
      text = toMrcal(camera.intrinsics);
      residualPx = toOpenCv(camera.intrinsics).maxResidualPx;
      break;
    case LensFormat::OpenCv:
      text = toOpenCvYaml(camera);
      residualPx = toOpenCv(camera.intrinsics).maxResidualPx;
      break;
  }
  if (const auto written = writeFile(file, text, true); !written) return tl::unexpected(written.error());
  return residualPx;
}

Expected<ConvertedLens> importLens(const std::filesystem::path& file, double pixelMm) {
  const auto format = lensFormatOf(file);
  if (!format) return tl::unexpected(format.error());
  if (*format == LensFormat::Vignole) {
    auto camera = loadIntrinsics(file);
    if (!camera) return tl::unexpected(camera.error());
    return ConvertedLens{std::move(*camera), 0};
  }
  const auto text = readFile(file);
  if (!text) return tl::unexpected(text.error());
  if (*format == LensFormat::Halcon) {
    const auto in = readHalcon(*text, file.string());
    if (!in) return tl::unexpected(in.error());
    ConvertedLens converted;
    converted.camera.intrinsics = *in;
    return converted;
  }
  ConvertedLens converted;
  const auto there = *format == LensFormat::Mrcal ? readMrcal(*text, file.string())
                                                  : readOpenCvYaml(*text, file.string(), converted.camera.rmsPx);
  if (!there) return tl::unexpected(there.error());
  const auto here = fromOpenCv(*there, DistortionModel::Polynomial, pixelMm);
  if (!here) return inputError(file.string(), here.error().what);
  converted.camera.intrinsics = here->intrinsics;
  converted.maxResidualPx = here->maxResidualPx;
  return converted;
}

}  // namespace vignole
