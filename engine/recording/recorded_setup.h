#pragma once
// What a recording knows beside its frames: what the rail was measured with, and by whom.

#include <map>
#include <string>

#include "engine/acquisition/frame.h"
#include "engine/geometry/expected.h"
#include "engine/optics/calibration.h"
#include "engine/recipe/recipe.h"

namespace vignole {

/// Serial numbers and sizes of the cameras are the calibration's.
struct RecordedSetup {
  std::string program;     ///< version
  std::string simdTarget;  ///< numbers are equal to the last bit on the same one
  std::string source;      ///< "virtual", "gige", "pictures" ...
  std::string origin;      ///< the source's own words (JSON), for who made it; may be empty
  bool whole = false;      ///< whole frames were wished for
  Recipe recipe;
  RigCalibration calibration;
};
[[nodiscard]] std::string toJson(const RecordedSetup& setup);
/// `where` for errors. The section is the recorded one, whatever has become of the catalogue since.
[[nodiscard]] Expected<RecordedSetup> parseSetup(const std::string& text, const std::string& where);

/// What a rail was announced with beside RailBegin: "strand", "order", "operator" ... as the site has them.
using RailNotes = std::map<std::string, std::string>;

struct RecordedRailBegin {
  RailBegin rail;
  RailNotes notes;
};
[[nodiscard]] std::string toJson(const RecordedRailBegin& begin);
[[nodiscard]] Expected<RecordedRailBegin> parseRailBegin(const std::string& text, const std::string& where);

}  // namespace vignole
