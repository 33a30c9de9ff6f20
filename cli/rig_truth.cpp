#include "cli/rig_truth.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace vignole::cli {

namespace {

using Json = nlohmann::ordered_json;

double shortened(double px) { return std::round(px * 1e4) / 1e4; }

}  // namespace

Json intrinsicsTruth(const Intrinsics& in) {
  Json json = {{"focal_mm", in.focalMm},
               {"pixel_width_mm", in.pixelWidthMm},
               {"pixel_height_mm", in.pixelHeightMm},
               {"cx_px", in.cxPx},
               {"cy_px", in.cyPx},
               {"width_px", in.widthPx},
               {"height_px", in.heightPx}};
  if (in.model == DistortionModel::Division) {
    json["model"] = "division";
    json["kappa_per_mm2"] = in.kappa;
  } else {
    json["model"] = "polynomial";
    json["k"] = {in.k1, in.k2, in.k3};
    json["p"] = {in.p1, in.p2};
  }
  return json;
}

Json poseTruth(const Extrinsics& pose) {
  Json rotation = Json::array();
  for (int row = 0; row < 3; ++row)
    rotation.push_back({pose.rotation(row, 0), pose.rotation(row, 1), pose.rotation(row, 2)});
  const auto& t = pose.translationMm;
  return {{"rotation", std::move(rotation)}, {"translation_mm", {t.x(), t.y(), t.z()}}};
}

Json rigTruth(const RigCalibration& rig) {
  Json cameras = Json::array();
  for (const RangeFinderCalibration& finder : rig.rangeFinders)
    cameras.push_back({{"camera", cameras.size() + 1},
                       {"serial", finder.serial},
                       {"intrinsics", intrinsicsTruth(finder.intrinsics)},
                       {"camera_from_world", poseTruth(finder.cameraFromWorld)}});
  return {{"id", rig.id}, {"cameras", std::move(cameras)}};
}

Json pixelsTruth(const std::vector<Point2>& pixels) {
  Json points = Json::array();
  for (const Point2& px : pixels) points.push_back({shortened(px.x()), shortened(px.y())});
  return points;
}

}  // namespace vignole::cli
