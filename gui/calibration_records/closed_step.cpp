#include "gui/calibration_records/closed_step.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace vignole {

ClosedStep::ClosedStep(Workplace& place, QWidget* parent) : Panel(parent) {
  title_ = makeLabel(24, 500, "t1", this, true);
  words_ = makeLabel(18, 400, "t2", this, true);
  stopLine_ = makeButton(place.theme, QStringLiteral("pause"), this, true);
  content()->addStretch(1);
  content()->addWidget(title_);
  content()->addWidget(words_);
  content()->addWidget(stopLine_, 0, Qt::AlignLeft);
  content()->addStretch(2);
  connect(stopLine_, &QPushButton::clicked, this, [&line = place.line] { line.stop(); });
}

void ClosedStep::say(const QString& why) {
  title_->setText(tr("Closed while the line measures"));
  words_->setText(why);
  stopLine_->setText(tr("Stop the line"));
  stopLine_->setAccessibleName(tr("Stop the line"));
}

}  // namespace vignole
