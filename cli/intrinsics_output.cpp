#include "cli/intrinsics_output.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "calibration/lens_files/opencv_lens.h"

namespace vignole::cli {
namespace {

using Json = nlohmann::ordered_json;

Json pair(const Point2& p) { return Json::array({p.x(), p.y()}); }

template <typename... Arguments>
std::string printed(const char* format, Arguments... arguments) {
  char text[512];
  std::snprintf(text, sizeof text, format, arguments...);
  return text;
}

double uncertainty(const CalibratedIntrinsics& camera, CameraParameter p) {
  return std::sqrt(camera.covariance(static_cast<int>(p), static_cast<int>(p)));
}

/// fy = f / s^y: the two are correlated where both were estimated.
double uFy(const CalibratedIntrinsics& camera) {
  const Intrinsics& in = camera.intrinsics;
  Eigen::Matrix<double, 1, kIntrinsicParameters> by = Eigen::Matrix<double, 1, kIntrinsicParameters>::Zero();
  by[static_cast<int>(CameraParameter::F)] = 1 / in.pixelHeightMm;
  by[static_cast<int>(CameraParameter::PixelHeight)] = -in.focalMm / (in.pixelHeightMm * in.pixelHeightMm);
  return std::sqrt((by * camera.covariance * by.transpose()).value());
}

Json uncertaintyJson(const CalibratedIntrinsics& camera) {
  const Intrinsics& in = camera.intrinsics;
  const auto u = [&](CameraParameter p) { return uncertainty(camera, p); };
  Json j = {{"f_mm", u(CameraParameter::F)},
            {"fx_px", u(CameraParameter::F) / in.pixelWidthMm},
            {"fy_px", uFy(camera)},
            {"cx_px", u(CameraParameter::U0)},
            {"cy_px", u(CameraParameter::V0)},
            {"s_y_mm", u(CameraParameter::PixelHeight)}};
  if (in.model == DistortionModel::Division) {
    j["kappa"] = u(CameraParameter::Kappa);
  } else {
    j["k"] = {u(CameraParameter::K1), u(CameraParameter::K2), u(CameraParameter::K3)};
    j["p"] = {u(CameraParameter::P1), u(CameraParameter::P2)};
  }
  return j;
}

Json covarianceJson(const IntrinsicsCalibration& c) {
  Json names = Json::array(), covariance = Json::array(), correlation = Json::array();
  for (const CameraParameter row : freeParameters(c.variant)) {
    names.push_back(name(row));
    Json covarianceRow = Json::array(), correlationRow = Json::array();
    for (const CameraParameter column : freeParameters(c.variant)) {
      covarianceRow.push_back(c.camera.covariance(static_cast<int>(row), static_cast<int>(column)));
      correlationRow.push_back(c.correlation(static_cast<int>(row), static_cast<int>(column)));
    }
    covariance.push_back(std::move(covarianceRow));
    correlation.push_back(std::move(correlationRow));
  }
  return {
      {"parameters", std::move(names)}, {"covariance", std::move(covariance)}, {"correlation", std::move(correlation)}};
}

Json variantJson(const VariantResult& v) {
  return {{"variant", name(v.variant)},
          {"rms_px", v.rmsPx},
          {"mean_px", v.meanPx},
          {"held_out_rms_px", v.heldOutRmsPx},
          {"f_mm", v.intrinsics.focalMm}};
}

Json crossValidationJson(const IntrinsicsCalibration& c) {
  Json j = {{"division", c.division ? Json(c.division->heldOutRmsPx) : Json()},
            {"polynomial", c.polynomial ? Json(c.polynomial->heldOutRmsPx) : Json()}};
  Json variants = Json::object();
  for (const VariantResult& v : c.variants) variants[name(v.variant)] = v.heldOutRmsPx;
  j["variants"] = std::move(variants);
  return j;
}

Json tableIIIJson(const IntrinsicsCalibration& c) {
  Json rows = Json::array();
  const auto add = [&](const char* model, const std::optional<VariantResult>& v) {
    if (!v) return;
    Json row = variantJson(*v);
    row["model"] = model;
    rows.push_back(std::move(row));
  };
  add("analytical", c.division);
  add("numerical", c.polynomial);
  return rows;
}

Json poseJson(const Extrinsics& pose) {
  Json rotation = Json::array();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) rotation.push_back(pose.rotation(row, column));
  return {{"rotation", std::move(rotation)},
          {"translation_mm", {pose.translationMm.x(), pose.translationMm.y(), pose.translationMm.z()}}};
}

Json viewsJson(const IntrinsicsCalibration& c) {
  Json views = Json::array();
  for (const ViewResult& v : c.views) {
    Json view = {{"file", v.file}, {"used", v.used}, {"reason", v.reason}};
    const bool fitted = v.points > 0;
    view["rms_px"] = fitted ? Json(v.rmsPx) : Json();
    view["mean_px"] = fitted ? Json(v.meanPx) : Json();
    view["points"] = v.points;
    view["rejected_points"] = v.rejected;
    if (fitted) view["camera_from_target"] = poseJson(v.cameraFromTarget);
    Json residuals = Json::array();
    for (const PointResult& p : v.pointResults)
      residuals.push_back({{"index", p.index}, {"px", pair(p.px)}, {"error_px", pair(p.errorPx)}, {"used", p.used}});
    view["residuals"] = std::move(residuals);
    views.push_back(std::move(view));
  }
  return views;
}

Json coverageJson(const Coverage& coverage) {
  Json points = Json::array(), rms = Json::array(), mean = Json::array();
  for (const CoverageCell& cell : coverage.cells) {
    points.push_back(cell.points);
    rms.push_back(cell.points > 0 ? Json(cell.rmsPx) : Json());
    mean.push_back(cell.points > 0 ? pair(cell.meanErrorPx) : Json());
  }
  return {{"columns", coverage.columns}, {"rows", coverage.rows},    {"share", coverage.share()},
          {"points", std::move(points)}, {"rms_px", std::move(rms)}, {"mean_error_px", std::move(mean)}};
}

Json openCvJson(const Intrinsics& in) {
  const ToOpenCv c = toOpenCv(in);
  return {{"k", {c.lens.k1, c.lens.k2, c.lens.p1, c.lens.p2, c.lens.k3}}, {"max_residual_px", c.maxResidualPx}};
}

Json referenceJson(const OpenCvReference& r) {
  return {{"rms_px", r.rmsPx},         {"fx_px", r.fxPx}, {"fy_px", r.fyPx},
          {"cx_px", r.cxPx},           {"cy_px", r.cyPx}, {"k", {r.k1, r.k2, r.p1, r.p2, r.k3}},
          {"parameters", r.parameters}};
}

Json targetJson(const IntrinsicsCalibration& c) {
  Json corrections = Json::array();
  for (const Point2& p : c.targetCorrectionsMm) corrections.push_back(pair(p));
  return {{"estimated", c.targetErrorMm > 0},
          {"error_mm", c.targetErrorMm},
          {"bend_mm", c.targetBendMm},
          {"corrections_mm", std::move(corrections)},
          {"heights_mm", c.targetHeightsMm}};
}

Json nextPoseJson(const NextPose& next) {
  Json outline = Json::array(), gains = Json::array();
  for (const Point2& p : next.outlinePx) outline.push_back(pair(p));
  for (const ExpectedGain& g : next.gains) {
    const std::string unit = g.dimension ? "_mm" : "_px";
    gains.push_back({{"name", g.dimension ? Json(name(*g.dimension)) : Json("shift in the picture")},
                     {"u" + unit, g.before},
                     {"u_after" + unit, g.after}});
  }
  return {{"words", next.words},
          {"camera_from_target", poseJson(next.cameraFromTarget)},
          {"outline_px", std::move(outline)},
          {"gains", std::move(gains)},
          {"remaining_variance", next.remainingShare}};
}

std::string parameterLine(const CalibratedIntrinsics& camera, CameraParameter p, double value, const char* unit) {
  return printed("  %-6s %14.6g  u %.2g %s\n", std::string(name(p)).c_str(), value, uncertainty(camera, p), unit);
}

std::string parameterTable(const IntrinsicsCalibration& c) {
  const Intrinsics& in = c.camera.intrinsics;
  std::string text = parameterLine(c.camera, CameraParameter::F, in.focalMm, "mm");
  text += printed("  %-6s %14.6g  fixed, mm\n", "s_x", in.pixelWidthMm);
  text += c.variant.aspect ? parameterLine(c.camera, CameraParameter::PixelHeight, in.pixelHeightMm, "mm")
                           : printed("  %-6s %14.6g  as s_x, mm\n", "s_y", in.pixelHeightMm);
  text += parameterLine(c.camera, CameraParameter::U0, in.cxPx, "px");
  text += parameterLine(c.camera, CameraParameter::V0, in.cyPx, "px");
  if (in.model == DistortionModel::Division)
    return text + parameterLine(c.camera, CameraParameter::Kappa, in.kappa, "1/mm^2");
  text += parameterLine(c.camera, CameraParameter::K1, in.k1, "1/mm^2");
  if (c.variant.radial > 1) text += parameterLine(c.camera, CameraParameter::K2, in.k2, "1/mm^4");
  if (c.variant.radial > 2) text += parameterLine(c.camera, CameraParameter::K3, in.k3, "1/mm^6");
  if (c.variant.tangential)
    text += parameterLine(c.camera, CameraParameter::P1, in.p1, "1/mm") +
            parameterLine(c.camera, CameraParameter::P2, in.p2, "1/mm");
  return text;
}

std::string modelTable(const IntrinsicsCalibration& c) {
  std::string text = printed("  %-22s %9s %9s %12s %12s\n", "Table III", "RMS px", "mean px", "held out px", "f mm");
  const auto row = [](const char* model, const std::optional<VariantResult>& v) {
    if (!v) return std::string();
    return printed("  %-22s %9.4f %9.4f %12.4f %12.4f\n",
                   (std::string(model) + " " +
                    (v->variant.model == DistortionModel::Division ? std::string(v->variant.aspect ? "s_y" : "")
                                                                   : "(" + name(v->variant) + ")"))
                       .c_str(),
                   v->rmsPx, v->meanPx, v->heldOutRmsPx, v->intrinsics.focalMm);
  };
  return text + row("analytical", c.division) + row("numerical", c.polynomial);
}

std::string openCvLine(const char* what, const std::optional<OpenCvReference>& r, const Intrinsics& in) {
  if (!r) return {};
  return printed("  %-22s %9.4f %9s %12s %12.4f   fx %.2f fy %.2f px\n", what, r->rmsPx, "", "",
                 r->fxPx * in.pixelWidthMm, r->fxPx, r->fyPx);
}

std::string nextPoseText(const NextPose& next) {
  std::string text =
      "next picture: " + next.words + printed(" (leaves %.0f %% of the variance", 100 * next.remainingShare);
  for (const ExpectedGain& g : next.gains) {
    if (!g.dimension)
      text += printed("; %.3f -> %.3f px in the picture", g.before, g.after);
    else if (*g.dimension == Dimension::HW || *g.dimension == Dimension::FW || *g.dimension == Dimension::RH)
      text += printed("; %s %.1f -> %.1f um", std::string(name(*g.dimension)).c_str(), 1000 * g.before, 1000 * g.after);
  }
  return text + ")\n";
}

bool calibrated(const IntrinsicsCalibration& c) { return c.division.has_value(); }

}  // namespace

Json lensJson(const Intrinsics& in) {
  Json j = {{"model", in.model == DistortionModel::Division ? "division" : "polynomial"},
            {"fx_px", in.focalMm / in.pixelWidthMm},
            {"fy_px", in.focalMm / in.pixelHeightMm},
            {"cx_px", in.cxPx},
            {"cy_px", in.cyPx},
            {"f_mm", in.focalMm},
            {"s_x_mm", in.pixelWidthMm},
            {"s_y_mm", in.pixelHeightMm},
            {"width_px", in.widthPx},
            {"height_px", in.heightPx}};
  if (in.model == DistortionModel::Division) {
    j["kappa"] = in.kappa;
    j["units"] = {{"kappa", "1/mm^2"}};
  } else {
    j["k"] = {in.k1, in.k2, in.k3};
    j["p"] = {in.p1, in.p2};
    j["units"] = {{"k", {"1/mm^2", "1/mm^4", "1/mm^6"}}, {"p", "1/mm"}};
  }
  j["direction"] = "distorted to undistorted, on the sensor";
  return j;
}

Json toJson(const IntrinsicsCalibration& c, const std::optional<NextPose>& next,
            const std::vector<ExportedLens>& exported) {
  Json j = {{"accepted", c.accepted()}, {"refusals", c.refusals}, {"warnings", c.warnings}};
  if (calibrated(c)) {
    j.update(lensJson(c.camera.intrinsics));
    j["variant"] = name(c.variant);
    j["rms_px"] = c.camera.rmsPx;
    j["mean_px"] = c.camera.meanPx;
    j["u"] = uncertaintyJson(c.camera);
    j["covariance"] = covarianceJson(c);
    j["cross_validation"] = crossValidationJson(c);
    j["table_iii"] = tableIIIJson(c);
    Json variants = Json::array();
    for (const VariantResult& v : c.variants) variants.push_back(variantJson(v));
    j["variants"] = std::move(variants);
    j["opencv"] = openCvJson(c.camera.intrinsics);
    if (c.openCv) j["opencv_reference"] = referenceJson(*c.openCv);
    if (c.openCvTargetAsStated) j["opencv_reference_target_as_stated"] = referenceJson(*c.openCvTargetAsStated);
    j["chi2_per_dof"] = c.chi2PerDof;
    j["unexplained_px"] = c.unexplainedPx;
    j["target"] = targetJson(c);
  }
  j["views"] = viewsJson(c);
  j["coverage"] = coverageJson(c.coverage);
  if (next) j["next_pose"] = nextPoseJson(*next);
  if (!exported.empty()) {
    Json files = Json::array();
    for (const ExportedLens& e : exported) files.push_back({{"file", e.file}, {"max_residual_px", e.maxResidualPx}});
    j["exported"] = std::move(files);
  }
  j["seconds"] = c.seconds;
  return j;
}

std::string toTable(const IntrinsicsCalibration& c, const std::optional<NextPose>& next) {
  std::string text;
  if (calibrated(c)) {
    text += printed("model %s: reprojection error %.4f px RMS, %.4f px mean\n", name(c.variant).c_str(), c.camera.rmsPx,
                    c.camera.meanPx) +
            parameterTable(c) + modelTable(c);
    text += openCvLine("OpenCV, same points", c.openCv, c.camera.intrinsics) +
            openCvLine("OpenCV, as stated", c.openCvTargetAsStated, c.camera.intrinsics);
  }
  for (const ViewResult& v : c.views) {
    text += v.file + ": ";
    if (v.used)
      text += printed("%d points, %.3f px RMS%s", v.points, v.rmsPx,
                      v.rejected > 0 ? (", " + std::to_string(v.rejected) + " points rejected").c_str() : "");
    else
      text += v.reason.empty() ? "found, but too few pictures are of use" : "not used, " + v.reason;
    text += "\n";
  }
  for (const std::string& w : c.warnings) text += "note: " + w + "\n";
  for (const std::string& r : c.refusals) text += r + "\n";
  if (next) text += nextPoseText(*next);
  return text;
}

}  // namespace vignole::cli
