#include "gui/diagnostics/support_bundle.h"

#include <QDir>
#include <QMetaObject>
#include <QSaveFile>
#include <utility>

namespace vignole {

namespace {

/// Empty: written, or nothing to write.
QString write(const QDir& folder, const SupportFile& file, const std::stop_token& stop) {
  const Expected<QByteArray> bytes = file.make(stop);
  if (!bytes) return QStringLiteral("%1: %2").arg(file.name, QString::fromStdString(bytes.error().message()));
  if (bytes->isEmpty()) return {};
  QSaveFile out(folder.filePath(file.name));
  if (!out.open(QIODevice::WriteOnly) || out.write(*bytes) != bytes->size() || !out.commit())
    return QStringLiteral("%1: %2").arg(file.name, out.errorString());
  return {};
}

}  // namespace

SupportBundle::~SupportBundle() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

void SupportBundle::cancel() { thread_.request_stop(); }

bool SupportBundle::start(const QString& folder, std::vector<SupportFile> files) {
  if (running_) return false;
  running_ = true;
  thread_ = std::jthread([this, folder, files = std::move(files)](const std::stop_token& stop) {
    QStringList problems;
    QDir into(folder);
    bool removed = false;
    if (into.exists() || !into.mkpath(QStringLiteral("."))) {
      problems << QStringLiteral("%1: %2").arg(folder, into.exists() ? tr("is there already") : tr("cannot be made"));
    } else {
      int done = 0;
      for (const SupportFile& file : files) {
        if (stop.stop_requested()) break;
        if (const QString problem = write(into, file, stop); !problem.isEmpty()) problems << problem;
        ++done;
        QMetaObject::invokeMethod(
            this, [this, done, of = static_cast<int>(files.size())] { emit progressed(done, of); },
            Qt::QueuedConnection);
      }
      removed = stop.stop_requested();
      if (removed) {
        into.removeRecursively();
        problems = QStringList{tr("cancelled: nothing is left of it")};
      }
    }
    QMetaObject::invokeMethod(
        this,
        [this, text = problems.join(QStringLiteral("; "))] {
          running_ = false;
          emit finished(text);
        },
        Qt::QueuedConnection);
  });
  return true;
}

}  // namespace vignole
