#include "gui/settings/people_panel.h"

#include <QComboBox>
#include <QDateTime>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "gui/bridge/archive_reader.h"
#include "gui/settings/sign_in_panel.h"
#include "gui/theme/theme.h"
#include "report/engine_words.h"

namespace vignole {

namespace {
constexpr std::array<Role, 4> kRoles = {Role::Operator, Role::Technician, Role::QA, Role::Administrator};
}

PeoplePanel::PeoplePanel(Workplace& place, ArchiveReader& reader, QWidget* parent)
    : Panel(parent), place_(place), reader_(reader) {
  words_ = makeLabel(16, 400, "t2", this, true);
  table_ = new QTableWidget(0, 4, this);
  styleTable(*table_);
  name_ = new QLineEdit(this);
  password_ = new QLineEdit(this);
  password_->setEchoMode(QLineEdit::Password);
  reason_ = new QLineEdit(this);
  role_ = new QComboBox(this);
  for (QWidget* w : std::initializer_list<QWidget*>{name_, password_, reason_, role_}) w->setFont(uiFont(16));
  add_ = makeButton(place.theme, QStringLiteral("add"), this, true);
  reset_ = makeButton(place.theme, QStringLiteral("revert"), this);
  give_ = makeButton(place.theme, QStringLiteral("user"), this);
  close_ = makeButton(place.theme, QStringLiteral("reject"), this);
  result_ = makeLabel(15, 500, "t1", this, true);
  auto* form = new QGridLayout;
  form->setSpacing(8);
  form->addWidget(name_, 0, 0);
  form->addWidget(role_, 0, 1);
  form->addWidget(password_, 1, 0);
  form->addWidget(reason_, 1, 1);
  form->addWidget(add_, 2, 0);
  form->addWidget(reset_, 2, 1);
  form->addWidget(give_, 3, 0);
  form->addWidget(close_, 3, 1);
  content()->addWidget(words_);
  content()->addWidget(table_, 100);
  content()->addLayout(form);
  content()->addWidget(result_);
  content()->addStretch(1);
  connect(add_, &QPushButton::clicked, this, &PeoplePanel::add);
  connect(reset_, &QPushButton::clicked, this, &PeoplePanel::resetPassword);
  connect(give_, &QPushButton::clicked, this, &PeoplePanel::giveRole);
  connect(close_, &QPushButton::clicked, this, &PeoplePanel::closeOrOpen);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &PeoplePanel::showChosen);
  connect(&place_.session, &Session::changed, this, &PeoplePanel::load);
  retranslate();
}

void PeoplePanel::retranslate() {
  setTitle(tr("People"));
  words_->setText(tr("Names and roles are the administrator's: sign in as administrator to see and enter people."));
  table_->setHorizontalHeaderLabels({tr("Name"), tr("Role"), tr("State"), tr("Last here")});
  table_->setAccessibleName(tr("People who may sign in"));
  name_->setPlaceholderText(tr("Name"));
  name_->setAccessibleName(tr("Name of the new person"));
  password_->setPlaceholderText(tr("First or new password"));
  password_->setAccessibleName(tr("First password of the new person"));
  reason_->setPlaceholderText(tr("Reason"));
  reason_->setAccessibleName(tr("Reason for entering the person"));
  role_->setAccessibleName(tr("Role of the new person"));
  const int role = std::max(0, role_->currentIndex());
  role_->clear();
  for (const Role r : kRoles) role_->addItem(roleWord(r));
  role_->setCurrentIndex(role);
  add_->setText(tr("Enter a person"));
  add_->setAccessibleName(tr("Enter a person"));
  reset_->setText(tr("Give a new password"));
  reset_->setAccessibleName(tr("Give the chosen person a new password"));
  give_->setText(tr("Give this role"));
  give_->setAccessibleName(tr("Give the chosen person this role"));
  showChosen();
  if (!people_.empty()) show(people_);
}

void PeoplePanel::load() {
  const bool may = place_.archive != nullptr && place_.session.may(Permission::ManageUsers);
  for (QWidget* w :
       std::initializer_list<QWidget*>{table_, name_, password_, reason_, role_, add_, reset_, give_, close_, result_})
    w->setVisible(may);
  words_->setVisible(!may);
  if (!may) {
    result_->clear();
    return;
  }
  reader_.ask("people", [this](const Archive* archive, const std::string& /*problem*/) -> ArchiveReader::Answer {
    if (archive == nullptr) return {};
    auto all = UserRegister(*archive).accounts();
    if (!all) return [this, words = all.error().message()] { result_->setText(QString::fromStdString(words)); };
    return [this, all = std::move(*all)] { show(all); };
  });
}

void PeoplePanel::show(const std::vector<UserAccount>& accounts) {
  const int row = table_->currentRow();
  people_ = accounts;
  const qint64 nowUs = QDateTime::currentMSecsSinceEpoch() * 1000;
  table_->setRowCount(static_cast<int>(people_.size()));
  for (int i = 0; i < table_->rowCount(); ++i) {
    const UserAccount& a = people_[static_cast<std::size_t>(i)];
    const QString state = a.disabled                ? tr("closed")
                          : a.lockedUntilUs > nowUs ? tr("locked")
                          : a.mustChangePassword    ? tr("chooses a password")
                                                    : tr("open");
    const QString last =
        a.lastSignInUs
            ? QDateTime::fromMSecsSinceEpoch(*a.lastSignInUs / 1000).toString(QStringLiteral("yyyy-MM-dd HH:mm"))
            : tr("never");
    const QString cells[] = {QString::fromStdString(a.name), roleWord(a.role), state, last};
    for (int column = 0; column < 4; ++column) table_->setItem(i, column, new QTableWidgetItem(cells[column]));
  }
  for (int column = 0; column < 3; ++column) table_->setColumnWidth(column, table_->viewport()->width() / 4);
  if (row >= 0 && row < table_->rowCount()) table_->selectRow(row);
  showChosen();
}

const UserAccount* PeoplePanel::chosen() const {
  const int row = table_->currentRow();
  return row >= 0 && static_cast<std::size_t>(row) < people_.size() ? &people_[static_cast<std::size_t>(row)] : nullptr;
}

void PeoplePanel::showChosen() {
  const UserAccount* person = chosen();
  for (QPushButton* button : {reset_, give_, close_}) button->setEnabled(person != nullptr);
  const bool closed = person != nullptr && person->disabled;
  close_->setText(closed ? tr("Open the account") : tr("Close the account"));
  close_->setAccessibleName(closed ? tr("Open the account of the chosen person")
                                   : tr("Close the account of the chosen person"));
}

void PeoplePanel::ask(const QString& done, Change change) {
  password_->clear();
  reader_.ask("change people",
              [this, done, change = std::move(change)](const Archive* archive,
                                                       const std::string& problem) -> ArchiveReader::Answer {
                Expected<void> result = worldError("archive", problem);
                if (archive != nullptr) {
                  UserRegister people(*archive);
                  result = change(people);
                }
                return [this, result, done] {
                  result_->setText(result ? done : inWords(result.error()));
                  if (!result) return;
                  name_->clear();
                  reason_->clear();
                  load();
                };
              });
}

void PeoplePanel::add() {
  const std::string name = name_->text().trimmed().toStdString(), password = password_->text().toStdString(),
                    reason = reason_->text().trimmed().toStdString(), by = place_.session.user().toStdString();
  const Role role = kRoles[static_cast<std::size_t>(std::max(0, role_->currentIndex()))];
  ask(tr("%1 is entered.").arg(QString::fromStdString(name)),
      [=](UserRegister& people) { return people.add(name, role, password, by, reason); });
}

void PeoplePanel::resetPassword() {
  const UserAccount* person = chosen();
  if (person == nullptr) return;
  const std::string name = person->name, password = password_->text().toStdString(),
                    reason = reason_->text().trimmed().toStdString(), by = place_.session.user().toStdString();
  ask(tr("%1 has a new password and chooses another at the next sign-in.").arg(QString::fromStdString(name)),
      [=](UserRegister& people) { return people.resetPassword(name, password, by, reason); });
}

void PeoplePanel::giveRole() {
  const UserAccount* person = chosen();
  if (person == nullptr) return;
  const std::string name = person->name, reason = reason_->text().trimmed().toStdString(),
                    by = place_.session.user().toStdString();
  const Role role = kRoles[static_cast<std::size_t>(std::max(0, role_->currentIndex()))];
  ask(tr("%1 is now %2.").arg(QString::fromStdString(name), roleWord(role)),
      [=](UserRegister& people) { return people.setRole(name, role, by, reason); });
}

void PeoplePanel::closeOrOpen() {
  const UserAccount* person = chosen();
  if (person == nullptr) return;
  const std::string name = person->name, reason = reason_->text().trimmed().toStdString(),
                    by = place_.session.user().toStdString();
  const bool close = !person->disabled;
  const QString who = QString::fromStdString(name);
  ask(close ? tr("The account of %1 is closed.").arg(who) : tr("The account of %1 is open.").arg(who),
      [=](UserRegister& people) { return people.setDisabled(name, close, by, reason); });
}

}  // namespace vignole
