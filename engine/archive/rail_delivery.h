#pragma once
// Rails that were measured for an archive on a server wait in a file beside the program (itself an archive) and go to
// the server one after the other, each whole or not at all, when they have passed: whether the server is there or not
// does not concern who measures. A rail leaves the file when the server has it for good; its uid keeps it from coming
// twice.

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/archive/archive.h"

namespace vignole {

struct RailDeliveryStatus {
  std::uint64_t delivered = 0;
  std::uint64_t waiting = 0;  ///< that have passed
  std::string failure;        ///< why they wait; empty: all is well
};

/// One rail that has passed, from the file into the server's archive, within one transaction of the server; gone from
/// the file afterwards. False: the server had it already. Throws DatabaseFailure.
bool deliverRail(Database& waiting, Database& server, std::int64_t key);

/// On a thread of its own.
class RailDelivery {
 public:
  RailDelivery(std::filesystem::path file, std::string url, std::chrono::milliseconds retry);
  ~RailDelivery();  ///< what waits stays in the file
  RailDelivery(const RailDelivery&) = delete;
  RailDelivery& operator=(const RailDelivery&) = delete;

  void railHasPassed();  ///< there is something to deliver
  [[nodiscard]] RailDeliveryStatus status() const;
  /// Tries once more to deliver all that waits, then stops. An error where something still waits.
  [[nodiscard]] Expected<void> finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Where the rails of a line wait for the server: a file in `folder`; empty: in the user's own state
/// ($XDG_STATE_HOME/vignole, ~/.local/state/vignole).
[[nodiscard]] Expected<std::filesystem::path> waitingRailsFile(const std::filesystem::path& folder,
                                                               const std::string& server, const std::string& line);

}  // namespace vignole
