#pragma once
// Reads what other programs write of a camera.

#include <string>

#include "calibration/lens_files/opencv_lens.h"

namespace vignole {

/// HALCON's internal camera parameters of an area scan camera: Focus, Kappa or Poly1 ... Poly5, Sx, Sy, Cx, Cy,
/// ImageWidth, ImageHeight, in metres.
[[nodiscard]] Expected<Intrinsics> readHalcon(const std::string& text, const std::string& fileName);
/// LENSMODEL_PINHOLE, LENSMODEL_OPENCV4, 5 and 8.
[[nodiscard]] Expected<OpenCvLens> readMrcal(const std::string& text, const std::string& fileName);
/// camera_matrix, distortion_coefficients (4, 5 or 8; more if they are 0), image_width, image_height.
[[nodiscard]] Expected<OpenCvLens> readOpenCvYaml(const std::string& text, const std::string& fileName, double& rmsPx);

}  // namespace vignole
