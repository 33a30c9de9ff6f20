#include "gui/rails/next_rail_dialog.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>

#include "gui/theme/panel.h"

namespace vignole {

namespace {

enum Field : std::size_t { kId, kHeat, kStrand, kOrder, kTemperature };
// Colder than any yard, and the hottest that a cold size is computed for.
constexpr double kColdestC = -40, kHottestC = 150;
constexpr int kLongest = 60;

}  // namespace

NextRailDialog::NextRailDialog(const Theme& theme, RailAnnouncements& rails, QWidget* parent)
    : QDialog(parent), rails_(rails) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(24, 20, 24, 20);
  grid->setHorizontalSpacing(16);
  grid->setVerticalSpacing(10);
  title_ = makeLabel(16, 400, "t2", this, true);
  grid->addWidget(title_, 0, 0, 1, 2);
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    labels_[i] = makeLabel(16, 500, "t1", this);
    fields_[i] = new QLineEdit(this);
    fields_[i]->setFont(uiFont(16));
    fields_[i]->setMaxLength(kLongest);
    fields_[i]->setMinimumSize(280, 44);
    labels_[i]->setBuddy(fields_[i]);
    grid->addWidget(labels_[i], static_cast<int>(i) + 1, 0);
    grid->addWidget(fields_[i], static_cast<int>(i) + 1, 1);
  }
  message_ = makeLabel(15, 500, "t1", this, true);
  message_->setMinimumHeight(44);
  grid->addWidget(message_, 6, 0, 1, 2);
  auto* buttons = new QHBoxLayout;
  announce_ = makeButton(theme, QString(), this, true);
  withdraw_ = makeButton(theme, QString(), this);
  close_ = makeButton(theme, QString(), this);
  announce_->setDefault(true);
  buttons->addWidget(announce_);
  buttons->addWidget(withdraw_);
  buttons->addStretch(1);
  buttons->addWidget(close_);
  grid->addLayout(buttons, 7, 0, 1, 2);
  connect(announce_, &QPushButton::clicked, this, &NextRailDialog::announce);
  connect(withdraw_, &QPushButton::clicked, this, [this] {
    rails_.withdraw();
    waited_ = false;
    message_->setText(tr("Nothing waits: the next rail is named by the line."));
    withdraw_->setEnabled(false);
  });
  connect(close_, &QPushButton::clicked, this, &QDialog::close);
  retranslate();
}

void NextRailDialog::retranslate() {
  setWindowTitle(tr("Next rail"));
  title_->setText(
      tr("What is entered here goes with the next rail that begins. An empty field stays as the line has "
         "it."));
  const std::array<QString, 5> words = {tr("Rail"), tr("Heat"), tr("Strand"), tr("Order"), tr("Temperature, °C")};
  for (std::size_t i = 0; i < words.size(); ++i) {
    labels_[i]->setText(words[i]);
    fields_[i]->setAccessibleName(words[i]);
  }
  announce_->setText(tr("For the next rail"));
  withdraw_->setText(tr("Withdraw"));
  close_->setText(tr("Close"));
  for (QPushButton* b : {announce_, withdraw_, close_}) b->setAccessibleName(b->text());
  refresh();
}

void NextRailDialog::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void NextRailDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  fields_[kId]->setFocus();
  refresh();
}

QString NextRailDialog::message() const { return message_->text(); }

void NextRailDialog::refresh() {
  const auto waiting = rails_.waiting();
  withdraw_->setEnabled(waiting.has_value());
  if (waiting) {
    message_->setText(waiting->id.empty() ? tr("Waits for the next rail.")
                                          : tr("%1 waits for the next rail.").arg(QString::fromStdString(waiting->id)));
  } else if (waited_) {
    message_->setText(tr("The rail has begun with what was entered."));
    for (const Field f : {kId, kTemperature}) fields_[f]->clear();  // the next rail has others; heat and strand go on
  }
  waited_ = waiting.has_value();
}

void NextRailDialog::announce() {
  RailAnnouncement next;
  const auto text = [this](Field f) { return fields_[f]->text().trimmed().toStdString(); };
  next.id = text(kId);
  next.heat = text(kHeat);
  next.strand = text(kStrand);
  next.order = text(kOrder);
  if (const QString entered = fields_[kTemperature]->text().trimmed(); !entered.isEmpty()) {
    bool ok = false;
    double celsius = locale().toDouble(entered, &ok);
    if (!ok) celsius = QLocale::c().toDouble(entered, &ok);
    if (!ok || celsius < kColdestC || celsius > kHottestC) {
      message_->setText(tr("The temperature is no number from %1 to %2 °C.").arg(kColdestC).arg(kHottestC));
      fields_[kTemperature]->setFocus();
      return;
    }
    next.temperatureC = celsius;
  }
  if (next.id.empty() && next.heat.empty() && next.strand.empty() && next.order.empty() && !next.temperatureC) {
    message_->setText(tr("Nothing was entered: fill in at least one field."));
    fields_[kId]->setFocus();
    return;
  }
  rails_.announce(std::move(next));
  refresh();
}

}  // namespace vignole
