#pragma once
// Who sits here: signing in and out; the first administrator where there is nobody yet.

#include <memory>
#include <optional>

#include "engine/archive/user_register.h"
#include "gui/bridge/workplace.h"
#include "gui/theme/panel.h"

class QLineEdit;

namespace vignole {

class ArchiveReader;

/// Passwords are checked in the reader's thread: a hash takes as long as it should.
class SignInPanel : public Panel {
  Q_OBJECT

 public:
  SignInPanel(Workplace& place, ArchiveReader& reader, QWidget* parent = nullptr);
  void retranslate();
  void lookForUsers();  ///< asks whether there are any
  void focusName();

 signals:
  void usersChanged();
  void answered();  ///< welcome or not

 private:
  void act();
  void changePassword();
  void told(const QString& words, std::optional<UserAccount> welcome);
  void show();

  Workplace& place_;
  ArchiveReader& reader_;
  bool first_ = false, ready_ = false;
  QLabel *words_, *result_;
  QLineEdit *name_, *password_, *newPassword_;
  QPushButton *button_, *leave_, *change_;
  bool wantsName_ = false;   ///< as soon as it is there
  bool mustChange_ = false;  ///< the password fits and was given by somebody else: another one first
};

/// "administrator" as people read it.
[[nodiscard]] QString roleWord(Role role);

}  // namespace vignole
