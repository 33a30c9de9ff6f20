#include "gui/main_window/page_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>

namespace vignole {

PageBar::PageBar(const Theme& theme, QWidget* parent) : QFrame(parent), theme_(theme), row_(new QHBoxLayout(this)) {
  setObjectName(QStringLiteral("pageBar"));
  setFixedHeight(56);
  row_->setContentsMargins(0, 0, 0, 0);
  row_->setSpacing(0);
  connect(&theme_, &Theme::changed, this, &PageBar::relabel);
}

void PageBar::addPage(PageId page) {
  auto* button = new QPushButton(this);
  button->setCheckable(true);
  button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
  connect(button, &QPushButton::clicked, this, [this, page] {
    setShown(shown_);  // what is shown stays marked, however often its button is pressed
    emit pageAsked(page);
  });
  pages_[static_cast<std::size_t>(page)] = button;
  row_->addWidget(button, 1);
  setShown(shown_);
  relabel();
}

void PageBar::setShown(PageId page) {
  shown_ = page;
  for (int i = 0; i < kPageCount; ++i)
    if (QPushButton* button = pages_[static_cast<std::size_t>(i)]) button->setChecked(i == static_cast<int>(page));
}

void PageBar::setAlarms(std::size_t active) {
  if (active == alarms_) return;
  alarms_ = active;
  relabel();
}

void PageBar::relabel() {
  // Narrow windows have room for the key and the word alone.
  const bool narrow = width() < 1700;
  for (int i = 0; i < kPageCount; ++i) {
    QPushButton* button = pages_[static_cast<std::size_t>(i)];
    if (button == nullptr) continue;
    const auto page = static_cast<PageId>(i);
    const QString key = QStringLiteral("F%1").arg(i + 1), word = pageWord(page);
    QString text = key + QStringLiteral("  ") + word;
    if (page == PageId::Alarms && alarms_ > 0) text += QStringLiteral("  %1").arg(alarms_);
    button->setFont(uiFont(narrow ? 15 : 17, 500));
    button->setText(text);
    button->setAccessibleName(word);
    button->setToolTip(QStringLiteral("%1 (%2)").arg(word, key));
    button->setIconSize(narrow ? QSize(0, 0) : QSize(22, 22));
    button->setIcon(narrow ? QIcon()
                           : QIcon(theme_.icon(QString::fromLatin1(pageName(page).icon), 22, theme_.palette().t1,
                                               devicePixelRatioF())));
  }
}

void PageBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) relabel();
}

void PageBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  relabel();
}

}  // namespace vignole
