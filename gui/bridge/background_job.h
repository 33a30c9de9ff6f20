#pragma once
// One long piece of work at a time in a thread of its own: its progress and its result come back to the window's
// thread.

#include <QObject>
#include <QString>
#include <functional>
#include <mutex>
#include <thread>

#include "calibration/job.h"

namespace vignole {

class BackgroundJob : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  ~BackgroundJob() override;  ///< cancels and joins; no result is told any more

  /// `work` runs in a thread and returns what is done with its result in the window's thread (nothing: none). False:
  /// another one is under way, nothing was started.
  using Result = std::function<void()>;
  bool start(std::function<Result(const Job&)> work);
  void cancel();
  [[nodiscard]] bool running() const { return running_; }

 signals:
  void progressed(double share, const QString& doing);
  void finished();  ///< after the result was told

 private:
  void tell(double share, std::string_view doing);

  bool running_ = false;
  std::mutex mutex_;
  bool told_ = true;  ///< the window has seen the latest
  double share_ = 0;
  QString doing_;
  std::jthread thread_;
};

}  // namespace vignole
