#pragma once
// What `vignole` understands on its command line.

#include <QSize>
#include <optional>
#include <string>

#include "engine/geometry/expected.h"
#include "gui/bridge/virtual_line.h"
#include "gui/main_window/page.h"

namespace vignole {

struct Options {
  PageId page = PageId::Monitor;
  bool dark = false;
  std::string language;    ///< "de"; empty: as chosen before, else the machine's
  std::string screenshot;  ///< file; empty: none
  std::string screens;     ///< folder for pictures of every page; empty: none
  QSize size{1920, 1080};
  double afterS = 5;
  std::optional<double> selfTestS;
  std::optional<double> switchPagesS;  ///< the next page every so often
  std::string chosenDimension;         ///< shown as if its row had been chosen; empty: none
  bool tour = false;                   ///< shown with a picture too
  std::string archive;                 ///< URL; empty: the usual one where a person sits, else none
  VirtualLineSettings line;

  [[nodiscard]] bool pictures() const { return !screenshot.empty() || !screens.empty(); }
  [[nodiscard]] bool unattended() const { return pictures() || selfTestS; }
};

/// What is left to do after reading the command line: run, or print `text` and leave with `exitCode`.
struct OptionsOutcome {
  std::optional<Options> options;
  std::string text;
  int exitCode = 0;
};

/// The outcome of a bad option is one line that names it, exit code 2.
[[nodiscard]] OptionsOutcome readOptions(int argc, const char* const* argv, const std::string& version);

}  // namespace vignole
