#include "gui/settings/settings_page.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "engine/archive/rail_archive.h"
#include "gui/bridge/archive_reader.h"
#include "gui/languages/languages.h"
#include "gui/settings/audit_panel.h"
#include "gui/settings/people_panel.h"
#include "gui/settings/rig_drawing.h"
#include "gui/settings/sign_in_panel.h"
#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"
#include "report/engine_words.h"

namespace vignole {

namespace {
constexpr int kFormWidth = 640;  ///< of a form that is no table: lines stay readable
}

SettingsPage::SettingsPage(Workplace& place, QWidget* parent)
    : Page(parent), place_(place), reader_(std::make_unique<ArchiveReader>(place.archive ? place.archiveUrl : "")) {
  setObjectName(QStringLiteral("page"));
  setFocusPolicy(Qt::ClickFocus);
  groupsPanel_ = new Panel(this);
  groups_ = new QListWidget(groupsPanel_);
  groups_->setFont(uiFont(18));
  groups_->setFrameShape(QFrame::NoFrame);
  groups_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  groupsPanel_->content()->addWidget(groups_, 1);
  forms_ = new QStackedWidget(this);
  signIn_ = new SignInPanel(place, *reader_, this);
  people_ = new PeoplePanel(place, *reader_, this);
  audit_ = new AuditPanel(place, *reader_, this);
  connect(signIn_, &SignInPanel::usersChanged, people_, &PeoplePanel::load);
  screen_ = makeScreen();
  archive_ = makeText(archiveWords_);
  cameras_ = makeText(cameraWords_);
  rig_ = new Panel(this);
  rigDrawing_ = new RigDrawing(place.theme, place.units, rig_);
  rigWords_ = makeLabel(15, 400, "t2", rig_, true);
  rig_->content()->addWidget(rigDrawing_, 1);
  rig_->content()->addWidget(rigWords_);
  about_ = makeText(aboutWords_);
  for (Panel* form :
       std::initializer_list<Panel*>{screen_, signIn_, people_, archive_, audit_, cameras_, rig_, about_}) {
    forms_->addWidget(form);
    groups_->addItem(QString());
    groups_->item(groups_->count() - 1)->setSizeHint({100, 52});
  }
  connect(groups_, &QListWidget::currentRowChanged, forms_, &QStackedWidget::setCurrentIndex);
  groups_->setCurrentRow(0);

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 16, 16, 16);
  row->setSpacing(16);
  row->addWidget(groupsPanel_, 5);
  row->addWidget(forms_, 11);
  retranslate();
}

SettingsPage::~SettingsPage() { reader_.reset(); }

Panel* SettingsPage::makeScreen() {
  auto* panel = new Panel(this);
  languageWord_ = makeLabel(15, 400, "t2", panel);
  themeWord_ = makeLabel(15, 400, "t2", panel);
  unitWord_ = makeLabel(15, 400, "t2", panel);
  language_ = new QComboBox(panel);
  for (const Language& language : Languages::all()) language_->addItem(language.ownName, language.code);
  theme_ = new QComboBox(panel);
  unit_ = new QComboBox(panel);
  for (QComboBox* box : {language_, theme_, unit_}) {
    box->setFont(uiFont(16));
    box->setMaximumWidth(kFormWidth);
  }
  for (QWidget* w : std::initializer_list<QWidget*>{languageWord_, language_, themeWord_, theme_, unitWord_, unit_})
    panel->content()->addWidget(w);
  for (QWidget* w : std::initializer_list<QWidget*>{languageWord_, language_})
    w->setVisible(place_.languages != nullptr);
  panel->content()->addSpacing(16);
  tour_ = makeButton(place_.theme, QStringLiteral("help"), panel);
  panel->content()->addWidget(tour_, 0, Qt::AlignLeft);
  panel->content()->addStretch(1);
  connect(tour_, &QPushButton::clicked, this, &SettingsPage::tourAsked);
  connect(language_, &QComboBox::activated, this,
          [this](int row) { place_.languages->use(language_->itemData(row).toString()); });
  connect(theme_, &QComboBox::activated, this, [this](int row) { place_.theme.setDark(row == 1); });
  connect(unit_, &QComboBox::activated, this,
          [this](int row) { place_.units.setLength(row == 1 ? Units::Length::Inch : Units::Length::Millimetre); });
  connect(&place_.theme, &Theme::changed, this, &SettingsPage::showScreen);
  connect(&place_.units, &Units::changed, this, &SettingsPage::showScreen);
  return panel;
}

Panel* SettingsPage::makeText(QLabel*& words) {
  auto* panel = new Panel(this);
  words = makeLabel(17, 400, "t1", panel, true);
  words->setMaximumWidth(kFormWidth + 200);
  words->setTextInteractionFlags(Qt::TextSelectableByMouse);
  panel->content()->addWidget(words);
  panel->content()->addStretch(1);
  return panel;
}

void SettingsPage::retranslate() {
  groupsPanel_->setTitle(tr("Settings"));
  groups_->setAccessibleName(tr("Groups of settings"));
  const QString groups[] = {tr("Screen"),      tr("Who is here"), tr("People"), tr("Archive"),
                            tr("Audit trail"), tr("Cameras"),     tr("Rig"),    tr("About")};
  for (int i = 0; i < groups_->count(); ++i) groups_->item(i)->setText(groups[i]);
  screen_->setTitle(tr("Screen"));
  screen_->setNote(tr("of this machine; kept for the next start"));
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
  tour_->setText(tr("Show the tour"));
  tour_->setAccessibleName(tr("Show the tour of Monitor"));
  archive_->setTitle(tr("Archive"));
  cameras_->setTitle(tr("Cameras"));
  cameraWords_->setText(
      tr("No site is configured: the four cameras are those of the virtual rig, and every page says "
         "SIMULATION. Cameras are measured with on the command line: vignole-cli inspect --source gige."));
  rig_->setTitle(tr("Rig"));
  rig_->setNote(tr("drawn from the calibration in force"));
  about_->setTitle(tr("About"));
  aboutWords_->setText(tr("Vignole %1: rail profiles in millimetres, with their uncertainty. Licence GPL-3.0-or-later.")
                           .arg(QCoreApplication::applicationVersion()));
  signIn_->retranslate();
  people_->retranslate();
  audit_->retranslate();
  showScreen();
  loadArchive();
}

void SettingsPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void SettingsPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  signIn_->lookForUsers();
  people_->load();
  audit_->load();
  loadArchive();
}

void SettingsPage::showLine(const LineSnapshot& line, PullDetail detail) {
  if (detail != PullDetail::Everything || !rigDrawing_->isVisible()) return;
  const RigCalibration calibration = place_.line.calibration();
  if (calibration.id.empty()) {
    rigWords_->setText(tr("This line does not tell its calibration."));
    return;
  }
  const bool seen = line.latest && line.latest->registration.valid;
  rigDrawing_->show(calibration, line.recipe->section,
                    seen ? line.latest->registration.worldFromSection : Transform2{});
  rigWords_->setText(
      seen ? tr("Calibration %1. The rail stands where it was seen last.").arg(QString::fromStdString(calibration.id))
           : tr("Calibration %1. No rail has been seen yet.").arg(QString::fromStdString(calibration.id)));
}

void SettingsPage::showGroup(Group group) { groups_->setCurrentRow(static_cast<int>(group)); }

void SettingsPage::askForName() {
  showGroup(Group::WhoIsHere);
  signIn_->focusName();
}

void SettingsPage::showScreen() {
  if (place_.languages != nullptr) language_->setCurrentIndex(language_->findData(place_.languages->code()));
  theme_->setCurrentIndex(place_.theme.dark() ? 1 : 0);
  unit_->setCurrentIndex(place_.units.length() == Units::Length::Inch ? 1 : 0);
}

void SettingsPage::loadArchive() {
  if (place_.archive == nullptr) {
    archiveWords_->setText(
        tr("There is none: %1. Rails are measured and not kept. Start the program with --archive FILE.")
            .arg(inWords(place_.archiveProblem)));
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
