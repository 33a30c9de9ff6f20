#include "calibration/intrinsics/intrinsics_verdict.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vignole {

namespace {

std::string digits(double value, int decimals) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

double uncertainty(const IntrinsicsCalibration& c, CameraParameter p) {
  return std::sqrt(c.camera.covariance(static_cast<int>(p), static_cast<int>(p)));
}

constexpr const char* kTiltIt =
    "take more pictures with the target tilted by 20 to 40 degrees to the left, right, top and bottom";

void refuseWhatIsOpen(double tiltDeg, const IntrinsicsSettings& settings, IntrinsicsCalibration& c) {
  const Intrinsics& in = c.camera.intrinsics;
  if (tiltDeg < settings.minTiltDifferenceDeg)
    c.refusals.push_back("refused, because the target is tilted alike in all pictures (within " + digits(tiltDeg, 1) +
                         " degrees), so that focal length and distance cannot be told apart; " + kTiltIt);
  else if (const double relative = uncertainty(c, CameraParameter::F) / in.focalMm;
           relative > settings.maxRelativeUFocal)
    c.refusals.push_back("refused, because the focal length is uncertain by " + digits(100 * relative, 1) +
                         " %, the limit is " + digits(100 * settings.maxRelativeUFocal, 1) + " %; " + kTiltIt);
  const double uPoint = std::max(uncertainty(c, CameraParameter::U0), uncertainty(c, CameraParameter::V0));
  if (const double limit = settings.maxUPrincipalPoint * in.widthPx; uPoint > limit && c.refusals.empty())
    c.refusals.push_back("refused, because the principal point is uncertain by " + digits(uPoint, 1) +
                         " px, the limit is " + digits(limit, 1) +
                         " px; take more pictures, with the target turned by 90 degrees in some and tilted in all");
  if (in.cxPx < 0 || in.cyPx < 0 || in.cxPx > in.widthPx - 1 || in.cyPx > in.heightPx - 1)
    c.refusals.push_back("refused, because the principal point lies outside the picture (" + digits(in.cxPx, 0) + ", " +
                         digits(in.cyPx, 0) +
                         "); is the size of the target right, and are all pictures of one camera?");
}

void warn(IntrinsicsCalibration& c) {
  constexpr double kEnoughCoverage = 0.7;
  constexpr int kEnoughViews = 8;
  constexpr double kLargeErrorPx = 0.5;
  const auto used = std::count_if(c.views.begin(), c.views.end(), [](const ViewResult& v) { return v.used; });
  if (used < kEnoughViews)
    c.warnings.push_back("only " + std::to_string(used) + " pictures; " + std::to_string(kEnoughViews) +
                         " and more make the uncertainty itself trustworthy");
  if (const double share = c.coverage.share(); share < kEnoughCoverage)
    c.warnings.push_back("only " + digits(100 * share, 0) +
                         " % of the picture was covered; the distortion is extrapolated elsewhere: show the target in "
                         "the corners as well");
  if (c.camera.rmsPx > kLargeErrorPx)
    c.warnings.push_back("points are off by " + digits(c.camera.rmsPx, 2) +
                         " px (RMS); is the target flat, sharp and its size right?");
  if (c.targetErrorMm > 0)
    c.warnings.push_back("the target's points lie " + digits(1000 * c.targetErrorMm, 0) +
                         " um (standard deviation of each coordinate) from where they are stated; they were estimated "
                         "with the camera");
  if (c.targetBendMm > 0)
    c.warnings.push_back(
        "the target is not flat: its points lie " + digits(1000 * c.targetBendMm, 0) +
        " um (standard deviation) out of its plane; that was estimated as well, but a flat one is better");
}

}  // namespace

std::string refusalForViews(std::size_t usable, const IntrinsicsSettings& settings) {
  if (usable >= settings.minViews) return {};
  const std::string count = usable == 0   ? "no picture is"
                            : usable == 1 ? "only one picture is"
                                          : "only " + std::to_string(usable) + " pictures are";
  return "refused, because " + count + " of use, and at least " + std::to_string(settings.minViews) +
         " that differ are needed; take 10 to 20 with the target moved over the whole picture and tilted by 20 to 40 "
         "degrees to all sides";
}

void judgeCalibration(double tiltDeg, const IntrinsicsSettings& settings, IntrinsicsCalibration& calibration) {
  refuseWhatIsOpen(tiltDeg, settings, calibration);
  warn(calibration);
}

}  // namespace vignole
