#pragma once
// A source that one reader can be taken from and another given to between two rails: how the recipe of the next rail
// comes into force while the running rail keeps its own.

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>

#include "engine/acquisition/frame.h"

namespace vignole {

/// Passes everything on as it comes. close() and open() from any thread. The source outlives it.
class RailGate : public FrameSource {
 public:
  explicit RailGate(FrameSource& source) : source_(source) {}

  /// All four streams end behind the same rail: the next to end of which none has passed the end yet.
  void close();
  /// The streams go on with the rail behind, for the next reader; call when the last reader has ended. Takes a close()
  /// back that no rail's end has met.
  void open();

  [[nodiscard]] FrameMessage next(int camera, std::stop_token stop) override;
  [[nodiscard]] bool live() const override { return source_.live(); }

 private:
  static constexpr std::size_t kStreams = 4;
  FrameSource& source_;
  std::mutex mutex_;
  bool closing_ = false;
  std::optional<std::uint64_t> closedAt_;         ///< end trigger of the last rail before the gate
  std::array<std::uint64_t, kStreams> passed_{};  ///< end trigger of the last rail that a stream has left, 0: none
  std::array<bool, kStreams> held_{};             ///< waits behind the gate
};

}  // namespace vignole
