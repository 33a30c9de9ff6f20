#include "gui/main_window/page_bar.h"

#include <QHBoxLayout>
#include <QPushButton>

namespace vignole {

PageBar::PageBar(const Theme& theme, QWidget* parent) : QFrame(parent), theme_(theme) {
  setObjectName(QStringLiteral("pageBar"));
  setFixedHeight(56);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  pageRow_ = new QHBoxLayout;
  pageRow_->setSpacing(0);
  row->addLayout(pageRow_);
  row->addStretch(1);
  pipeline_ = add(QStringLiteral("H"), tr("Pipeline"), QStringLiteral("diagnostics"), &PageBar::pipelineAsked);
  pipeline_->setCheckable(true);
  full_ = add(QStringLiteral("F11"), tr("Full view"), QStringLiteral("fit"), &PageBar::fullViewAsked);
  full_->setCheckable(true);
  run_ = add(QStringLiteral("Ctrl+R"), tr("Stop line"), QStringLiteral("pause"), &PageBar::runAsked);
  for (QPushButton* button : {pipeline_, full_, run_}) row->addWidget(button);
  connect(&theme_, &Theme::changed, this, &PageBar::relabel);
  relabel();
}

void PageBar::addPage(PageId page) {
  auto* button = new QPushButton(this);
  button->setFont(uiFont(18, 500));
  button->setFixedHeight(56);
  button->setIconSize({22, 22});
  button->setCheckable(true);
  connect(button, &QPushButton::clicked, this, [this, page] {
    setShown(shown_);  // what is shown stays marked, however often its button is pressed
    emit pageAsked(page);
  });
  pages_[static_cast<std::size_t>(page)] = button;
  pageRow_->addWidget(button);
  setShown(shown_);
  relabel();
}

void PageBar::setShown(PageId page) {
  shown_ = page;
  for (int i = 0; i < kPageCount; ++i)
    if (QPushButton* button = pages_[static_cast<std::size_t>(i)]) button->setChecked(i == static_cast<int>(page));
}

QPushButton* PageBar::add(const QString& key, const QString& word, const QString& icon, void (PageBar::*signal)()) {
  auto* button = new QPushButton(this);
  button->setFont(uiFont(18, 500));
  button->setFixedHeight(56);
  button->setMinimumWidth(192);
  button->setIconSize({22, 22});
  label(button, key, word, icon);
  connect(button, &QPushButton::clicked, this, signal);
  return button;
}

void PageBar::label(QPushButton* button, const QString& key, const QString& word, const QString& icon) {
  button->setText(QStringLiteral("%1   %2").arg(key, word));
  button->setAccessibleName(word);
  button->setToolTip(QStringLiteral("%1 (%2)").arg(word, key));
  button->setIcon(theme_.icon(icon, 22, theme_.palette().t1, devicePixelRatioF()));
}

void PageBar::relabel() {
  for (int i = 0; i < kPageCount; ++i)
    if (QPushButton* button = pages_[static_cast<std::size_t>(i)]) {
      const auto page = static_cast<PageId>(i);
      label(button, QStringLiteral("F%1").arg(i + 1), pageWord(page), QString::fromLatin1(pageName(page).icon));
    }
  label(pipeline_, QStringLiteral("H"), tr("Pipeline"), QStringLiteral("diagnostics"));
  label(full_, QStringLiteral("F11"), tr("Full view"), QStringLiteral("fit"));
  label(run_, QStringLiteral("Ctrl+R"), running_ ? tr("Stop line") : tr("Start line"),
        running_ ? QStringLiteral("pause") : QStringLiteral("play"));
}

void PageBar::setRunning(bool running) {
  if (running == running_) return;
  running_ = running;
  relabel();
}

void PageBar::setPipelineShown(bool shown) { pipeline_->setChecked(shown); }
void PageBar::setFullView(bool full) { full_->setChecked(full); }

}  // namespace vignole
