#pragma once
// A camera's lens in the files of other programs: OpenCV YAML, HALCON .dat (division and polynomial), mrcal
// .cameramodel; and ours.

#include <filesystem>

#include "calibration/intrinsics/calibrated_intrinsics.h"

namespace vignole {

enum class LensFormat { Vignole, OpenCv, Halcon, Mrcal };

/// By the name's end: .toml, .yaml or .yml, .dat, .cameramodel.
[[nodiscard]] Expected<LensFormat> lensFormatOf(const std::filesystem::path& file);

struct ConvertedLens {
  CalibratedIntrinsics camera;
  double maxResidualPx = 0;  ///< largest difference over the picture that the other lens model leaves; 0: the same one
};

/// Files of OpenCV and mrcal become polynomial lenses. `pixelMm`: the width of a pixel, which those do not say. Errors
/// name the file, the key and the remedy. Covariance is known of our own files alone.
[[nodiscard]] Expected<ConvertedLens> importLens(const std::filesystem::path& file, double pixelMm);

/// Written whole or not at all; gives the largest difference over the picture, px, that the format's lens model leaves.
[[nodiscard]] Expected<double> exportLens(const CalibratedIntrinsics& camera, const std::filesystem::path& file);

/// What exportLens writes.
[[nodiscard]] std::string toHalcon(const Intrinsics& in);
[[nodiscard]] std::string toMrcal(const Intrinsics& in);
[[nodiscard]] std::string toOpenCvYaml(const CalibratedIntrinsics& camera);

}  // namespace vignole
