#include "gui/main_window/header_bar.h"

#include <QFontMetricsF>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "gui/monitor/judgement.h"
#include "gui/settings/sign_in_panel.h"

namespace vignole {

namespace {

const QString kNone = QStringLiteral("–");

QString shown(const std::string& text) { return text.empty() ? kNone : QString::fromStdString(text); }

/// SIMULATION in a frame of its own: nobody may take the virtual rig for a mill.
class SimulationMark : public QWidget {
 public:
  SimulationMark(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
    setAccessibleName(tr("Simulation: the rails are not real"));
    setToolTip(tr("The rails come from the virtual rig"));
    connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
  }
  [[nodiscard]] QSize sizeHint() const override {
    return {qRound(QFontMetricsF(uiFont(18, 500)).horizontalAdvance(kWord)) + 24, 36};
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
    painter.drawText(box, Qt::AlignCenter, kWord);
  }

 private:
  inline static const QString kWord = QStringLiteral("SIMULATION");
  const Theme& theme_;
};

}  // namespace

HeaderField::HeaderField(const Theme& theme, const QString& caption, const QString& widest, QWidget* parent)
    : QWidget(parent), theme_(theme), caption_(caption), value_(kNone), widest_(widest) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void HeaderField::setCaption(const QString& caption) {
  caption_ = caption;
  update();
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

HeaderBar::HeaderBar(const Theme& theme, const Session& session, std::function<QDateTime()> clock, QWidget* parent)
    : QFrame(parent), theme_(theme), clock_(std::move(clock)) {
  setObjectName(QStringLiteral("header"));
  setFixedHeight(64);
  rail_ = new HeaderField(theme, tr("Rail"), QStringLiteral("V0001-0000"), this);
  heat_ = new HeaderField(theme, tr("Heat"), QStringLiteral("000000"), this);
  section_ = new HeaderField(theme, tr("Section"), QStringLiteral("60E1"), this);
  recipe_ = new HeaderField(theme, tr("Recipe"), QStringLiteral("60E1 X/A  v1"), this);
  length_ = new HeaderField(theme, tr("Length"), QStringLiteral("00.00 / 00.00 m"), this);
  speed_ = new HeaderField(theme, tr("Speed"), QStringLiteral("0.00 m/s"), this);
  gauge_ = new HeaderField(theme, tr("Gauge"), QStringLiteral("Not trusted"), this);
  gauge_->setSymbol(StateSymbol::NoLimit);
  time_ = new HeaderField(theme, tr("Time"), QStringLiteral("00:00:00"), this);
  time_->setHeartbeat(0);
  simulation_ = new SimulationMark(theme, this);
  themeButton_ = new QPushButton(this);
  themeButton_->setFont(uiFont(16, 500));
  themeButton_->setFixedHeight(44);
  const auto label = [this] {
    themeButton_->setText(theme_.dark() ? tr("Light") : tr("Dark"));
    themeButton_->setAccessibleName(theme_.dark() ? tr("Light theme") : tr("Dark theme"));
    update();
  };
  label();
  themeButton_->setToolTip(tr("Other theme (Ctrl+D)"));
  connect(&theme_, &Theme::changed, this, label);

  userButton_ = makeButton(theme, QStringLiteral("user"), this);
  const auto who = [this, &session] {
    const QString role = roleWord(session.role());
    userButton_->setText(session.user().isEmpty() ? role : session.user());
    userButton_->setAccessibleName(session.user().isEmpty() ? tr("%1: sign in").arg(role)
                                                            : tr("%1, %2: sign out").arg(session.user(), role));
    userButton_->setToolTip(session.user().isEmpty() ? tr("Sign in (Ctrl+L)") : tr("%1: sign out (Ctrl+L)").arg(role));
  };
  who();
  connect(&session, &Session::changed, this, who);
  auto* row = new QHBoxLayout(this);
  row->setSpacing(0);
  for (HeaderField* field : {rail_, heat_, section_, recipe_, length_, speed_, gauge_, time_}) row->addWidget(field, 1);
  row->addSpacing(8);
  row->addWidget(simulation_);
  row->addSpacing(12);
  row->addWidget(userButton_);
  row->addSpacing(6);
  row->addWidget(themeButton_);
  row->setContentsMargins(stateWidth(), 0, 12, 0);
  beat();
}

int HeaderBar::stateWidth() const {
  // As wide as the longest word of a state: the rail's id stays where it is when the line stops.
  return 66 + qRound(QFontMetricsF(uiFont(24, 500)).horizontalAdvance(QStringLiteral("No profiles"))) + 12;
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
    length = QString::number(line.latest->profile.positionMm / 1000, 'f', 2);
    if (rail->lengthMm > 0) length += QStringLiteral(" / ") + QString::number(rail->lengthMm / 1000, 'f', 2);
    length += QStringLiteral(" m");
    const double mPerS = line.state == LineState::Measuring ? rail->speedMmPerS / 1000 : 0;
    if (rail->speedMmPerS > 0) speed = QString::number(mPerS, 'f', 2) + QStringLiteral(" m/s");
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
  // The recipe names the section, and the heat is asked for at a desk: these two go first.
  section_->setVisible(width() >= 1600);
  heat_->setVisible(width() >= 1440);
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
