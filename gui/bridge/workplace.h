#pragma once
// What the pages work with: made once by main.cpp (or a test), outlives them all.

#include <string>

#include "engine/archive/archive.h"
#include "engine/archive/rail_writer.h"
#include "gui/bridge/line.h"
#include "gui/bridge/session.h"
#include "gui/bridge/units.h"
#include "gui/theme/theme.h"

namespace vignole {

class Languages;

struct Workplace {
  Theme& theme;
  Line& line;
  Session& session;
  Units& units;
  Archive* archive = nullptr;       ///< null: there is none at the moment
  std::string archiveUrl = {};      ///< of `archive`, for whoever opens a connection of its own
  std::string archiveProblem = {};  ///< why: one line
  RailWriter* writer = nullptr;     ///< keeps what the line measures; null: nobody does
  Languages* languages = nullptr;   ///< null: English alone
};

}  // namespace vignole
