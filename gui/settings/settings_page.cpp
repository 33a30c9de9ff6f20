#include "gui/settings/settings_page.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDateTime>
#include <QEvent>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

#include "engine/archive/rail_archive.h"
#include "engine/archive/user_register.h"
#include "gui/bridge/archive_reader.h"
#include "gui/languages/languages.h"
#include "gui/settings/sign_in_panel.h"
#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"

namespace vignole {

namespace {
constexpr std::array<Role, 4> kRoles = {Role::Operator, Role::Technician, Role::QA, Role::Administrator};
}

SettingsPage::SettingsPage(Workplace& place, QWidget* parent)
    : Page(parent), place_(place), reader_(std::make_unique<ArchiveReader>(place.archive ? place.archiveUrl : "")) {
  setObjectName(QStringLiteral("page"));
  setFocusPolicy(Qt::ClickFocus);
  screen_ = new Panel(this);
  languageWord_ = makeLabel(15, 400, "t2", screen_);
  themeWord_ = makeLabel(15, 400, "t2", screen_);
  unitWord_ = makeLabel(15, 400, "t2", screen_);
  language_ = new QComboBox(screen_);
  for (const Language& language : Languages::all()) language_->addItem(language.ownName, language.code);
  theme_ = new QComboBox(screen_);
  unit_ = new QComboBox(screen_);
  for (QComboBox* box : {language_, theme_, unit_}) box->setFont(uiFont(16));
  for (QWidget* w : std::initializer_list<QWidget*>{languageWord_, language_, themeWord_, theme_, unitWord_, unit_})
    screen_->content()->addWidget(w);
  screen_->content()->addStretch(1);
  for (QWidget* w : std::initializer_list<QWidget*>{languageWord_, language_})
    w->setVisible(place.languages != nullptr);
  connect(language_, &QComboBox::activated, this,
          [this](int row) { place_.languages->use(language_->itemData(row).toString()); });
  connect(theme_, &QComboBox::activated, this, [this](int row) { place_.theme.setDark(row == 1); });
  connect(unit_, &QComboBox::activated, this,
          [this](int row) { place_.units.setLength(row == 1 ? Units::Length::Inch : Units::Length::Millimetre); });
  connect(&place_.theme, &Theme::changed, this, &SettingsPage::showScreen);
  connect(&place_.units, &Units::changed, this, &SettingsPage::showScreen);

  signIn_ = new SignInPanel(place, *reader_, this);
  connect(signIn_, &SignInPanel::usersChanged, this, &SettingsPage::loadPeople);
  connect(&place_.session, &Session::changed, this, &SettingsPage::loadPeople);

  archive_ = new Panel(this);
  archiveWords_ = makeLabel(16, 400, "t1", archive_, true);
  archive_->content()->addWidget(archiveWords_);
  archive_->content()->addStretch(1);
  cameras_ = new Panel(this);
  cameraWords_ = makeLabel(16, 400, "t1", cameras_, true);
  cameras_->content()->addWidget(cameraWords_);
  cameras_->content()->addStretch(1);
  about_ = new Panel(this);
  aboutWords_ = makeLabel(16, 400, "t1", about_, true);
  about_->content()->addWidget(aboutWords_);
  about_->content()->addStretch(1);

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(16, 16, 16, 16);
  grid->setSpacing(16);
  grid->addWidget(screen_, 0, 0);
  grid->addWidget(signIn_, 0, 1);
  grid->addWidget(makePeople(), 0, 2, 2, 1);
  grid->addWidget(archive_, 1, 0);
  grid->addWidget(cameras_, 1, 1);
  grid->addWidget(about_, 2, 0, 1, 3);
  grid->setColumnStretch(0, 4);
  grid->setColumnStretch(1, 4);
  grid->setColumnStretch(2, 6);
  grid->setRowStretch(0, 3);
  grid->setRowStretch(1, 2);
  retranslate();
}

SettingsPage::~SettingsPage() { reader_.reset(); }

QWidget* SettingsPage::makePeople() {
  people_ = new Panel(this);
  peopleWords_ = makeLabel(16, 400, "t2", people_, true);
  accounts_ = new QTableWidget(0, 3, people_);
  styleTable(*accounts_);
  name_ = new QLineEdit(people_);
  password_ = new QLineEdit(people_);
  password_->setEchoMode(QLineEdit::Password);
  reason_ = new QLineEdit(people_);
  role_ = new QComboBox(people_);
  add_ = makeButton(place_.theme, QStringLiteral("add"), people_);
  peopleResult_ = makeLabel(15, 500, "t1", people_, true);
  auto* form = new QGridLayout;
  form->setSpacing(8);
  form->addWidget(name_, 0, 0);
  form->addWidget(role_, 0, 1);
  form->addWidget(password_, 1, 0);
  form->addWidget(reason_, 1, 1);
  for (QWidget* w : std::initializer_list<QWidget*>{name_, password_, reason_, role_}) w->setFont(uiFont(16));
  people_->content()->addWidget(peopleWords_);
  people_->content()->addWidget(accounts_, 100);
  people_->content()->addLayout(form);
  people_->content()->addWidget(add_);
  people_->content()->addWidget(peopleResult_);
  people_->content()->addStretch(1);
  connect(add_, &QPushButton::clicked, this, &SettingsPage::addPerson);
  return people_;
}

void SettingsPage::retranslate() {
  screen_->setTitle(tr("Screen"));
  languageWord_->setText(tr("Language"));
  language_->setAccessibleName(tr("Language of the screen"));
  themeWord_->setText(tr("Theme"));
  unitWord_->setText(tr("Lengths"));
  theme_->setAccessibleName(tr("Theme"));
  unit_->setAccessibleName(tr("Unit of lengths"));
  theme_->clear();
  theme_->addItems({tr("Light"), tr("Dark")});
  unit_->clear();
  unit_->addItems({tr("Millimetres"), tr("Inches")});
  people_->setTitle(tr("People"));
  accounts_->setHorizontalHeaderLabels({tr("Name"), tr("Role"), tr("Last here")});
  accounts_->setAccessibleName(tr("People who may sign in"));
  name_->setPlaceholderText(tr("Name"));
  name_->setAccessibleName(tr("Name of the new person"));
  password_->setPlaceholderText(tr("First password"));
  password_->setAccessibleName(tr("First password of the new person"));
  reason_->setPlaceholderText(tr("Reason"));
  reason_->setAccessibleName(tr("Reason for entering the person"));
  role_->setAccessibleName(tr("Role of the new person"));
  role_->clear();
  for (const Role role : kRoles) role_->addItem(roleWord(role));
  add_->setText(tr("Enter a person"));
  add_->setAccessibleName(tr("Enter a person"));
  archive_->setTitle(tr("Archive"));
  cameras_->setTitle(tr("Cameras"));
  cameraWords_->setText(
      tr("No site is configured: the four cameras are those of the virtual rig, and every page says "
         "SIMULATION. Cameras with GigE Vision are not part of this version."));
  about_->setTitle(tr("About"));
  aboutWords_->setText(tr("Vignole %1: rail profiles in millimetres, with their uncertainty. Licence GPL-3.0-or-later.")
                           .arg(QCoreApplication::applicationVersion()));
  signIn_->retranslate();
  showScreen();
  loadPeople();
  loadArchive();
}

void SettingsPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void SettingsPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  signIn_->lookForUsers();
  loadPeople();
  loadArchive();
}

void SettingsPage::showLine(const LineSnapshot& /*line*/, PullDetail /*detail*/) {}

void SettingsPage::askForName() { signIn_->focusName(); }

void SettingsPage::showScreen() {
  theme_->setCurrentIndex(place_.theme.dark() ? 1 : 0);
  if (place_.languages != nullptr) language_->setCurrentIndex(language_->findData(place_.languages->code()));
  unit_->setCurrentIndex(place_.units.length() == Units::Length::Inch ? 1 : 0);
}

void SettingsPage::loadPeople() {
  const bool may = place_.archive != nullptr && place_.session.may(Permission::ManageUsers);
  for (QWidget* w : std::initializer_list<QWidget*>{accounts_, name_, password_, reason_, role_, add_})
    w->setVisible(may);
  peopleWords_->setVisible(!may);
  peopleWords_->setText(
      tr("Names and roles are the administrator's: sign in as administrator to see and enter people."));
  if (!may) {
    peopleResult_->clear();
    return;
  }
  reader_->ask("people", [this](const Archive* archive, const std::string& /*problem*/) -> ArchiveReader::Answer {
    if (archive == nullptr) return {};
    auto all = UserRegister(*archive).accounts();
    if (!all) return [this, words = all.error().message()] { peopleResult_->setText(QString::fromStdString(words)); };
    return [this, all = std::move(*all)] {
      accounts_->setRowCount(static_cast<int>(all.size()));
      for (int i = 0; i < static_cast<int>(all.size()); ++i) {
        const UserAccount& a = all[static_cast<std::size_t>(i)];
        accounts_->setItem(i, 0, new QTableWidgetItem(QString::fromStdString(a.name)));
        accounts_->setItem(i, 1, new QTableWidgetItem(roleWord(a.role) + (a.disabled ? tr(", closed") : QString())));
        accounts_->setItem(i, 2,
                           new QTableWidgetItem(a.lastSignInUs ? QDateTime::fromMSecsSinceEpoch(*a.lastSignInUs / 1000)
                                                                     .toString(QStringLiteral("yyyy-MM-dd HH:mm"))
                                                               : tr("never")));
      }
      accounts_->setColumnWidth(0, accounts_->viewport()->width() / 3);
      accounts_->setColumnWidth(1, accounts_->viewport()->width() / 3);
    };
  });
}

void SettingsPage::addPerson() {
  const std::string name = name_->text().trimmed().toStdString(), password = password_->text().toStdString(),
                    reason = reason_->text().trimmed().toStdString(), by = place_.session.user().toStdString();
  const Role role = kRoles[static_cast<std::size_t>(std::max(0, role_->currentIndex()))];
  password_->clear();
  reader_->ask("add", [=, this](const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
    Expected<void> done = archive != nullptr ? UserRegister(*archive).add(name, role, password, by, reason)
                                             : Expected<void>(worldError("archive", problem));
    return [this, done, name] {
      peopleResult_->setText(done ? tr("%1 is entered.").arg(QString::fromStdString(name))
                                  : QString::fromStdString(done.error().message()));
      if (!done) return;
      name_->clear();
      reason_->clear();
      loadPeople();
    };
  });
}

void SettingsPage::loadArchive() {
  if (place_.archive == nullptr) {
    archiveWords_->setText(
        tr("There is none: %1. Rails are measured and not kept. Start the program with --archive FILE.")
            .arg(QString::fromStdString(place_.archiveProblem)));
    return;
  }
  reader_->ask("archive", [this](const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
    if (archive == nullptr) return [this, problem] { archiveWords_->setText(QString::fromStdString(problem)); };
    const auto rails = RailArchive(*archive).count();
    return [this, url = archive->url(), rails] {
      archiveWords_->setText(
          tr("%1\n%2 rails are kept.").arg(QString::fromStdString(url), rails ? count(*rails) : QString()));
    };
  });
}

}  // namespace vignole
