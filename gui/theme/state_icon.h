#pragma once
// The symbol of a state as an icon for lists and tables.

#include <QIcon>

#include "report/palette.h"
#include "report/state_symbol.h"

namespace vignole {

[[nodiscard]] QIcon stateIcon(StateSymbol symbol, const Palette& palette);

}  // namespace vignole
