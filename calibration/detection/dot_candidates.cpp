#include "calibration/detection/dot_candidates.h"

#include <algorithm>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "calibration/detection/picture_levels.h"
#include "calibration/detection/point_index.h"
#include "calibration/detection/regions.h"

namespace vignole {
namespace {

constexpr int kLeastArea = 7;             // px
constexpr double kMostOfPicture = 0.05;   // larger is no dot among others
constexpr double kLeastAxisRatio = 0.22;  // a circle seen at 77 degrees
// Area over that of the ellipse with the same second moments: 1; a square 0.955, a ring or a crescent much less.
constexpr double kLeastFill = 0.88, kMostFill = 1.1;
constexpr double kSmoothedNoise = 0.375;  // of a pixel's noise, after the 3 x 3 filter
constexpr double kNoiseFactor = 3.5, kLeastStep = 2.5;

bool elliptical(const Region& region) {
  const DotEllipse ellipse = ellipseOfMoments(region.centrePx, region.covariance);
  const Eigen::Vector2d axes = ellipse.semiAxesPx();
  if (!(axes.x() > 0 && axes.y() > kLeastAxisRatio * axes.x())) return false;
  const double fill = region.areaPx / ellipse.areaPx();
  // Of few pixels the outline is known to a pixel only.
  const double slack = 0.5 / std::sqrt(region.areaPx);
  return fill > kLeastFill - slack && fill < kMostFill + slack;
}

}  // namespace

std::vector<DotEllipse> dotCandidates(const ImageView& image, bool light, int halfWindow) {
  const cv::Mat grey(image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.data),
                     static_cast<std::size_t>(image.stride));
  cv::Mat smooth, mean;
  cv::GaussianBlur(grey, smooth, cv::Size(3, 3), 0, 0, cv::BORDER_REPLICATE);
  cv::blur(smooth, mean, cv::Size(2 * halfWindow + 1, 2 * halfWindow + 1), cv::Point(-1, -1), cv::BORDER_REPLICATE);
  const int step = static_cast<int>(std::ceil(std::max(kLeastStep, kNoiseFactor * kSmoothedNoise * noiseOf(image))));
  std::vector<std::uint8_t> mask(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t *at = smooth.ptr(y), *about = mean.ptr(y);
    std::uint8_t* to = mask.data() + static_cast<std::ptrdiff_t>(y) * image.width;
    if (light)
      for (int x = 0; x < image.width; ++x) to[x] = at[x] >= about[x] + step ? 1 : 0;
    else
      for (int x = 0; x < image.width; ++x) to[x] = at[x] + step <= about[x] ? 1 : 0;
  }
  const double most = kMostOfPicture * image.width * image.height;
  std::vector<DotEllipse> spots;
  for (const Region& region : regionsOf(mask, image.width, image.height, kLeastArea))
    if (!region.atBorder && region.areaPx < most && elliptical(region))
      spots.push_back(ellipseOfMoments(region.centrePx, region.covariance));
  return spots;
}

void addNew(const std::vector<DotEllipse>& more, std::vector<DotEllipse>& all) {
  std::vector<Point2> places;
  places.reserve(all.size());
  for (const DotEllipse& ellipse : all) places.push_back(ellipse.centrePx);
  const PointIndex index(places);
  for (const DotEllipse& ellipse : more) {
    const auto nearest = index.nearest(ellipse.centrePx, 0.5 * ellipse.semiAxesPx().y());
    if (!nearest) all.push_back(ellipse);
  }
}

}  // namespace vignole
