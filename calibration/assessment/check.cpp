#include "calibration/assessment/check.h"

namespace vignole {

std::vector<std::string> refusalsOf(const std::vector<Check>& checks) {
  std::vector<std::string> refusals;
  for (const Check& check : checks)
    if (check.refuses && !check.pass()) refusals.push_back("refused, because " + check.words + "; " + check.remedy);
  return refusals;
}

}  // namespace vignole
