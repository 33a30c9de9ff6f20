#include "calibration/intrinsics/opencv_reference.h"

#include <opencv2/calib3d.hpp>

namespace vignole {

namespace {

int flagsFor(const LensVariant& variant) {
  const int radial = variant.model == DistortionModel::Division ? 1 : variant.radial;
  int flags = 0;
  if (!variant.aspect) flags |= cv::CALIB_FIX_ASPECT_RATIO;
  if (!variant.tangential) flags |= cv::CALIB_ZERO_TANGENT_DIST;
  if (radial < 3) flags |= cv::CALIB_FIX_K3;
  if (radial < 2) flags |= cv::CALIB_FIX_K2;
  if (radial < 1) flags |= cv::CALIB_FIX_K1;
  return flags;
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
      inTarget.back().emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0F);
      inPicture.back().emplace_back(static_cast<float>(o.px.x()), static_cast<float>(o.px.y()));
    }
  }
  try {
    cv::Mat camera = cv::Mat::eye(3, 3, CV_64F), distortion = cv::Mat::zeros(5, 1, CV_64F);
    camera.at<double>(0, 0) = like.pixelHeightMm / like.pixelWidthMm;  // the aspect ratio that a flag may hold
    std::vector<cv::Mat> rotations, translations;
    const cv::TermCriteria until(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-12);
    OpenCvReference reference;
    reference.rmsPx = cv::calibrateCamera(inTarget, inPicture, cv::Size(like.widthPx, like.heightPx), camera,
                                          distortion, rotations, translations, flagsFor(variant), until);
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
