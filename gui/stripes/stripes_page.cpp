#include "gui/stripes/stripes_page.h"

#include <QEvent>
#include <QFileDialog>
#include <QGridLayout>
#include <QLocale>
#include <QResizeEvent>
#include <QSaveFile>
#include <QShortcut>

#include "engine/archive/audit_trail.h"
#include "engine/stripe/stripe_extractor.h"
#include "gui/bridge/archive_reader.h"
#include "gui/stripes/stripe_view.h"
#include "gui/stripes/trial_panel.h"
#include "gui/theme/inscription.h"

namespace vignole {

namespace {

/// Places of the cameras on the page as they stand: 1 and 2 above, 4 and 3 below.
constexpr std::array<std::pair<int, int>, kCameraCount> kPlaces = {{{0, 0}, {0, 1}, {1, 1}, {1, 0}}};

/// Lower pages have two parameters in a row.
constexpr int kRoomyPx = 860;

bool same(const StripeSettings& a, const StripeSettings& b) {
  return a.sigma == b.sigma && a.low == b.low && a.high == b.high && a.gapDistance == b.gapDistance &&
         a.gapAngle == b.gapAngle;
}

}  // namespace

StripesPage::StripesPage(Workplace& place, QWidget* parent) : Page(parent), place_(place) {
  setObjectName(QStringLiteral("page"));
  setFocusPolicy(Qt::ClickFocus);
  if (place.archive != nullptr) archive_ = std::make_unique<ArchiveReader>(place.archiveUrl);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(16, 16, 16, 16);
  grid->setSpacing(16);
  for (int c = 0; c < kCameraCount; ++c) {
    auto*& view = views_[static_cast<std::size_t>(c)];
    view = new StripeView(place.theme, c, this);
    const auto [row, column] = kPlaces[static_cast<std::size_t>(c)];
    grid->addWidget(view, row, column);
    grid->setRowStretch(row, 1);
    grid->setColumnStretch(column, 1);
    connect(view, &StripeView::pressed, this, &StripesPage::choose);
  }
  trial_ = new TrialPanel(place.theme, this);
  trial_->setFixedWidth(560);
  trial_->setCompact(false);
  grid->addWidget(trial_, 0, 2, 2, 1);
  connect(trial_, &TrialPanel::trialChanged, this, &StripesPage::startTrial);
  connect(trial_, &TrialPanel::applyAsked, this, &StripesPage::apply);
  connect(trial_, &TrialPanel::discardAsked, this, &StripesPage::discard);
  connect(trial_, &TrialPanel::freezeAsked, this, [this] { setFrozen(!frozen_); });
  connect(trial_, &TrialPanel::profileAsked, this, [this] {
    if (latest_) showBehind(*latest_);
  });
  connect(trial_, &TrialPanel::saveAsked, this, &StripesPage::save);
  connect(trial_, &TrialPanel::cameraAsked, this, &StripesPage::choose);
  connect(&place_.session, &Session::changed, this, &StripesPage::say);
  bindKeys();
  inUse_ = place.line.pull(PullDetail::Profile).recipe->stripe;
  exposureMs_ = place.line.exposureMs();
  trial_->setInUse(inUse_, exposureMs_, place.line.pictureAgain() != nullptr);
  choose(0);
  say();
}

StripesPage::~StripesPage() {
  watch_.reset();
  archive_.reset();
}

void StripesPage::bindKeys() {
  const auto bind = [this](const QKeySequence& key, auto action) {
    auto* shortcut = new QShortcut(key, this);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, this, action);
  };
  for (int c = 0; c < kCameraCount; ++c) bind(QKeySequence(Qt::Key_1 + c), [this, c] { choose(c); });
  bind(Qt::Key_P, [this] { setFrozen(!frozen_); });
  bind(Qt::Key_B, [this] {
    if (latest_) showBehind(*latest_);
  });
  bind(Qt::Key_Plus, [this] { view(chosen_).zoom(1.5); });
  bind(Qt::Key_Equal, [this] { view(chosen_).zoom(1.5); });
  bind(Qt::Key_Minus, [this] { view(chosen_).zoom(1 / 1.5); });
  bind(Qt::Key_0, [this] { view(chosen_).fit(); });
  bind(QKeySequence(Qt::CTRL | Qt::Key_S), [this] { save(); });
}

void StripesPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) say();
}

void StripesPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  if (watch_) watch_->setLooking(true);
}

void StripesPage::hideEvent(QHideEvent* event) {
  Page::hideEvent(event);
  // Nobody looks: nothing is held, but what is frozen. The calibration may be another when somebody looks again.
  if (frozen_ && watch_)
    watch_->setLooking(false);
  else
    watch_.reset();
}

void StripesPage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  const bool compact = height() < kRoomyPx;
  trial_->setFixedWidth(compact ? 470 : width() < 1700 ? 520 : 560);
  trial_->setCompact(compact);
}

void StripesPage::watch(const LineSnapshot& line) {
  if (!watch_ && isVisible())
    if (auto frames = place_.line.frames()) {
      watch_ = std::make_unique<StripeWatch>(std::move(frames), place_.line.calibration(), line.recipe->section,
                                             line.recipe->stripe);
      watch_->setLooking(true);
      for (int c = 0; c < kCameraCount; ++c) view(c).setField(watch_->field(c));
    }
  if (!watch_) return;
  for (int c = 0; c < kCameraCount; ++c) watch_->setViewSize(c, view(c).pictureSize());
  if (const auto pictures = watch_->takeNew())
    for (int c = 0; c < kCameraCount; ++c) {
      const auto& picture = (*pictures)[static_cast<std::size_t>(c)];
      if (picture && picture != view(c).picture()) view(c).show(picture);
    }
  trial_->showPicture(view(chosen_).picture());
}

void StripesPage::followSettings(const LineSnapshot& line) {
  const auto exposure = place_.line.exposureMs();
  if (!same(line.recipe->stripe, inUse_) || exposure != exposureMs_) {
    inUse_ = line.recipe->stripe;
    exposureMs_ = exposure;
    if (watch_) watch_->setInUse(inUse_);
    trial_->setInUse(inUse_, exposureMs_, place_.line.pictureAgain() != nullptr);
    discard();
  }
  if (line.nextStripe.has_value() != waiting_.has_value()) {
    waiting_ = line.nextStripe;
    say();
  }
}

void StripesPage::showRates(const LineSnapshot& line) {
  const auto now = std::chrono::steady_clock::now();
  const double seconds = std::chrono::duration<double>(now - framesAt_).count();
  if (seconds < 1) return;
  for (int c = 0; c < kCameraCount; ++c) {
    std::uint64_t& before = framesBefore_[static_cast<std::size_t>(c)];
    for (const StageStatistics& stage : line.stages)
      if (stage.name == "extract." + std::to_string(c + 1)) {
        // The first time there is nothing to count from, nor after a restart.
        const bool known = seconds < 5 && stage.count >= before;
        view(c).setRate(known ? static_cast<double>(stage.count - before) / seconds : 0);
        before = stage.count;
      }
  }
  framesAt_ = now;
}

void StripesPage::showStates(const LineSnapshot& line) {
  const auto now = std::chrono::steady_clock::now();
  for (int c = 0; c < kCameraCount; ++c) {
    const auto& picture = view(c).picture();
    const bool pixels = picture && picture->taken;
    QString words;
    bool stale = false;
    if (!watch_) words = tr("This source hands out no pictures.");
    if (frozen_) {
      words = pixels ? tr("Frozen") : missing_[static_cast<std::size_t>(c)];
    } else if (watch_) {
      for (const LostCamera& lost : line.lostCameras)
        if (lost.camera == c) {
          words = tr("Lost: %1").arg(QString::fromStdString(lost.reason));
          stale = true;
        }
      if (!stale && line.held()) {
        words = tr("Held");
        stale = true;
      }
      if (line.state == LineState::Idle) words = tr("The line has not been started (Ctrl+R).");
      if (stale && pixels)
        words += QStringLiteral(", ") + tr("%1 old").arg(age(std::chrono::duration<double>(now - picture->at).count()));
    }
    view(c).setState(words, stale);
  }
}

void StripesPage::showLine(const LineSnapshot& line, PullDetail detail) {
  latest_ = line.latest;
  watch(line);
  if (detail != PullDetail::Everything) return;
  followSettings(line);
  showRates(line);
  showStates(line);
}

void StripesPage::startTrial() {
  const auto fine = checked(trial_->stripeOnTrial());
  if (!fine) {
    trial_->setMessage(QString::fromStdString(fine.error().message()));
    if (watch_) watch_->setTrial({});
    return;
  }
  say();
  const bool differs = trial_->differs();
  // Old and new are compared on the same picture.
  if (differs && !frozen_) setFrozen(true);
  if (!watch_) return;
  if (differs)
    watch_->setTrial(LineTrial{*fine, trial_->exposureOnTrial().value_or(0)}, place_.line.pictureAgain());
  else
    watch_->setTrial({});
}

void StripesPage::discard() {
  trial_->discard();
  if (watch_) watch_->setTrial({});
  if (frozen_) setFrozen(false);
  say();
}

void StripesPage::setFrozen(bool frozen) {
  frozen_ = frozen;
  missing_ = {};
  if (watch_) watch_->setFrozen(frozen);
  trial_->setFrozen(frozen);
  trial_->setCamera(chosen_);
  for (StripeView* view : views_) view->setState(frozen ? tr("Frozen") : QString(), false);
}

void StripesPage::showBehind(const ProfileResult& profile) {
  if (!watch_) return;
  setFrozen(true);
  for (int c = 0; c < kCameraCount; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const std::string& why = profile.profile.missing[i];
    missing_[i] = why.empty() ? tr("The picture is no longer held: the last %n are.", nullptr,
                                   static_cast<int>(LatestFrames::kHeld))
                              : tr("No picture: %1").arg(QString::fromStdString(why));
  }
  // A frame that was lost is not made again: it was never seen.
  PictureAgain again;
  if (auto any = place_.line.pictureAgain())
    again = [any = std::move(any), missing = profile.profile.missing](int camera, std::uint64_t trigger,
                                                                      double exposureMs) -> std::optional<Frame> {
      if (!missing[static_cast<std::size_t>(camera)].empty()) return {};
      return any(camera, trigger, exposureMs);
    };
  watch_->showTrigger(profile.profile.trigger, std::move(again));
  trial_->setMessage(
      tr("Pictures behind the profile at %1 m.").arg(locale().toString(profile.profile.positionMm / 1000, 'f', 3)));
}

void StripesPage::choose(int camera) {
  chosen_ = camera;
  for (int c = 0; c < kCameraCount; ++c) view(c).setChosen(c == camera);
  trial_->setCamera(camera);
  trial_->showPicture(view(camera).picture());
}

void StripesPage::say() {
  const bool may = place_.session.may(Permission::TuneLines);
  trial_->setMay(may);
  if (waiting_)
    trial_->setMessage(tr("Waits for the next rail; the running rail keeps what it began with."));
  else if (!may)
    trial_->setMessage(tr("Anybody may try; a technician who has signed in applies."));
  else
    trial_->setMessage(tr("What is tried acts on these pictures alone until it is applied."));
}

void StripesPage::apply() {
  if (!place_.session.may(Permission::TuneLines)) return;
  if (!trial_->differs()) return trial_->setMessage(tr("Nothing is on trial: change a parameter first."));
  const QString reason = trial_->reason();
  if (reason.isEmpty()) {
    trial_->setMessage(tr("A change of the measurement needs a reason."));
    return trial_->askForReason();
  }
  const auto fine = checked(trial_->stripeOnTrial());
  if (!fine) return trial_->setMessage(QString::fromStdString(fine.error().message()));
  if (!archive_)
    return trial_->setMessage(tr("There is no archive, so the change could not be recorded: nothing was changed."));
  trial_->setMessage(tr("The change is being recorded…"));
  // Recorded first: what is not in the audit trail does not come into force. Of each kind only the newest question
  // waits, so every change is a kind of its own.
  archive_->ask(
      "audit " + std::to_string(++changes_),
      [this, stripe = *fine, exposure = trial_->exposureOnTrial(), details = trial_->changes(),
       why = reason.toStdString(), user = place_.session.user().toStdString()](
          const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
        std::string failure = problem;
        if (archive != nullptr) {
          const auto added = AuditTrail(*archive).add(user, "line parameters", "stripe extraction", why, details);
          failure = added ? std::string() : added.error().message();
        }
        return [this, stripe, exposure, failure] {
          if (failure.empty()) return use(stripe, exposure);
          trial_->setMessage(
              tr("Nothing was changed, because it could not be recorded: %1").arg(QString::fromStdString(failure)));
        };
      });
}

void StripesPage::use(const StripeSettings& stripe, std::optional<double> exposureMs) {
  if (!same(stripe, inUse_)) place_.line.useStripeSettings(stripe);
  if (exposureMs) place_.line.useExposure(*exposureMs);
  trial_->clearReason();
  trial_->setMessage(exposureMs ? tr("Recorded. The exposure changes with the next start of the line, the parameters "
                                     "with the next rail.")
                                : tr("Recorded. Waits for the next rail; the running rail keeps what it began with."));
}

void StripesPage::save() {
  const auto picture = view(chosen_).picture();
  if (!picture || !picture->taken) return trial_->setMessage(tr("Camera %1 has no picture to save.").arg(chosen_ + 1));
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save the picture"), QStringLiteral("camera%1-trigger%2.png").arg(chosen_ + 1).arg(picture->trigger),
      tr("Pictures (*.png)"));
  if (!file.isEmpty()) savePicture(file);
}

void StripesPage::savePicture(const QString& file) {
  const auto picture = view(chosen_).picture();
  if (!picture || !picture->taken) return;
  trial_->setMessage(tr("Saving %1…").arg(file));
  writing_ = std::jthread([this, file, taken = picture->taken] {
    const ImageView& image = taken->frame.image;
    QSaveFile out(file);
    const QImage pixels(image.data, image.width, image.height, image.stride, QImage::Format_Grayscale8);
    QString failure;
    if (!out.open(QIODevice::WriteOnly) || !pixels.save(&out, "PNG") || !out.commit()) failure = out.errorString();
    QMetaObject::invokeMethod(
        this,
        [this, file, failure] {
          trial_->setMessage(failure.isEmpty() ? tr("%1 is written.").arg(file)
                                               : tr("%1 cannot be written: %2").arg(file, failure));
        },
        Qt::QueuedConnection);
  });
}

}  // namespace vignole
