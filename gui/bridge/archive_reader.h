#pragma once
// Questions to the archive, answered by a thread and a connection of its own: the window never waits for the disk.

#include <QObject>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "engine/archive/archive.h"

namespace vignole {

class ArchiveReader : public QObject {
  Q_OBJECT

 public:
  explicit ArchiveReader(std::string url, QObject* parent = nullptr);
  ~ArchiveReader() override;  ///< what has not been asked yet is forgotten

  /// `question` runs in the reader's thread (the archive is null where it cannot be opened: `problem` says why) and
  /// returns what is done with the answer in the window's thread; that is left out if the reader is gone by then.
  /// Questions of one `kind` that wait are replaced by the newest.
  using Answer = std::function<void()>;
  using Question = std::function<Answer(const Archive* archive, const std::string& problem)>;
  void ask(const std::string& kind, Question question);

 private:
  void run(const std::stop_token& stop);

  std::string url_;
  std::mutex mutex_;
  std::condition_variable_any waiting_;
  std::deque<std::pair<std::string, Question>> questions_;
  std::jthread thread_;
};

}  // namespace vignole
