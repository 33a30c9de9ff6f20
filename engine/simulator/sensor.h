#pragma once
// The sensor of the virtual rig's cameras: ground, noise and speckle; light on a canvas becomes a picture.

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/geometry/image_view.h"
#include "engine/simulator/light_kernels.h"
#include "engine/simulator/virtual_rig.h"

namespace vignole::simulator {

/// 10,000 electrons at 60 DN: variance in DN^2 per DN of signal.
inline constexpr double kShotPerDn = 60.0 / 10000;

/// How a camera takes a frame.
struct Exposure {
  std::uint64_t key = 0;  ///< draws its noise
  bool black = false;     ///< no light, no ambient
  float gain = 1;         ///< on light and ambient alike
};

/// Immutable; any thread.
class Sensor {
 public:
  Sensor(std::uint64_t seed, const Effects& effects, int widthPx, int heightPx);
  [[nodiscard]] int widthPx() const { return widthPx_; }
  [[nodiscard]] int heightPx() const { return heightPx_; }
  /// The whole picture without light.
  void fillGround(const Exposure& exposure, const MutableImageView& image) const;
  /// Turns the canvas' light into pixels, and leaves it dark.
  void expose(const Exposure& exposure, Canvas& canvas, const MutableImageView& image) const;

 private:
  Effects effects_;
  int widthPx_, heightPx_;
  std::vector<float> speckle_, normals_;
  std::vector<std::uint8_t> ground_;
};

/// Buffers that are lent to whoever renders, so that none is made for every picture; any thread.
template <typename Scratch>
class ScratchPool {
 public:
  /// A buffer, given back at the end of the scope.
  class Lease {
   public:
    explicit Lease(ScratchPool& pool, int width, int height) : pool_(pool) {
      const std::lock_guard lock(pool.mutex_);
      if (!pool.idle_.empty()) {
        scratch_ = std::move(pool.idle_.back());
        pool.idle_.pop_back();
      } else {
        scratch_ = std::make_unique<Scratch>(width, height);
      }
    }
    ~Lease() {
      const std::lock_guard lock(pool_.mutex_);
      pool_.idle_.push_back(std::move(scratch_));
    }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    Scratch& operator*() { return *scratch_; }

   private:
    ScratchPool& pool_;
    std::unique_ptr<Scratch> scratch_;
  };

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Scratch>> idle_;
};

}  // namespace vignole::simulator
