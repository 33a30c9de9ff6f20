#include "engine/acquisition/frame_memory.h"

#include <cstdlib>
#include <new>
#include <sys/mman.h>

namespace vignole {

namespace {
constexpr std::size_t kLargePage = std::size_t{1} << 21U;
constexpr std::size_t kOrdinaryAlignment = 64;
}  // namespace

void FrameMemoryFree::operator()(std::uint8_t* bytes) const { std::free(bytes); }

FrameMemory makeFrameMemory(std::size_t bytes) {
  // A small picture would waste most of a large page.
  const std::size_t alignment = bytes >= kLargePage / 2 ? kLargePage : kOrdinaryAlignment;
  const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, rounded);
  if (memory == nullptr) throw std::bad_alloc();
  if (alignment == kLargePage) (void)madvise(memory, rounded, MADV_HUGEPAGE);  // a wish: it works without
  return FrameMemory(static_cast<std::uint8_t*>(memory));
}

}  // namespace vignole
