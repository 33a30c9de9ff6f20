#pragma once
// The languages of the screen, switched while the program runs.

#include <QObject>
#include <QString>
#include <QTranslator>
#include <vector>

namespace vignole {

struct Language {
  QString code;     ///< "de"
  QString ownName;  ///< "Deutsch"
};

/// Installs translations, the locale of numbers and the decimal mark; widgets get QEvent::LanguageChange. English where
/// nothing else is chosen. Window's thread.
class Languages : public QObject {
  Q_OBJECT

 public:
  explicit Languages(QObject* parent = nullptr);
  ~Languages() override;
  [[nodiscard]] static const std::vector<Language>& all();
  /// That of the machine where it is one of ours, else English.
  [[nodiscard]] static QString ofThisMachine();

  [[nodiscard]] const QString& code() const { return code_; }
  /// False, and nothing changes, where there is no such language.
  bool use(const QString& code);

 signals:
  void changed();

 private:
  QTranslator words_, standardWords_;
  QString code_;
};

}  // namespace vignole
