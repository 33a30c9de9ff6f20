#pragma once
// Memory for frames, in pages as large as the system gives: a frame is looked at once, cold, and to look up its 350
// ordinary pages would cost a tenth of that.

#include <cstddef>
#include <cstdint>
#include <memory>

namespace vignole {

struct FrameMemoryFree {
  void operator()(std::uint8_t* bytes) const;
};
using FrameMemory = std::unique_ptr<std::uint8_t[], FrameMemoryFree>;

/// At least `bytes` bytes of no particular content; throws std::bad_alloc.
[[nodiscard]] FrameMemory makeFrameMemory(std::size_t bytes);

}  // namespace vignole
