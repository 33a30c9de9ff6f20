#pragma once
// Settings: how the screen looks and counts, who is here and who may what, where records are kept, what this program
// is.

#include <memory>

#include "gui/bridge/workplace.h"
#include "gui/main_window/page.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace vignole {

class ArchiveReader;
class Panel;
class SignInPanel;

class SettingsPage : public Page {
  Q_OBJECT

 public:
  explicit SettingsPage(Workplace& place, QWidget* parent = nullptr);
  ~SettingsPage() override;
  void showLine(const LineSnapshot& line, PullDetail detail) override;
  void askForName();  ///< the field to sign in with has the keys

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QWidget* makePeople();
  void retranslate();
  void showScreen();
  void loadPeople();
  void addPerson();
  void loadArchive();

  Workplace& place_;
  std::unique_ptr<ArchiveReader> reader_;
  Panel *screen_, *people_, *archive_, *cameras_, *about_;
  SignInPanel* signIn_;
  QComboBox *language_, *theme_, *unit_, *role_;
  QLabel *languageWord_, *themeWord_, *unitWord_, *peopleWords_, *peopleResult_, *archiveWords_, *cameraWords_,
      *aboutWords_;
  QTableWidget* accounts_;
  QLineEdit *name_, *password_, *reason_;
  QPushButton* add_;
};

}  // namespace vignole
