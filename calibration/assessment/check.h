#pragma once
// One question that a calibration must stand, and its answer.

#include <string>
#include <vector>

namespace vignole {

struct Check {
  std::string name;
  bool done = true;  ///< false: could not be asked; `words` say what it would take
  double value = 0;  ///< passes up to the limit
  double limit = 0;
  std::string unit;
  bool refuses = true;  ///< a calibration that fails must not be used; false: only worth a look
  std::string words;    ///< what was found, a clause: "the pins that were left out lie 0.21 mm off"
  std::string remedy;   ///< what to do if it fails: "measure the plate again"

  [[nodiscard]] bool pass() const { return !done || value <= limit; }
};

/// "refused, because ...; ..." for every refusing check that failed.
[[nodiscard]] std::vector<std::string> refusalsOf(const std::vector<Check>& checks);

}  // namespace vignole
