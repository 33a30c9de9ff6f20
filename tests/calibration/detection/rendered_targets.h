#pragma once
// Rendered pictures of flat targets with known points, for the tests of detection.

#include <cstdint>
#include <gtest/gtest.h>
#include <memory>
#include <vector>

#include "calibration/detection/circle_centre.h"
#include "calibration/detection/target_finder.h"
#include "engine/optics/camera_model.h"
#include "engine/optics/nominal_rig.h"
#include "engine/simulator/virtual_target.h"

namespace vignole::rendered {

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
  [[nodiscard]] ImageView view() const { return {pixels.data(), width, height, width}; }
  [[nodiscard]] MutableImageView mutableView() { return {pixels.data(), width, height, width}; }
};

inline Image blank(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
}

/// A camera of 16 mm with the barrel distortion of its kind, smaller than the rig's where `width` says so.
inline RangeFinderCalibration camera(int width = 1400, int height = 1024) {
  RangeFinderCalibration finder = nominalRig().rangeFinders[0];
  finder.intrinsics.widthPx = width;
  finder.intrinsics.heightPx = height;
  finder.intrinsics.cxPx = (width - 1) / 2.0 + 7.3;
  finder.intrinsics.cyPx = (height - 1) / 2.0 - 4.6;
  finder.intrinsics.model = DistortionModel::Division;
  finder.intrinsics.kappa = -4e-4;
  return finder;
}

inline VirtualTargetSettings settings(const char* words, const RangeFinderCalibration& finder, double noiseDn,
                                      std::uint64_t seed = 1) {
  VirtualTargetSettings s;
  s.target = *parseTarget(words);
  s.camera = finder;
  s.readNoiseDn = noiseDn;
  s.shotNoise = 0;
  s.seed = seed;
  return s;
}

inline std::shared_ptr<const VirtualTarget> make(const VirtualTargetSettings& s) {
  auto target = VirtualTarget::create(s);
  EXPECT_TRUE(target.has_value()) << (target ? "" : target.error().message());
  return target ? *target : nullptr;
}

inline Image render(const VirtualTarget& target, const Extrinsics& pose, int view = 0, bool laser = false) {
  Image image = blank(target.settings().camera.intrinsics.widthPx, target.settings().camera.intrinsics.heightPx);
  target.render(pose, view, laser, image.mutableView());
  return image;
}

/// Where the centres of the circles' images are, or the corners.
inline std::vector<Point2> expected(const PlanarTarget& target, const Intrinsics& in, const Extrinsics& pose) {
  std::vector<Point2> all;
  for (const Point2& p : target.points()) {
    Point2 at = p;
    if (target.pattern != TargetPattern::Chessboard) {
      const double depth = (pose.rotation * Point3(p.x(), p.y(), 0) + pose.translationMm).z();
      at = circleCentreInPlane<double>(p, target.diameterMm / 2, pose.rotation(2, 0), pose.rotation(2, 1), depth);
    }
    Point2 px = project<double>(lens(in), pose.rotation, pose.translationMm, Point3(at.x(), at.y(), 0));
    if (target.pattern != TargetPattern::Chessboard) px += circleImageShift(in, pose, p, target.diameterMm / 2);
    all.push_back(px);
  }
  return all;
}

struct Errors {
  std::size_t points = 0;
  double rmsPx = 0;    ///< of a coordinate
  double chi2 = 0;     ///< mean of (error / u)^2 of a coordinate
  double worstPx = 0;  ///< largest distance
  double meanU = 0;
};

class ErrorSum {
 public:
  void add(const TargetView& view, const std::vector<Point2>& truth) {
    for (const FoundPoint& p : view.points) {
      const double square = (p.px - truth[static_cast<std::size_t>(p.index)]).squaredNorm();
      squares_ += square;
      weighted_ += square / (p.uPx * p.uPx);
      u_ += p.uPx;
      worst_ = std::max(worst_, std::sqrt(square));
      ++count_;
    }
  }
  [[nodiscard]] Errors result() const {
    const double n = static_cast<double>(count_);
    return {count_, std::sqrt(squares_ / (2 * n)), weighted_ / (2 * n), worst_, u_ / n};
  }

 private:
  std::size_t count_ = 0;
  double squares_ = 0, weighted_ = 0, worst_ = 0, u_ = 0;
};

}  // namespace vignole::rendered
