#pragma once
// Rail profile computation (paper section II-E): partial contours of the four cameras become one profile, matched by
// their trigger count, never by time. Every trigger of a rail is accounted for.

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/acquisition/frame.h"
#include "engine/profile/profile.h"

namespace vignole {

struct AssemblerSettings {
  /// Live: how far the fastest camera may be ahead of a trigger before it is given up as incomplete. 0: never, wait.
  std::uint64_t giveUpAfter = 0;
};

/// One settled thing, in the order of the triggers. Reused by its owner: every field is set anew by next().
struct Assembly {
  enum class Kind { RailBegan, Profile, Lost, RailEnded };
  Kind kind = Kind::Lost;
  std::shared_ptr<const RailBegin> rail;  ///< the rail that it belongs to; null outside of rails (Lost only)
  Profile profile;                        ///< Kind::Profile only
  /// Kind::Lost: triggers that gave no profile. 0 if only a superfluous frame is reported.
  std::uint64_t lost = 0;
  std::vector<std::string> reasons;  ///< Kind::Lost: "camera 3: frame lost"
};

/// "camera 3: frame lost" (people count cameras from 1).
[[nodiscard]] std::string cameraReason(int camera, const std::string& reason);

/// Fed with each camera's stream in its own order, streams in any order among each other; what comes out does not
/// depend on how the streams interleave unless `giveUpAfter` had to be used. One thread.
///
/// A camera has passed a trigger when it delivered it, anything later, or the end. A trigger is settled when all four
/// have passed it. Repeated and late frames are left out and named in the reasons of the rail.
class ProfileAssembler {
 public:
  explicit ProfileAssembler(AssemblerSettings settings = {}) : settings_(settings) {}

  /// The contour is taken by exchange: `contour` holds a spent one with its buffers afterwards.
  void add(PartialContour& contour);
  void add(int camera, const FrameLost& lost);
  void add(int camera, const RailBegin& begin);
  void add(int camera, const RailEnd& end);
  void add(int camera, const SourceEnd& end);

  /// The next settled thing; false: nothing yet. Call until false after every add.
  [[nodiscard]] bool next(Assembly& out);
  /// All four streams have ended and nothing is left.
  [[nodiscard]] bool ended() const;
  /// Triggers by which this camera is ahead of the slowest: hold it back to bound what waits here.
  [[nodiscard]] std::uint64_t lead(int camera) const;
  /// The first error that a stream ended with, camera 1 first.
  [[nodiscard]] std::string error() const;

 private:
  struct Slot {
    PartialContour contour;
    bool has = false;
    std::string missing;
  };
  struct Pending {
    std::array<Slot, kCameraCount> slots;
  };
  /// A rail is told four times, once by each camera: the same first trigger and id are the same rail.
  using RailKey = std::pair<std::uint64_t, std::string>;
  struct Stream {
    std::uint64_t next = 0;        ///< everything below has been passed
    std::uint64_t railsEnded = 0;  ///< the largest endTrigger of a RailEnd
    std::optional<std::uint64_t> lastFrame;
    std::optional<RailKey> rail;  ///< of its latest RailBegin
    bool ended = false;
    std::string error;
  };
  struct Rail {
    std::shared_ptr<const RailBegin> begin;
    std::optional<std::uint64_t> end;  ///< exclusive
    [[nodiscard]] RailKey key() const { return {begin->firstTrigger, begin->id}; }
  };

  Stream& stream(int camera) { return streams_[static_cast<std::size_t>(camera)]; }
  [[nodiscard]] const Stream& stream(int camera) const { return streams_[static_cast<std::size_t>(camera)]; }
  /// The slot of a trigger that the camera has not passed yet, or null (then it is remarked as repeated or late).
  Slot* accept(int camera, std::uint64_t trigger);
  Pending& pendingAt(std::uint64_t trigger);
  [[nodiscard]] bool allEnded() const;
  [[nodiscard]] std::uint64_t passedByAll() const;
  [[nodiscard]] std::uint64_t furthest() const;
  [[nodiscard]] std::uint64_t settledBelow() const;
  [[nodiscard]] std::optional<std::uint64_t> endOfRail() const;
  [[nodiscard]] bool railPassed(std::uint64_t end) const;
  bool nextRemark(std::uint64_t upTo, Assembly& out);
  bool nextOutsideRail(Assembly& out);
  bool nextInRail(Assembly& out);
  bool beginRail(Assembly& out);
  void endRail(Assembly& out);
  void lose(std::uint64_t count, std::vector<std::string> reasons, Assembly& out);
  void settle(std::uint64_t trigger, Pending& pending, Assembly& out);
  [[nodiscard]] std::string reasonForEmptySlot(int camera, std::uint64_t trigger) const;
  void join(std::uint64_t trigger, Pending& pending, Profile& profile) const;
  void recycle(std::map<std::uint64_t, std::unique_ptr<Pending>>::iterator entry);

  AssemblerSettings settings_;
  std::array<Stream, kCameraCount> streams_;
  std::map<std::uint64_t, std::unique_ptr<Pending>> pending_;
  std::vector<std::unique_ptr<Pending>> spent_;
  std::multimap<std::uint64_t, std::string> remarks_;  ///< by the trigger before which they are told
  std::deque<Rail> rails_;                             ///< announced; the front one has begun if inRail_
  std::optional<RailKey> lastEnded_;
  bool inRail_ = false;
  std::uint64_t cursor_ = 0;  ///< everything below has been told
};

}  // namespace vignole
