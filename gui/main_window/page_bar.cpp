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
  monitor_ = add(QStringLiteral("F1"), tr("Monitor"), QStringLiteral("monitor"), &PageBar::monitorAsked);
  monitor_->setCheckable(true);
  monitor_->setChecked(true);
  // The page that is shown stays marked, however often its button is pressed.
  connect(monitor_, &QPushButton::clicked, monitor_, [this] { monitor_->setChecked(true); });
  row->addWidget(monitor_);
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
  label(monitor_, QStringLiteral("F1"), tr("Monitor"), QStringLiteral("monitor"));
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
