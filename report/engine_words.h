#pragma once
// Sentences of the engine, which speaks English, in the language of the screen.

#include <QString>
#include <string>

#include "engine/geometry/expected.h"

namespace vignole {

/// Reasons and remarks: "only 3 points on SHBR, 8 are needed", "camera 3: frame lost". What is not known is returned as
/// it is. Thread: any.
[[nodiscard]] QString inWords(const std::string& english);
/// "password: is shorter than 8 characters"
[[nodiscard]] QString inWords(const Error& error);

}  // namespace vignole
