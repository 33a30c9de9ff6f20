#pragma once
// Who sits at the screen.

#include <QObject>
#include <QString>

#include "engine/archive/roles.h"

namespace vignole {

/// Starts as an operator without a name. Window's thread.
class Session : public QObject {
  Q_OBJECT

 public:
  [[nodiscard]] Role role() const { return role_; }
  [[nodiscard]] const QString& user() const { return user_; }  ///< empty: nobody has signed in
  [[nodiscard]] bool may(Permission permission) const { return vignole::may(role_, permission); }
  /// After a password has been checked.
  void enter(const QString& user, Role role);
  void leave();  ///< back to the operator

 signals:
  void changed();

 private:
  Role role_ = Role::Operator;
  QString user_;
};

}  // namespace vignole
