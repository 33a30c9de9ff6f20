#include "gui/main_window/page_round.h"

#include <QDir>
#include <QSaveFile>
#include <utility>

#include "gui/theme/theme.h"

namespace vignole {

Expected<void> savePicture(QWidget& window, const std::string& file) {
  QSaveFile out(QString::fromStdString(file));
  if (!out.open(QIODevice::WriteOnly) || !window.grab().save(&out, "PNG") || !out.commit())
    return worldError(file, "cannot be written: " + out.errorString().toStdString());
  return {};
}

PageRound::PageRound(MainWindow& window, double pauseS) {
  connect(&timer_, &QTimer::timeout, this,
          [&window] { window.showPage(static_cast<PageId>((static_cast<int>(window.page()) + 1) % kPageCount)); });
  timer_.start(static_cast<int>(pauseS * 1000));
}

PagePictures::PagePictures(MainWindow& window, Theme& theme, std::string folder, double pauseS)
    : window_(window), theme_(theme), folder_(std::move(folder)) {
  for (const QSize& size : {QSize(1366, 768), QSize(1920, 1080)})
    for (const bool dark : {false, true})
      for (int page = 0; page < kPageCount; ++page) steps_.push_back({size, dark, static_cast<PageId>(page)});
  timer_.setInterval(static_cast<int>(pauseS * 1000));
  connect(&timer_, &QTimer::timeout, this, &PagePictures::take);
  show();
  timer_.start();
}

void PagePictures::show() {
  const Step& step = steps_[next_];
  window_.resize(step.size);
  theme_.setDark(step.dark);
  window_.showPage(step.page);
}

void PagePictures::take() {
  const Step& step = steps_[next_];
  const QString folder = QStringLiteral("%1/%2x%3-%4")
                             .arg(QString::fromStdString(folder_))
                             .arg(step.size.width())
                             .arg(step.size.height())
                             .arg(step.dark ? QStringLiteral("dark") : QStringLiteral("light"));
  QString problem;
  if (!QDir().mkpath(folder)) problem = folder + QStringLiteral(": the folder cannot be made");
  window_.tick(PullDetail::Everything);
  if (problem.isEmpty())
    if (const auto saved = savePicture(window_, folder.toStdString() + "/" + pageName(step.page).option + ".png");
        !saved)
      problem = QString::fromStdString(saved.error().message());
  if (problem.isEmpty() && ++next_ < steps_.size()) return show();
  timer_.stop();
  emit ended(problem);
}

}  // namespace vignole
