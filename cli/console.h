#pragma once
// What every command shares: exit codes, one-line errors, results to a file or to stdout, progress on a terminal.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/geometry/expected.h"

namespace vignole::cli {

/// The contract of every command.
enum ExitCode : int { kDone = 0, kVerdictFail = 1, kBadInput = 2, kWorldFailed = 3 };

/// One line on stderr; returns the exit code that fits.
int fail(const Error& error);

/// "-" is stdout; a file is written whole or not at all.
[[nodiscard]] Expected<void> writeResult(const std::string& fileOrDash, const std::string& text);
[[nodiscard]] Expected<void> writeJson(const std::string& fileOrDash, const nlohmann::ordered_json& document);

/// Now, as files and reports have it: "2026-11-25T03:44:00Z".
[[nodiscard]] std::string isoTimeUtc();

/// One line on stderr that is overwritten, at most ten times a second, and only if stderr is a terminal.
class Progress {
 public:
  Progress(bool quiet, std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void update(double share, const std::string& detail = {});

 private:
  bool on_;
  std::string what_;
  double lastS_ = -1;
};

}  // namespace vignole::cli
