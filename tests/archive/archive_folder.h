#pragma once
// Archives for tests: an empty folder that is gone with the object, and rails to put into them. url() names an archive
// of the kind that is to be tested, SQLite or PostgreSQL (PostgresqlServer::wished()); file() always a file.

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>

#include "engine/archive/archive.h"
#include "engine/archive/generated_rails.h"
#include "tests/archive/postgresql_server.h"

namespace vignole::testing {

class ArchiveFolder {
 public:
  ArchiveFolder() {
    // In memory where that is to be had: an archive waits for its disk after every transaction.
    std::string pattern = "/dev/shm/vignole-archive-XXXXXX";
    if (::mkdtemp(pattern.data()) == nullptr) {
      pattern = (std::filesystem::temp_directory_path() / "vignole-archive-XXXXXX").string();
      if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no folder for a test's archive");
    }
    path_ = pattern;
  }
  ~ArchiveFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ArchiveFolder(const ArchiveFolder&) = delete;
  ArchiveFolder& operator=(const ArchiveFolder&) = delete;
  [[nodiscard]] std::string file(const std::string& name = "rails of the mill.db") const {
    return (path_ / name).string();
  }
  [[nodiscard]] std::string url(const std::string& name = "rails of the mill.db") const {
    if (!PostgresqlServer::wished()) return file(name);
    std::string schema = path_.filename().string() + "_" + name;
    for (char& c : schema) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    // Names are without case, and the folder's has both.
    std::string plain;
    for (const char c : schema) {
      if (std::isupper(static_cast<unsigned char>(c)) != 0) plain += "_";
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return PostgresqlServer::ofThisProgram().url(plain);
  }

 private:
  std::filesystem::path path_;
};

inline Archive openArchive(const std::string& url, Archive::Missing missing = Archive::Missing::Create) {
  auto archive = Archive::open(url, missing);
  if (!archive) throw std::runtime_error(archive.error().message());
  return std::move(*archive);
}

inline const Recipe& recipe() {
  static const Recipe made = [] {
    auto r = makeRecipe("60E1");
    if (!r) throw std::runtime_error(r.error().message());
    return *r;
  }();
  return made;
}

inline std::shared_ptr<const MeasuringSetup> setup() {
  MeasuringSetup s{recipe(), {}};
  s.calibration.id = "test rig";
  s.calibration.method = "exact";
  return std::make_shared<const MeasuringSetup>(std::move(s));
}

/// Points on a circle, a few per camera.
inline void addPoints(Profile& profile, int count = 40) {
  profile.points.clear();
  profile.lineEnds.clear();
  profile.pointsOfCamera.fill(0);
  for (int i = 0; i < count; ++i) {
    ProfilePoint p;
    p.x = 50 * std::cos(0.1 * i) + 0.001 * static_cast<double>(profile.trigger);
    p.y = 50 * std::sin(0.1 * i);
    p.sigmaMm = 0.004F;
    profile.points.push_back(p);
  }
  profile.pointsOfCamera[0] = static_cast<std::uint32_t>(count);
  profile.lineEnds.push_back(static_cast<std::uint32_t>(count));
}

}  // namespace vignole::testing
