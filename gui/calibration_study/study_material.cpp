#include "gui/calibration_study/study_material.h"

#include <QImage>
#include <algorithm>
#include <filesystem>
#include <mutex>

#include "calibration/parallel_for.h"
#include "engine/simulator/virtual_plate.h"
#include "gui/calibration_rig/plate_stand.h"

namespace vignole {

namespace {

constexpr double kUsualExposureMs = 15;
constexpr double kRenderShare = 0.2;

/// Levels of exposure_ms, or the usual one.
std::vector<double> exposuresOf(const StudyPlan& plan) {
  for (const Factor& factor : plan.factors) {
    if (factor.name != "exposure_ms") continue;
    std::vector<double> all;
    for (const FactorLevel& level : factor.levels)
      if (const auto* ms = std::get_if<double>(&level)) all.push_back(*ms);
    return all;
  }
  return {kUsualExposureMs};
}

}  // namespace

Expected<ParameterStudy> runVirtualStudy(const VirtualStudySettings& settings, const Job& job) {
  namespace fs = std::filesystem;
  const std::vector<double> exposures = exposuresOf(settings.plan);
  TrialMaterial material;
  material.plate = settings.known.plate;
  material.cameras = settings.known.cameras;
  const std::size_t count = exposures.size() * static_cast<std::size_t>(settings.placements) * kCameraCount;
  std::size_t done = 0;
  std::mutex telling;
  std::optional<Error> failed;
  for (const double exposure : exposures) {
    VirtualPlateSettings how;
    how.plate = settings.known.plate;
    how.rigSeed = settings.rigSeed;
    how.exposureMs = exposure;
    for (int i = 0; i < settings.placements; ++i) how.placements.push_back(placementAt(wantedPose(i)));
    const auto plate = VirtualPlate::create(std::move(how));
    if (!plate) return tl::unexpected<Error>(plate.error());
    for (int placement = 0; placement < settings.placements; ++placement) {
      const fs::path folder =
          fs::path(settings.folder) / exposureFolder(exposure) / ("placement" + std::to_string(placement + 1));
      std::error_code error;
      fs::create_directories(folder, error);
      if (error) return worldError(folder.string(), error.message());
      parallelFor(kCameraCount, [&](std::size_t c) {
        if (job.cancelled()) return;
        const Intrinsics& in = settings.known.cameras[c].intrinsics;
        QImage image(in.widthPx, in.heightPx, QImage::Format_Grayscale8);
        (*plate)->render(static_cast<int>(c), placement, {image.bits(), in.widthPx, in.heightPx, image.bytesPerLine()});
        const std::string file = (folder / ("camera" + std::to_string(c + 1) + ".png")).string();
        const bool saved = image.save(QString::fromStdString(file), "PNG");
        const std::scoped_lock lock(telling);
        if (!saved) failed = Error{file, "cannot be written: is the disk full?", ErrorKind::World};
        job.report(kRenderShare * static_cast<double>(++done) / static_cast<double>(count), "taking the pictures");
      });
      if (job.cancelled()) return cancelledError();
      if (failed) return tl::unexpected<Error>(*failed);
    }
  }
  auto placements = findPlacements({fs::path(settings.folder)});
  if (!placements) return tl::unexpected<Error>(placements.error());
  material.placements = *std::move(placements);
  if (auto jacobian = dimensionJacobian(settings.section, settings.parameters, settings.rig))
    material.jacobian = *std::move(jacobian);
  const Job rest{
      [&job](double share, std::string_view doing) { job.report(kRenderShare + (1 - kRenderShare) * share, doing); },
      job.stop};
  return runCalibrationStudy(settings.plan, std::move(material), rest);
}

}  // namespace vignole
