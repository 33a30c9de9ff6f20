#include "gui/bridge/session.h"

namespace vignole {

void Session::enter(const QString& user, Role role) {
  user_ = user;
  role_ = role;
  emit changed();
}

void Session::leave() { enter({}, Role::Operator); }

}  // namespace vignole
