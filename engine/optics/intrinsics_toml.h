#pragma once
// Intrinsic parameters as TOML, for the files that carry them.

#include <span>
#include <string>

#include "engine/files/toml_reader.h"
#include "engine/optics/calibration.h"

namespace vignole {

/// The shortest text that reads back as the same number, always with what makes it a TOML float.
[[nodiscard]] std::string number(double value);
[[nodiscard]] std::string list(std::span<const double> values);

/// The keys, without the table's header.
[[nodiscard]] std::string toToml(const Intrinsics& in);
/// Of the table whose keys begin with `at` ("intrinsics."); what is wrong is noted in the reader.
[[nodiscard]] Intrinsics readIntrinsics(TomlReader& toml, const std::string& at);

}  // namespace vignole
