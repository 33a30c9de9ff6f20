#pragma once
// A report as values: headings, facts, tables, pictures, plots, one after the other. Who has results composes one;
// document_pages.h sets it in type. No Qt here.

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/geometry/transform2.h"

namespace vignole {

/// States a row or a verdict can have; always shown with a symbol and a word, never by colour alone.
enum class Standing { None, Good, Near, Bad };

struct Heading {
  std::string text;
};
struct Paragraph {
  std::string text;
  bool note = false;  ///< smaller
};
/// Label and value, in columns.
struct FactList {
  std::vector<std::pair<std::string, std::string>> facts;
};
/// The sentence that counts, in large letters on a coloured ground.
struct VerdictLine {
  Standing standing = Standing::Good;
  std::string headline, reason;
};
/// Numbers are aligned right, everything else left: by the head ("<name" is left; default right).
struct TableBlock {
  std::string title;
  std::vector<std::string> heads;
  std::vector<std::vector<std::string>> rows;
  std::vector<Standing> standings;  ///< per row; empty: none
  std::string note;
};
/// A curve drawn in a picture or a plot.
struct Curve {
  std::string name;            ///< in the key; empty: not in it
  std::vector<Point2> points;  ///< px of the picture, or units of the axes
  int colour = 0;              ///< 0-3 as the cameras', 4 neutral, 5 accent, 6 out
  bool line = true;            ///< joined; false: dots
  double dotPx = 3;            ///< diameter of a dot, or width of the line
};
struct PictureCell {
  int width = 0, height = 0;
  std::vector<std::uint8_t> grey;  ///< row-major; empty: a blank ground
  std::vector<Curve> curves;       ///< px
  std::string caption;
};
struct PictureBlock {
  std::string title;
  int columns = 2;
  std::vector<PictureCell> cells;
  std::string note;
};
struct Plot {
  std::string title, xLabel, yLabel;
  std::vector<Curve> curves;
  bool equalScale = false;              ///< a millimetre is as long in x as in y
  bool yDown = false;                   ///< rows of a picture
  std::vector<std::string> categories;  ///< names at x = 0, 1, 2 ... in place of numbers
  bool bars = false;                    ///< the first curve as bars from 0
};
struct PlotBlock {
  std::string title;
  int columns = 1;
  double aspect = 0.62;  ///< height over width of each
  std::vector<Plot> plots;
  std::string note;
};

using Block = std::variant<Heading, Paragraph, FactList, VerdictLine, TableBlock, PictureBlock, PlotBlock>;

struct Document {
  std::string title;    ///< "Calibration report"
  std::string subject;  ///< right end of the page's head
  std::string foot;     ///< left end of the page's foot
  bool simulation = false;
  std::vector<Block> blocks;
};

}  // namespace vignole
