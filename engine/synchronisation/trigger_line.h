#pragma once
// Four cameras as one line: their frames are matched by the count of the trigger, rails are told from what lies between
// them, and every trigger of a rail goes to every camera's stream exactly once, as a frame or as a loss with its
// reason.

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "engine/acquisition/frame.h"

namespace vignole {

struct TriggerLineSettings {
  int beginAfter = 3;  ///< triggers in a row with something in view: a rail begins with the first of them
  int endAfter = 5;    ///< triggers in a row with nothing in view: the rail has ended before the first of them
  std::uint64_t giveUpAfter = 32;  ///< a camera this far behind is not waited for
  double spacingMm = 15;           ///< travel between triggers
  double temperatureC = 20, temperatureUncertaintyC = 1;
  double lengthMm = 0;                                      ///< a rail is cut off there; 0: never
  std::uint64_t rails = 0;                                  ///< the streams end behind so many; 0: never
  std::function<std::string(std::uint64_t number)> railId;  ///< of the number-th rail, from 1; default "rail-N"
  std::string heat, sectionName;
};

/// Every trigger that was settled is in exactly one of inRails and outsideRails.
struct TriggerLineCounts {
  std::uint64_t inRails = 0, outsideRails = 0;
  std::uint64_t seenByNone = 0;                      ///< of both: no camera had a frame
  std::uint64_t rails = 0;                           ///< begun
  std::uint64_t lateFrames = 0, repeatedFrames = 0;  ///< frames that came too late or twice, left out
  std::uint64_t framesOfLostCounts = 0;              ///< whose trigger was forgotten when all cameras were gone
};

/// Fed with each camera's frames in its own order. Not thread-safe: one mutex around it.
class TriggerLine {
 public:
  static constexpr std::size_t kCameras = 4;

  explicit TriggerLine(TriggerLineSettings settings);

  /// `frame.trigger` is its place among the triggers. `arrivedS` of any clock that goes forward.
  void add(Frame frame, bool railInView, double arrivedS);
  /// The camera's frames of `count` triggers before `next` are gone, for this reason; call before adding that of
  /// `next`.
  void lose(int camera, std::uint64_t next, std::uint64_t count, const std::string& reason);
  /// It is not waited for until it shows a frame again; its triggers are lost for this reason.
  void setDown(int camera, std::string reason);
  /// It is waited for again, from its next frame on.
  void setUp(int camera);
  /// All counts have gone (no camera was left to count): a running rail ends, triggers are counted on from next().
  void restartCounts();

  [[nodiscard]] std::optional<FrameMessage> take(int camera);
  /// One past the latest trigger that any camera has answered.
  [[nodiscard]] std::uint64_t next() const;
  /// Triggers that others have answered since this camera's last.
  [[nodiscard]] std::uint64_t behind(int camera) const;
  [[nodiscard]] bool railRunning() const { return inRail_; }
  [[nodiscard]] const TriggerLineCounts& counts() const { return counts_; }
  [[nodiscard]] double triggersPerS() const;  ///< of late; 0: not known

 private:
  enum class View { Rail, Nothing, Unknown };
  struct Slot {
    std::optional<Frame> frame;
    bool railInView = false;
    std::string reason;
  };
  struct Row {
    std::uint64_t trigger = 0;
    std::array<Slot, kCameras> slots;
    [[nodiscard]] View view() const;
  };
  struct Camera {
    std::uint64_t next = 0;   ///< everything below has been answered or passed
    std::uint64_t first = 0;  ///< trigger of its first frame
    bool began = false;       ///< has shown a frame since the counts began
    bool down = false;
    std::string downReason;
    bool justBack = false;
    std::deque<FrameMessage> out;
  };
  struct Arrival {
    std::uint64_t trigger;
    double s;
  };

  Camera& at(int camera) { return cameras_[static_cast<std::size_t>(camera)]; }
  [[nodiscard]] const Camera& at(int camera) const { return cameras_[static_cast<std::size_t>(camera)]; }
  void open();
  void settle();
  [[nodiscard]] bool settled(std::uint64_t trigger) const;
  void judge(Row row);
  void dropHeld();
  void beginRail();
  void endRail(std::uint64_t endTrigger);
  void emitHeld();
  void emit(Row row);
  void tellAll(const FrameMessage& message);

  TriggerLineSettings settings_;
  std::array<Camera, kCameras> cameras_;
  std::map<std::uint64_t, Row> waiting_;  ///< not settled yet
  std::deque<Row> held_;                  ///< settled; whether they belong to a rail is not decided
  std::deque<Arrival> arrivals_;          ///< the first frame of each of the latest triggers
  bool open_ = false, inRail_ = false, ended_ = false;
  std::uint64_t cursor_ = 0;  ///< everything below is settled
  std::uint64_t railFirst_ = 0;
  int run_ = 0;  ///< rows in a row that speak against what is: with a rail while there is none, or the other way
  TriggerLineCounts counts_;
};

}  // namespace vignole
