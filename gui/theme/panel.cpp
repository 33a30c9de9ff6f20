#include "gui/theme/panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTableView>

#include "gui/theme/theme.h"

namespace vignole {

namespace {

/// Gives way: ends with an ellipsis where there is no room.
class NoteLabel : public QLabel {
 public:
  using QLabel::QLabel;
  [[nodiscard]] QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.setFont(font());
    painter.setPen(palette().color(foregroundRole()));
    painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(text(), Qt::ElideRight, width()));
  }
};

QLabel* makeNote(QWidget* parent) {
  auto* label = new NoteLabel(parent);
  label->setFont(uiFont(15));
  label->setProperty("ink", QStringLiteral("t2"));
  return label;
}

}  // namespace

Panel::Panel(QWidget* parent)
    : QFrame(parent),
      title_(makeLabel(18, 500, "t1", this)),
      note_(makeNote(this)),
      head_(new QHBoxLayout),
      content_(new QVBoxLayout) {
  setObjectName(QStringLiteral("panel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 10, 16, 12);
  column->setSpacing(8);
  title_->hide();
  head_->setSpacing(8);
  head_->addWidget(title_);
  head_->addWidget(note_);
  head_->addStretch(1);
  content_->setSpacing(8);
  column->addLayout(head_);
  column->addLayout(content_, 1);
}

void Panel::setTitle(const QString& title) {
  title_->setText(title);
  title_->setVisible(!title.isEmpty());
  setAccessibleName(title);
}
void Panel::setNote(const QString& note) { note_->setText(note); }

QPushButton* makeButton(const Theme& theme, const QString& icon, QWidget* parent, bool first) {
  auto* button = new QPushButton(parent);
  button->setFont(uiFont(16, 500));
  button->setIconSize({20, 20});
  if (first) button->setObjectName(QStringLiteral("first"));
  if (icon.isEmpty()) return button;
  const auto tint = [&theme, icon, button, first] {
    const Palette& p = theme.palette();
    QIcon made(theme.icon(icon, 20, first ? p.panel2 : p.t1, button->devicePixelRatioF()));
    made.addPixmap(theme.icon(icon, 20, p.t3, button->devicePixelRatioF()), QIcon::Disabled);
    button->setIcon(made);
  };
  tint();
  QObject::connect(&theme, &Theme::changed, button, tint);
  return button;
}

void styleTable(QTableView& table) {
  table.setFont(uiFont(16));
  table.setShowGrid(false);
  table.setFrameShape(QFrame::NoFrame);
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);  // columns share what there is
  table.setTabKeyNavigation(false);
  table.setWordWrap(false);
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(40);
  QHeaderView* head = table.horizontalHeader();
  head->setFont(uiFont(14));
  head->setHighlightSections(false);
  head->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  head->setStretchLastSection(true);
}

QLabel* makeLabel(int pixels, int weight, const char* role, QWidget* parent, bool wrapped) {
  auto* label = new QLabel(parent);
  label->setFont(uiFont(pixels, weight));
  label->setProperty("ink", QString::fromLatin1(role));
  label->setWordWrap(wrapped);
  return label;
}

}  // namespace vignole
