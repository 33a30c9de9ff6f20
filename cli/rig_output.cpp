#include "cli/rig_output.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "engine/optics/paper_parameters.h"

namespace vignole::cli {
namespace {

using Json = nlohmann::ordered_json;

template <typename... Arguments>
std::string printed(const char* format, Arguments... arguments) {
  char text[512];
  std::snprintf(text, sizeof text, format, arguments...);
  return text;
}

Json spread(const SpreadMm& s) { return {{"mean", s.mean}, {"std", s.std}, {"max", s.max}}; }

Eigen::MatrixXd covarianceOf(const RigCalibration& rig, int camera) {
  if (rig.covariance.size() == 0) return {};
  const int first = camera * kCameraParameters;
  return rig.covariance.block(first, first, kCameraParameters, kCameraParameters);
}

Json parameters(const RigCalibration& rig, int camera) {
  Json all = Json::array();
  for (const PaperParameter& p :
       paperParameters(rig.rangeFinders[static_cast<std::size_t>(camera)], covarianceOf(rig, camera)))
    all.push_back({{"name", p.name}, {"value", p.value}, {"u", p.u}, {"unit", p.unit}});
  return all;
}

Json pinView(const PinView& pin) {
  Json j = {{"pin", pin.pin},       {"placement", pin.placement + 1}, {"used", pin.used},
            {"reason", pin.reason}, {"arc_deg", pin.arcDeg},          {"points", pin.points}};
  if (pin.used)
    j.update({{"cd_mm", pin.cdMm},
              {"rd_mm", pin.rdMm},
              {"pd_mm", pin.pdMm},
              {"pd_nominal_mm", pin.pdNominalMm},
              {"left_out_mm", pin.leaveOneOutMm}});
  return j;
}

Json camera(const RigResult& result, int camera) {
  const RigAdjustment& a = result.adjustment;
  const RangeFinderFit& fit = a.finders[static_cast<std::size_t>(camera)];
  Json j = {{"camera", camera + 1},
            {"serial", a.calibration.rangeFinders[static_cast<std::size_t>(camera)].serial},
            {"cd", spread(fit.cd)},
            {"rd", spread(fit.rd)},
            {"pd", spread(fit.pd)},
            {"pd_nominal", spread(fit.pdNominal)},
            {"reprojection_px", fit.reprojectionPx},
            {"rms_px", fit.rmsPx},
            {"noise_px", fit.noisePx},
            {"noise_expected_px", fit.expectedNoisePx},
            {"correlated_points", fit.correlatedPoints},
            {"blur_px", a.calibration.rangeFinders[static_cast<std::size_t>(camera)].blurPx},
            {"sheet_thickness_mm", a.calibration.rangeFinders[static_cast<std::size_t>(camera)].lightPlane.thicknessMm},
            {"parameters", parameters(a.calibration, camera)},
            {"pictures", Json::array()},
            {"pins", Json::array()}};
  for (const PlacementLines& placement : result.inputs->placements) {
    const PinPicture& picture = placement.pictures[static_cast<std::size_t>(camera)];
    j["pictures"].push_back({{"file", picture.file},
                             {"used", picture.usable()},
                             {"reason", picture.refusal},
                             {"lines", picture.arcs.size()}});
  }
  for (const PinView& pin : a.pins)
    if (pin.camera == camera) j["pins"].push_back(pinView(pin));
  return j;
}

Json plate(const RigAdjustment& a) {
  Json pins = Json::array();
  for (const CalibratedPin& pin : a.calibration.pins)
    pins.push_back({{"pin", pin.number},
                    {"x_mm", pin.xMm},
                    {"y_mm", pin.yMm},
                    {"radius_mm", pin.radiusMm},
                    {"u_mm", pin.uMm},
                    {"u_radius_mm", pin.uRadiusMm}});
  return {{"id", a.calibration.plate}, {"pins", std::move(pins)}};
}

std::string tableFour(const RigAdjustment& a) {
  std::string text =
      "  Table IV, mm       CD mean    std    max   RD mean    std    max   PD mean    std    max   reproj. px\n";
  for (int c = 0; c < kCameraCount; ++c) {
    const RangeFinderFit& fit = a.finders[static_cast<std::size_t>(c)];
    text += printed("  camera %d           %7.3f%7.3f%7.3f   %7.3f%7.3f%7.3f   %7.3f%7.3f%7.3f   %10.3f\n", c + 1,
                    fit.cd.mean, fit.cd.std, fit.cd.max, fit.rd.mean, fit.rd.std, fit.rd.max, fit.pd.mean, fit.pd.std,
                    fit.pd.max, fit.reprojectionPx);
  }
  return text;
}

std::string dimensionTable(const RigResult& result) {
  std::string text = "  " + result.section + ", by the calibration alone, um      u   U (k=2)   worst contributors\n";
  for (const DimensionUncertainty& d : result.dimensions) {
    text += printed("  %-38s%7.1f%10.1f   ", std::string(name(d.dimension)).c_str(), 1000 * d.uMm, 2000 * d.uMm);
    for (std::size_t i = 0; i < d.contributions.size() && i < 3; ++i)
      text += printed("%s%s %.1f", i > 0 ? ", " : "", d.contributions[i].source.c_str(), 1000 * d.contributions[i].uMm);
    text += "\n";
  }
  return text;
}

std::string checkTable(const RigChecks& checks) {
  std::string text;
  for (const Check& check : checks.checks) {
    if (!check.done) {
      text += printed("  %-28s not done: %s\n", check.name.c_str(), check.words.c_str());
      continue;
    }
    text += printed("  %-28s%9.3g of %-8.3g%-4s %s: %s\n", check.name.c_str(), check.value, check.limit,
                    check.unit.c_str(), check.pass() ? "pass" : (check.refuses ? "FAIL" : "look"), check.words.c_str());
  }
  return text;
}

}  // namespace

Json toJson(const Check& check) {
  Json j = {{"name", check.name}, {"done", check.done},   {"value", check.value}, {"limit", check.limit},
            {"unit", check.unit}, {"pass", check.pass()}, {"words", check.words}, {"remedy", check.remedy}};
  if (!check.done) j["value"] = nullptr;
  return j;
}

Json toJson(const std::vector<DimensionUncertainty>& dimensions) {
  Json all = Json::array();
  for (const DimensionUncertainty& d : dimensions) {
    Json contributions = Json::array();
    for (const Contribution& c : d.contributions) contributions.push_back({{"source", c.source}, {"u_mm", c.uMm}});
    all.push_back({{"name", std::string(name(d.dimension))},
                   {"u_mm", d.uMm},
                   {"U_mm", 2 * d.uMm},
                   {"contributors", std::move(contributions)}});
  }
  return all;
}

Json toJson(const RigResult& result) {
  const RigAdjustment& a = result.adjustment;
  Json j = {{"accepted", result.refusals.empty()},   {"refusals", result.refusals}, {"warnings", a.warnings},
            {"method", std::string(name(a.method))}, {"id", a.calibration.id},      {"created", a.calibration.created},
            {"euler_angles", kEulerOrder},           {"cameras", Json::array()}};
  for (int c = 0; c < kCameraCount; ++c) j["cameras"].push_back(camera(result, c));
  j["plate"] = plate(a);
  j["placements"] = Json::array();
  for (const PlacedPlate& placed : a.placements)
    j["placements"].push_back({{"folder", placed.folder},
                               {"x_mm", placed.worldFromPlate.xMm},
                               {"y_mm", placed.worldFromPlate.yMm},
                               {"angle_deg", placed.worldFromPlate.angleRad * 57.29577951308232}});
  j["section"] = result.section;
  j["dimension_uncertainty"] = toJson(result.dimensions);
  j["checks"] = Json::array();
  for (const Check& check : result.checks.checks) j["checks"].push_back(toJson(check));
  j["intrinsics_freed"] = a.intrinsicsFreed;
  j["chi2_per_dof"] = a.chi2PerDof;
  j["solve_s"] = a.solveS;
  return j;
}

namespace {

/// A pin that no picture shows is not there, dirty, or hidden.
std::string pinsNeverSeen(const RigResult& result) {
  std::string text;
  for (const Pin& pin : result.inputs->plate.pins) {
    const auto seen = [&](const PinView& view) { return view.pin == pin.number && view.used; };
    const auto& views = result.adjustment.pins;
    if (std::none_of(views.begin(), views.end(), seen))
      text += printed("note: pin %d is used in no picture; look whether it is on the plate and clean\n", pin.number);
  }
  return text;
}

}  // namespace

std::string toTable(const RigResult& result) {
  const RigAdjustment& a = result.adjustment;
  std::size_t used = 0;
  for (const PinView& pin : a.pins) used += pin.used ? 1U : 0U;
  std::string text;
  if (used > 0) {
    text = printed("rig by %s: %zu of %zu pin views used, ", std::string(name(a.method)).c_str(), used, a.pins.size());
    if (a.chi2PerDof > 0) text += printed("chi2 per degree of freedom %.2f, ", a.chi2PerDof);
    text += printed("intrinsics %s, %.2f s\n", a.intrinsicsFreed ? "improved by the plate" : "as calibrated before",
                    a.solveS);
    text += tableFour(a) + pinsNeverSeen(result);
  }
  if (!result.dimensions.empty()) text += dimensionTable(result);
  text += checkTable(result.checks);
  for (const PlacementLines& placement : result.inputs->placements)
    for (const PinPicture& picture : placement.pictures)
      if (!picture.usable()) text += picture.file + ": " + picture.refusal + "\n";
  for (const std::string& warning : a.warnings) text += "note: " + warning + "\n";
  for (const std::string& refusal : result.refusals) text += refusal + "\n";
  return text;
}

}  // namespace vignole::cli
