#include "tests/archive/postgresql_server.h"

#include <arpa/inet.h>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <grp.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <pwd.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "engine/database/database.h"

namespace vignole::testing {

namespace {

namespace fs = std::filesystem;

fs::path findPrograms() {
  std::error_code error;
  for (const fs::directory_entry& version : fs::directory_iterator("/usr/lib/postgresql", error))
    if (fs::exists(version.path() / "bin" / "initdb")) return version.path() / "bin";
  throw std::runtime_error("PostgreSQL is not installed (Debian: apt install postgresql); its tests are left out");
}

/// Whom root becomes.
const passwd* ordinaryUser() {
  if (::getuid() != 0) return nullptr;
  const passwd* user = ::getpwnam("postgres");
  return user != nullptr ? user : ::getpwnam("nobody");
}

pid_t launch(const std::vector<std::string>& arguments, const fs::path& log) {
  const passwd* user = ordinaryUser();
  const pid_t child = ::fork();
  if (child != 0) return child;
  const int out = ::open(log.c_str(), O_CREAT | O_WRONLY | O_APPEND, 0644);
  ::dup2(out, 1);
  ::dup2(out, 2);
  if (user != nullptr && (::setgroups(0, nullptr) != 0 || ::setgid(user->pw_gid) != 0 || ::setuid(user->pw_uid) != 0))
    ::_exit(126);
  ::prctl(PR_SET_PDEATHSIG, SIGQUIT);
  std::vector<char*> argv;
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  ::execv(argv[0], argv.data());
  ::_exit(127);
}

int freePort() {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  if (::bind(socket, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
      ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0)
    throw std::runtime_error("no free port");
  ::close(socket);
  return ntohs(address.sin_port);
}

std::string contentsOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

PostgresqlServer::PostgresqlServer() : programs_(findPrograms()), port_(freePort()) {
  std::string pattern =
      fs::exists("/dev/shm") ? "/dev/shm/vignole-postgresql-XXXXXX" : "/tmp/vignole-postgresql-XXXXXX";
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no folder for a server");
  folder_ = pattern;
  std::ofstream(folder_ / "password") << kPassword << '\n';
  std::ofstream(folder_ / "pgpass") << "127.0.0.1:" << port_ << ":*:vignole:" << kPassword << '\n';
  ::chmod((folder_ / "pgpass").c_str(), 0600);
  if (const passwd* user = ordinaryUser()) {
    (void)!::chown(folder_.c_str(), user->pw_uid, user->pw_gid);
    (void)!::chown((folder_ / "password").c_str(), user->pw_uid, user->pw_gid);
  }
  const pid_t making =
      launch({(programs_ / "initdb").string(), "-D", (folder_ / "data").string(), "-U", "vignole", "-A",
              "scram-sha-256", "--pwfile", (folder_ / "password").string(), "--no-sync", "-E", "UTF8", "--locale", "C"},
             folder_ / "log");
  int status = 0;
  if (::waitpid(making, &status, 0) != making || status != 0)
    throw std::runtime_error("initdb failed: " + contentsOf(folder_ / "log"));
  start();
}

PostgresqlServer::~PostgresqlServer() {
  stop();
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void PostgresqlServer::start() {
  if (process_ > 0) return;
  process_ = launch({(programs_ / "postgres").string(), "-D", (folder_ / "data").string(), "-p", std::to_string(port_),
                     "-k", folder_.string(), "-c", "listen_addresses=127.0.0.1", "-c", "fsync=off"},
                    folder_ / "log");
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (std::chrono::steady_clock::now() < until) {
    const auto there = guarded([&] {
      Database database(*parseArchiveUrl(urlWithPassword(kPassword)), Database::Missing::Refuse);
      return database.first("select 1", {}, "i").has_value();
    });
    if (there) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  throw std::runtime_error("the server does not answer: " + contentsOf(folder_ / "log"));
}

void PostgresqlServer::stop() {
  if (process_ <= 0) return;
  ::kill(process_, SIGQUIT);
  ::waitpid(process_, nullptr, 0);
  process_ = -1;
}

std::string PostgresqlServer::url(const std::string& schema) const {
  const auto done = guarded([&] {
    Database database(*parseArchiveUrl(urlWithPassword(kPassword)), Database::Missing::Refuse);
    database.run("create schema if not exists " + schema);
  });
  if (!done) throw std::runtime_error(done.error().message());
  return "postgresql://vignole@127.0.0.1:" + std::to_string(port_) + "/postgres?options=-csearch_path%3D" + schema +
         "&passfile=" + (folder_ / "pgpass").string();
}

std::string PostgresqlServer::urlWithPassword(const std::string& password) const {
  std::string escaped;
  for (const char c : password) escaped += c == ' ' ? "%20" : std::string(1, c);
  return "postgresql://vignole:" + escaped + "@127.0.0.1:" + std::to_string(port_) + "/postgres";
}

PostgresqlServer& PostgresqlServer::ofThisProgram() {
  static PostgresqlServer server;
  return server;
}

bool PostgresqlServer::wished() {
  const char* wish = std::getenv("VIGNOLE_TEST_POSTGRESQL");
  return wish != nullptr && std::string(wish) == "1";
}

namespace {

/// Without a server nothing is tested, and the reason is told.
class ServerIsThere : public ::testing::Environment {
 public:
  void SetUp() override {
    if (!PostgresqlServer::wished()) return;
    try {
      (void)PostgresqlServer::ofThisProgram();
    } catch (const std::exception& failure) {
      if (std::string(failure.what()).starts_with("PostgreSQL is not installed")) GTEST_SKIP() << failure.what();
      FAIL() << failure.what();
    }
  }
};

const auto* const kServerIsThere = ::testing::AddGlobalTestEnvironment(new ServerIsThere);

}  // namespace

}  // namespace vignole::testing
