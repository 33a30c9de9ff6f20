#include "gui/bridge/background_job.h"

#include <QMetaObject>
#include <utility>

namespace vignole {

BackgroundJob::~BackgroundJob() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

bool BackgroundJob::start(std::function<Result(const Job&)> work) {
  if (running_) return false;
  running_ = true;
  thread_ = std::jthread([this, work = std::move(work)](const std::stop_token& stop) {
    const Job job{[this](double share, std::string_view doing) { tell(share, doing); }, stop};
    Result result = work(job);
    QMetaObject::invokeMethod(
        this,
        [this, result = std::move(result)] {
          running_ = false;
          if (result) result();
          emit finished();
        },
        Qt::QueuedConnection);
  });
  return true;
}

void BackgroundJob::cancel() { thread_.request_stop(); }

// Steps tell often; the window is asked once for whatever is the latest.
void BackgroundJob::tell(double share, std::string_view doing) {
  {
    const std::lock_guard lock(mutex_);
    share_ = share;
    doing_ = QString::fromUtf8(doing.data(), static_cast<qsizetype>(doing.size()));
    if (!told_) return;
    told_ = false;
  }
  QMetaObject::invokeMethod(
      this,
      [this] {
        double latest = 0;
        QString words;
        {
          const std::lock_guard lock(mutex_);
          told_ = true;
          latest = share_;
          words = doing_;
        }
        if (running_) emit progressed(latest, words);
      },
      Qt::QueuedConnection);
}

}  // namespace vignole
