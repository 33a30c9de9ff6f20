#include "report/intrinsics_report.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/optics/paper_parameters.h"
#include "report/number_text.h"

namespace vignole {

namespace {

constexpr std::size_t kMostPictures = 16;

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : "; ") + text;
  return all;
}

std::string fileName(const std::string& path) { return std::filesystem::path(path).filename().string(); }

VerdictLine verdict(const IntrinsicsCalibration& c) {
  if (!c.accepted()) return {Standing::Bad, "Refused", joined(c.refusals)};
  if (!c.warnings.empty()) return {Standing::Near, "May be used", joined(c.warnings)};
  return {Standing::Good, "May be used",
          "mean reprojection error " + fixedText(c.camera.meanPx, 3) + " px with the lens model " + name(c.variant) +
              ", chosen by pictures that it had not seen"};
}

FactList facts(const IntrinsicsReport& report) {
  const IntrinsicsCalibration& c = *report.calibration;
  const auto used = std::count_if(c.views.begin(), c.views.end(), [](const ViewResult& v) { return v.used; });
  return {{{"Camera", c.camera.serial.empty() ? "\u2013" : c.camera.serial},
           {"Made (UTC)", c.camera.created},
           {"Target", words(*report.target)},
           {"Views used", std::to_string(used) + " of " + std::to_string(c.views.size())},
           {"Lens model", name(c.variant)},
           {"RMS, mean error", fixedText(c.camera.rmsPx, 3) + ", " + fixedText(c.camera.meanPx, 3) + " px"},
           {"Picture covered", fixedText(100 * c.coverage.share(), 0) + " %"},
           {"Target off by", c.targetErrorMm > 0 ? fixedText(1000 * c.targetErrorMm, 0) + " \u00b5m (found)"
                                                 : std::string("taken as stated")}}};
}

TableBlock tableThree(const IntrinsicsCalibration& c) {
  TableBlock table{"Table III: internal parameters",
                   {"<Distortion model", "mean error px", "RMS px", "held out RMS px", "focal length mm"},
                   {},
                   {},
                   "Analytical: division model (kappa); numerical: polynomial (k, p). Held out: of pictures that the "
                   "model had not seen; by it the model was chosen."};
  const auto row = [&](const std::string& label, const VariantResult& v) {
    table.rows.push_back({label + " (" + name(v.variant) + ")", fixedText(v.meanPx, 3), fixedText(v.rmsPx, 3),
                          fixedText(v.heldOutRmsPx, 3), fixedText(v.intrinsics.focalMm, 3)});
    table.standings.push_back(v.variant == c.variant ? Standing::Good : Standing::None);
  };
  if (c.division) row("Analytical", *c.division);
  if (c.polynomial) row("Numerical", *c.polynomial);
  for (const VariantResult& v : c.variants)
    if ((!c.division || !(v.variant == c.division->variant)) &&
        (!c.polynomial || !(v.variant == c.polynomial->variant)))
      row("also tried", v);
  return table;
}

TableBlock parameters(const IntrinsicsCalibration& c) {
  TableBlock table{
      "Parameters",
      {"<parameter", "value", "u", "<unit"},
      {},
      {},
      "s^x is fixed: only f / s^x can be observed. Distortion in mm on the sensor, from the distorted to the "
      "undistorted point."};
  for (const PaperParameter& p : paperParameters(c.camera.intrinsics, c.camera.covariance))
    table.rows.push_back({p.name, significantText(p.value, 8), p.u > 0 ? significantText(p.u, 2) : "\u2013", p.unit});
  return table;
}

Curve frameOf(const Intrinsics& in) {
  const double w = in.widthPx - 1, h = in.heightPx - 1;
  return {"", {{0, 0}, {w, 0}, {w, h}, {0, h}, {0, 0}}, 4, true, 1};
}

TableBlock viewTable(const IntrinsicsCalibration& c) {
  TableBlock table{"Views", {"<picture", "points", "rejected", "RMS px", "mean px", "<not used, because"}, {}, {}, ""};
  for (const ViewResult& v : c.views) {
    table.rows.push_back({fileName(v.file), std::to_string(v.points), std::to_string(v.rejected),
                          v.used ? fixedText(v.rmsPx, 3) : "", v.used ? fixedText(v.meanPx, 3) : "", v.reason});
    table.standings.push_back(v.used ? Standing::None : Standing::Near);
  }
  return table;
}

PictureBlock pictures(const IntrinsicsReport& report) {
  PictureBlock block{"Pictures (Fig. 7)", 4, {}, "Dots: the points found."};
  for (std::size_t i = 0; i < report.pictures.size() && block.cells.size() < kMostPictures; ++i) {
    const Picture* picture = report.pictures[i];
    if (picture == nullptr || i >= report.calibration->views.size()) continue;
    const ViewResult& view = report.calibration->views[i];
    PictureCell cell{picture->width, picture->height, picture->pixels, {}, fileName(view.file)};
    Curve dots{"", {}, view.used ? 1 : 6, false, 2.5};
    for (const PointResult& p : view.pointResults) dots.points.push_back(p.px);
    cell.curves.push_back(std::move(dots));
    block.cells.push_back(std::move(cell));
  }
  return block;
}

}  // namespace

PlotBlock lensMaps(const IntrinsicsCalibration& c) {
  const Intrinsics& in = c.camera.intrinsics;
  Plot seen{"Points of all views", "column px", "row px", {frameOf(in)}, true, true, {}, false};
  Curve dots{"", {}, 5, false, 2};
  double worst = 1e-6;
  for (const ViewResult& view : c.views)
    for (const PointResult& p : view.pointResults)
      if (view.used && p.used) {
        dots.points.push_back(p.px);
        worst = std::max(worst, p.errorPx.norm());
      }
  seen.curves.push_back(std::move(dots));

  Plot residuals{"Mean residual by place", "column px", "row px", {frameOf(in)}, true, true, {}, false};
  const Coverage& coverage = c.coverage;
  double longest = 1e-6;
  for (const CoverageCell& cell : coverage.cells)
    if (cell.points > 0) longest = std::max(longest, cell.meanErrorPx.norm());
  const double cellPx = static_cast<double>(in.widthPx) / std::max(1, coverage.columns);
  const double magnify = 0.9 * cellPx / longest;
  for (int row = 0; row < coverage.rows; ++row)
    for (int column = 0; column < coverage.columns; ++column) {
      const CoverageCell& cell =
          coverage.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(coverage.columns) +
                         static_cast<std::size_t>(column)];
      if (cell.points == 0) continue;
      const Point2 at((column + 0.5) * cellPx, (row + 0.5) * in.heightPx / std::max(1, coverage.rows));
      residuals.curves.push_back({"", {at, at + magnify * cell.meanErrorPx}, 6, true, 1.6});
      residuals.curves.push_back({"", {at}, 4, false, 3.5});
    }
  return {"Coverage and residuals",
          2,
          0.86,
          {std::move(seen), std::move(residuals)},
          "Right: what the points of a cell have in common, magnified " + fixedText(magnify, 0) +
              " times (the longest is " + fixedText(longest, 3) + " px)."};
}

Document intrinsicsDocument(const IntrinsicsReport& report) {
  const IntrinsicsCalibration& c = *report.calibration;
  Document document;
  document.title = "Calibration of a lens";
  document.subject = c.camera.serial.empty() ? "camera" : c.camera.serial;
  document.foot = "target " + words(*report.target) + "   " + c.camera.created;
  auto& blocks = document.blocks;
  blocks.emplace_back(verdict(c));
  blocks.emplace_back(facts(report));
  blocks.emplace_back(tableThree(c));
  if (c.openCv)
    blocks.emplace_back(Paragraph{"OpenCV's calibrateCamera with the same points and as many parameters: RMS " +
                                      fixedText(c.openCv->rmsPx, 3) + " px.",
                                  true});
  blocks.emplace_back(parameters(c));
  if (!report.advice.empty()) {
    blocks.emplace_back(Heading{"The next picture"});
    blocks.emplace_back(Paragraph{report.advice, false});
  }
  blocks.emplace_back(lensMaps(c));
  if (!report.pictures.empty()) blocks.emplace_back(pictures(report));
  blocks.emplace_back(viewTable(c));
  return document;
}

}  // namespace vignole
