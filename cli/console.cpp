#include "cli/console.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "engine/files/atomic_file.h"

namespace vignole::cli {

int fail(const Error& error) {
  std::string line = error.message();
  for (char& c : line)
    if (c == '\n' || c == '\r') c = ' ';
  std::fprintf(stderr, "vignole-cli: %s\n", line.c_str());
  return error.kind == ErrorKind::World ? kWorldFailed : kBadInput;
}

Expected<void> writeResult(const std::string& fileOrDash, const std::string& text) {
  if (fileOrDash != "-") return writeFile(fileOrDash, text);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    return worldError("stdout", "cannot be written; is the reader gone?");
  return {};
}

std::string isoTimeUtc() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc)};
}

Expected<void> writeJson(const std::string& fileOrDash, const nlohmann::ordered_json& document) {
  return writeResult(fileOrDash, document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

namespace {
double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
}  // namespace

Progress::Progress(bool quiet, std::string what) : on_(!quiet && isatty(STDERR_FILENO) != 0), what_(std::move(what)) {}

Progress::~Progress() {
  if (on_ && lastS_ >= 0) std::fputs("\r\033[K", stderr);
}

void Progress::update(double share, const std::string& detail) {
  if (!on_) return;
  const double now = secondsNow();
  if (lastS_ >= 0 && now - lastS_ < 0.1) return;
  lastS_ = now;
  std::fprintf(stderr, "\r\033[K%s %3.0f %% %s", what_.c_str(), 100 * share, detail.c_str());
  std::fflush(stderr);
}

}  // namespace vignole::cli
