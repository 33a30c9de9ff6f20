#include "report/rig_calibration_report.h"

#include <algorithm>
#include <map>
#include <set>

#include "engine/optics/paper_parameters.h"
#include "report/number_text.h"

namespace vignole {

namespace {

constexpr double kFullTurn = 6.283185307179586;

std::string cameraName(int camera) { return "camera " + std::to_string(camera + 1); }

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : "; ") + text;
  return all;
}

std::string methodName(RigMethod method) { return std::string(name(method)); }

VerdictLine verdict(const RigCalibrationReport& report) {
  const RigAdjustment& a = *report.adjustment;
  if (!report.refusals.empty()) return {Standing::Bad, "Refused", joined(report.refusals)};
  if (!a.warnings.empty()) return {Standing::Near, "May be used", joined(a.warnings)};
  const auto worst = std::max_element(report.dimensions.begin(), report.dimensions.end(),
                                      [](const auto& x, const auto& y) { return x.uMm < y.uMm; });
  std::string reason = "every check is within its limit";
  const auto hw = std::find_if(report.dimensions.begin(), report.dimensions.end(),
                               [](const auto& d) { return d.dimension == Dimension::HW; });
  if (worst != report.dimensions.end() && hw != report.dimensions.end() && !hw->contributions.empty())
    reason += "; with this calibration HW of " + report.section + " has U = \u00b1" + fixedText(2 * hw->uMm, 3) +
              " mm (k = 2), most of it by " + hw->contributions.front().source;
  return {Standing::Good, "May be used", reason};
}

FactList facts(const RigCalibrationReport& report) {
  const RigAdjustment& a = *report.adjustment;
  std::size_t used = 0;
  for (const PinView& pin : a.pins) used += pin.used ? 1U : 0U;
  const PinPlate& plate = report.inputs->plate;
  return {{{"Calibration", a.calibration.id},
           {"Made (UTC)", a.calibration.created},
           {"Method", methodName(a.method)},
           {"To be repeated", a.calibration.intervalDays > 0
                                  ? "after " + std::to_string(a.calibration.intervalDays) + " days"
                                  : std::string("no interval set")},
           {"Plate", plate.id + (plate.measured ? ", measured" : ", as drawn")},
           {"Placements", std::to_string(a.placements.size())},
           {"Pin views used", std::to_string(used) + " of " + std::to_string(a.pins.size())},
           {"Intrinsics", a.intrinsicsFreed ? "improved by the plate" : "as calibrated before"},
           {"chi\u00b2 / degree of freedom", fixedText(a.chi2PerDof, 2)},
           {"Solved in", fixedText(a.solveS, 2) + " s"}}};
}

TableBlock dimensionTable(const RigCalibrationReport& report) {
  TableBlock table{
      "What the calibration is worth on " + report.section,
      {"<Dimension", "u mm", "U (k=2) mm", "<largest contribution", "u mm", "<second", "u mm", "<third", "u mm"},
      {},
      {},
      "Standard uncertainty by the calibration alone, by propagation of the joint covariance; the squares of "
      "all contributions sum up to u\u00b2. The noise of the stripes comes on top, profile by profile."};
  for (const DimensionUncertainty& d : report.dimensions) {
    std::vector<std::string> row = {std::string(name(d.dimension)), fixedText(d.uMm, 4), fixedText(2 * d.uMm, 4)};
    for (std::size_t i = 0; i < 3; ++i) {
      const bool there = i < d.contributions.size();
      row.push_back(there ? d.contributions[i].source : "");
      row.push_back(there ? fixedText(d.contributions[i].uMm, 4) : "");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

TableBlock checkTable(const RigCalibrationReport& report) {
  TableBlock table{"Checks", {"<Check", "value", "limit", "<unit", "<what it says"}, {}, {}, ""};
  for (const Check& check : report.checks) {
    const bool bad = !check.pass();
    table.rows.push_back({check.name, check.done ? significantText(check.value, 3) : "\u2013",
                          significantText(check.limit, 3), check.unit, check.words});
    table.standings.push_back(!check.done ? Standing::None
                              : !bad      ? Standing::Good
                                          : (check.refuses ? Standing::Bad : Standing::Near));
  }
  return table;
}

TableBlock tableFour(const RigAdjustment& a) {
  TableBlock table{
      "Table IV: pins found against pins stated, mm",
      {"<Camera", "CD mean", "STD", "max", "RD mean", "STD", "max", "PD mean", "STD", "max", "reproj. px", "noise px"},
      {},
      {},
      "CD: distance of centres, RD: difference of radii, PD: mean distance of the points from the stated "
      "radius about the centre found; radius free, against the plate file. Reprojection: mean distance of "
      "points and pins in the picture."};
  for (int camera = 0; camera < kCameraCount; ++camera) {
    const RangeFinderFit& fit = a.finders[static_cast<std::size_t>(camera)];
    std::vector<std::string> row = {cameraName(camera)};
    for (const SpreadMm* spread : {&fit.cd, &fit.rd, &fit.pd})
      for (const double value : {spread->mean, spread->std, spread->max}) row.push_back(fixedText(value, 3));
    row.push_back(fixedText(fit.reprojectionPx, 3));
    row.push_back(fixedText(fit.noisePx, 3));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::vector<TableBlock> parameterTables(const RigAdjustment& a) {
  std::vector<TableBlock> tables;
  for (int camera = 0; camera < kCameraCount; ++camera) {
    const RangeFinderCalibration& finder = a.calibration.rangeFinders[static_cast<std::size_t>(camera)];
    TableBlock table{cameraName(camera) + " (" + finder.serial + ")",
                     {"<parameter", "value", "u", "<unit", "<parameter", "value", "u", "<unit"},
                     {},
                     {},
                     camera + 1 == kCameraCount ? std::string("Angles: ") + kEulerOrder +
                                                      "; t: the world's origin in the "
                                                      "camera's frame. s^x is fixed: only f / s^x can be observed."
                                                : std::string()};
    Eigen::MatrixXd covariance;
    if (a.calibration.covariance.size() > 0)
      covariance = a.calibration.covariance.block(camera * kCameraParameters, camera * kCameraParameters,
                                                  kCameraParameters, kCameraParameters);
    const std::vector<PaperParameter> all = paperParameters(finder, covariance);
    const std::size_t half = (all.size() + 1) / 2;
    for (std::size_t i = 0; i < half; ++i) {
      std::vector<std::string> row;
      for (const std::size_t k : {i, i + half}) {
        if (k >= all.size()) break;
        row.push_back(all[k].name);
        row.push_back(significantText(all[k].value, 8));
        row.push_back(all[k].u > 0 ? significantText(all[k].u, 2) : "\u2013");
        row.push_back(all[k].unit);
      }
      table.rows.push_back(std::move(row));
    }
    tables.push_back(std::move(table));
  }
  return tables;
}

PictureBlock pictures(const RigCalibrationReport& report, bool lines) {
  PictureBlock block;
  block.title = lines ? "Lines extracted (Fig. 8c)" : "Pictures of the first placement (Fig. 8b)";
  block.columns = lines ? 4 : 2;  // both on one page
  if (report.inputs->placements.empty()) return block;
  const PlacementLines& placement = report.inputs->placements.front();
  for (const int camera : {0, 1, 3, 2}) {
    const auto i = static_cast<std::size_t>(camera);
    const Picture* picture = report.pictures[i];
    PictureCell cell;
    const Intrinsics& in = report.adjustment->calibration.rangeFinders[i].intrinsics;
    cell.width = picture != nullptr ? picture->width : in.widthPx;
    cell.height = picture != nullptr ? picture->height : in.heightPx;
    cell.caption = cameraName(camera);
    if (!lines && picture != nullptr) cell.grey = picture->pixels;
    if (lines)
      for (const PinArc& arc : placement.pictures[i].arcs) {
        Curve curve{"", {}, arc.pin > 0 ? camera : 4, true, arc.pin > 0 ? 2.0 : 1.0};
        for (const ArcPoint& p : arc.points) curve.points.push_back(p.px);
        cell.curves.push_back(std::move(curve));
      }
    block.cells.push_back(std::move(cell));
  }
  block.note = lines ? "Grey: lines that were given no pin." : "Clockwise from the top left: camera 1, 2, 3, 4.";
  return block;
}

PlotBlock features(const RigAdjustment& a) {
  return {"Pins in the world (Fig. 8d)",
          1,
          0.95,
          {pinsInWorld(a)},
          "Circles: the pins as found; points: the lines of the first placement through the calibration."};
}

TableBlock pinTable(const RigAdjustment& a) {
  TableBlock table{"Pins, one view a row",
                   {"<placement", "<camera", "pin", "arc deg", "points", "CD mm", "RD mm", "PD mm", "left out mm",
                    "<not used, because"},
                   {},
                   {},
                   "Left out: where all other pins put this one against where its own line puts it."};
  for (const PinView& pin : a.pins) {
    const auto value = [&](double mm) { return pin.used ? fixedText(mm, 3) : std::string(); };
    table.rows.push_back({std::to_string(pin.placement + 1), std::to_string(pin.camera + 1), std::to_string(pin.pin),
                          pin.points > 0 ? fixedText(pin.arcDeg, 0) : "", std::to_string(pin.points), value(pin.cdMm),
                          value(pin.rdMm), value(pin.pdMm), value(pin.leaveOneOutMm), pin.reason});
    table.standings.push_back(pin.used ? Standing::None : Standing::Near);
  }
  return table;
}

TableBlock plateTable(const RigCalibrationReport& report) {
  TableBlock table{"The plate: as stated and as found, mm",
                   {"pin", "x stated", "y stated", "r stated", "u stated", "x found", "y found", "r found", "u found"},
                   {},
                   {},
                   ""};
  for (const CalibratedPin& pin : report.adjustment->calibration.pins) {
    std::vector<std::string> row = {std::to_string(pin.number)};
    for (const Pin& stated : report.inputs->plate.pins)
      if (stated.number == pin.number)
        for (const double value : {stated.centreMm.x(), stated.centreMm.y(), stated.radiusMm, stated.uCentreMm})
          row.push_back(fixedText(value, 4));
    for (const double value : {pin.xMm, pin.yMm, pin.radiusMm, pin.uMm}) row.push_back(fixedText(value, 4));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

Plot pinsInWorld(const RigAdjustment& a) {
  Plot plot{"", "x mm", "y mm", {}, true, false, {}, false};
  std::vector<Curve> found;
  for (int camera = 0; camera < kCameraCount; ++camera) found.push_back({cameraName(camera), {}, camera, false, 2.2});
  for (const PinView& pin : a.pins)
    if (pin.used && pin.placement == 0)
      for (const Point2& p : pin.pointsInWorld) found[static_cast<std::size_t>(pin.camera)].points.push_back(p);
  for (const CalibratedPin& pin : a.calibration.pins) {
    Curve circle{"", {}, 4, true, 0.8};
    for (int i = 0; i <= 72; ++i)
      circle.points.emplace_back(pin.xMm + pin.radiusMm * std::cos(kFullTurn * i / 72),
                                 pin.yMm + pin.radiusMm * std::sin(kFullTurn * i / 72));
    plot.curves.push_back(std::move(circle));
  }
  for (Curve& curve : found) plot.curves.push_back(std::move(curve));
  return plot;
}

Document rigCalibrationDocument(const RigCalibrationReport& report) {
  const RigAdjustment& a = *report.adjustment;
  Document document;
  document.title = "Calibration of the range finders";
  document.subject = a.calibration.id;
  document.foot = "calibration " + a.calibration.id + "   plate " + report.inputs->plate.id;
  document.simulation = report.simulation;
  auto& blocks = document.blocks;
  blocks.emplace_back(verdict(report));
  blocks.emplace_back(facts(report));
  if (!report.dimensions.empty()) blocks.emplace_back(dimensionTable(report));
  if (!report.checks.empty()) blocks.emplace_back(checkTable(report));
  blocks.emplace_back(tableFour(a));
  blocks.emplace_back(Heading{"What was seen"});
  if (std::any_of(report.pictures.begin(), report.pictures.end(), [](const Picture* p) { return p != nullptr; }))
    blocks.emplace_back(pictures(report, false));
  blocks.emplace_back(pictures(report, true));
  blocks.emplace_back(features(a));
  blocks.emplace_back(Heading{"Parameters"});
  for (TableBlock& table : parameterTables(a)) blocks.emplace_back(std::move(table));
  blocks.emplace_back(Heading{"Pins"});
  if (!a.calibration.pins.empty()) blocks.emplace_back(plateTable(report));
  blocks.emplace_back(pinTable(a));
  return document;
}

}  // namespace vignole
