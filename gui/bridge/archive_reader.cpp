#include "gui/bridge/archive_reader.h"

#include <QMetaObject>
#include <algorithm>
#include <optional>

namespace vignole {

ArchiveReader::ArchiveReader(std::string url, QObject* parent)
    : QObject(parent), url_(std::move(url)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

ArchiveReader::~ArchiveReader() {
  thread_.request_stop();
  waiting_.notify_all();
  thread_.join();
}

void ArchiveReader::ask(const std::string& kind, Question question) {
  {
    const std::lock_guard lock(mutex_);
    const auto same =
        std::find_if(questions_.begin(), questions_.end(), [&](const auto& q) { return q.first == kind; });
    if (same != questions_.end()) questions_.erase(same);
    questions_.emplace_back(kind, std::move(question));
  }
  waiting_.notify_one();
}

void ArchiveReader::run(const std::stop_token& stop) {
  std::optional<Archive> archive;
  std::string problem = "no archive was asked for (--archive)";
  while (!stop.stop_requested()) {
    Question question;
    {
      std::unique_lock lock(mutex_);
      if (!waiting_.wait(lock, stop, [this] { return !questions_.empty(); })) return;
      question = std::move(questions_.front().second);
      questions_.pop_front();
    }
    if (!archive && !url_.empty()) {
      auto opened = Archive::open(url_);
      if (opened)
        archive.emplace(std::move(*opened));
      else
        problem = opened.error().message();
    }
    Answer answer = question(archive ? &*archive : nullptr, problem);
    if (answer) QMetaObject::invokeMethod(this, std::move(answer), Qt::QueuedConnection);
  }
}

}  // namespace vignole
