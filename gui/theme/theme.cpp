#include "gui/theme/theme.h"

#include <QBuffer>
#include <QFile>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QImageReader>

#include "report/typeface.h"

namespace vignole {

Expected<void> installFonts() {
  const QFont font = uiFont(16);  // registers what is installed
  const QStringList families = QFontDatabase::families();
  if (!families.contains("Roboto") && !families.contains("DejaVu Sans"))
    return worldError("fonts",
                      "neither Roboto nor DejaVu Sans is installed, so no text could be read; "
                      "install fonts-roboto-unhinted and fonts-dejavu-core");
  QGuiApplication::setFont(font);
  return {};
}

QFont uiFont(int pixels, int weight) {
  return typeface(pixels, weight >= 700 ? QFont::Bold : weight >= 500 ? QFont::Medium : QFont::Normal);
}

void Theme::setDark(bool dark) {
  if (dark == palette_->dark) return;
  palette_ = dark ? &darkPalette() : &lightPalette();
  emit changed();
}

QString Theme::styleSheet() const {
  const Palette& p = *palette_;
  QString sheet = QStringLiteral(R"(
    QMainWindow, QWidget#page { background: @bg; }
    QLabel { background: transparent; color: @t1; }
    QToolTip { background: @panel2; color: @t1; border: 1px solid @line; padding: 6px; }
    QFrame#panel { background: @panel; border: 1px solid @line; border-radius: 4px; }
    QFrame#banner { background: @accsoft; border: 2px solid @accent; border-radius: 4px; }
    QFrame#plotPanel { background: @panel2; border: 1px solid @line; border-radius: 4px; }
    QPushButton { background: @panel2; color: @t1; border: 1px solid @line; border-radius: 3px; padding: 1px 13px;
                  min-height: 40px; }
    QPushButton:hover { border-color: @t3; }
    QPushButton:pressed { background: @accsoft; }
    QPushButton:checked, QPushButton:focus { border: 2px solid @accent; padding: 0 12px; }
    QPushButton:checked { background: @accsoft; }
    QPushButton:checked:focus { border: 3px solid @accent; padding: 0 11px; min-height: 38px; }
    QPushButton:disabled { color: @t3; }
    QPushButton#segment { color: @t2; padding: 1px 5px; }
    QPushButton#segment:checked { color: @t1; }
    QPushButton#segment:checked, QPushButton#segment:focus { padding: 0 4px; }
    QPushButton#segment:checked:focus { padding: 0 3px; }
    QLabel#magnification { background: @panel2; border-top: 1px solid @line; border-bottom: 1px solid @line; }
    QFrame#pageBar { background: @head; }
    QFrame#pageBar QPushButton { background: @head; color: @t2; border: 0; border-radius: 0; text-align: left;
                                 padding: 0 8px; border-top: 4px solid @head; border-right: 1px solid @line; }
    QFrame#pageBar QPushButton:hover { background: @panel; }
    QFrame#pageBar QPushButton:checked { background: @panel2; color: @t1; border-top: 4px solid @accent; }
    QFrame#pageBar QPushButton:focus { border: 2px solid @accent; padding: 2px 6px 0 6px; }
    QFrame#header { background: @head; }
    QTableView { background: @panel; border: 0; color: @t1; outline: 0; selection-background-color: @accsoft;
                 selection-color: @t1; }
    QTableView::item { border-bottom: 1px solid @line2; padding: 0 8px; }
    QTableView:focus { border: 2px solid @accent; }
    QHeaderView { background: @panel; border: 0; }
    QHeaderView::section { background: @panel; color: @t2; border: 0; padding: 0 8px; }
    QHeaderView::section { border-bottom: 1px solid @line; height: 30px; }
    QTableCornerButton::section { background: @panel; border: 0; }
    QScrollBar:vertical { background: @panel; width: 14px; margin: 0; }
    QScrollBar:horizontal { background: @panel; height: 14px; margin: 0; }
    QScrollBar::handle { background: @line; border-radius: 4px; min-height: 32px; min-width: 32px; margin: 2px; }
    QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
    QScrollBar::add-page, QScrollBar::sub-page { background: @panel; }
    QScrollArea, QScrollArea > QWidget > QWidget { background: transparent; border: 0; }
    QLabel[ink="t1"] { color: @t1; }
    QLabel[ink="t2"] { color: @t2; }
    QLabel[ink="t3"] { color: @t3; }
    QPushButton#inLine { min-height: 32px; }
    QListWidget { background: @panel; color: @t1; border: 0; outline: 0; }
    QListWidget::item { padding: 0 12px; border-left: 4px solid @panel; }
    QListWidget::item:selected { background: @panel2; color: @t1; border-left: 4px solid @accent; }
    QListWidget:focus { border: 2px solid @accent; }
    QPushButton#first { background: @accent; color: @panel2; border: 1px solid @accent; }
    QPushButton#first:disabled { background: @panel2; color: @t3; border: 1px solid @line; }
    QPushButton#first:focus { border: 3px solid @t1; padding: 0 11px; min-height: 38px; }
    QLineEdit, QComboBox, QSpinBox, QDoubleSpinBox, QPlainTextEdit, QDateTimeEdit { background: @panel2; color: @t1;
        border: 1px solid @line; border-radius: 3px; padding: 1px 10px; min-height: 40px;
        selection-background-color: @accent; selection-color: @panel2; }
    QLineEdit:focus, QComboBox:focus, QSpinBox:focus, QDoubleSpinBox:focus, QPlainTextEdit:focus { border: 2px solid
        @accent; padding: 0 9px; }
    QLineEdit:disabled, QComboBox:disabled, QSpinBox:disabled, QDoubleSpinBox:disabled { color: @t3; }
    QComboBox::drop-down { border: 0; width: 32px; }
    QComboBox::down-arrow { image: url(:/icons/@arrow.svg); width: 16px; height: 16px; }
    QDoubleSpinBox[changed="true"] { background: @accsoft; border-color: @accent; }
    QComboBox QAbstractItemView { background: @panel2; color: @t1; selection-background-color: @accsoft;
        selection-color: @t1; border: 1px solid @line; outline: 0; }
    QMenu { background: @panel2; color: @t1; border: 1px solid @line; padding: 4px; }
    QMenu::item { padding: 10px 24px; }
    QMenu::item:selected { background: @accsoft; }
    QCheckBox, QRadioButton { color: @t1; spacing: 10px; min-height: 40px; background: transparent; }
    QCheckBox:focus, QRadioButton:focus { border: 2px solid @accent; border-radius: 3px; }
    QProgressBar { background: @chan; border: 0; border-radius: 3px; height: 12px; text-align: center; color: @t1; }
    QProgressBar::chunk { background: @t3; border-radius: 3px; }
    QDialog { background: @panel; }
    QDialog QLabel { color: @t1; }
    QToolTip { background: @panel2; color: @t1; border: 1px solid @line; padding: 6px; }
    QSlider::groove:horizontal { background: @chan; height: 8px; border-radius: 4px; }
    QSlider::handle:horizontal { background: @accent; width: 22px; margin: -9px 0; border-radius: 4px; }
    QSlider:focus { border: 2px solid @accent; border-radius: 3px; }
  )");
  const std::initializer_list<std::pair<const char*, QColor>> tokens = {
      {"@bg", p.bg},       {"@panel2", p.panel2}, {"@panel", p.panel},        {"@head", p.head},
      {"@line2", p.line2}, {"@line", p.line},     {"@chan", p.chan},          {"@t1", p.t1},
      {"@t2", p.t2},       {"@t3", p.t3},         {"@accsoft", p.accentSoft}, {"@accent", p.accent},
  };
  for (const auto& [token, colour] : tokens) sheet.replace(QLatin1String(token), colour.name());
  sheet.replace(QLatin1String("@arrow"), p.dark ? QStringLiteral("dropdown-dark") : QStringLiteral("dropdown-light"));
  return sheet;
}

QPixmap Theme::icon(const QString& name, int pixels, const QColor& colour, qreal pixelRatio) const {
  QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
  if (!file.open(QIODevice::ReadOnly)) return {};
  QByteArray svg = file.readAll();
  svg.replace("currentColor", colour.name().toLatin1());
  QBuffer buffer(&svg);
  QImageReader reader(&buffer, "svg");
  const int device = qRound(pixels * pixelRatio);
  reader.setScaledSize({device, device});
  QPixmap pixmap = QPixmap::fromImage(reader.read());
  pixmap.setDevicePixelRatio(pixelRatio);
  return pixmap;
}

}  // namespace vignole
