#pragma once
// The one way in which the engine reports what the world does (file bad, camera gone, no solution).

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace vignole {

/// Whose fault it is; the command line turns Input into exit code 2 and World into 3.
enum class ErrorKind { Input, World };

/// One line for a person: where it happened (file, line, column, field) and what is wrong and what to do.
struct Error {
  std::string where;
  std::string what;
  ErrorKind kind = ErrorKind::Input;

  [[nodiscard]] std::string message() const { return where.empty() ? what : where + ": " + what; }
};

template <typename T>
using Expected = tl::expected<T, Error>;

[[nodiscard]] inline tl::unexpected<Error> inputError(std::string where, std::string what) {
  return tl::unexpected<Error>(Error{std::move(where), std::move(what), ErrorKind::Input});
}
[[nodiscard]] inline tl::unexpected<Error> worldError(std::string where, std::string what) {
  return tl::unexpected<Error>(Error{std::move(where), std::move(what), ErrorKind::World});
}

}  // namespace vignole
