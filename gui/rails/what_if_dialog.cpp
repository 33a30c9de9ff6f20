#include "gui/rails/what_if_dialog.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>
#include <map>

#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"
#include "gui/theme/state_icon.h"
#include "report/dimension_text.h"
#include "report/state_symbol.h"

namespace vignole {

namespace {

constexpr std::size_t kRailsPerQuestion = 4;  // between two of them a search of the page gets its turn
constexpr int kMostListed = 200;
constexpr std::size_t kRowsPerBlock = 7;

QString shown(const std::string& text) { return QString::fromStdString(text); }

}  // namespace

WhatIfDialog::WhatIfDialog(Workplace& place, ArchiveReader& reader, QWidget* parent)
    : QDialog(parent), place_(place), reader_(reader) {
  auto* all = new QGridLayout(this);
  all->setContentsMargins(24, 20, 24, 20);
  all->setHorizontalSpacing(24);
  all->setVerticalSpacing(10);
  intro_ = makeLabel(16, 400, "t2", this, true);
  all->addWidget(intro_, 0, 0, 1, 2);

  auto* fields = new QGridLayout;
  fields->setHorizontalSpacing(8);
  fields->setVerticalSpacing(4);
  profileLabel_ = makeLabel(15, 400, "t2", this);
  straightnessLabel_ = makeLabel(15, 400, "t2", this);
  profileClass_ = new QComboBox(this);
  straightnessClass_ = new QComboBox(this);
  for (QComboBox* box : {profileClass_, straightnessClass_}) {
    box->setFont(uiFont(16));
    connect(box, &QComboBox::activated, this, &WhatIfDialog::fillFromClass);
  }
  fields->addWidget(profileLabel_, 0, 0, 1, 2);
  fields->addWidget(profileClass_, 1, 0, 1, 3);
  fields->addWidget(straightnessLabel_, 0, 3, 1, 2);
  fields->addWidget(straightnessClass_, 1, 3, 1, 3);
  for (std::size_t block = 0; block < 2; ++block) {
    const int column = 3 * static_cast<int>(block);
    lowerHeads_[block] = makeLabel(14, 400, "t2", this);
    upperHeads_[block] = makeLabel(14, 400, "t2", this);
    fields->addWidget(lowerHeads_[block], 2, column + 1);
    fields->addWidget(upperHeads_[block], 2, column + 2);
  }
  // In two blocks, so that a low screen holds them.
  for (const Dimension d : kDimensions) {
    const int row = 3 + static_cast<int>(index(d) % kRowsPerBlock);
    const int column = 3 * static_cast<int>(index(d) / kRowsPerBlock);
    names_[index(d)] = makeLabel(16, 500, "t1", this);
    names_[index(d)]->setText(spoken(d));
    fields->addWidget(names_[index(d)], row, column);
    for (auto* side : {&lower_, &upper_}) {
      auto* field = new QLineEdit(this);
      field->setFont(uiFont(15));
      field->setAlignment(Qt::AlignRight);
      field->setFixedWidth(92);
      (*side)[index(d)] = field;
      fields->addWidget(field, row, column + (side == &lower_ ? 1 : 2));
    }
  }
  fields->setRowStretch(3 + static_cast<int>(kRowsPerBlock), 1);
  all->addLayout(fields, 1, 0);

  auto* right = new QVBoxLayout;
  result_ = makeLabel(20, 500, "t1", this, true);
  detail_ = makeLabel(15, 400, "t2", this, true);
  progress_ = new QProgressBar(this);
  progress_->setTextVisible(false);
  progress_->setFixedHeight(8);
  table_ = new QTableWidget(0, 4, this);
  styleTable(*table_);
  table_->setIconSize({18, 18});
  table_->setMinimumWidth(440);
  right->addWidget(result_);
  right->addWidget(progress_);
  right->addWidget(detail_);
  right->addWidget(table_, 1);
  all->addLayout(right, 1, 1);
  all->setColumnStretch(1, 1);

  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  try_ = makeButton(place.theme, QStringLiteral("play"), this, true);
  close_ = makeButton(place.theme, QString(), this);
  try_->setDefault(true);
  buttons->addWidget(try_);
  buttons->addStretch(1);
  buttons->addWidget(close_);
  all->addLayout(buttons, 2, 0, 1, 2);
  connect(try_, &QPushButton::clicked, this, [this] { running_ ? stop() : start(); });
  connect(close_, &QPushButton::clicked, this, &QDialog::close);
  connect(&place_.theme, &Theme::changed, this, &WhatIfDialog::showResult);
  connect(&place_.units, &Units::changed, this, [this] {
    fillFromClass();
    retranslate();
  });
  resize(1160, 600);
  retranslate();
}

void WhatIfDialog::retranslate() {
  setWindowTitle(tr("What if"));
  intro_->setText(
      tr("The rails that were found are judged again with other limits, from what is stored of every "
         "profile. Nothing that is stored changes."));
  profileLabel_->setText(tr("Profile class"));
  straightnessLabel_->setText(tr("Straightness class"));
  const int profile = std::max(0, profileClass_->currentIndex());
  const int straightness = std::max(0, straightnessClass_->currentIndex());
  profileClass_->clear();
  profileClass_->addItem(tr("As in the recipe"));
  for (const char* name : {"X", "Y", "IRS-T12", "AREMA"}) profileClass_->addItem(QLatin1String(name));
  profileClass_->setCurrentIndex(profile);
  straightnessClass_->clear();
  straightnessClass_->addItems({QStringLiteral("A"), QStringLiteral("B")});
  straightnessClass_->setCurrentIndex(straightness);
  straightnessClass_->setEnabled(profile > 0);
  profileClass_->setAccessibleName(profileLabel_->text());
  straightnessClass_->setAccessibleName(straightnessLabel_->text());
  for (QLabel* head : lowerHeads_) head->setText(tr("lower, %1").arg(place_.units.name()));
  for (QLabel* head : upperHeads_) head->setText(tr("upper, %1").arg(place_.units.name()));
  for (const Dimension d : kDimensions) {
    lower_[index(d)]->setAccessibleName(tr("Lower limit of %1, deviation").arg(spoken(d)));
    upper_[index(d)]->setAccessibleName(tr("Upper limit of %1, deviation").arg(spoken(d)));
  }
  table_->setHorizontalHeaderLabels({tr("Rail"), tr("Was"), tr("Would be"), tr("Because of")});
  table_->setAccessibleName(tr("Rails whose verdict would change"));
  progress_->setAccessibleName(tr("Progress"));
  close_->setText(tr("Close"));
  close_->setAccessibleName(close_->text());
  showResult();
}

void WhatIfDialog::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void WhatIfDialog::hideEvent(QHideEvent* event) {
  QDialog::hideEvent(event);
  stop();
}

void WhatIfDialog::setRails(const Recipe& recipe, std::vector<RailLine> rails) {
  stop();
  recipe_ = recipe;
  rails_ = std::move(rails);
  judged_.clear();
  next_ = refused_ = 0;
  profileClass_->setCurrentIndex(0);
  fillFromClass();
  showResult();
}

void WhatIfDialog::fillFromClass() {
  straightnessClass_->setEnabled(profileClass_->currentIndex() > 0);
  if (profileClass_->currentIndex() <= 0) {
    fillFields(recipe_.limits);
    return;
  }
  const auto limits = toleranceLimits(recipe_.section, profileClass_->currentText().toStdString(),
                                      straightnessClass_->currentText().toStdString());
  if (limits)
    fillFields(*limits);
  else
    result_->setText(shown(limits.error().message()));
}

void WhatIfDialog::fillFields(const PerDimension<ToleranceLimits>& limits) {
  const auto put = [this](QLineEdit* field, const std::optional<double>& mm) {
    field->setText(mm ? locale().toString(place_.units.shown(*mm), 'f', place_.units.decimals(3)) : QString());
  };
  for (std::size_t d = 0; d < kDimensionCount; ++d) {
    put(lower_[d], limits[d].lowerMm);
    put(upper_[d], limits[d].upperMm);
  }
}

std::optional<PerDimension<ToleranceLimits>> WhatIfDialog::limitsEntered() {
  PerDimension<ToleranceLimits> limits;
  const auto read = [this](QLineEdit* field, std::optional<double>& mm) {
    const QString text = field->text().trimmed().replace(QChar(0x2212), u'-');
    if (text.isEmpty()) return true;
    bool ok = false;
    double value = locale().toDouble(text, &ok);
    if (!ok) value = QLocale::c().toDouble(text, &ok);
    if (ok) mm = place_.units.mmFrom(value);
    return ok;
  };
  for (const Dimension d : kDimensions) {
    ToleranceLimits& l = limits[index(d)];
    if (!read(lower_[index(d)], l.lowerMm) || !read(upper_[index(d)], l.upperMm)) {
      result_->setText(tr("A limit of %1 is no number. An empty field is no limit.").arg(spoken(d)));
      return {};
    }
    if (l.lowerMm && l.upperMm && *l.lowerMm > *l.upperMm) {
      result_->setText(tr("The lower limit of %1 is above the upper one: exchange them.").arg(spoken(d)));
      return {};
    }
  }
  return limits;
}

void WhatIfDialog::start() {
  if (running_ || rails_.empty()) return;
  const auto limits = limitsEntered();
  if (!limits) return;
  judged_.clear();
  next_ = refused_ = 0;
  refusal_.clear();
  running_ = true;
  ++run_;
  showResult();
  askNext(*limits);
}

void WhatIfDialog::stop() {
  if (!running_) return;
  running_ = false;
  showResult();
}

void WhatIfDialog::askNext(PerDimension<ToleranceLimits> limits) {
  std::vector<std::int64_t> keys;
  for (; next_ < rails_.size() && keys.size() < kRailsPerQuestion; ++next_) keys.push_back(rails_[next_].key);
  if (keys.empty()) {
    running_ = false;
    showResult();
    emit finished();
    return;
  }
  reader_.ask(
      "what if",
      [this, keys, limits, run = run_](const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
        std::vector<Expected<RejudgedRail>> rails;
        for (const std::int64_t key : keys)
          rails.push_back(archive != nullptr ? rejudge(RailArchive(*archive), key, limits)
                                             : Expected<RejudgedRail>(worldError("archive", problem)));
        return [this, rails = std::move(rails), limits, run] {
          if (!running_ || run != run_) return;
          take(rails);
          askNext(limits);
        };
      });
}

void WhatIfDialog::take(const std::vector<Expected<RejudgedRail>>& rails) {
  for (const auto& rail : rails) {
    if (rail) {
      judged_.push_back(*rail);
    } else {
      ++refused_;
      refusal_ = rail.error().message();
    }
  }
  progress_->setValue(static_cast<int>(judged_.size() + refused_));
  detail_->setText(tr("%1 of %2 rails judged").arg(judged_.size() + refused_).arg(rails_.size()));
}

std::size_t WhatIfDialog::changed() const {
  return static_cast<std::size_t>(
      std::count_if(judged_.begin(), judged_.end(), [](const auto& r) { return r.before != r.after; }));
}

QString WhatIfDialog::summary() const { return result_->text(); }

void WhatIfDialog::showResult() {
  try_->setText(running_ ? tr("Stop") : tr("Try"));
  try_->setAccessibleName(running_ ? tr("Stop judging") : tr("Judge the rails with these limits"));
  try_->setEnabled(!rails_.empty());
  progress_->setRange(0, static_cast<int>(std::max<std::size_t>(rails_.size(), 1)));
  progress_->setValue(static_cast<int>(judged_.size() + refused_));
  if (rails_.empty()) {
    result_->setText(tr("No rail of this section is in the list. Search for rails first."));
    detail_->clear();
  } else if (running_) {
    result_->setText(tr("Judging …"));
  } else if (judged_.empty() && refused_ == 0) {
    result_->setText(
        tr("%n rail(s) of section %1", nullptr, static_cast<int>(rails_.size())).arg(shown(recipe_.section.name)));
    detail_->setText(rails_.size() < kFewRails
                         ? tr("Fewer than %1 rails prove little.").arg(kFewRails)
                         : tr("Choose a class or enter deviations from nominal, then Try. Empty: no limit."));
  } else {
    result_->setText(tr("%1 of %2 rails would change their verdict").arg(changed()).arg(judged_.size()));
    std::map<std::pair<Verdict, Verdict>, int> ways;
    for (const RejudgedRail& r : judged_)
      if (r.before != r.after) ++ways[{r.before, r.after}];
    QStringList words;
    for (const auto& [way, rails] : ways)
      words << tr("%1 from %2 to %3").arg(rails).arg(wordOf(way.first), wordOf(way.second));
    if (judged_.size() + refused_ < rails_.size()) words << tr("stopped before all %1 were judged").arg(rails_.size());
    if (refused_ > 0)
      words << tr("%n could not be judged: %1", nullptr, static_cast<int>(refused_)).arg(shown(refusal_));
    if (judged_.size() < kFewRails) words << tr("fewer than %1 rails prove little").arg(kFewRails);
    detail_->setText(words.join(QStringLiteral("; ")));
  }
  const Palette& p = place_.theme.palette();
  table_->setRowCount(0);
  if (running_) return;
  for (const RejudgedRail& r : judged_) {
    if (r.before == r.after || table_->rowCount() >= kMostListed) continue;
    const int row = table_->rowCount();
    table_->insertRow(row);
    table_->setItem(row, 0, new QTableWidgetItem(shown(r.id)));
    const std::pair<int, Verdict> verdicts[] = {{1, r.before}, {2, r.after}};
    for (const auto& [column, verdict] : verdicts)
      table_->setItem(row, column, new QTableWidgetItem(stateIcon(symbolOf(verdict), p), wordOf(verdict)));
    QStringList because;
    for (const Dimension d : kDimensions)
      if (r.dimensionsBefore[index(d)] != r.dimensionsAfter[index(d)]) because << spoken(d);
    table_->setItem(row, 3, new QTableWidgetItem(because.join(QStringLiteral(", "))));
  }
  for (int column = 0; column < 3; ++column) table_->setColumnWidth(column, table_->viewport()->width() * 20 / 100);
}

}  // namespace vignole
