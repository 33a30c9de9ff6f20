#pragma once
// Which exposure for rails (paper section IV: 15 ms "after several experiments with different surface conditions of
// rails and lens apertures", hence 66 frames a second): light, noise, motion and trigger rate weighed over pictures
// taken at several exposures.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "calibration/job.h"
#include "calibration/parameter_study/exposure_folders.h"
#include "engine/geometry/image_view.h"
#include "engine/optics/calibration.h"
#include "engine/stripe/stripe.h"

namespace vignole {

/// How the rail moves while light is gathered. Motion along z carries only what changes along z into the picture; the
/// whole section does not change as it slides through the light plane. So the line is smeared by what the section moves
/// across within an exposure t: speed * slope * t, spread evenly (variance over 12), and the vibration, a sine of
/// standard deviation a and frequency f whose variance within a window of t is a^2 (1 - sinc^2(pi f t)), averaged over
/// its phase. Details of the surface shorter than speed * t are averaged along the rail.
struct RailMotionModel {
  double speedMPerS = 1;
  double vibrationMm = 0.05;  ///< standard deviation across the line
  double vibrationHz = 20;
  double slopeMmPerM = 3;  ///< how the section moves across its way along the rail: bends, wander on the roller table
};
/// Standard deviation of the smear across the line, mm.
[[nodiscard]] double motionBlurMm(const RailMotionModel& motion, double exposureMs);

/// When a camera takes the next trigger: after the end of the exposure, and not before the last picture is read out.
/// The default is a Genie HM1400 (1400 x 1024 bytes through 1 Gbit/s: 11.5 ms) that exposes while it reads out: 15 ms
/// are 66 triggers a second, as in the paper.
struct CameraTiming {
  double readoutMs = 11.5;
  double deadMs = 0;    ///< between exposures
  bool overlap = true;  ///< exposes while it reads out
};
[[nodiscard]] double highestRateHz(const CameraTiming& timing, double exposureMs);

struct ExposureSettings {
  StripeSettings stripe{.sigma = 2.2};  ///< as recipes for rails have it
  RailMotionModel motion;
  CameraTiming timing;
  std::optional<double> rateHz;   ///< triggers that are wanted; none: any rate will do
  bool takenAtRest = false;       ///< the pictures do not hold the smear yet: it is added to the line's uncertainty
  std::optional<double> mmPerPx;  ///< across the line, where no calibration tells it
  double maxSaturated = 0.02;     ///< share of a picture's line that may be clipped
  double minWeakSnr = 6;          ///< at the weakest 5 % of a line; 6: about 0.1 px with sigma 3
  double maxBlurPx = 1;           ///< motion; widens a line of 3 px by 5 %
  double minCoverage = 0.95;      ///< of the line's points, against the unclipped exposure that shows most of them
  double tolerance = 0.1;         ///< a shorter exposure is taken if its uncertainty is no more than this larger
};

/// What one picture says.
struct ExposureReading {
  double exposureMs = 0;
  std::string scene;
  int camera = 0;
  int points = 0;         ///< on lines that were not rejected
  double saturated = 0;   ///< share of them
  double contrastDn = 0;  ///< median
  double weakDn = 0;      ///< contrast that 5 % of them stay below
  double noiseDn = 0;     ///< of a pixel
  double sigmaPx = 0;     ///< median standard uncertainty across the line
  double widthPx = 0;     ///< median standard deviation of the light across the line
  double mmPerPx = 0;     ///< median, across the line; 0: not known
};
/// `calibration`: of the camera; null: mm are not known.
[[nodiscard]] ExposureReading readExposure(const StripeResult& lines, const RangeFinderCalibration* calibration);

/// One exposure over all its pictures.
struct ExposureRow {
  double exposureMs = 0;
  int pictures = 0;
  int empty = 0;                           ///< pictures without a line
  double saturated = 0, saturatedMax = 0;  ///< mean, worst picture
  double snr = 0;                          ///< median contrast over noise of a pixel, mean of the pictures
  double weakSnr = 0;                      ///< contrast of the weakest 5 % over noise, worst picture
  double coverage = 0;              ///< points against the unclipped exposure that shows most, mean of the scenes
  double sigmaPx = 0, sigmaMm = 0;  ///< of a point in one profile, with the smear; mm 0: not known. Clipped lines
                                    ///< hide their noise: too small there
  double blurMm = 0, blurPx = 0;    ///< smear by motion; px 0: not known
  double travelMm = 0;              ///< way of the rail within the exposure
  double highestRateHz = 0;
  double spacingMm = 0;             ///< of profiles along the rail at that rate (or at the wanted one)
  double sigmaPerMetreMm = 0;       ///< mean over the profiles of a metre at that rate; mm 0: px
  std::vector<std::string> limits;  ///< which are broken, in words; empty: may be used
};

struct ExposureAdvice {
  std::vector<ExposureRow> rows;  ///< by exposure
  std::vector<ExposureReading> readings;
  std::optional<double> exposureMs;  ///< recommended; none: every exposure breaks a limit
  double bestMs = 0;                 ///< of least uncertainty among those that break no limit
  std::vector<std::string> reasons;
  ExposureSettings settings;
};

/// Refuses readings at fewer than two exposures.
[[nodiscard]] Expected<ExposureAdvice> adviseExposure(std::vector<ExposureReading> readings,
                                                      const ExposureSettings& settings);
/// Reads the pictures, finds their lines, advises. `rig`: null where it is not known.
[[nodiscard]] Expected<ExposureAdvice> adviseExposure(const std::vector<ExposedPicture>& pictures,
                                                      const RigCalibration* rig, const ExposureSettings& settings,
                                                      const Job& job);

}  // namespace vignole
