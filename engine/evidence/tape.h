#pragma once
// A tar archive (POSIX ustar) in the one way in which we write it: any tar lists and unpacks it, and a byte that is not
// as we would have written it is refused.

#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"

namespace vignole {

struct TapeEntry {
  std::string name;  ///< at most 99 of [a-z0-9_./-]
  std::string_view content;
  std::size_t at = 0;  ///< where its header begins
};

class TapeWriter {
 public:
  void add(std::string_view name, std::string_view content);
  [[nodiscard]] const std::string& soFar() const { return bytes_; }
  [[nodiscard]] std::string finish();

 private:
  std::string bytes_;
};

/// The contents refer to `bytes`.
[[nodiscard]] Expected<std::vector<TapeEntry>> readTape(std::string_view bytes);

}  // namespace vignole
