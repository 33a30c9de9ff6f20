#include "engine/simulator/line_painter.h"

#include <algorithm>
#include <cmath>

namespace vignole::simulator {

namespace {

constexpr double kPower = 4200;  // DN px/mm, so that a bare face seen frontally peaks near 200 DN
constexpr double kLaserReferenceMm = 480;
constexpr double kStepPx = 0.7;         // between samples of light; a ripple below 0.1 % at the sharpest
constexpr double kKernelReachMm = 2.5;  // a kernel serves this far along the outline
constexpr double kGhostSheetMm = 0.8, kGhostStepPx = 1.6;
constexpr double kGhostSpread = 2;  // a ghost is so much broader, so its energy for the same peak is higher

}  // namespace

void LinePainter::startStretch(const LitBy& lit) {
  lit_ = lit;
  first_ = true;
  kernelPlace_ = {1e9, 1e9};
  ghostKernel_ = false;
}

double LinePainter::step(const Point2& from, const Point2& to, const Point2& normal) {
  from_ = from;
  to_ = to;
  fromPx_ = first_ ? view_.pixel(from) : toPx_;
  toPx_ = view_.pixel(to);
  first_ = false;
  middle_ = (from + to) / 2;
  double light = 0;
  for (std::size_t k = 0; k < kCameraCount; ++k) {
    if (!lit_[k]) continue;
    const Point2 toLaser = rig_.lasers[k].positionMm - middle_;
    const double distance = toLaser.norm();
    light += view_.passes[k] * std::max(0.0, normal.dot(toLaser)) / (distance * distance) * kLaserReferenceMm;
  }
  const Point3 toCamera = (view_.centre - Point3(middle_.x(), middle_.y(), 0)).normalized();
  return light * (kPower * exposure_ * std::max(0.0, normal.dot(toCamera.head<2>())) * (to - from).norm());
}

double LinePainter::frontalLight(double lengthMm) const {
  const Point3 toCamera = (view_.centre - Point3(middle_.x(), middle_.y(), 0)).normalized();
  return kPower * exposure_ * toCamera.head<2>().norm() * lengthMm;
}

void LinePainter::paint(double light, double reflectanceFrom, double reflectanceTo) {
  if ((middle_ - kernelPlace_).squaredNorm() > kKernelReachMm * kKernelReachMm) {
    kernel_ = static_cast<std::uint32_t>(samples_.kernels.size());
    samples_.kernels.push_back(view_.kernelAt(pose_, middle_, view_.sheetSigmaMm, 0));
    kernelPlace_ = middle_;
    ghostKernel_ = false;
  }
  spread(fromPx_, toPx_, light, reflectanceFrom, reflectanceTo, kStepPx, kernel_);
}

void LinePainter::paintGhost(double light, double reflectanceFrom, double reflectanceTo, double offPlaneMm) {
  if (!ghostKernel_) {
    samples_.kernels.push_back(view_.kernelAt(pose_, middle_, kGhostSheetMm, offPlaneMm));
    ghostKernel_ = true;
  }
  spread(view_.pixel(from_, offPlaneMm), view_.pixel(to_, offPlaneMm), light * kGhostSpread, reflectanceFrom,
         reflectanceTo, kGhostStepPx, static_cast<std::uint32_t>(samples_.kernels.size() - 1));
}

void LinePainter::spread(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double light, double r0, double r1,
                         double stepPx, std::uint32_t kernel) {
  const int count = std::max(1, static_cast<int>(std::ceil((to - from).norm() / stepPx)));
  for (int i = 0; i < count; ++i) {
    const double t = (i + 0.5) / count;
    const Eigen::Vector2d at = from + t * (to - from);
    samples_.splats.push_back({static_cast<float>(at.x()), static_cast<float>(at.y()),
                               static_cast<float>(light * (r0 + t * (r1 - r0)) / count), kernel});
  }
}

}  // namespace vignole::simulator
