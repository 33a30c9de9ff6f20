#pragma once
// A folder with what a person who helps from afar wants to see, written by a thread of its own: state, recipe,
// calibration, the cameras' pictures. No users, no passwords.

#include <QObject>
#include <QString>
#include <functional>
#include <thread>
#include <vector>

#include "engine/geometry/expected.h"

namespace vignole {

/// One file of a bundle. `make` runs in the bundle's thread; no bytes and no error: there is nothing, it is left out.
struct SupportFile {
  QString name;
  std::function<Expected<QByteArray>(const std::stop_token& stop)> make;
};

class SupportBundle : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  ~SupportBundle() override;  ///< cancels and joins
  /// Makes the folder, which must not be there yet, and writes one file after the other. False: one is under way.
  bool start(const QString& folder, std::vector<SupportFile> files);
  void cancel();  ///< what is written so far is removed
  [[nodiscard]] bool running() const { return running_; }

 signals:
  void progressed(int done, int of);
  void finished(const QString& problem);  ///< empty: all is written; files that could not be made are named

 private:
  bool running_ = false;
  std::jthread thread_;
};

}  // namespace vignole
