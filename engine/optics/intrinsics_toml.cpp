#include "engine/optics/intrinsics_toml.h"

#include <array>
#include <charconv>

namespace vignole {

std::string number(double value) {
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  std::string text(buffer.data(), end);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string list(std::span<const double> values) {
  std::string text = "[";
  for (const double v : values) text += (text.size() > 1 ? ", " : "") + number(v);
  return text + "]";
}

std::string toToml(const Intrinsics& in) {
  std::string text = "focal_mm = " + number(in.focalMm) + "\npixel_width_mm = " + number(in.pixelWidthMm) +
                     "\npixel_height_mm = " + number(in.pixelHeightMm) + "\ncx_px = " + number(in.cxPx) +
                     "\ncy_px = " + number(in.cyPx) + "\nwidth_px = " + std::to_string(in.widthPx) +
                     "\nheight_px = " + std::to_string(in.heightPx) + "\n";
  if (in.model == DistortionModel::Division)
    return text + "model = \"division\"\nkappa_per_mm2 = " + number(in.kappa) + "\n";
  return text + "model = \"polynomial\"\nk1_per_mm2 = " + number(in.k1) + "\nk2_per_mm4 = " + number(in.k2) +
         "\nk3_per_mm6 = " + number(in.k3) + "\np1_per_mm = " + number(in.p1) + "\np2_per_mm = " + number(in.p2) + "\n";
}

Intrinsics readIntrinsics(TomlReader& toml, const std::string& at) {
  Intrinsics in;
  in.focalMm = toml.number(at + "focal_mm", 1, 1000);
  in.pixelWidthMm = toml.number(at + "pixel_width_mm", 1e-4, 0.1);
  in.pixelHeightMm = toml.number(at + "pixel_height_mm", 1e-4, 0.1);
  in.widthPx = toml.integer(at + "width_px", 32, 20000);
  in.heightPx = toml.integer(at + "height_px", 32, 20000);
  // A principal point outside the picture is possible in theory only; it would be a mistake here.
  in.cxPx = toml.number(at + "cx_px", -0.5, 19999.5);
  in.cyPx = toml.number(at + "cy_px", -0.5, 19999.5);
  const std::string model = toml.text(at + "model");
  if (model == "polynomial") {
    in.model = DistortionModel::Polynomial;
    in.k1 = toml.number(at + "k1_per_mm2", -0.1, 0.1);
    in.k2 = toml.number(at + "k2_per_mm4", -0.01, 0.01);
    in.k3 = toml.number(at + "k3_per_mm6", -0.001, 0.001);
    in.p1 = toml.number(at + "p1_per_mm", -0.1, 0.1);
    in.p2 = toml.number(at + "p2_per_mm", -0.1, 0.1);
  } else {
    if (model != "division") toml.refuse(at + "model", "is neither \"division\" nor \"polynomial\"");
    in.kappa = toml.number(at + "kappa_per_mm2", -0.1, 0.1);
  }
  if (in.cxPx > in.widthPx - 0.5) toml.refuse(at + "cx_px", "lies outside the picture; correct it or width_px");
  if (in.cyPx > in.heightPx - 0.5) toml.refuse(at + "cy_px", "lies outside the picture; correct it or height_px");
  return in;
}

}  // namespace vignole
