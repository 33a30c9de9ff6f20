#include "gui/stripes/trial_panel.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QStyle>
#include <QTableWidget>
#include <algorithm>
#include <cmath>

#include "gui/stripes/pixel_view.h"
#include "gui/theme/inscription.h"

namespace vignole {

namespace {

struct Parameter {
  double StripeSettings::*value;  ///< null: the exposure, which is the camera's
  const char* name;               ///< in recipes and records
  const char* symbol;             ///< rich text
  double least, most, step;
  int decimals;
  const char* unit;
};
constexpr std::array<Parameter, TrialPanel::kFields> kParameters = {
    {{nullptr, "exposure", "t", 0.1, 100, 0.5, 1, " ms"},
     {&StripeSettings::sigma, "sigma", "σ", 1, 8, 0.1, 1, " px"},
     {&StripeSettings::low, "low", "t<sub>l</sub>", 0.5, 255, 0.5, 1, " DN"},
     {&StripeSettings::high, "high", "t<sub>h</sub>", 0.5, 255, 0.5, 1, " DN"},
     {&StripeSettings::gapDistance, "gap_distance", "d", 0, 500, 5, 0, " px"},
     {&StripeSettings::gapAngle, "gap_angle", "α", 0, 90, 1, 0, "°"}}};

enum Row { kPoints, kGainedLost, kSaturatedPoints, kUncertainty, kShift, kTime, kRows };

}  // namespace

TrialPanel::TrialPanel(const Theme& theme, QWidget* parent) : Panel(parent), theme_(theme) {
  makeFields();
  makeComparison();
  makeButtons();
  layOutFields();
  retranslate();
  setCamera(0);
  setInUse({}, {}, false);
}

void TrialPanel::makeFields() {
  save_ = makeButton(theme_, QStringLiteral("save"), this);
  connect(save_, &QPushButton::clicked, this, &TrialPanel::saveAsked);
  head()->addWidget(save_);
  for (int c = 0; c < kCameraCount; ++c) {
    auto* button = new QPushButton(QString::number(c + 1), this);
    button->setObjectName(QStringLiteral("segment"));
    button->setCheckable(true);
    button->setFixedWidth(44);
    button->setFont(uiFont(16, 500));
    connect(button, &QPushButton::clicked, this, [this, c] { emit cameraAsked(c); });
    head()->addWidget(button);
    cameras_[static_cast<std::size_t>(c)] = button;
  }
  form_ = new QGridLayout;
  form_->setHorizontalSpacing(8);
  form_->setVerticalSpacing(2);
  for (std::size_t i = 0; i < kFields; ++i) {
    const Parameter& p = kParameters[i];
    words_[i] = makeLabel(16, 400, "t1", this);
    symbols_[i] = makeLabel(17, 500, "t1", this);
    symbols_[i]->setTextFormat(Qt::RichText);
    symbols_[i]->setText(QString::fromUtf8(p.symbol));
    used_[i] = makeLabel(17, 400, "t2", this);
    auto* field = new QDoubleSpinBox(this);
    field->setFont(uiFont(17, 500));
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    field->setAlignment(Qt::AlignRight);
    field->setRange(p.least, p.most);
    field->setSingleStep(p.step);
    field->setDecimals(p.decimals);
    field->setSuffix(QString::fromUtf8(p.unit));
    field->setKeyboardTracking(false);
    fields_[i] = field;
    less_[i] = makeButton(theme_, QStringLiteral("minus"), this);
    more_[i] = makeButton(theme_, QStringLiteral("add"), this);
    for (QPushButton* button : {less_[i], more_[i]}) {
      button->setFixedWidth(52);
      button->setAutoRepeat(true);
    }
    connect(less_[i], &QPushButton::clicked, field, &QDoubleSpinBox::stepDown);
    connect(more_[i], &QPushButton::clicked, field, &QDoubleSpinBox::stepUp);
    connect(field, &QDoubleSpinBox::valueChanged, this, [this] {
      showMarks();
      emit trialChanged();
    });
  }
  for (QLabel*& head : heads_) head = makeLabel(14, 400, "t2", this);
  content()->addLayout(form_);
}

// Two parameters in a row where the screen is low; there the keys of the fields step, without buttons.
void TrialPanel::layOutFields() {
  for (QLabel* head : heads_) {
    form_->removeWidget(head);
    head->setVisible(!compact_);
  }
  if (!compact_) {
    form_->addWidget(heads_[0], 0, 0);
    form_->addWidget(heads_[1], 0, 1, 1, 2, Qt::AlignRight);
    form_->addWidget(heads_[2], 0, 4, Qt::AlignRight);
  }
  for (std::size_t i = 0; i < kFields; ++i) {
    const int row = static_cast<int>(compact_ ? i / 2 : i + 1), column = compact_ && i % 2 == 1 ? 6 : 0;
    for (QWidget* w : std::initializer_list<QWidget*>{words_[i], symbols_[i], used_[i], less_[i], fields_[i], more_[i]})
      form_->removeWidget(w);
    for (QWidget* w : std::initializer_list<QWidget*>{words_[i], less_[i], more_[i]}) w->setVisible(!compact_);
    if (!compact_) form_->addWidget(words_[i], row, column);
    form_->addWidget(symbols_[i], row, column + 1);
    form_->addWidget(used_[i], row, column + 2, Qt::AlignRight | Qt::AlignVCenter);
    if (!compact_) form_->addWidget(less_[i], row, column + 3);
    form_->addWidget(fields_[i], row, column + 4);
    if (!compact_) form_->addWidget(more_[i], row, column + 5);
    fields_[i]->setFixedWidth(compact_ ? 118 : 112);
  }
  form_->setColumnStretch(0, compact_ ? 0 : 1);
}

void TrialPanel::makeComparison() {
  auto* views = new QGridLayout;
  views->setHorizontalSpacing(12);
  views->setVerticalSpacing(4);
  for (int i = 0; i < 2; ++i) {
    auto& caption = captions_[static_cast<std::size_t>(i)];
    auto& view = pixels_[static_cast<std::size_t>(i)];
    caption = makeLabel(15, 500, "t1", this);
    view = new PixelView(theme_, this);
    views->addWidget(caption, 0, i);
    views->addWidget(view, 1, i);
    views->setColumnStretch(i, 1);
  }
  views->setRowStretch(1, 1);
  content()->addLayout(views, 1);
  comparison_ = new QTableWidget(kRows, 4, this);
  styleTable(*comparison_);
  comparison_->setSelectionMode(QAbstractItemView::NoSelection);
  comparison_->setFocusPolicy(Qt::NoFocus);
  comparison_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  comparison_->setFont(uiFont(15));
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < 4; ++column) {
      auto* item = new QTableWidgetItem;
      item->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      comparison_->setItem(row, column, item);
    }
  comparison_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  comparison_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  comparison_->horizontalHeader()->setStretchLastSection(false);
  comparison_->horizontalHeader()->setMinimumSectionSize(84);
  content()->addWidget(comparison_);
}

void TrialPanel::makeButtons() {
  freeze_ = makeButton(theme_, QStringLiteral("freeze"), this);
  freeze_->setCheckable(true);
  profile_ = makeButton(theme_, QStringLiteral("camera"), this);
  discard_ = makeButton(theme_, QStringLiteral("revert"), this);
  apply_ = makeButton(theme_, QStringLiteral("approve"), this, true);
  reason_ = new QLineEdit(this);
  reason_->setFont(uiFont(16));
  message_ = makeLabel(15, 400, "t2", this, true);
  auto* buttons = new QGridLayout;
  buttons->setSpacing(6);
  buttons->addWidget(freeze_, 0, 0);
  buttons->addWidget(profile_, 0, 1);
  buttons->addWidget(discard_, 0, 2);
  content()->addLayout(buttons);
  auto* decision = new QHBoxLayout;
  decision->setSpacing(6);
  decision->addWidget(reason_, 1);
  decision->addWidget(apply_);
  content()->addLayout(decision);
  content()->addWidget(message_);
  connect(freeze_, &QPushButton::clicked, this, &TrialPanel::freezeAsked);
  connect(profile_, &QPushButton::clicked, this, &TrialPanel::profileAsked);
  connect(discard_, &QPushButton::clicked, this, &TrialPanel::discardAsked);
  connect(apply_, &QPushButton::clicked, this, &TrialPanel::applyAsked);
  connect(reason_, &QLineEdit::returnPressed, this, &TrialPanel::applyAsked);
}

void TrialPanel::retranslate() {
  setTitle(tr("Line extraction"));
  const std::array<QString, kFields> words = {tr("Exposure"),       tr("Smoothing"),     tr("Low threshold"),
                                              tr("High threshold"), tr("Link distance"), tr("Link angle")};
  heads_[0]->setText(tr("Parameter"));
  heads_[1]->setText(tr("In use"));
  heads_[2]->setText(tr("On trial"));
  for (std::size_t i = 0; i < kFields; ++i) {
    words_[i]->setText(words[i]);
    fields_[i]->setAccessibleName(tr("%1 on trial").arg(words[i]));
    fields_[i]->setToolTip(words[i]);
    symbols_[i]->setToolTip(words[i]);
    less_[i]->setAccessibleName(tr("%1: less").arg(words[i]));
    more_[i]->setAccessibleName(tr("%1: more").arg(words[i]));
  }
  for (int c = 0; c < kCameraCount; ++c)
    cameras_[static_cast<std::size_t>(c)]->setAccessibleName(tr("Choose camera %1").arg(c + 1));
  captions_[0]->setText(tr("In use"));
  captions_[1]->setText(tr("On trial"));
  pixels_[0]->setAccessibleName(tr("Pixels with the line in use"));
  pixels_[1]->setAccessibleName(tr("Pixels with the line on trial"));
  comparison_->setHorizontalHeaderLabels({QString(), tr("In use"), tr("On trial"), tr("Difference")});
  for (int column = 1; column < 4; ++column)
    comparison_->horizontalHeaderItem(column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  comparison_->setAccessibleName(tr("In use against on trial"));
  const QStringList rows = {
      tr("Points"),  tr("Gained, lost"), tr("Saturated points"), tr("Uncertainty, px"), tr("Shift: mean, largest, px"),
      tr("Time, ms")};
  for (int row = 0; row < kRows; ++row) comparison_->item(row, 0)->setText(rows[row]);
  const auto name = [this](QPushButton* button, const QString& word, const QString& spoken, bool iconAlone) {
    button->setText(iconAlone ? QString() : word);
    button->setAccessibleName(spoken);
    button->setToolTip(spoken);
  };
  name(save_, tr("Save"), tr("Save the picture of the chosen camera (Ctrl+S)"), true);
  name(freeze_, frozen_ ? tr("Live") : tr("Freeze"),
       frozen_ ? tr("Live pictures again (P)") : tr("Freeze the pictures (P)"), compact_);
  freeze_->setAccessibleName(tr("Freeze the pictures"));
  name(profile_, tr("Profile"), tr("The pictures behind the newest profile (B)"), compact_);
  name(discard_, tr("Discard"), tr("Discard what is on trial"), compact_);
  name(apply_, tr("Use from next rail"), tr("Use what is on trial from the next rail on"), false);
  reason_->setPlaceholderText(tr("Reason for the change"));
  reason_->setAccessibleName(tr("Reason for the change"));
  setMay(may_);
  setCamera(camera_);
  compare();
}

void TrialPanel::changeEvent(QEvent* event) {
  Panel::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

double TrialPanel::inUse(std::size_t field) const {
  const Parameter& p = kParameters[field];
  return p.value != nullptr ? inUse_.*p.value : exposureMs_.value_or(p.least);
}

bool TrialPanel::differs(std::size_t field) const {
  // What the field cannot show is no difference.
  const double resolution = 0.5 * std::pow(10, -kParameters[field].decimals);
  return std::abs(fields_[field]->value() - inUse(field)) > resolution;
}

void TrialPanel::setInUse(const StripeSettings& settings, std::optional<double> exposureMs, bool exposureCanChange) {
  inUse_ = settings;
  exposureMs_ = exposureMs;
  for (QWidget* w : std::initializer_list<QWidget*>{fields_[0], less_[0], more_[0]}) w->setEnabled(exposureCanChange);
  if (!exposureCanChange) fields_[0]->setToolTip(tr("These cameras' exposure cannot be changed from here."));
  discard();
}

void TrialPanel::discard() {
  for (std::size_t i = 0; i < kFields; ++i) {
    const QSignalBlocker quiet(fields_[i]);
    fields_[i]->setValue(inUse(i));
    const bool told = i > 0 || exposureMs_.has_value();
    used_[i]->setText(told ? locale().toString(inUse(i), 'f', kParameters[i].decimals) : QStringLiteral("–"));
  }
  showMarks();
}

bool TrialPanel::stripeDiffers() const {
  for (std::size_t i = 1; i < kFields; ++i)
    if (differs(i)) return true;
  return false;
}

std::optional<double> TrialPanel::exposureOnTrial() const {
  if (!fields_[0]->isEnabled() || !differs(std::size_t{0})) return {};
  return fields_[0]->value();
}

StripeSettings TrialPanel::stripeOnTrial() const {
  StripeSettings settings = inUse_;
  for (std::size_t i = 1; i < kFields; ++i)
    if (differs(i)) settings.*kParameters[i].value = fields_[i]->value();
  return settings;
}

std::string TrialPanel::changes() const {
  QStringList all;
  for (std::size_t i = 0; i < kFields; ++i)
    if (differs(i) && fields_[i]->isEnabled())
      all << QStringLiteral("%1 %2 -> %3")
                 .arg(QString::fromLatin1(kParameters[i].name))
                 .arg(inUse(i))
                 .arg(fields_[i]->value());
  return all.join(QStringLiteral("; ")).toStdString();
}

void TrialPanel::showMarks() {
  for (std::size_t i = 0; i < kFields; ++i) {
    const bool changed = differs(i) && fields_[i]->isEnabled();
    if (fields_[i]->property("changed").toBool() == changed) continue;
    fields_[i]->setProperty("changed", changed);
    fields_[i]->style()->unpolish(fields_[i]);
    fields_[i]->style()->polish(fields_[i]);
  }
  discard_->setEnabled(differs());
}

void TrialPanel::setCamera(int camera) {
  camera_ = camera;
  for (int c = 0; c < kCameraCount; ++c) cameras_[static_cast<std::size_t>(c)]->setChecked(c == camera);
  setNote(frozen_ ? tr("camera %1, frozen").arg(camera + 1) : tr("camera %1, live").arg(camera + 1));
}

void TrialPanel::setFrozen(bool frozen) {
  frozen_ = frozen;
  freeze_->setChecked(frozen);
  retranslate();
}

void TrialPanel::setMay(bool mayApply) {
  may_ = mayApply;
  apply_->setEnabled(may_);
  reason_->setEnabled(may_);
}

void TrialPanel::setMessage(const QString& message) { message_->setText(message); }
QString TrialPanel::message() const { return message_->text(); }
QString TrialPanel::reason() const { return reason_->text().trimmed(); }
void TrialPanel::askForReason() { reason_->setFocus(); }
void TrialPanel::clearReason() { reason_->clear(); }

void TrialPanel::showPicture(const std::shared_ptr<const StripePicture>& picture) {
  if (picture == picture_) return;
  picture_ = picture;
  compare();
}

void TrialPanel::compare() {
  const auto put = [this](int row, int column, const QString& text) {
    if (QTableWidgetItem* item = comparison_->item(row, column); item->text() != text) item->setText(text);
  };
  const QString none = QStringLiteral("–");
  const StripePicture* picture = picture_ && picture_->taken ? picture_.get() : nullptr;
  const StripeTrial* trial = picture != nullptr && picture->trial ? &*picture->trial : nullptr;
  // Where the trial does most, else where the light is too strong, else the middle of the line.
  QPointF centre;
  if (picture != nullptr) {
    if (trial != nullptr && trial->difference.where)
      centre = {static_cast<double>(trial->difference.where->x), static_cast<double>(trial->difference.where->y)};
    else if (!picture->saturated.empty())
      centre = picture->saturated.front().center();
    else if (!picture->strokes.empty())
      centre = picture->strokes.front().at(picture->strokes.front().size() / 2);
    else
      centre = QPointF(picture->taken->frame.image.width, picture->taken->frame.image.height) / 2;
  }
  pixels_[0]->show(picture != nullptr ? picture->taken : nullptr, centre, tr("no picture"));
  pixels_[1]->show(trial != nullptr ? trial->taken : nullptr, centre, tr("nothing on trial: change a parameter"));
  if (picture == nullptr) {
    for (int row = 0; row < kRows; ++row)
      for (int column = 1; column < 4; ++column) put(row, column, none);
    return;
  }
  const auto number = [this](double value, int decimals) { return locale().toString(value, 'f', decimals); };
  const auto whole = [](double value) { return count(static_cast<std::uint64_t>(std::max(value, 0.0))); };
  const auto row = [&](int at, double used, double tried, int decimals) {
    put(at, 1, decimals == 0 ? whole(used) : number(used, decimals));
    put(at, 2, trial == nullptr ? none : decimals == 0 ? whole(tried) : number(tried, decimals));
    QString difference = (tried > used ? QStringLiteral("+") : QString()) + number(tried - used, decimals);
    difference.replace(QLatin1Char('-'), QChar(0x2212));
    put(at, 3, trial != nullptr ? difference : none);
  };
  const StripeFigures& used = picture->figures;
  const StripeFigures tried = trial != nullptr ? trial->figures : StripeFigures{};
  row(kPoints, static_cast<double>(used.points), static_cast<double>(tried.points), 0);
  row(kSaturatedPoints, static_cast<double>(used.saturatedPoints), static_cast<double>(tried.saturatedPoints), 0);
  row(kUncertainty, used.sigmaPx, tried.sigmaPx, 3);
  row(kTime, picture->taken->extractMs, trial != nullptr ? trial->taken->extractMs : 0, 2);
  for (const int at : {kGainedLost, kShift}) {
    put(at, 1, none);
    put(at, 2, none);
  }
  if (trial == nullptr) {
    put(kGainedLost, 3, none);
    put(kShift, 3, none);
    return;
  }
  const LineDifference& d = trial->difference;
  put(kGainedLost, 3, QStringLiteral("+%1  −%2").arg(count(d.gained), count(d.lost)));
  put(kShift, 3, QStringLiteral("%1  %2").arg(number(d.meanShiftPx, 3), number(d.largestShiftPx, 3)));
}

void TrialPanel::setCompact(bool compact) {
  const int row = compact ? 21 : 27;
  comparison_->verticalHeader()->setMinimumSectionSize(row);
  comparison_->verticalHeader()->setDefaultSectionSize(row);
  comparison_->setFont(uiFont(compact ? 14 : 15));
  comparison_->setFixedHeight(kRows * row + 33);
  content()->setSpacing(compact ? 5 : 8);
  if (compact == compact_) return;
  compact_ = compact;
  layOutFields();
  retranslate();
}

}  // namespace vignole
