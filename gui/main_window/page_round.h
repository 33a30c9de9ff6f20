#pragma once
// The pages one after the other, without a person: pictures of all of them, and a window that is kept busy for hours.

#include <QSize>
#include <QTimer>
#include <string>
#include <vector>

#include "engine/geometry/expected.h"
#include "gui/main_window/main_window.h"

namespace vignole {

class Theme;

/// The window as a PNG file, whole or not at all.
[[nodiscard]] Expected<void> savePicture(QWidget& window, const std::string& file);

/// Shows the next page every `pauseS`, for as long as it lives.
class PageRound : public QObject {
 public:
  PageRound(MainWindow& window, double pauseS);

 private:
  QTimer timer_;
};

/// Every page in both themes at both sizes that the pages are made for: FOLDER/1366x768-light/monitor.png and so on.
/// Ends once.
class PagePictures : public QObject {
  Q_OBJECT

 public:
  /// Each page is shown for `pauseS` before its picture: what it reads has arrived by then.
  PagePictures(MainWindow& window, Theme& theme, std::string folder, double pauseS);

 signals:
  void ended(const QString& problem);  ///< empty: all pictures are there

 private:
  struct Step {
    QSize size;
    bool dark;
    PageId page;
  };
  void show();
  void take();

  MainWindow& window_;
  Theme& theme_;
  std::string folder_;
  QTimer timer_;
  std::vector<Step> steps_;
  std::size_t next_ = 0;
};

}  // namespace vignole
