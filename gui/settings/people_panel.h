#pragma once
// Who may sign in, and as what: the administrator's. Every change needs a reason and goes into the audit trail.

#include "engine/archive/user_register.h"
#include "gui/bridge/workplace.h"
#include "gui/theme/panel.h"

class QComboBox;
class QLineEdit;
class QTableWidget;

namespace vignole {

class ArchiveReader;

class PeoplePanel : public Panel {
  Q_OBJECT

 public:
  PeoplePanel(Workplace& place, ArchiveReader& reader, QWidget* parent = nullptr);
  void retranslate();
  void load();

 private:
  using Change = std::function<Expected<void>(UserRegister& people)>;
  void ask(const QString& done, Change change);
  void show(const std::vector<UserAccount>& accounts);
  void showChosen();
  void add();
  void resetPassword();
  void giveRole();
  void closeOrOpen();
  [[nodiscard]] const UserAccount* chosen() const;

  Workplace& place_;
  ArchiveReader& reader_;
  std::vector<UserAccount> people_;
  QLabel *words_, *result_;
  QTableWidget* table_;
  QLineEdit *name_, *password_, *reason_;
  QComboBox* role_;
  QPushButton *add_, *reset_, *give_, *close_;
};

}  // namespace vignole
