#include "report/magnified_outline.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace vignole {

namespace {

constexpr double kCornerRadiusMm = 7.0;  // arcs up to this radius are joined across, not followed
constexpr double kBridgedGapMm = 2.0;    // a gap this short is no missing stretch
constexpr double kCrownDepthMm = 20.0;   // the crown ends somewhere above this depth
constexpr double kWebHalfMm = 16.0;      // half length of the stretch that stands for the web thickness
constexpr double kFootHalfMm = 8.0;      // the same for the foot thickness
constexpr double kFishingHalfMm = 6.0;   // and for the fishing height

void take(OutlineBin& bin, std::initializer_list<Dimension> dimensions) {
  for (const Dimension d : dimensions) bin.dimensions = static_cast<std::uint16_t>(bin.dimensions | 1u << index(d));
}

bool isCorner(const Primitive& primitive) {
  const Arc* arc = std::get_if<Arc>(&primitive);
  return arc != nullptr && arc->radiusMm <= kCornerRadiusMm + 1e-9;
}

bool within(double value, double middle, double half) { return std::abs(value - middle) <= half; }

}  // namespace

MagnifiedOutline::MagnifiedOutline(const Section& section, const DimensionParameters& parameters, double stepMm)
    : section_(section) {
  sample(section, stepMm);
  markDimensions(section, parameters);
}

void MagnifiedOutline::sample(const Section& section, double stepMm) {
  firstBin_.reserve(section.primitives.size() + 1);
  stepMm_.reserve(section.primitives.size());
  bins_.reserve(2048);
  for (std::size_t p = 0; p < section.primitives.size(); ++p) {
    const Primitive& shape = section.primitives[p].shape;
    const double whole = length(shape);
    const auto count = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(whole / stepMm)));
    firstBin_.push_back(bins_.size());
    stepMm_.push_back(whole / static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
      const double s = (static_cast<double>(i) + 0.5) * stepMm_.back();
      OutlineBin bin;
      bin.point = pointAt(shape, s);
      bin.normal = normalAt(shape, s);
      bin.primitive = static_cast<std::uint16_t>(p);
      bin.corner = isCorner(shape);
      bins_.push_back(bin);
    }
  }
  firstBin_.push_back(bins_.size());
}

double thinnestWebHeightMm(const Section& section, const std::vector<OutlineBin>& bins) {
  const double height = section.heightMm();
  const auto isWeb = [&](const OutlineBin& b) {
    return b.normal.x() > 0.5 && b.point.y() > 0.25 * height && b.point.y() < 0.75 * height;
  };
  double thinnest = std::numeric_limits<double>::infinity();
  for (const OutlineBin& b : bins)
    if (isWeb(b)) thinnest = std::min(thinnest, b.point.x());
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const OutlineBin& b : bins)
    if (isWeb(b) && b.point.x() <= thinnest + 1e-6) {
      low = std::min(low, b.point.y());
      high = std::max(high, b.point.y());
    }
  return low <= high ? 0.5 * (low + high) : 0.5 * height;
}

void MagnifiedOutline::markDimensions(const Section& section, const DimensionParameters& parameters) {
  const double height = section.heightMm(), axis = section.axisFromFootMiddleMm;
  const double webHeight = parameters.wtHeightMm.value_or(thinnestWebHeightMm(section, bins_));
  double leftEdge = 0, rightEdge = 0;
  for (const OutlineBin& b : bins_) {
    leftEdge = std::min(leftEdge, b.point.x());
    rightEdge = std::max(rightEdge, b.point.x());
  }
  for (OutlineBin& b : bins_) {
    const std::string& primitive = section.primitives[b.primitive].name;
    const double x = b.point.x() - axis, y = b.point.y();
    const bool left = x < 0;
    const double crownHalf = left ? parameters.hfHalfWidthMm.left : parameters.hfHalfWidthMm.right;
    if (y > height - kCrownDepthMm && b.normal.y() > 0.5 && std::abs(x) <= crownHalf)
      take(b, {Dimension::RH, Dimension::HF});
    if (primitive == "AHT") take(b, {Dimension::HR});
    if (primitive == "SHL" || primitive == "SHR")
      take(b, {Dimension::HW, Dimension::HWA, left ? Dimension::RASl : Dimension::RASr});
    if (primitive == "SBL" || primitive == "SBR") take(b, {Dimension::FW, left ? Dimension::RASl : Dimension::RASr});
    if (primitive == "SBB") take(b, {Dimension::FC});
    if (std::abs(b.normal.x()) > 0.9 && within(y, webHeight, std::min(kWebHalfMm, 0.1 * height)))
      take(b, {Dimension::WT});
    const double fishing = left ? parameters.rfhFromAxisMm.left : parameters.rfhFromAxisMm.right;
    if ((primitive.starts_with("SHB") || primitive.starts_with("SWB")) && within(std::abs(x), fishing, kFishingHalfMm))
      take(b, {Dimension::RFH});
    const double inside = left ? b.point.x() - leftEdge : rightEdge - b.point.x();
    const double footAt = left ? parameters.ftInsideMm.left : parameters.ftInsideMm.right;
    if (!b.corner && b.normal.y() > 0.5 && y < 0.25 * height && within(inside, footAt, kFootHalfMm))
      take(b, {left ? Dimension::FTl : Dimension::FTr});
  }
}

void MagnifiedOutline::place(const Profile& profile, const Registration& registration, bool keepPoints) {
  if (!registration.valid) return;
  const std::size_t count = std::min(profile.points.size(), registration.primitiveOfPoint.size());
  if (keepPoints) points_.reserve(count);
  const Transform2 sectionFromWorld = registration.worldFromSection.inverse();
  const double c = std::cos(sectionFromWorld.angleRad), s = std::sin(sectionFromWorld.angleRad);
  for (std::size_t i = 0; i < count; ++i) {
    const ProfilePoint& world = profile.points[i];
    const Point2 point(c * world.x - s * world.y + sectionFromWorld.xMm,
                       s * world.x + c * world.y + sectionFromWorld.yMm);
    const int primitive = registration.primitiveOfPoint[i];
    if (primitive < 0 || static_cast<std::size_t>(primitive) >= section_.primitives.size()) {
      unassigned_.push_back(point);
      continue;
    }
    const auto p = static_cast<std::size_t>(primitive);
    const Nearest foot = nearest(section_.primitives[p].shape, point);
    const float deviation =
        i < registration.residualMm.size() ? registration.residualMm[i] : static_cast<float>(foot.distanceMm);
    if (!std::isfinite(deviation)) continue;
    const std::size_t last = firstBin_[p + 1] - firstBin_[p] - 1;
    const auto slot = static_cast<std::size_t>(std::max(0.0, foot.arcLengthMm / stepMm_[p]));
    OutlineBin& bin = bins_[firstBin_[p] + std::min(slot, last)];
    bin.deviationMm += deviation;
    ++bin.points;
    if (keepPoints) points_.push_back({foot.point, foot.normal, deviation, world.camera});
  }
  for (OutlineBin& bin : bins_)
    if (bin.points > 0) {
      bin.deviationMm /= static_cast<float>(bin.points);
      bin.seen = true;
    }
  bridgeGaps();
}

void MagnifiedOutline::bridgeGaps() {
  const std::size_t n = bins_.size();
  const auto start = std::find_if(bins_.begin(), bins_.end(), [](const OutlineBin& b) { return b.seen; });
  if (start == bins_.end()) return;
  const auto origin = static_cast<std::size_t>(start - bins_.begin());
  const auto at = [&](std::size_t k) -> OutlineBin& { return bins_[(origin + k) % n]; };
  for (std::size_t k = 0; k < n;) {
    if (at(k).points > 0) {
      ++k;
      continue;
    }
    std::size_t end = k;
    double gap = 0;
    for (; end < n && at(end).points == 0; ++end) gap += stepMm_[at(end).primitive];
    if (gap <= kBridgedGapMm) {
      const float before = at(k - 1).deviationMm, after = at(end).deviationMm;
      for (std::size_t i = k; i < end; ++i) {
        const float t = static_cast<float>(i - k + 1) / static_cast<float>(end - k + 1);
        at(i).deviationMm = before + t * (after - before);
        at(i).seen = true;
      }
    }
    k = end;
  }
}

}  // namespace vignole
