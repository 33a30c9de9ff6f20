#include "gui/main_window/header_bar.h"

#include <QEvent>
#include <QFontMetricsF>
#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <algorithm>

#include "gui/monitor/judgement.h"
#include "gui/settings/sign_in_panel.h"
#include "gui/theme/panel.h"
#include "report/dimension_text.h"

namespace vignole {

namespace {

const QString kNone = QStringLiteral("–");

QString shown(const std::string& text) { return text.empty() ? kNone : QString::fromStdString(text); }

/// SIMULATION in a frame of its own: nobody may take the virtual rig for a mill.
class SimulationMark : public QWidget {
 public:
  SimulationMark(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
    connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
  }
  void setWord(const QString& word) {
    word_ = word;
    updateGeometry();
    update();
  }
  [[nodiscard]] QSize sizeHint() const override {
    return {qRound(QFontMetricsF(uiFont(18, 500)).horizontalAdvance(word_)) + 24, 36};
  }
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme_.palette().t1, 2));
    const QRectF box(1, height() / 2.0 - 17, width() - 2, 34);
    painter.drawRoundedRect(box, 3, 3);
    painter.setFont(uiFont(18, 500));
    painter.drawText(box, Qt::AlignCenter, word_);
  }

 private:
  QString word_;
  const Theme& theme_;
};

}  // namespace

HeaderField::HeaderField(const Theme& theme, const QString& caption, const QString& widest, QWidget* parent)
    : QWidget(parent), theme_(theme), caption_(caption), value_(kNone), widest_(widest) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void HeaderField::setCaption(const QString& caption) {
  if (caption == caption_) return;
  caption_ = caption;
  setAccessibleName(QStringLiteral("%1: %2").arg(caption_, value_));
  updateGeometry();
  update();
}

void HeaderField::setWidest(const QString& widest) {
  widest_ = widest;
  updateGeometry();
}

void HeaderField::setValue(const QString& value) {
  if (value == value_) return;
  const bool wider = value.size() > widest_.size();
  value_ = value;
  setAccessibleName(QStringLiteral("%1: %2").arg(caption_, value));
  if (wider) widest_ = value, updateGeometry();
  update();
}

void HeaderField::setSymbol(StateSymbol symbol) {
  hasSymbol_ = true;
  symbol_ = symbol;
  update();
}

void HeaderField::setHeartbeat(int beat) {
  beat_ = beat;
  update();
}

QSize HeaderField::sizeHint() const {
  const double text = std::max(QFontMetricsF(uiFont(20, 500)).horizontalAdvance(widest_),
                               QFontMetricsF(uiFont(14)).horizontalAdvance(caption_));
  return {qRound(text) + (hasSymbol_ ? 28 : 0) + (beat_ >= 0 ? 30 : 0) + 18, 52};
}

void HeaderField::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double left = 12, middle = height() / 2.0;
  if (hasSymbol_ && symbol_ == StateSymbol::NotMeasured) painter.fillRect(rect(), p.invalidSoft);
  painter.fillRect(QRectF(0, 12, 1, height() - 24), p.line);
  painter.setPen(p.t2);
  painter.setFont(uiFont(14));
  painter.drawText(QPointF(left, middle - 8), caption_);
  double x = left;
  if (hasSymbol_) {
    paintSymbol(painter, QRectF(x, middle + 1, 20, 20), symbol_, p);
    x += 27;
  }
  painter.setPen(p.t1);
  painter.setFont(uiFont(20, 500));
  painter.drawText(QPointF(x, middle + 17), value_);
  if (beat_ < 0) return;
  const double bars = x + QFontMetricsF(painter.font()).horizontalAdvance(value_) + 10;
  for (int i = 0; i < 3; ++i) {
    const double tall = i == beat_ % 3 ? 14 : 8;
    painter.fillRect(QRectF(bars + 6 * i, middle + 17 - tall, 4, tall), p.t1);
  }
}

HeaderBar::HeaderBar(const Theme& theme, const Session& session, Languages* languages, std::function<QDateTime()> clock,
                     QWidget* parent)
    : QFrame(parent), theme_(theme), clock_(std::move(clock)), session_(session), languages_(languages) {
  setObjectName(QStringLiteral("header"));
  setFixedHeight(64);
  addFields();
  simulation_ = new SimulationMark(theme, this);
  userButton_ = makeButton(theme, QStringLiteral("user"), this);
  connect(&session, &Session::changed, this, &HeaderBar::nameUser);
  languageButton_ = makeButton(theme, QStringLiteral("language"), this);
  languageButton_->setVisible(languages_ != nullptr);
  if (languages_ != nullptr) addLanguages();
  themeButton_ = makeButton(theme, QStringLiteral("theme"), this);
  themeButton_->setFixedWidth(52);
  connect(&theme_, &Theme::changed, this, &HeaderBar::retranslate);
  auto* row = new QHBoxLayout(this);
  row->setSpacing(0);
  for (HeaderField* field : {rail_, heat_, section_, recipe_, length_, speed_, gauge_, time_}) row->addWidget(field, 1);
  row->addSpacing(8);
  row->addWidget(simulation_);
  row->addSpacing(12);
  for (QPushButton* button : {userButton_, languageButton_, themeButton_}) {
    row->addWidget(button);
    row->addSpacing(6);
  }
  retranslate();
  beat();
}

void HeaderBar::addFields() {
  rail_ = new HeaderField(theme_, {}, QStringLiteral("V0001-0000"), this);
  heat_ = new HeaderField(theme_, {}, QStringLiteral("000000"), this);
  section_ = new HeaderField(theme_, {}, QStringLiteral("60E1"), this);
  recipe_ = new HeaderField(theme_, {}, QStringLiteral("60E1 X/A  v1"), this);
  length_ = new HeaderField(theme_, {}, QStringLiteral("00.00 / 00.00 m"), this);
  speed_ = new HeaderField(theme_, {}, QStringLiteral("0.00 m/s"), this);
  gauge_ = new HeaderField(theme_, {}, {}, this);
  gauge_->setSymbol(StateSymbol::NoLimit);
  time_ = new HeaderField(theme_, {}, QStringLiteral("00:00:00"), this);
  time_->setHeartbeat(0);
}

void HeaderBar::addLanguages() {
  auto* menu = new QMenu(languageButton_);
  menu->setFont(uiFont(16));
  for (const Language& language : Languages::all())
    menu->addAction(language.ownName, this, [this, code = language.code] { languages_->use(code); });
  // Not setMenu(): its arrow takes the room of a word.
  connect(languageButton_, &QPushButton::clicked, menu,
          [this, menu] { menu->popup(languageButton_->mapToGlobal(QPoint(0, languageButton_->height()))); });
}

void HeaderBar::retranslate() {
  rail_->setCaption(tr("Rail"));
  heat_->setCaption(tr("Heat"));
  section_->setCaption(tr("Section"));
  recipe_->setCaption(tr("Recipe"));
  length_->setCaption(tr("Length"));
  speed_->setCaption(tr("Speed"));
  gauge_->setCaption(tr("Gauge"));
  gauge_->setWidest(widestTrustWord());
  auto* mark = static_cast<SimulationMark*>(simulation_);
  mark->setWord(tr("SIMULATION"));
  mark->setAccessibleName(tr("Simulation: the rails are not real"));
  mark->setToolTip(tr("The rails come from the virtual rig"));
  themeButton_->setAccessibleName(theme_.dark() ? tr("Light theme") : tr("Dark theme"));
  themeButton_->setToolTip(tr("Other theme (Ctrl+D)"));
  languageButton_->setText(languages_ != nullptr ? languages_->code().toUpper() : QString());
  languageButton_->setAccessibleName(tr("Language"));
  languageButton_->setToolTip(tr("Language"));
  nameUser();
  layout()->setContentsMargins(stateWidth(), 0, 6, 0);
  makeRoom();
  update();
}

void HeaderBar::nameUser() {
  const QString role = roleWord(session_.role()), &user = session_.user();
  const QString text = user.isEmpty() ? role : user;
  userButton_->setText(userButton_->fontMetrics().elidedText(text, Qt::ElideRight, 130));
  userButton_->setAccessibleName(user.isEmpty() ? tr("%1: sign in").arg(role) : tr("%1, %2: sign out").arg(user, role));
  userButton_->setToolTip(user.isEmpty() ? tr("Sign in (Ctrl+L)") : tr("%1: sign out (Ctrl+L)").arg(role));
}

void HeaderBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

int HeaderBar::stateWidth() const {
  // As wide as the longest word of a state: the rail's id stays where it is when the line stops.
  double widest = 0;
  for (int i = 0; i <= static_cast<int>(LineState::Fault); ++i)
    widest =
        std::max(widest, QFontMetricsF(uiFont(24, 500)).horizontalAdvance(lineState(static_cast<LineState>(i)).word));
  return 66 + qRound(widest) + 12;
}

void HeaderBar::show(const LineSnapshot& line) {
  const StateWord state = lineState(line.state);
  stateWord_ = state.word;
  stateSymbol_ = state.symbol;
  setAccessibleName(tr("Line: %1").arg(state.word));
  const RailBegin* rail = line.latest ? line.latest->rail.get() : nullptr;
  rail_->setValue(rail ? shown(rail->id) : kNone);
  heat_->setValue(rail ? shown(rail->heat) : kNone);
  section_->setValue(shown(line.recipe->section.name));
  recipe_->setValue(QStringLiteral("%1  v%2").arg(QString::fromStdString(line.recipe->name)).arg(line.recipe->version));
  QString length = kNone, speed = kNone;
  if (rail) {
    length = numberText(line.latest->profile.positionMm / 1000, 2);
    if (rail->lengthMm > 0) length += QStringLiteral(" / ") + numberText(rail->lengthMm / 1000, 2);
    length += QStringLiteral(" m");
    const double mPerS = line.state == LineState::Measuring ? rail->speedMmPerS / 1000 : 0;
    if (rail->speedMmPerS > 0) speed = numberText(mPerS, 2) + QStringLiteral(" m/s");
  }
  length_->setValue(length);
  speed_->setValue(speed);
  const GaugeTrust trust = gaugeTrust(line);
  gauge_->setSymbol(trust.symbol);
  gauge_->setValue(trust.word);
  simulation_->setVisible(line.simulation);
  update();
}

void HeaderBar::beat() {
  const QDateTime now = clock_();
  time_->setCaption(now.toString(QStringLiteral("yyyy-MM-dd")));
  time_->setValue(now.toString(QStringLiteral("HH:mm:ss")));
  time_->setHeartbeat(beats_++);
}

void HeaderBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  makeRoom();
}

void HeaderBar::makeRoom() {
  // The recipe names the section, and the heat is asked for at a desk: these two go first.
  HeaderField* const byWorth[] = {section_, heat_, speed_, recipe_};
  int needed = layout()->contentsMargins().left() + layout()->contentsMargins().right() + 60;
  for (const HeaderField* field : {rail_, heat_, section_, recipe_, length_, speed_, gauge_, time_})
    needed += field->sizeHint().width();
  for (const QWidget* w :
       std::initializer_list<const QWidget*>{simulation_, userButton_, languageButton_, themeButton_})
    if (!w->isHidden()) needed += w->sizeHint().width();
  for (HeaderField* field : byWorth) {
    const bool fits = needed <= width();
    field->setVisible(fits);
    if (!fits) needed -= field->sizeHint().width();
  }
}

void HeaderBar::paintEvent(QPaintEvent* event) {
  QFrame::paintEvent(event);
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (stateSymbol_ == StateSymbol::Fault) painter.fillRect(0, 0, stateWidth(), height(), p.invalidSoft);
  paintSymbol(painter, QRectF(22, height() / 2.0 - 16, 32, 32), stateSymbol_, p);
  painter.setPen(p.t1);
  painter.setFont(uiFont(24, 500));
  painter.drawText(QPointF(66, height() / 2.0 + 8), stateWord_);
}

}  // namespace vignole
