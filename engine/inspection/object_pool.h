#pragma once
// Objects with big vectors go round instead of being made and destroyed: the hot path allocates nothing in steady
// state.

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace vignole {

/// Thread-safe. Must outlive what it handed out. An object comes back as it was left: whoever takes it resets it.
template <typename T>
class ObjectPool {
 public:
  struct Return {
    ObjectPool* pool = nullptr;
    void operator()(T* object) const { pool->give(std::unique_ptr<T>(object)); }
  };
  using Ptr = std::unique_ptr<T, Return>;

  [[nodiscard]] Ptr take() {
    {
      const std::scoped_lock lock(mutex_);
      if (!free_.empty()) {
        Ptr object(free_.back().release(), Return{this});
        free_.pop_back();
        return object;
      }
    }
    return Ptr(std::make_unique<T>().release(), Return{this});
  }

  /// Objects at rest.
  [[nodiscard]] std::size_t available() const {
    const std::scoped_lock lock(mutex_);
    return free_.size();
  }

 private:
  void give(std::unique_ptr<T> object) {
    const std::scoped_lock lock(mutex_);
    free_.push_back(std::move(object));
  }

  mutable std::mutex mutex_;
  std::vector<std::unique_ptr<T>> free_;
};

}  // namespace vignole
