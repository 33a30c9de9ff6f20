#include "gui/languages/languages.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QWidget>
#include <algorithm>

#include "report/dimension_text.h"

namespace vignole {

namespace {

/// Dates are ISO everywhere and digits have no groups: of the locale the decimal mark is left.
QLocale localeOf(const QString& code) {
  QLocale locale(code == QStringLiteral("zh") ? QStringLiteral("zh_CN") : code);
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale;
}

}  // namespace

const std::vector<Language>& Languages::all() {
  static const std::vector<Language> languages = {
      {QStringLiteral("en"), QStringLiteral("English")}, {QStringLiteral("es"), QStringLiteral("Español")},
      {QStringLiteral("de"), QStringLiteral("Deutsch")}, {QStringLiteral("fr"), QStringLiteral("Français")},
      {QStringLiteral("pl"), QStringLiteral("Polski")},  {QStringLiteral("zh"), QStringLiteral("中文")}};
  return languages;
}

QString Languages::ofThisMachine() {
  const QString code = QLocale::system().name().left(2);
  const bool known = std::any_of(all().begin(), all().end(), [&](const Language& l) { return l.code == code; });
  return known ? code : all().front().code;
}

Languages::Languages(QObject* parent) : QObject(parent) { use(all().front().code); }

Languages::~Languages() {
  setDecimalMark('.');
  QLocale::setDefault(QLocale::c());
}

bool Languages::use(const QString& code) {
  if (code == code_) return true;
  if (std::none_of(all().begin(), all().end(), [&](const Language& l) { return l.code == code; })) return false;
  const QLocale locale = localeOf(code);
  QLocale::setDefault(locale);
  setDecimalMark(locale.decimalPoint().at(0));
  code_ = code;
  for (QTranslator* translator : {&words_, &standardWords_}) QCoreApplication::removeTranslator(translator);
  // Qt's own words (file dialogs) are a package of their own: where it is not installed they stay English.
  if (standardWords_.load(QStringLiteral("qtbase_") + locale.name(),
                          QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&standardWords_);
  if (words_.load(QStringLiteral(":/translations/vignole_%1.qm").arg(code)))
    QCoreApplication::installTranslator(&words_);
  for (QWidget* window : QApplication::topLevelWidgets()) window->setLocale(locale);
  emit changed();
  return true;
}

}  // namespace vignole
