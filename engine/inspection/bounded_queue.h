#pragma once
// The queue between two stages: bounded, in order, many producers and one consumer, woken by condition variables (a
// spinning queue starves its peer on two cores). Lanes keep apart what must be held back apart: the four cameras in
// front of the assembler.

#include <algorithm>
#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace vignole {

template <typename T, std::size_t Lanes = 1>
class BoundedQueue {
 public:
  struct Taken {
    std::size_t lane;
    T item;
  };
  /// When the consumer is woken: by this item, or by a later one that the producer promises to bring without waiting
  /// for anybody (a quarter of a lane is never left lying).
  enum class Wake { Now, Later };

  /// Capacity of each lane, at least 1.
  explicit BoundedQueue(std::size_t capacity) : capacity_(std::max<std::size_t>(capacity, 1)) {}

  /// Waits for a place. False if a stop was requested first; the item is then untouched.
  bool push(T&& item, const std::stop_token& stop = {}, std::size_t lane = 0, Wake wake = Wake::Now) {
    bool wakes = false;
    {
      std::unique_lock lock(mutex_);
      Lane& into = lanes_[lane];
      ++into.waiting;
      const bool free = places_.wait(lock, stop, [&] { return into.places < capacity_; });
      --into.waiting;
      if (!free) return false;
      insert(std::move(item), lane, true);
      wakes = wake == Wake::Now || 4 * into.places >= capacity_;
    }
    if (wakes) items_.notify_one();
    return true;
  }

  /// Never waits. False if the lane is full: counted as an overflow, the item is untouched.
  bool tryPush(T&& item, std::size_t lane = 0, Wake wake = Wake::Now) {
    bool wakes = false;
    {
      const std::scoped_lock lock(mutex_);
      if (lanes_[lane].places >= capacity_) {
        ++overflows_;
        return false;
      }
      insert(std::move(item), lane, true);
      wakes = wake == Wake::Now || 4 * lanes_[lane].places >= capacity_;
    }
    if (wakes) items_.notify_one();
    return true;
  }

  /// For small tokens that must neither wait nor be lost: takes its turn but no place.
  void pushToken(T&& item, std::size_t lane = 0) {
    {
      const std::scoped_lock lock(mutex_);
      insert(std::move(item), lane, false);
    }
    items_.notify_one();
  }

  /// The oldest item; empty only if a stop was requested and nothing is left.
  std::optional<T> pop(const std::stop_token& stop = {}) {
    auto taken = pop(stop, [](std::size_t) { return true; });
    if (!taken) return {};
    return std::move(taken->item);
  }

  /// The oldest item of a lane that `wants(lane)`, lanes in turn. `wants` may only change by what the consumer does.
  template <typename Wants>
  std::optional<Taken> pop(const std::stop_token& stop, Wants wants) {
    std::optional<Taken> taken;
    bool wakes = false;
    {
      std::unique_lock lock(mutex_);
      std::size_t lane = Lanes;
      if (!items_.wait(lock, stop, [&] { return (lane = readyLane(wants)) < Lanes; })) return taken;
      Lane& from = lanes_[lane];
      taken.emplace(Taken{lane, std::move(from.entries.front().item)});
      if (from.entries.front().takesPlace) --from.places;
      from.entries.pop_front();
      turn_ = (lane + 1) % Lanes;
      // Who found the lane full is woken for half a lane at once: a thread woken for every place costs the machine two
      // changes of thread an item.
      wakes = from.waiting > 0 && from.places <= capacity_ / 2;
    }
    // All waiting producers, because the place is one particular lane's.
    if (wakes) places_.notify_all();
    return taken;
  }

  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  [[nodiscard]] bool empty() const {
    const std::scoped_lock lock(mutex_);
    return std::all_of(lanes_.begin(), lanes_.end(), [](const Lane& lane) { return lane.entries.empty(); });
  }
  /// Places that the fullest lane has taken.
  [[nodiscard]] std::size_t depth() const {
    const std::scoped_lock lock(mutex_);
    return std::max_element(lanes_.begin(), lanes_.end(),
                            [](const Lane& a, const Lane& b) { return a.places < b.places; })
        ->places;
  }
  /// Most places that any lane ever had taken.
  [[nodiscard]] std::size_t highWater() const {
    const std::scoped_lock lock(mutex_);
    return highWater_;
  }
  [[nodiscard]] std::uint64_t overflows() const {
    const std::scoped_lock lock(mutex_);
    return overflows_;
  }

 private:
  struct Entry {
    T item;
    bool takesPlace;
  };
  struct Lane {
    std::deque<Entry> entries;
    std::size_t places = 0;
    std::size_t waiting = 0;  ///< producers
  };

  void insert(T&& item, std::size_t lane, bool takesPlace) {
    Lane& into = lanes_[lane];
    into.entries.push_back(Entry{std::move(item), takesPlace});
    if (takesPlace) highWater_ = std::max(highWater_, ++into.places);
  }

  template <typename Wants>
  std::size_t readyLane(Wants& wants) const {
    for (std::size_t i = 0; i < Lanes; ++i) {
      const std::size_t lane = (turn_ + i) % Lanes;
      if (!lanes_[lane].entries.empty() && wants(lane)) return lane;
    }
    return Lanes;
  }

  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::condition_variable_any places_, items_;
  std::array<Lane, Lanes> lanes_;
  std::size_t turn_ = 0;
  std::size_t highWater_ = 0;
  std::uint64_t overflows_ = 0;
};

}  // namespace vignole
