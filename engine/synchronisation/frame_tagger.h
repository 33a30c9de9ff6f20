#pragma once
// Which trigger a frame belongs to, from what its camera writes on it: a frame id (16 bits on older cameras, it wraps
// every 16.5 minutes at 66 Hz) and, where the camera can, the count of the trigger itself.

#include <cstdint>
#include <optional>

namespace vignole {

/// Frame ids as one count without wraps. GigE Vision ids of 16 bits go from 65535 to 1; ids above that are of 64 bits
/// and do not wrap.
class FrameIds {
 public:
  /// Steps from the last id to this one: 1 for the next frame, 0 for the same, negative for an older one.
  [[nodiscard]] std::int64_t step(std::uint64_t id) const;
  /// Takes the id as the latest; its place in the count, from 0.
  std::int64_t take(std::uint64_t id);
  [[nodiscard]] bool any() const { return any_; }

 private:
  bool any_ = false;
  std::uint64_t last_ = 0;
  std::int64_t place_ = 0;
};

/// A frame's place in its camera's own count, and what is known of the triggers since the last frame.
struct FrameTag {
  enum class Kind {
    Frame,        ///< goes on from the last one
    Repeated,     ///< the same frame or an older one again
    Implausible,  ///< its numbers contradict each other: a damaged leader. Not to be used
    Restarted     ///< the camera counts from anew: its place among the triggers must be found again
  };
  Kind kind = Kind::Frame;
  std::int64_t place = 0;        ///< of the count if the camera counts triggers, else of the ids
  std::uint64_t incomplete = 0;  ///< triggers since the last frame whose frames arrived damaged
  std::uint64_t lost = 0;        ///< ... whose frames were sent but never arrived
  std::uint64_t missed = 0;      ///< ... that the camera did not answer (seen only with a count)
  [[nodiscard]] std::uint64_t between() const { return incomplete + lost + missed; }
};

/// One per stream: a new stream begins anew. Only frames that arrived whole are shown to it, because a damaged one may
/// carry the numbers of a frame long gone. One thread.
class FrameTagger {
 public:
  /// `count` of the trigger, where the camera writes it.
  [[nodiscard]] FrameTag add(std::uint64_t id, std::optional<std::uint64_t> count);
  /// A frame arrived damaged: nothing on it is believed but that it was sent.
  void addDamaged() { ++damaged_; }

 private:
  [[nodiscard]] FrameTag doubt(std::uint64_t id, std::uint64_t count);
  void start(std::uint64_t id, std::uint64_t count);
  [[nodiscard]] FrameTag goOn(std::int64_t place, std::uint64_t between, std::uint64_t notSent);

  FrameIds ids_;
  std::uint64_t count_ = 0;
  std::uint64_t damaged_ = 0;
  /// What a stray frame said; several in a row that go on from each other are the truth.
  struct Doubt {
    std::uint64_t id = 0, count = 0;
    int frames = 0;
  } doubt_;
};

}  // namespace vignole
