#pragma once

#include <QCoreApplication>

namespace vignole {

/// The one context in which the words of drawings and reports are translated.
struct Drawing {
  Q_DECLARE_TR_FUNCTIONS(Drawing)
};

}  // namespace vignole
