#include "calibration/intrinsics/opencv_reference.h"

#include <opencv2/calib3d.hpp>

namespace vignole {

namespace {

int flagsFor(const LensVariant& variant) {
  const int radial = variant.model == DistortionModel::Division ? 1 : variant.radial;
  int flags = cv::CALIB_USE_INTRINSIC_GUESS;
  if (!variant.aspect) flags |= cv::CALIB_FIX_ASPECT_RATIO;
  if (!variant.tangential) flags |= cv::CALIB_ZERO_TANGENT_DIST;
  if (radial < 3) flags |= cv::CALIB_FIX_K3;
  if (radial < 2) flags |= cv::CALIB_FIX_K2;
  if (radial < 1) flags |= cv::CALIB_FIX_K1;
  return flags;
}

std::vector<std::vector<cv::Point3f>> flattened(std::vector<std::vector<cv::Point3f>> views) {
  for (auto& view : views)
    for (cv::Point3f& p : view) p.z = 0;
  return views;
}

}  // namespace

std::optional<OpenCvReference> openCvReference(const TargetObservations& observations,
                                               const std::vector<Eigen::Vector3d>& points, const LensVariant& variant,
                                               const Intrinsics& like) {
  std::vector<std::vector<cv::Point3f>> inTarget;
  std::vector<std::vector<cv::Point2f>> inPicture;
  for (const ObservedView& view : observations.views) {
    if (view.empty()) continue;
    inTarget.emplace_back();
    inPicture.emplace_back();
    for (const Observation& o : view) {
      const Eigen::Vector3d& p = points[static_cast<std::size_t>(o.point)];
      inTarget.back().emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
      inPicture.back().emplace_back(static_cast<float>(o.px.x()), static_cast<float>(o.px.y()));
    }
  }
  try {
    // A start of its own, as it makes itself for targets that are quite flat.
    const cv::Size size(like.widthPx, like.heightPx);
    const double aspect = like.pixelHeightMm / like.pixelWidthMm;
    cv::Mat camera = cv::initCameraMatrix2D(flattened(inTarget), inPicture, size, variant.aspect ? 0 : aspect);
    cv::Mat distortion = cv::Mat::zeros(5, 1, CV_64F);
    std::vector<cv::Mat> rotations, translations;
    const cv::TermCriteria until(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-12);
    OpenCvReference reference;
    reference.rmsPx = cv::calibrateCamera(inTarget, inPicture, size, camera, distortion, rotations, translations,
                                          flagsFor(variant), until);
    reference.fxPx = camera.at<double>(0, 0);
    reference.fyPx = camera.at<double>(1, 1);
    reference.cxPx = camera.at<double>(0, 2);
    reference.cyPx = camera.at<double>(1, 2);
    reference.k1 = distortion.at<double>(0);
    reference.k2 = distortion.at<double>(1);
    reference.p1 = distortion.at<double>(2);
    reference.p2 = distortion.at<double>(3);
    reference.k3 = distortion.at<double>(4);
    reference.parameters = static_cast<int>(freeParameters(variant).size());
    return reference;
  } catch (const cv::Exception&) {
    return {};
  }
}

}  // namespace vignole
