#pragma once
// Whether a camera is there: judged by the triggers that the others answer, long before its control channel is given
// up (Aravis tells that 5.7 s after the last frame).

#include <cstdint>
#include <string>

namespace vignole {

enum class CameraState {
  Connecting,  ///< being opened for the first time
  Connected,   ///< frames come, or nothing is triggered
  Degraded,    ///< something is wrong but it may pass: no frames for a moment, or only the control channel is gone
  Lost         ///< given up; being opened again
};
[[nodiscard]] const char* name(CameraState state);

/// Both a number of triggers and a time: a line that crawls has few triggers, a loaded computer late ones.
struct CameraWatchSettings {
  std::uint64_t silentTriggers = 8;  ///< answered by others since its last frame: it is silent, nobody waits for it
  double silentS = 0.25;
  std::uint64_t lostTriggers = 16;  ///< it is given up and opened again
  double lostS = 1;
};

/// One thread at a time. Times in seconds of any clock that goes forward.
class CameraWatch {
 public:
  explicit CameraWatch(CameraWatchSettings settings = {}) : settings_(settings) {}

  void opened(double nowS);      ///< its frames may come from now on
  void frame(double nowS);       ///< one came
  void controlLost();            ///< its control channel no longer answers
  void failed(std::string why);  ///< it cannot be opened, or must be opened again
  void doesNotAnswer();          ///< nothing answers at its address; tells why if it is lost
  /// `ahead`: triggers that others have answered since its last frame.
  void look(double nowS, std::uint64_t ahead);

  [[nodiscard]] CameraState state() const { return state_; }
  [[nodiscard]] const std::string& why() const { return why_; }  ///< empty when connected
  [[nodiscard]] bool silent() const { return silent_; }          ///< nothing is to be waited for from it
  /// A camera whose frames still come is opened again only when that costs no profile.
  [[nodiscard]] bool toBeOpenedAgain(bool railInView) const;

 private:
  void become(CameraState state, std::string why);

  CameraWatchSettings settings_;
  CameraState state_ = CameraState::Connecting;
  std::string why_;
  bool silent_ = true;
  bool controlLost_ = false;
  double lastS_ = 0;
};

}  // namespace vignole
