#pragma once
// A PostgreSQL server of the tests' own: in a folder and on a port nobody else has, gone with the object (and with the
// test, should that die). Debian's package postgresql, run by an ordinary user: the server refuses to be root.

#include <filesystem>
#include <string>
#include <sys/types.h>

namespace vignole::testing {

class PostgresqlServer {
 public:
  /// Throws std::runtime_error; where there is none installed its words begin with "PostgreSQL is not installed".
  PostgresqlServer();
  ~PostgresqlServer();
  PostgresqlServer(const PostgresqlServer&) = delete;
  PostgresqlServer& operator=(const PostgresqlServer&) = delete;

  void start();  ///< returns when it answers
  void stop();   ///< at once: whoever is connected is cut off
  /// Of an archive in a schema of its own, which is made. Without password: that is in a file.
  [[nodiscard]] std::string url(const std::string& schema) const;
  /// The same without the schema and the file: "postgresql://vignole:PASSWORD@127.0.0.1:PORT/postgres".
  [[nodiscard]] std::string urlWithPassword(const std::string& password) const;
  static constexpr const char* kPassword = "s3cret of the mill";

  /// The one of this program, started when it is first asked for.
  static PostgresqlServer& ofThisProgram();
  /// Is this program to test on PostgreSQL (VIGNOLE_TEST_POSTGRESQL=1) rather than on SQLite?
  static bool wished();

 private:
  std::filesystem::path folder_, programs_;
  int port_ = 0;
  pid_t process_ = -1;
};

}  // namespace vignole::testing
