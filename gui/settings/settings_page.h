#pragma once
// Settings: how the screen looks and counts, who is here and who may what, where records are kept, what this program
// is. Groups at the left, the form of one at the right.

#include <memory>
#include <vector>

#include "gui/bridge/workplace.h"
#include "gui/main_window/page.h"

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;
class QStackedWidget;

namespace vignole {

class ArchiveReader;
class AuditPanel;
class Panel;
class PeoplePanel;
class RigDrawing;
class SignInPanel;

class SettingsPage : public Page {
  Q_OBJECT

 public:
  enum class Group { Screen, WhoIsHere, People, Archive, Audit, Cameras, Rig, About };

  explicit SettingsPage(Workplace& place, QWidget* parent = nullptr);
  ~SettingsPage() override;
  void showLine(const LineSnapshot& line, PullDetail detail) override;
  void showGroup(Group group);
  void askForName();  ///< the field to sign in with has the keys

 signals:
  void tourAsked();

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  Panel* makeScreen();
  Panel* makeText(QLabel*& words);
  void retranslate();
  void showScreen();
  void loadArchive();

  Workplace& place_;
  std::unique_ptr<ArchiveReader> reader_;
  Panel* groupsPanel_;
  QListWidget* groups_;
  QStackedWidget* forms_;
  RigDrawing* rigDrawing_;
  QLabel* rigWords_;
  Panel *screen_, *archive_, *cameras_, *rig_, *about_;
  SignInPanel* signIn_;
  PeoplePanel* people_;
  AuditPanel* audit_;
  QComboBox *language_, *theme_, *unit_;
  QLabel *languageWord_, *themeWord_, *unitWord_, *archiveWords_, *cameraWords_, *aboutWords_;
  QPushButton* tour_;
};

}  // namespace vignole
