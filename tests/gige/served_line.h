#pragma once
// simulate serve and inspect --source gige as two processes.

#include <chrono>
#include <csignal>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/end_to_end/program.h"

namespace vignole::testing {

using nlohmann::json;
using Arguments = std::vector<std::string>;

/// Cameras at four addresses of their own; stopped with the object.
class ServedCameras {
 public:
  explicit ServedCameras(std::string address, const Arguments& options) : address_(std::move(address)) {
    Arguments all = {"simulate", "serve", "--address", address_, "--json", folder_.file("served.json")};
    all.insert(all.end(), options.begin(), options.end());
    program_ = std::make_unique<Program>(all);
    for (int i = 0; i < 4000 && program_->out().find("ready\n") == std::string::npos; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(program_->out(), "ready\n");
  }
  ~ServedCameras() {
    if (program_) stop();
  }
  ServedCameras(const ServedCameras&) = delete;
  ServedCameras& operator=(const ServedCameras&) = delete;
  /// What was served.
  json stop() {
    program_->signal(SIGINT);
    const ProgramResult result = program_->wait();
    program_.reset();
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return json::parse(contents(folder_.file("served.json")), nullptr, false);
  }
  /// As if its power failed.
  void kill() {
    program_->signal(SIGKILL);
    program_->wait();
    program_.reset();
  }
  [[nodiscard]] const std::string& address() const { return address_; }

 private:
  std::string address_;
  Folder folder_;
  std::unique_ptr<Program> program_;
};

/// An inspection under way.
class LiveInspection {
 public:
  LiveInspection(const std::string& address, const Arguments& options) {
    Arguments all = {"inspect", "--source",
                     "gige",    "--address",
                     address,   "--quiet",
                     "--json",  folder_.file("run.json"),
                     "--csv",   folder_.file("run.csv")};
    all.insert(all.end(), options.begin(), options.end());
    program_ = std::make_unique<Program>(all);
  }
  void kill() { program_->signal(SIGKILL); }
  json wait() {
    result = program_->wait();
    rows.clear();
    std::istringstream csv(contents(folder_.file("run.csv")));
    for (std::string line; std::getline(csv, line);) rows.push_back(line);
    return json::parse(contents(folder_.file("run.json")), nullptr, false);
  }
  ProgramResult result;
  Arguments rows;  ///< of the CSV, after wait()

 private:
  Folder folder_;
  std::unique_ptr<Program> program_;
};

/// Two rails of 60 triggers with a gap between them, at 20 Hz.
inline constexpr std::uint64_t kRailTriggers = 60;
inline Arguments twoRails(const Arguments& faults = {}) {
  Arguments all = {"--rate", "20", "--length", "0.9", "--gap", "0.3"};
  for (const std::string& fault : faults) all.insert(all.end(), {"--fault", fault});
  return all;
}

inline std::uint64_t reason(const json& run, const std::string& words) {
  return run["triggers"]["reasons"].value(words, std::uint64_t{0});
}

/// Every trigger is in exactly one column, and there are as many as were issued while a rail was there.
inline void expectAccounted(const json& run, std::uint64_t seen) {
  ASSERT_TRUE(run.is_object());
  const json& t = run["triggers"];
  EXPECT_EQ(t["seen"].get<std::uint64_t>(),
            t["measured"].get<std::uint64_t>() + t["incomplete"].get<std::uint64_t>() + t["lost"].get<std::uint64_t>());
  EXPECT_EQ(t["seen"].get<std::uint64_t>(), seen) << run["triggers"].dump();
  EXPECT_EQ(run["line"]["in_rails"].get<std::uint64_t>(), seen);
}

/// Fields of a row of the CSV.
inline Arguments fields(const std::string& row) {
  Arguments all;
  std::istringstream in(row);
  for (std::string field; std::getline(in, field, ',');) all.push_back(field);
  return all;
}

/// Rows by trigger, without the rail's name and without the uncertainties: those hold that of the rail's temperature,
/// which the virtual rig knows exactly and a line does not.
inline std::map<std::uint64_t, std::string> byTrigger(const Arguments& rows) {
  std::map<std::uint64_t, std::string> found;
  const Arguments head = fields(rows.front());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Arguments row = fields(rows[i]);
    std::string& kept = found[std::stoull(row[3])];
    for (std::size_t f = 1; f < row.size(); ++f)
      if (head[f].rfind("u_", 0) != 0) kept += "," + row[f];
  }
  return found;
}

}  // namespace vignole::testing
