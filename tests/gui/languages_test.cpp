// Every page in every language: nothing is left in English, nothing is cut off; the switch is live.

#include "gui/languages/languages.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QStyle>
#include <QTest>
#include <gtest/gtest.h>
#include <set>

#include "gui/main_window/header_bar.h"
#include "gui/main_window/main_window.h"
#include "gui/main_window/page_bar.h"
#include "gui/monitor/dimension_model.h"
#include "gui/monitor/dimension_table.h"
#include "gui/monitor/monitor_page.h"
#include "gui/monitor/verdict_panel.h"
#include "report/dimension_text.h"
#include "report/engine_words.h"
#include "tests/gui/least_size.h"
#include "tests/gui/made_line.h"

namespace vignole {
namespace {

using namespace vignole::test;

class LanguagesTest : public ::testing::Test {
 protected:
  FakeLine line;
  Theme theme;
  Session session;
  Units units;
  Languages languages;
  Workplace place{theme, line, session, units};
  std::unique_ptr<MainWindow> window;

  void SetUp() override {
    place.languages = &languages;
    place.archiveProblem = "there is none";
    line.snapshot = makeSnapshot({.deviationMm = {{Dimension::WT, 1.4}}});
    window = std::make_unique<MainWindow>(place);
    window->resize(1920, 1080);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
  }
  /// What was asked of the archive's thread is not waited for: a page without an archive asks nothing.
  static void settle() {
    for (int i = 0; i < 3; ++i) QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  }
  void speak(const QString& code) {
    ASSERT_TRUE(languages.use(code));
    QCoreApplication::processEvents();
    window->tick(PullDetail::Everything);
  }
};

TEST_F(LanguagesTest, AreSwitchedWhileTheProgramRuns) {
  EXPECT_EQ(window->header().stateWord(), QStringLiteral("Measuring"));
  speak(QStringLiteral("de"));
  EXPECT_EQ(window->header().stateWord(), QStringLiteral("Misst"));
  EXPECT_EQ(window->monitor().verdict().verdict().word, QStringLiteral("Außer Toleranz"));
  const auto* model = window->monitor().table().model();
  const QModelIndex value = model->index(static_cast<int>(index(Dimension::FW)), DimensionModel::Value);
  EXPECT_TRUE(value.data().toString().contains(',')) << "decimal comma";
  EXPECT_EQ(numberText(1.5, 2), QStringLiteral("1,50"));
  speak(QStringLiteral("zh"));
  EXPECT_EQ(numberText(1.5, 2), QStringLiteral("1.50"));
  speak(QStringLiteral("en"));
  EXPECT_EQ(window->header().stateWord(), QStringLiteral("Measuring"));
  EXPECT_FALSE(languages.use(QStringLiteral("tlh")));
  EXPECT_EQ(languages.code(), QStringLiteral("en"));
}

TEST_F(LanguagesTest, CountOneAndMany) {
  EXPECT_EQ(QCoreApplication::translate("vignole::AlarmLine", "%n alarm(s) acknowledged, still on", nullptr, 1),
            QStringLiteral("1 alarm acknowledged, still on"));
  languages.use(QStringLiteral("pl"));
  const auto in = [](int n) { return QCoreApplication::translate("vignole::AlarmCard", "%n alarm(s)", nullptr, n); };
  EXPECT_EQ(in(1), QStringLiteral("1 alarm"));
  EXPECT_EQ(in(3), QStringLiteral("3 alarmy"));
  EXPECT_EQ(in(5), QStringLiteral("5 alarmów"));
}

TEST_F(LanguagesTest, SayWhatTheEngineSays) {
  EXPECT_EQ(inWords(std::string("camera 3: frame lost")), QStringLiteral("camera 3: frame lost"));
  languages.use(QStringLiteral("de"));
  EXPECT_EQ(inWords(std::string("camera 3: frame lost")), QStringLiteral("Kamera 3: Bild verloren"));
  EXPECT_EQ(inWords(std::string("only 3 points on SHBR, 8 are needed (camera 1: no frame; camera 3: late frame)")),
            QStringLiteral("nur 3 Punkte auf SHBR, 8 sind nötig (Kamera 1: kein Bild; Kamera 3: Bild verspätet)"));
  EXPECT_EQ(inWords(std::string("100 %2 of something new")), QStringLiteral("100 %2 of something new"));
}

/// What a person can read of a widget, and what a screen reader says of it.
QStringList textsOf(const QWidget& w) {
  QStringList texts{w.accessibleName(), w.toolTip()};
  if (const auto* label = qobject_cast<const QLabel*>(&w)) texts << label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&w)) texts << button->text();
  if (const auto* edit = qobject_cast<const QLineEdit*>(&w)) texts << edit->placeholderText();
  if (const auto* box = qobject_cast<const QComboBox*>(&w))
    for (int i = 0; i < box->count(); ++i) texts << box->itemText(i);
  if (const auto* view = qobject_cast<const QAbstractItemView*>(&w); view != nullptr && view->model() != nullptr) {
    const QAbstractItemModel& model = *view->model();
    for (int column = 0; column < model.columnCount(); ++column) {
      texts << model.headerData(column, Qt::Horizontal).toString();
      for (int row = 0; row < model.rowCount(); ++row) texts << model.index(row, column).data().toString();
    }
  }
  return texts;
}

TEST_F(LanguagesTest, ChineseLeavesNothingInEnglish) {
  // A word of Latin letters without a Chinese sign beside it is one that nobody has translated.
  static const QRegularExpression latin(QStringLiteral("[a-z]{4,}|\\b[A-Z]{5,}\\b")),
      chinese(QStringLiteral("\\p{Han}"));
  std::set<QString> names;
  for (const Language& language : Languages::all()) names.insert(language.ownName);
  names.insert(QStringLiteral("AREMA"));
  speak(QStringLiteral("zh"));
  for (int page = 0; page < kPageCount; ++page) {
    window->showPage(static_cast<PageId>(page));
    for (const QWidget* w : window->findChildren<QWidget*>()) {
      for (const QString& text : textsOf(*w)) {
        if (text.contains(latin) && !text.contains(chinese) && names.count(text) == 0)
          ADD_FAILURE() << "page " << page << ", " << w->metaObject()->className() << ": " << text.toStdString();
      }
    }
  }
}

/// Texts of controls have room; widgets have at least their minimum and lie within their parents.
void expectRoom(const QWidget& root, const std::string& where) {
  for (const QWidget* w : root.findChildren<QWidget*>()) {
    if (!w->isVisible() || w->parentWidget() == nullptr || w->inherits("QCustomPlot") ||
        w->parentWidget()->inherits("QAbstractScrollArea"))
      continue;
    const std::string who = where + ": " + w->metaObject()->className() + " \"" + w->accessibleName().toStdString() +
                            "\" of " + w->parentWidget()->metaObject()->className();
    const QSize least = leastSize(*w);
    EXPECT_GE(w->width(), least.width()) << who;
    EXPECT_GE(w->height(), least.height()) << who;
    EXPECT_TRUE(w->parentWidget()->rect().contains(w->geometry())) << who;
    if (w->inherits("QPushButton") || w->inherits("QComboBox")) {
      EXPECT_FALSE(w->accessibleName().isEmpty()) << who << " at " << w->x() << "," << w->y();
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(w); button != nullptr && !button->text().isEmpty()) {
      const int icon = button->icon().isNull() ? 0 : button->iconSize().width() + 4;
      EXPECT_GE(w->width(), button->fontMetrics().horizontalAdvance(button->text()) + icon + 8)
          << who << " " << button->text().toStdString();
    }
    if (const auto* label = qobject_cast<const QLabel*>(w); label != nullptr && label->wordWrap()) {
      EXPECT_GE(w->height(), label->heightForWidth(w->width())) << who << " " << label->text().toStdString();
    }
  }
}

class LanguageAndSize : public LanguagesTest, public ::testing::WithParamInterface<std::tuple<const char*, QSize>> {};

TEST_P(LanguageAndSize, NothingIsCutOffOnAnyPage) {
  const auto& [code, size] = GetParam();
  window->resize(size);
  ASSERT_EQ(window->size(), size);
  speak(QString::fromLatin1(code));
  for (const bool dark : {false, true}) {
    theme.setDark(dark);
    for (int page = 0; page < kPageCount; ++page) {
      if (window->page(static_cast<PageId>(page)) == nullptr) continue;
      window->showPage(static_cast<PageId>(page));
      settle();
      expectRoom(*window, std::string(code) + (dark ? " dark" : " light") + ", page " + std::to_string(page));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, LanguageAndSize,
                         ::testing::Combine(::testing::Values("en", "es", "de", "fr", "pl", "zh"),
                                            ::testing::Values(QSize(1366, 768), QSize(1920, 1080))),
                         [](const auto& param) {
                           return std::string(std::get<0>(param.param)) + "_" +
                                  std::to_string(std::get<1>(param.param).width());
                         });

}  // namespace
}  // namespace vignole
