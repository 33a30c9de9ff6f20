#pragma once
// The header of every page: line state, rail, heat, section, recipe, length, speed, gauge, clock with heartbeat.

#include <QDateTime>
#include <QFrame>
#include <functional>
#include <vector>

#include "gui/bridge/line.h"
#include "gui/bridge/session.h"
#include "gui/languages/languages.h"
#include "gui/theme/theme.h"
#include "report/state_symbol.h"

class QPushButton;

namespace vignole {

/// Caption over value, as wide as its widest expected value, so that numbers do not make their neighbours jump.
class HeaderField : public QWidget {
  Q_OBJECT

 public:
  HeaderField(const Theme& theme, const QString& caption, const QString& widest, QWidget* parent);
  void setCaption(const QString& caption);
  void setWidest(const QString& widest);  ///< of what is to be expected
  void setValue(const QString& value);
  void setSymbol(StateSymbol symbol);  ///< before the value; NotMeasured colours the ground
  void setHeartbeat(int beat);         ///< three bars after the value, one of them pale; < 0: none
  [[nodiscard]] const QString& value() const { return value_; }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Theme& theme_;
  QString caption_, value_, widest_;
  bool hasSymbol_ = false;
  StateSymbol symbol_ = StateSymbol::NoLimit;
  int beat_ = -1;
};

class HeaderBar : public QFrame {
  Q_OBJECT

 public:
  /// `languages`: null where there is English alone.
  HeaderBar(const Theme& theme, const Session& session, Languages* languages, std::function<QDateTime()> clock,
            QWidget* parent = nullptr);
  void show(const LineSnapshot& line);
  void beat();                                                      ///< once a second: still bars mean a frozen screen
  [[nodiscard]] QPushButton& userButton() { return *userButton_; }  ///< who sits here; pressed: sign in or out
  [[nodiscard]] QPushButton& themeButton() { return *themeButton_; }
  [[nodiscard]] QPushButton& languageButton() { return *languageButton_; }
  [[nodiscard]] const QString& stateWord() const { return stateWord_; }

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  [[nodiscard]] int stateWidth() const;
  void addFields();
  void addLanguages();
  void retranslate();
  void nameUser();
  void makeRoom();  ///< fields that matter least leave first

  const Theme& theme_;
  std::function<QDateTime()> clock_;
  QString stateWord_;
  StateSymbol stateSymbol_ = StateSymbol::Idle;
  HeaderField *rail_, *heat_, *section_, *recipe_, *length_, *speed_, *gauge_, *time_;
  QWidget* simulation_;
  QPushButton *userButton_, *themeButton_, *languageButton_;
  const Session& session_;
  Languages* languages_;
  int beats_ = 0;
};

}  // namespace vignole
