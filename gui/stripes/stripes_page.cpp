#include "gui/stripes/stripes_page.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QShortcut>
#include <QTableWidget>
#include <cmath>

#include "engine/archive/audit_trail.h"
#include "engine/stripe/stripe_extractor.h"
#include "gui/bridge/archive_reader.h"
#include "gui/stripes/stripe_view.h"
#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"

namespace vignole {

namespace {

struct Parameter {
  double StripeSettings::*value;
  double least, most, step;
  int decimals;
  const char* unit;
};
constexpr std::array<Parameter, 5> kParameters = {{{&StripeSettings::sigma, 1, 8, 0.1, 1, " px"},
                                                   {&StripeSettings::low, 0.5, 255, 0.5, 1, " DN"},
                                                   {&StripeSettings::high, 0.5, 255, 0.5, 1, " DN"},
                                                   {&StripeSettings::gapDistance, 0, 500, 5, 0, " px"},
                                                   {&StripeSettings::gapAngle, 0, 90, 1, 0, "°"}}};

/// Places of the cameras on the page as they stand: 1 and 2 above, 4 and 3 below.
constexpr std::array<std::pair<int, int>, kCameraCount> kPlaces = {{{0, 0}, {0, 1}, {1, 1}, {1, 0}}};

double meanSigma(const StripeResult& stripe) {
  double sum = 0;
  for (const StripePoint& p : stripe.points) sum += static_cast<double>(p.sigmaPx);
  return stripe.points.empty() ? 0 : sum / static_cast<double>(stripe.points.size());
}

/// Mean distance of the points of one line from the nearest of the other, as far as there is one within 3 px.
double meanShift(const StripeResult& from, const StripeResult& to) {
  double sum = 0, n = 0;
  std::size_t near = 0;
  for (const StripePoint& p : from.points) {
    double best = 9;
    // Both run along the same light: the nearest is looked for from where the last one was found.
    const std::size_t begin = near > 60 ? near - 60 : 0, end = std::min(to.points.size(), near + 200);
    for (std::size_t i = begin; i < end; ++i) {
      const double dx = static_cast<double>(to.points[i].x - p.x), dy = static_cast<double>(to.points[i].y - p.y);
      const double along = dx * static_cast<double>(p.nx) + dy * static_cast<double>(p.ny);
      if (dx * dx + dy * dy < best) {
        best = dx * dx + dy * dy;
        near = i;
        if (best < 1) {
          sum += std::abs(along);
          n += 1;
          break;
        }
      }
    }
  }
  return n > 0 ? sum / n : 0;
}

}  // namespace

StripesPage::StripesPage(Workplace& place, QWidget* parent) : Page(parent), place_(place) {
  setObjectName(QStringLiteral("page"));
  setFocusPolicy(Qt::ClickFocus);
  if (place.archive != nullptr) archive_ = std::make_unique<ArchiveReader>(place.archiveUrl);
  inUse_ = place.line.pull(PullDetail::Profile).recipe->stripe;
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(16, 16, 16, 16);
  grid->setSpacing(16);
  for (int c = 0; c < kCameraCount; ++c) {
    auto*& view = views_[static_cast<std::size_t>(c)];
    view = new StripeView(place.theme, c, this);
    const auto [row, column] = kPlaces[static_cast<std::size_t>(c)];
    grid->addWidget(view, row, column);
    connect(view, &StripeView::pressed, this, &StripesPage::choose);
  }
  grid->addWidget(makeTrial(), 0, 2, 2, 1);
  grid->setColumnStretch(0, 5);
  grid->setColumnStretch(1, 5);
  grid->setColumnStretch(2, 5);
  bindKeys();
  retranslate();
  choose(0);
  discard();
  connect(&place_.session, &Session::changed, this, &StripesPage::showPermission);
}

StripesPage::~StripesPage() {
  watch_.reset();
  archive_.reset();
}

QWidget* StripesPage::makeTrial() {
  trial_ = new Panel(this);
  auto* form = new QGridLayout;
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(6);
  for (std::size_t i = 0; i < kParameters.size(); ++i) {
    const int row = static_cast<int>(i);
    words_[i] = makeLabel(16, 400, "t1", trial_);
    used_[i] = makeLabel(17, 400, "t2", trial_);
    fields_[i] = new QDoubleSpinBox(trial_);
    fields_[i]->setFont(uiFont(17, 500));
    fields_[i]->setRange(kParameters[i].least, kParameters[i].most);
    fields_[i]->setSingleStep(kParameters[i].step);
    fields_[i]->setDecimals(kParameters[i].decimals);
    fields_[i]->setSuffix(QString::fromUtf8(kParameters[i].unit));
    connect(fields_[i], &QDoubleSpinBox::valueChanged, this, &StripesPage::startTrial);
    form->addWidget(words_[i], row, 0);
    form->addWidget(used_[i], row, 1, Qt::AlignRight);
    form->addWidget(fields_[i], row, 2);
  }
  form->setColumnStretch(0, 1);
  comparison_ = new QTableWidget(5, 4, trial_);
  styleTable(*comparison_);
  comparison_->setSelectionMode(QAbstractItemView::NoSelection);
  comparison_->verticalHeader()->setDefaultSectionSize(30);
  comparison_->setMinimumHeight(120);
  reason_ = new QLineEdit(trial_);
  reason_->setFont(uiFont(16));
  freeze_ = makeButton(place_.theme, QStringLiteral("freeze"), trial_);
  freeze_->setCheckable(true);
  save_ = makeButton(place_.theme, QStringLiteral("save"), trial_);
  discard_ = makeButton(place_.theme, QStringLiteral("revert"), trial_);
  apply_ = makeButton(place_.theme, QStringLiteral("approve"), trial_, true);
  auto* upper = new QHBoxLayout;
  upper->addWidget(freeze_, 1);
  upper->addWidget(save_, 1);
  auto* lower = new QHBoxLayout;
  lower->addWidget(discard_, 1);
  lower->addWidget(apply_, 1);
  result_ = makeLabel(15, 400, "t2", trial_, true);
  trial_->content()->addLayout(form);
  trial_->content()->addWidget(comparison_, 1);
  trial_->content()->addLayout(upper);
  trial_->content()->addWidget(reason_);
  trial_->content()->addLayout(lower);
  trial_->content()->addWidget(result_);
  connect(freeze_, &QPushButton::clicked, this, [this] { setFrozen(!frozen_); });
  connect(save_, &QPushButton::clicked, this, &StripesPage::save);
  connect(discard_, &QPushButton::clicked, this, &StripesPage::discard);
  connect(apply_, &QPushButton::clicked, this, &StripesPage::apply);
  return trial_;
}

void StripesPage::bindKeys() {
  const auto bind = [this](const QKeySequence& key, auto action) {
    auto* shortcut = new QShortcut(key, this);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, this, action);
  };
  for (int c = 0; c < kCameraCount; ++c) bind(QKeySequence(Qt::Key_1 + c), [this, c] { choose(c); });
  bind(Qt::Key_P, [this] { setFrozen(!frozen_); });
  bind(Qt::Key_Plus, [this] { view(chosen_).zoom(1.5); });
  bind(Qt::Key_Equal, [this] { view(chosen_).zoom(1.5); });
  bind(Qt::Key_Minus, [this] { view(chosen_).zoom(1 / 1.5); });
  bind(Qt::Key_0, [this] { view(chosen_).fit(); });
  bind(QKeySequence(Qt::CTRL | Qt::Key_S), [this] { save(); });
}

void StripesPage::retranslate() {
  trial_->setTitle(tr("Line extraction"));
  const QStringList words = {tr("Smoothing σ"), tr("Low threshold t_l"), tr("High threshold t_h"),
                             tr("Link distance d"), tr("Link angle α")};
  for (std::size_t i = 0; i < words_.size(); ++i) {
    words_[i]->setText(QString(words[static_cast<int>(i)]).replace('_', ' '));
    fields_[i]->setAccessibleName(tr("%1 on trial").arg(words_[i]->text()));
  }
  comparison_->setHorizontalHeaderLabels({QString(), tr("In use"), tr("On trial"), tr("Difference")});
  comparison_->setAccessibleName(tr("In use against on trial"));
  save_->setText(tr("Save picture…"));
  save_->setAccessibleName(tr("Save the picture of the chosen camera"));
  discard_->setText(tr("Discard"));
  discard_->setAccessibleName(tr("Discard what is on trial"));
  apply_->setText(tr("Use from next start"));
  apply_->setAccessibleName(tr("Use what is on trial from the next start of the line"));
  reason_->setPlaceholderText(tr("Reason"));
  reason_->setAccessibleName(tr("Reason for the change"));
  freeze_->setText(frozen_ ? tr("Live again") : tr("Freeze"));
  freeze_->setAccessibleName(tr("Freeze the pictures"));
  freeze_->setToolTip(tr("Freeze the pictures (P)"));
  showPermission();
}

void StripesPage::showPermission() {
  const bool may = place_.session.may(Permission::TuneLines);
  apply_->setEnabled(may);
  reason_->setVisible(may);
  result_->setText(may ? tr("What is tried acts on these pictures alone until it is applied.")
                       : tr("Anybody may try; a technician who has signed in applies."));
}

void StripesPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void StripesPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  if (watch_) watch_->setLooking(true);
}

void StripesPage::hideEvent(QHideEvent* event) {
  Page::hideEvent(event);
  if (watch_) watch_->setLooking(false);
}

void StripesPage::showLine(const LineSnapshot& line, PullDetail detail) {
  if (!watch_)
    if (auto frames = place_.line.frames()) {
      watch_ = std::make_unique<StripeWatch>(std::move(frames), place_.line.calibration(), line.recipe->section,
                                             line.recipe->stripe);
      watch_->setLooking(isVisible());
    }
  if (watch_)
    for (int c = 0; c < kCameraCount; ++c)
      if (auto picture = watch_->take(c)) view(c).show(std::move(picture), onTrialDiffers());
  if (detail != PullDetail::Everything) return;
  const StripeSettings& now = line.recipe->stripe;
  for (const Parameter& p : kParameters)
    if (now.*p.value != inUse_.*p.value) {
      inUse_ = now;
      if (watch_) watch_->setInUse(inUse_);
      discard();
      break;
    }
  for (int c = 0; c < kCameraCount; ++c) {
    QString words;
    bool stale = false;
    for (const LostCamera& lost : line.lostCameras)
      if (lost.camera == c) {
        words = tr("lost: %1").arg(QString::fromStdString(lost.reason));
        stale = true;
      }
    if (words.isEmpty() && line.held()) {
      words = tr("held, %1 old").arg(age(line.ageS));
      stale = true;
    }
    if (words.isEmpty() && frozen_) words = tr("Frozen");
    if (words.isEmpty() && !watch_) words = tr("This source hands out no pictures.");
    view(c).setState(words, stale);
  }
  compare();
}

StripeSettings StripesPage::onTrial() const {
  StripeSettings settings = inUse_;
  for (std::size_t i = 0; i < kParameters.size(); ++i) settings.*kParameters[i].value = fields_[i]->value();
  return settings;
}

bool StripesPage::onTrialDiffers() const {
  const StripeSettings trial = onTrial();
  return std::any_of(kParameters.begin(), kParameters.end(),
                     [&](const Parameter& p) { return std::abs(trial.*p.value - inUse_.*p.value) > 1e-9; });
}

void StripesPage::startTrial() {
  discard_->setEnabled(onTrialDiffers());
  const auto fine = checked(onTrial());
  if (!fine) {
    result_->setText(QString::fromStdString(fine.error().message()));
    if (watch_) watch_->setTrial({});
    return;
  }
  showPermission();
  // Old and new are compared on the same picture.
  if (onTrialDiffers()) setFrozen(true);
  if (watch_) watch_->setTrial(onTrialDiffers() ? std::optional(*fine) : std::nullopt);
}

void StripesPage::discard() {
  for (std::size_t i = 0; i < kParameters.size(); ++i) {
    const QSignalBlocker quiet(fields_[i]);
    fields_[i]->setValue(inUse_.*kParameters[i].value);
    used_[i]->setText(locale().toString(inUse_.*kParameters[i].value, 'f', kParameters[i].decimals));
  }
  discard_->setEnabled(false);
  if (watch_) watch_->setTrial({});
  if (frozen_) setFrozen(false);
}

void StripesPage::apply() {
  const QString reason = reason_->text().trimmed();
  if (!onTrialDiffers()) {
    result_->setText(tr("Nothing is on trial: change a parameter first."));
    return;
  }
  if (reason.isEmpty()) {
    result_->setText(tr("A change of the measurement needs a reason."));
    reason_->setFocus();
    return;
  }
  const auto fine = checked(onTrial());
  if (!fine) {
    result_->setText(QString::fromStdString(fine.error().message()));
    return;
  }
  std::string details;
  for (std::size_t i = 0; i < kParameters.size(); ++i)
    if (std::abs((*fine).*kParameters[i].value - inUse_.*kParameters[i].value) > 1e-9)
      details += words_[i]->text().toStdString() + " " + std::to_string(inUse_.*kParameters[i].value) + " -> " +
                 std::to_string((*fine).*kParameters[i].value) + "; ";
  place_.line.useStripeSettings(*fine);
  if (archive_)
    archive_->ask("audit",
                  [user = place_.session.user().toStdString(), why = reason.toStdString(), details](
                      const Archive* archive, const std::string&) -> ArchiveReader::Answer {
                    if (archive != nullptr)
                      (void)AuditTrail(*archive).add(user, "line parameters", "stripe extraction", why, details);
                    return {};
                  });
  reason_->clear();
  result_->setText(
      tr("Is used from the next start of the line (Ctrl+R stops and starts it); the running rail keeps what "
         "it began with."));
}

void StripesPage::setFrozen(bool frozen) {
  frozen_ = frozen;
  if (watch_) watch_->setFrozen(frozen);
  freeze_->setChecked(frozen);
  freeze_->setText(frozen ? tr("Live again") : tr("Freeze"));
  for (StripeView* view : views_)
    if (view->accessibleDescription().isEmpty() || !frozen) view->setState(frozen ? tr("Frozen") : QString(), false);
}

void StripesPage::choose(int camera) {
  chosen_ = camera;
  for (int c = 0; c < kCameraCount; ++c) view(c).setChosen(c == camera);
  trial_->setNote(tr("camera %1").arg(camera + 1));
  compare();
}

void StripesPage::compare() {
  const auto& picture = view(chosen_).picture();
  const auto cell = [&](int row, int column, const QString& text) {
    QTableWidgetItem* item = comparison_->item(row, column);
    if (item == nullptr) {
      item = new QTableWidgetItem;
      item->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      comparison_->setItem(row, column, item);
    }
    item->setText(text);
  };
  const QStringList words = {tr("Points"), tr("Saturated, %"), tr("Uncertainty, px"), tr("Time, ms"),
                             tr("Mean shift, px")};
  for (int row = 0; row < 5; ++row) cell(row, 0, words[row]);
  comparison_->setColumnWidth(0, comparison_->viewport()->width() * 37 / 100);
  comparison_->setColumnWidth(1, comparison_->viewport()->width() * 20 / 100);
  comparison_->setColumnWidth(2, comparison_->viewport()->width() * 20 / 100);
  if (!picture) return;
  const StripeResult& used = picture->inUse.stripe;
  const StripeResult* tried = picture->trial ? &picture->trial->stripe : nullptr;
  const auto row = [&](int at, double inUse, double trial, int decimals) {
    cell(at, 1, locale().toString(inUse, 'f', decimals));
    cell(at, 2, tried != nullptr ? locale().toString(trial, 'f', decimals) : QStringLiteral("–"));
    const QString sign = trial >= inUse ? QStringLiteral("+") : QString();
    cell(at, 3, tried != nullptr ? sign + locale().toString(trial - inUse, 'f', decimals) : QStringLiteral("–"));
  };
  row(0, static_cast<double>(used.points.size()), tried ? static_cast<double>(tried->points.size()) : 0, 0);
  row(1, 100 * static_cast<double>(used.saturatedShare), tried ? 100 * static_cast<double>(tried->saturatedShare) : 0,
      2);
  row(2, meanSigma(used), tried ? meanSigma(*tried) : 0, 3);
  row(3, picture->inUse.ms, picture->trial ? picture->trial->ms : 0, 2);
  cell(4, 1, QStringLiteral("–"));
  cell(4, 2, QStringLiteral("–"));
  cell(4, 3, tried != nullptr ? locale().toString(meanShift(*tried, used), 'f', 3) : QStringLiteral("–"));
}

void StripesPage::save() {
  const auto picture = view(chosen_).picture();
  if (!picture) return;
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save the picture"), QStringLiteral("camera%1-trigger%2.png").arg(chosen_ + 1).arg(picture->trigger));
  if (!file.isEmpty())
    result_->setText(picture->image.save(file) ? tr("%1 is written").arg(file) : tr("%1 cannot be written").arg(file));
}

}  // namespace vignole
