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
  password_->setEchoMode(QLineEdit::Password);
  for (QLineEdit* field : {name_, password_}) field->setFont(uiFont(16));
  button_ = makeButton(place.theme, QStringLiteral("user"), this, true);
  leave_ = makeButton(place.theme, QStringLiteral("back"), this);
  result_ = makeLabel(15, 500, "t1", this, true);
  for (QWidget* w : std::initializer_list<QWidget*>{words_, name_, password_, button_, leave_, result_})
    content()->addWidget(w);
  content()->addStretch(1);
  connect(button_, &QPushButton::clicked, this, &SignInPanel::act);
  connect(password_, &QLineEdit::returnPressed, this, &SignInPanel::act);
  connect(leave_, &QPushButton::clicked, this, [this] {
    result_->clear();
    place_.session.leave();
  });
  connect(&place_.session, &Session::changed, this, &SignInPanel::show);
  retranslate();
}

void SignInPanel::retranslate() {
  setTitle(tr("Who is here"));
  name_->setPlaceholderText(tr("Name"));
  name_->setAccessibleName(tr("Name"));
  password_->setPlaceholderText(tr("Password"));
  password_->setAccessibleName(tr("Password"));
  leave_->setText(tr("Sign out"));
  leave_->setAccessibleName(tr("Sign out"));
  show();
}

void SignInPanel::focusName() {
  if (name_->isVisible()) name_->setFocus();
}

void SignInPanel::show() {
  const bool in = !place_.session.user().isEmpty();
  setNote(in ? place_.session.user() + QStringLiteral(", ") + roleWord(place_.session.role())
             : roleWord(Role::Operator));
  for (QWidget* w : std::initializer_list<QWidget*>{name_, password_, button_}) w->setVisible(!in && ready_);
  leave_->setVisible(in);
  button_->setText(first_ ? tr("Enter as the first administrator") : tr("Sign in"));
  button_->setAccessibleName(button_->text());
  if (place_.archive == nullptr)
    words_->setText(tr("Nobody can sign in: people are kept in the archive, and there is none (%1).")
                        .arg(QString::fromStdString(place_.archiveProblem)));
  else if (in)
    words_->setText(tr("After a quarter of an hour without a key or a touch it is the operator's screen again."));
  else if (first_)
    words_->setText(
        tr("Nobody is entered yet. The first one is the administrator and enters the others; the password "
           "has at least 8 characters."));
  else
    words_->setText(tr("Without signing in this is the operator's screen: it measures, shows and acknowledges."));
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
                const auto answer = [this](const QString& words, std::optional<UserAccount> welcome) {
                  button_->setEnabled(true);
                  result_->setText(words);
                  if (welcome) {
                    name_->clear();
                    first_ = false;
                    place_.session.enter(QString::fromStdString(welcome->name), welcome->role);
                  }
                  emit answered();
                  emit usersChanged();
                };
                if (archive == nullptr) return [=] { answer(QString::fromStdString(problem), {}); };
                UserRegister people(*archive);
                if (first) {
                  const auto added = people.add(name, Role::Administrator, password, name, "first administrator");
                  if (!added)
                    return [=, words = added.error().message()] { answer(QString::fromStdString(words), {}); };
                }
                const auto in = people.signIn(name, password);
                if (!in) return [=, words = in.error().message()] { answer(QString::fromStdString(words), {}); };
                return [=, this, in = *in] {
                  switch (in.result) {
                    case SignInResult::Welcome:
                      answer({}, in.account);
                      break;
                    case SignInResult::WrongNameOrPassword:
                      answer(tr("Name or password is wrong."), {});
                      break;
                    case SignInResult::Disabled:
                      answer(tr("This account is closed; ask the administrator."), {});
                      break;
                    case SignInResult::Locked:
                      answer(tr("Too many wrong passwords: locked until %1.")
                                 .arg(QDateTime::fromMSecsSinceEpoch(in.account.lockedUntilUs / 1000)
                                          .toString(QStringLiteral("HH:mm:ss"))),
                             {});
                      break;
                  }
                };
              });
}

}  // namespace vignole
