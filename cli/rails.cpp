// vignole-cli rails: the catalogue of sections, their check table, and sections that users bring.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <numbers>

#include "cli/commands.h"
#include "cli/console.h"
#include "engine/measurement/measurement.h"
#include "engine/rail/catalogue.h"
#include "engine/rail/check.h"
#include "engine/rail/outline.h"
#include "engine/rail/section_svg.h"

namespace vignole::cli {

namespace {

const char* words(SectionStanding standing) {
  switch (standing) {
    case SectionStanding::Standard:
      return "standard";
    case SectionStanding::Approximate:
      return "approximate";
    case SectionStanding::Invented:
      return "invented";
  }
  return "";
}

int listRails() {
  const auto names = catalogueNames();
  if (names.empty()) return fail(findSection("").error());
  int code = kDone;
  std::printf("%-8s %-24s %-12s %9s %9s\n", "name", "standard", "standing", "height_mm", "kg/m");
  for (const std::string& name : names) {
    const auto section = findSection(name);
    if (!section) {
      code = fail(section.error());
      continue;
    }
    std::printf("%-8s %-24s %-12s %9.2f %9.3f\n", section->name.c_str(), section->standard.c_str(),
                words(section->standing), section->heightMm(), properties(*section).massKgPerM);
  }
  return code;
}

void printPrimitives(const Section& section) {
  std::printf("\n%-7s %-8s %10s %10s %10s %10s %9s %9s\n", "name", "type", "x0_mm", "y0_mm", "x1_mm", "y1_mm", "R_mm",
              "turn_deg");
  for (const NamedPrimitive& p : section.primitives) {
    const Point2 a = startPoint(p.shape), b = endPoint(p.shape);
    const auto* arc = std::get_if<Arc>(&p.shape);
    std::printf("%-7s %-8s %10.4f %10.4f %10.4f %10.4f", p.name.c_str(), arc == nullptr ? "segment" : "arc", a.x(),
                a.y(), b.x(), b.y());
    if (arc != nullptr) std::printf(" %9.4f %9.3f", arc->radiusMm, arc->sweepRad * 180 / std::numbers::pi);
    std::printf("\n");
  }
}

void printProperties(const Section& section) {
  const SectionProperties p = properties(section);
  std::printf("\narea %.3f cm2   mass %.3f kg/m   Ix %.2f cm4   Iy %.2f cm4   centroid (%.3f, %.3f) mm\n",
              p.areaMm2 / 100, p.massKgPerM, p.ixCm4, p.iyCm4, p.centroidXMm, p.centroidYMm);
  std::printf("perimeter %.3f mm   axis %.3f mm from the middle of the foot   %s\n", p.perimeterMm,
              section.axisFromFootMiddleMm, section.symmetric() ? "symmetric" : "asymmetric");
}

int printNominals(const Section& section) {
  const auto nominals = nominalDimensions(section, section.parameters);
  if (!nominals) return fail(nominals.error());
  std::printf("\n%-6s %-24s %12s\n", "dim", "title", "nominal_mm");
  for (const Dimension d : kDimensions) {
    const auto& value = nominals->at(index(d));
    std::printf("%-6s %-24s ", name(d).data(), title(d).data());
    if (value)
      std::printf("%12.3f\n", *value);
    else
      std::printf("%12s\n", "undefined");
  }
  return kDone;
}

int showRail(const std::string& nameOrFile, const std::string& svgFile) {
  const auto section = findSection(nameOrFile);
  if (!section) return fail(section.error());
  if (svgFile == "-") {
    const auto written = writeResult("-", toSvg(*section));
    return written ? kDone : fail(written.error());
  }
  std::printf("%s   %s   %s\n%s\n", section->name.c_str(), section->standard.c_str(), words(section->standing),
              section->note.c_str());
  printProperties(*section);
  const int code = printNominals(*section);
  printPrimitives(*section);
  if (svgFile.empty()) return code;
  const auto written = writeResult(svgFile, toSvg(*section));
  return written ? code : fail(written.error());
}

/// One line a value; true if all pass.
bool printChecks(const Section& section) {
  bool good = true;
  for (const SectionCheck& c : checkSection(section)) {
    std::printf("%-8s %-5s %12.5f ", section.name.c_str(), c.what.c_str(), c.value);
    if (c.published)
      std::printf("%12.3f %11.4f", *c.published, c.value - *c.published);
    else
      std::printf("%12s %11s", "-", "-");
    std::printf(" %10.4f %-5s %s\n", c.tolerance, c.unit.c_str(), c.pass ? "pass" : "FAIL");
    good = good && c.pass;
  }
  return good;
}

int checkRails(std::vector<std::string> which) {
  if (which.empty()) which = catalogueNames();
  if (which.empty()) return fail(findSection("").error());
  int code = kDone;
  std::printf("%-8s %-5s %12s %12s %11s %10s %-5s %s\n", "name", "what", "value", "published", "difference",
              "tolerance", "unit", "verdict");
  for (const std::string& one : which) {
    const auto section = findSection(one);
    if (!section) {
      std::fflush(stdout);
      code = std::max(code, fail(section.error()));
    } else if (!printChecks(*section)) {
      std::fflush(stdout);
      code = std::max(code, fail({one, "does not meet what is published of it; see the lines marked FAIL"}));
    }
  }
  return code;
}

int importRail(const std::string& file, const std::string& name, const std::string& out) {
  const auto section = importSection(file, name);
  if (!section) return fail(section.error());
  if (out == "-") {
    const auto written = writeResult("-", toJson(*section));
    return written ? kDone : fail(written.error());
  }
  std::printf("%s from %s\n", section->name.c_str(), file.c_str());
  printProperties(*section);
  printPrimitives(*section);
  if (out.empty()) {
    std::printf("\nnot saved; give --out %s.json to keep it\n", name.c_str());
    return kDone;
  }
  const auto written = writeResult(out, toJson(*section));
  return written ? kDone : fail(written.error());
}

}  // namespace

void addRails(CLI::App& app, int& exitCode) {
  CLI::App* rails = app.add_subcommand("rails", "Sections: the catalogue, their checks, and your own");
  rails->require_subcommand(1);
  rails->footer("Example: vignole-cli rails check 60E1 my_rail.json");

  CLI::App* list = rails->add_subcommand("list", "Sections of the catalogue");
  list->footer("Example: vignole-cli rails list");
  list->callback([&exitCode] { exitCode = listRails(); });

  struct Options {
    std::string name, file, svg, out;
    std::vector<std::string> names;
  };
  const auto o = std::make_shared<Options>();

  CLI::App* show = rails->add_subcommand("show", "Primitives, properties and nominal dimensions of a section");
  show->add_option("NAME", o->name, "A name of the catalogue or a section file")->required();
  show->add_option("--svg", o->svg, "Draw the outline with the primitives' names (- is stdout)");
  show->footer("Example: vignole-cli rails show 60E1 --svg 60E1.svg");
  show->callback([o, &exitCode] { exitCode = showRail(o->name, o->svg); });

  CLI::App* check = rails->add_subcommand("check", "Closure, kinks, area, mass and inertia against what is published");
  check->add_option("NAME", o->names, "Names or section files; all of the catalogue if none is given");
  check->footer("Example: vignole-cli rails check 60E1 my_rail.json");
  check->callback([o, &exitCode] { exitCode = checkRails(o->names); });

  CLI::App* import = rails->add_subcommand("import", "Read a DXF, JSON or MiniProf design and name its primitives");
  import->add_option("FILE", o->file, "A closed outline: .dxf, .json, .ban, .prr")->required();
  import->add_option("--name", o->name, "Name of the section")->required();
  import->add_option("--out", o->out, "Section file to write (- is stdout)");
  import->footer("Example: vignole-cli rails import drawing.dxf --name MY60 --out my60.json");
  import->callback([o, &exitCode] { exitCode = importRail(o->file, o->name, o->out);
});
}  // namespace vignole::cli

}  // namespace vignole::cli
