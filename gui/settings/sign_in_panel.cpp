#include "gui/settings/sign_in_panel.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "engine/archive/user_register.h"
#include "gui/bridge/archive_reader.h"
#include "gui/theme/theme.h"
#include "report/engine_words.h"

namespace vignole {

QString roleWord(Role role) {
  switch (role) {
    case Role::Operator:
      return QCoreApplication::translate("Role", "Operator");
    case Role::Technician:
      return QCoreApplication::translate("Role", "Technician");
    case Role::QA:
      return QCoreApplication::translate("Role", "QA");
    case Role::Administrator:
      return QCoreApplication::translate("Role", "Administrator");
  }
  return {};
}

SignInPanel::SignInPanel(Workplace& place, ArchiveReader& reader, QWidget* parent)
    : Panel(parent), place_(place), reader_(reader) {
  words_ = makeLabel(16, 400, "t2", this, true);
  name_ = new QLineEdit(this);
  password_ = new QLineEdit(this);
  newPassword_ = new QLineEdit(this);
  for (QLineEdit* field : {password_, newPassword_}) field->setEchoMode(QLineEdit::Password);
  button_ = makeButton(place.theme, QStringLiteral("user"), this, true);
  change_ = makeButton(place.theme, QStringLiteral("edit"), this);
  leave_ = makeButton(place.theme, QStringLiteral("back"), this);
  result_ = makeLabel(15, 500, "t1", this, true);
  for (QLineEdit* field : {name_, password_, newPassword_}) field->setFont(uiFont(16));
  for (QWidget* w :
       std::initializer_list<QWidget*>{words_, name_, password_, newPassword_, button_, change_, leave_, result_}) {
    w->setMaximumWidth(640);
    content()->addWidget(w);
  }
  content()->addStretch(1);
  connect(button_, &QPushButton::clicked, this, &SignInPanel::act);
  connect(password_, &QLineEdit::returnPressed, this, [this] {
    if (button_->isVisible())
      act();
    else
      newPassword_->setFocus();
  });
  connect(change_, &QPushButton::clicked, this, &SignInPanel::changePassword);
  connect(newPassword_, &QLineEdit::returnPressed, this, &SignInPanel::changePassword);
  connect(leave_, &QPushButton::clicked, this, [this] {
    result_->clear();
    mustChange_ = false;
    name_->clear();
    place_.session.leave();
    show();
  });
  connect(&place_.session, &Session::changed, this, &SignInPanel::show);
  retranslate();
}

void SignInPanel::retranslate() {
  setTitle(tr("Who is here"));
  name_->setPlaceholderText(tr("Name"));
  name_->setAccessibleName(tr("Name"));
  newPassword_->setPlaceholderText(tr("New password, at least 8 characters"));
  newPassword_->setAccessibleName(tr("New password"));
  change_->setText(tr("Change the password"));
  change_->setAccessibleName(tr("Change the password"));
  show();
}

void SignInPanel::focusName() {
  wantsName_ = !name_->isVisible();
  if (name_->isVisible()) name_->setFocus();
}

void SignInPanel::show() {
  const bool in = !place_.session.user().isEmpty();
  if (in) mustChange_ = false;
  setNote(in ? place_.session.user() + QStringLiteral(", ") + roleWord(place_.session.role())
             : roleWord(Role::Operator));
  name_->setVisible(!in && ready_);
  name_->setEnabled(!mustChange_);
  if (wantsName_ && name_->isVisible()) focusName();
  password_->setVisible(in || ready_);
  password_->setPlaceholderText(in || mustChange_ ? tr("Present password") : tr("Password"));
  password_->setAccessibleName(password_->placeholderText());
  button_->setVisible(!in && ready_ && !mustChange_);
  for (QWidget* w : std::initializer_list<QWidget*>{newPassword_, change_}) w->setVisible(in || mustChange_);
  leave_->setVisible(in || mustChange_);
  leave_->setText(in ? tr("Sign out") : tr("Cancel"));
  leave_->setAccessibleName(leave_->text());
  button_->setText(first_ ? tr("Enter as the first administrator") : tr("Sign in"));
  button_->setAccessibleName(button_->text());
  if (place_.archive == nullptr)
    words_->setText(tr("Nobody can sign in: people are kept in the archive, and there is none (%1).")
                        .arg(inWords(place_.archiveProblem)));
  else if (in)
    words_->setText(tr("After a quarter of an hour without a key or a touch it is the operator's screen again."));
  else if (mustChange_)
    words_->setText(tr("This password was given by somebody else: choose one of your own."));
  else if (first_)
    words_->setText(
        tr("Nobody is entered yet. The first one is the administrator and enters the others; the password "
           "has at least 8 characters."));
  else
    words_->setText(tr("Without signing in this is the operator's screen: it measures, shows and acknowledges."));
}

void SignInPanel::told(const QString& words, std::optional<UserAccount> welcome) {
  button_->setEnabled(true);
  change_->setEnabled(true);
  result_->setText(words);
  if (welcome) {
    first_ = false;
    mustChange_ = welcome->mustChangePassword;
    if (mustChange_) {
      show();
      password_->setFocus();
    } else {
      name_->clear();
      place_.session.enter(QString::fromStdString(welcome->name), welcome->role);
    }
  }
  emit answered();
  emit usersChanged();
}

void SignInPanel::changePassword() {
  const bool in = !place_.session.user().isEmpty();
  const std::string name = in ? place_.session.user().toStdString() : name_->text().trimmed().toStdString(),
                    old = password_->text().toStdString(), fresh = newPassword_->text().toStdString();
  password_->clear();
  newPassword_->clear();
  change_->setEnabled(false);
  reader_.ask(
      "password",
      [this, name, old, fresh, in](const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
        if (archive == nullptr) return [this, problem] { told(QString::fromStdString(problem), {}); };
        UserRegister people(*archive);
        if (const auto done = people.changePassword(name, old, fresh); !done)
          return [this, words = inWords(done.error())] { told(words, {}); };
        if (in) return [this] { told(tr("The password is changed."), {}); };
        const auto again = people.signIn(name, fresh);
        if (!again || again->result != SignInResult::Welcome)
          return [this] { told(tr("The password is changed: sign in with it."), {}); };
        return [this, account = again->account] { told({}, account); };
      });
}

void SignInPanel::lookForUsers() {
  if (place_.archive == nullptr) return;
  reader_.ask("users", [this](const Archive* archive, const std::string& /*problem*/) -> ArchiveReader::Answer {
    if (archive == nullptr) return {};
    const auto accounts = UserRegister(*archive).accounts();
    if (!accounts) return {};
    return [this, none = accounts->empty()] {
      first_ = none;
      ready_ = true;
      show();
    };
  });
}

void SignInPanel::act() {
  const std::string name = name_->text().trimmed().toStdString(), password = password_->text().toStdString();
  password_->clear();
  if (name.empty() || password.empty()) {
    result_->setText(tr("Name and password are both needed."));
    return;
  }
  button_->setEnabled(false);
  reader_.ask("sign in",
              [this, name, password, first = first_](const Archive* archive,
                                                     const std::string& problem) -> ArchiveReader::Answer {
                if (archive == nullptr) return [=, this] { told(QString::fromStdString(problem), {}); };
                UserRegister people(*archive);
                if (first) {
                  const auto added = people.add(name, Role::Administrator, password, name, "first administrator");
                  if (!added) return [=, this, words = inWords(added.error())] { told(words, {}); };
                }
                const auto in = people.signIn(name, password);
                if (!in) return [=, this, words = inWords(in.error())] { told(words, {}); };
                return [=, this, in = *in] {
                  switch (in.result) {
                    case SignInResult::Welcome:
                      told({}, in.account);
                      break;
                    case SignInResult::WrongNameOrPassword:
                      told(tr("Name or password is wrong."), {});
                      break;
                    case SignInResult::Disabled:
                      told(tr("This account is closed; ask the administrator."), {});
                      break;
                    case SignInResult::Locked:
                      told(tr("Too many wrong passwords: locked until %1.")
                               .arg(QDateTime::fromMSecsSinceEpoch(in.account.lockedUntilUs / 1000)
                                        .toString(QStringLiteral("HH:mm:ss"))),
                           {});
                      break;
                  }
                };
              });
}

}  // namespace vignole
