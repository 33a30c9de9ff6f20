#include "gui/recipes/recipes_page.h"

#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <QTableWidget>

#include "engine/archive/audit_trail.h"
#include "engine/archive/rail_archive.h"
#include "engine/archive/user_register.h"
#include "engine/files/atomic_file.h"
#include "engine/rail/catalogue.h"
#include "engine/recipe/recipe_difference.h"
#include "gui/bridge/archive_reader.h"
#include "gui/rails/what_if_dialog.h"
#include "gui/recipes/recipe_setting.h"
#include "gui/recipes/section_dialog.h"
#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"
#include "report/dimension_text.h"
#include "report/engine_words.h"

namespace vignole {

namespace {

QString shown(const std::string& text) { return QString::fromStdString(text); }

QString wordOf(RecipeState state) {
  switch (state) {
    case RecipeState::Draft:
      return RecipesPage::tr("Draft");
    case RecipeState::Approved:
      return RecipesPage::tr("Approved");
    case RecipeState::Retired:
      return RecipesPage::tr("Retired");
    case RecipeState::Measured:
      return RecipesPage::tr("With the program");
  }
  return {};
}

constexpr std::size_t kMostTried = 500;

/// EN 13674-1: profile classes X and Y, straightness A and B.
constexpr std::array<const char*, 4> kClasses = {"X/A", "X/B", "Y/A", "Y/B"};

std::optional<double> limitFrom(const QString& text, bool& fine) {
  const QString plain = QString(text).replace(QChar(0x2212), '-').replace(',', '.').trimmed();
  if (plain.isEmpty() || plain == QStringLiteral("–")) return {};
  bool ok = false;
  const double value = plain.toDouble(&ok);
  fine = fine && ok;
  return value;
}

}  // namespace

RecipesPage::RecipesPage(Workplace& place, QWidget* parent)
    : Page(parent), place_(place), reader_(std::make_unique<ArchiveReader>(place.archive ? place.archiveUrl : "")) {
  setObjectName(QStringLiteral("page"));
  setFocusPolicy(Qt::ClickFocus);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 16, 16, 16);
  row->setSpacing(16);
  row->addWidget(makeList(), 5);
  row->addWidget(makeEdit(), 6);
  row->addWidget(makeDecision(), 5);
  connect(&place_.session, &Session::changed, this, &RecipesPage::showPermission);
  retranslate();
}

RecipesPage::~RecipesPage() {
  delete whatIf_;  // it asks the reader
  reader_.reset();
}

QWidget* RecipesPage::makeList() {
  list_ = new Panel(this);
  table_ = new QTableWidget(0, 3, list_);
  styleTable(*table_);
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
    if (!table_->selectedItems().isEmpty()) choose(table_->currentRow());
  });
  empty_ = makeLabel(15, 400, "t2", list_, true);
  section_ = new QComboBox(list_);
  class_ = new QComboBox(list_);
  for (QComboBox* box : {section_, class_}) box->setFont(uiFont(16));
  for (const std::string& name : catalogueNames()) section_->addItem(shown(name));
  for (const char* one : kClasses) class_->addItem(QString::fromLatin1(one));
  new_ = makeButton(place_.theme, QStringLiteral("add"), list_);
  import_ = makeButton(place_.theme, QStringLiteral("import"), list_);
  export_ = makeButton(place_.theme, QStringLiteral("export"), list_);
  auto* made = new QHBoxLayout;
  made->addWidget(section_, 1);
  made->addWidget(class_, 1);
  made->addWidget(new_, 1);
  auto* files = new QHBoxLayout;
  files->addWidget(import_, 1);
  files->addWidget(export_, 1);
  sectionButton_ = makeButton(place_.theme, QStringLiteral("rails"), list_);
  tryButton_ = makeButton(place_.theme, QStringLiteral("compare"), list_);
  onLine_ = makeLabel(15, 400, "t2", list_, true);
  auto* looks = new QHBoxLayout;
  looks->addWidget(sectionButton_, 1);
  looks->addWidget(tryButton_, 1);
  list_->content()->addWidget(table_, 1);
  list_->content()->addWidget(empty_);
  list_->content()->addLayout(made);
  list_->content()->addLayout(files);
  list_->content()->addLayout(looks);
  list_->content()->addWidget(onLine_);
  connect(sectionButton_, &QPushButton::clicked, this, [this] {
    if (chosen_ >= 0) sectionDialog().showSection(entries_[static_cast<std::size_t>(chosen_)].recipe.section);
    sectionDialog().show();
  });
  connect(tryButton_, &QPushButton::clicked, this, &RecipesPage::tryOnStoredRails);
  connect(new_, &QPushButton::clicked, this, &RecipesPage::newFromClass);
  connect(import_, &QPushButton::clicked, this, &RecipesPage::importFile);
  connect(export_, &QPushButton::clicked, this, &RecipesPage::exportFile);
  return list_;
}

QWidget* RecipesPage::makeEdit() {
  edit_ = new Panel(this);
  editWords_ = makeLabel(15, 400, "t2", edit_, true);
  limits_ = new QTableWidget(static_cast<int>(kDimensionCount), 4, edit_);
  styleTable(*limits_);
  limits_->verticalHeader()->setMinimumSectionSize(20);
  limits_->verticalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  limits_->setMinimumHeight(20 * static_cast<int>(kDimensionCount) + 36);
  limits_->setSelectionBehavior(QAbstractItemView::SelectItems);
  settings_ = new QTableWidget(0, 2, edit_);
  styleTable(*settings_);
  settings_->verticalHeader()->setDefaultSectionSize(30);
  settings_->setSelectionBehavior(QAbstractItemView::SelectItems);
  editors_ = new QStackedWidget(edit_);
  editors_->addWidget(limits_);
  editors_->addWidget(settings_);
  limitsButton_ = new QPushButton(edit_);
  settingsButton_ = new QPushButton(edit_);
  auto* which = new QHBoxLayout;
  which->setSpacing(0);
  for (QPushButton* button : {limitsButton_, settingsButton_}) {
    button->setObjectName(QStringLiteral("segment"));
    button->setFont(uiFont(16, 500));
    button->setCheckable(true);
    which->addWidget(button, 1);
  }
  connect(limitsButton_, &QPushButton::clicked, this, [this] { chooseEditor(false); });
  connect(settingsButton_, &QPushButton::clicked, this, [this] { chooseEditor(true); });
  chooseEditor(false);
  name_ = new QLineEdit(edit_);
  note_ = new QLineEdit(edit_);
  for (QLineEdit* field : {name_, note_}) field->setFont(uiFont(16));
  auto* said = new QHBoxLayout;
  said->setSpacing(8);
  said->addWidget(name_, 2);
  said->addWidget(note_, 3);
  save_ = makeButton(place_.theme, QStringLiteral("save"), edit_, true);
  edit_->content()->addWidget(editWords_);
  edit_->content()->addLayout(which);
  edit_->content()->addWidget(editors_, 1);
  edit_->content()->addLayout(said);
  edit_->content()->addWidget(save_);
  connect(save_, &QPushButton::clicked, this, &RecipesPage::saveDraft);
  return edit_;
}

QWidget* RecipesPage::makeDecision() {
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(16);
  difference_ = new Panel(side);
  against_ = new QComboBox(difference_);
  against_->setFont(uiFont(16));
  against_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  differences_ = new QTableWidget(0, 3, difference_);
  styleTable(*differences_);
  differences_->setSelectionMode(QAbstractItemView::NoSelection);
  differences_->verticalHeader()->setDefaultSectionSize(32);
  differences_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  differences_->setMinimumHeight(96);
  same_ = makeLabel(16, 400, "t2", difference_, true);
  difference_->content()->addWidget(against_);
  difference_->content()->addWidget(same_);
  difference_->content()->addWidget(differences_, 1);
  connect(against_, &QComboBox::activated, this, &RecipesPage::showDifference);
  decision_ = new Panel(side);
  decisionWords_ = makeLabel(15, 400, "t2", decision_, true);
  reason_ = new QLineEdit(decision_);
  password_ = new QLineEdit(decision_);
  password_->setEchoMode(QLineEdit::Password);
  for (QLineEdit* field : {reason_, password_}) field->setFont(uiFont(16));
  approve_ = makeButton(place_.theme, QStringLiteral("approve"), decision_, true);
  use_ = makeButton(place_.theme, QStringLiteral("next"), decision_);
  result_ = makeLabel(15, 500, "t1", decision_, true);
  for (QWidget* w : std::initializer_list<QWidget*>{decisionWords_, reason_, password_, approve_, use_, result_})
    decision_->content()->addWidget(w);
  connect(approve_, &QPushButton::clicked, this, &RecipesPage::approve);
  connect(use_, &QPushButton::clicked, this, &RecipesPage::useForNextRail);
  column->addWidget(difference_, 1);
  column->addWidget(decision_);
  decision_->content()->addStretch(1);
  return side;
}

void RecipesPage::retranslate() {
  list_->setTitle(tr("Recipes"));
  table_->setHorizontalHeaderLabels({tr("Recipe"), tr("Version"), tr("State")});
  table_->setAccessibleName(tr("Recipes and their versions"));
  section_->setAccessibleName(tr("Section of the new recipe"));
  class_->setAccessibleName(tr("Profile and straightness class of the new recipe"));
  new_->setText(tr("New"));
  new_->setAccessibleName(tr("New draft from section and class"));
  import_->setText(tr("Import…"));
  import_->setAccessibleName(tr("Import a recipe file as a draft"));
  export_->setText(tr("Export…"));
  export_->setAccessibleName(tr("Export the chosen recipe"));
  sectionButton_->setText(tr("Section…"));
  sectionButton_->setAccessibleName(tr("Draw the section, or bring one along from a drawing"));
  tryButton_->setText(tr("What if…"));
  tryButton_->setAccessibleName(tr("Judge stored rails by the chosen recipe"));
  use_->setText(tr("Use for the next rail"));
  use_->setAccessibleName(tr("Use the chosen recipe for the next rail"));
  limitsButton_->setText(tr("Tolerances"));
  limitsButton_->setAccessibleName(tr("Tolerances"));
  settingsButton_->setText(tr("Settings"));
  settingsButton_->setAccessibleName(tr("Parameters of dimensions and settings of the stages"));
  settings_->setHorizontalHeaderLabels({tr("Setting"), tr("Value")});
  settings_->setAccessibleName(tr("Settings of the chosen recipe"));
  name_->setPlaceholderText(tr("Name"));
  name_->setAccessibleName(tr("Name of the draft; another name makes a copy"));
  limits_->setHorizontalHeaderLabels({tr("Dimension"), tr("Nominal, mm"), tr("Lower, mm"), tr("Upper, mm")});
  limits_->setAccessibleName(tr("Tolerances of the chosen recipe"));
  note_->setPlaceholderText(tr("What is new in it"));
  note_->setAccessibleName(tr("What is new in the draft"));
  save_->setText(tr("Save as a new draft"));
  save_->setAccessibleName(tr("Save as a new draft"));
  difference_->setTitle(tr("Difference"));
  against_->setAccessibleName(tr("Recipe to compare with"));
  differences_->setHorizontalHeaderLabels({tr("What"), tr("There"), tr("Here")});
  differences_->setAccessibleName(tr("What differs"));
  decision_->setTitle(tr("Approval"));
  reason_->setPlaceholderText(tr("Reason"));
  reason_->setAccessibleName(tr("Reason for the approval"));
  password_->setPlaceholderText(tr("Your password"));
  password_->setAccessibleName(tr("Your password"));
  approve_->setText(tr("Approve"));
  approve_->setAccessibleName(tr("Approve the draft"));
  showEntries();
}

void RecipesPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void RecipesPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  load();
}

void RecipesPage::showLine(const LineSnapshot& line, PullDetail detail) {
  if (detail != PullDetail::Everything) return;
  QString words = tr("On the line: %1 v%2.").arg(shown(line.recipe->name)).arg(line.recipe->version);
  if (!line.nextRecipe.empty()) words += ' ' + tr("From the next rail: %1.").arg(shown(line.nextRecipe));
  if (words != onLine_->text()) onLine_->setText(words);
}

void RecipesPage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  // The layout has its say first.
  QMetaObject::invokeMethod(this, &RecipesPage::shareColumns, Qt::QueuedConnection);
}

void RecipesPage::shareColumns() {
  const auto share = [](QTableWidget* table, std::initializer_list<int> percent) {
    int column = 0;
    for (const int p : percent) table->setColumnWidth(column++, table->viewport()->width() * p / 100);
  };
  share(table_, {46, 18});
  share(limits_, {25, 25, 25});
  share(settings_, {70});
  share(differences_, {34, 33});
}

QString RecipesPage::words() const { return result_->text(); }

void RecipesPage::load() {
  reader_->ask("load", [this](const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
    std::vector<Entry> entries;
    std::string words, noArchive;
    if (archive != nullptr) {
      const RecipeHistory history(*archive);
      const auto names = history.names();
      if (!names) words = names.error().message();
      for (const std::string& name : names ? *names : std::vector<std::string>{}) {
        const auto versions = history.versions(name);
        for (const RecipeVersion& version : versions ? *versions : std::vector<RecipeVersion>{}) {
          const auto text = history.text(version.key);
          auto recipe = text ? parseRecipe(*text, name) : Expected<Recipe>(tl::unexpected(text.error()));
          if (recipe)
            entries.push_back({version, std::move(*recipe)});
          else
            words = recipe.error().message();
        }
      }
    } else {
      noArchive = problem;
    }
    for (const std::string& name : recipeNames())
      if (auto recipe = findRecipe(name)) {
        RecipeVersion version;
        version.name = recipe->name;
        version.version = recipe->version;
        version.state = RecipeState::Measured;
        version.note = recipe->note;
        entries.push_back({version, std::move(*recipe)});
      }
    return [this, entries = std::move(entries), words, noArchive] {
      entries_ = entries;
      empty_->setText(noArchive.empty() ? inWords(words)
                                        : tr("Recipes are read, drafts cannot be kept: %1.").arg(inWords(noArchive)));
      empty_->setVisible(!empty_->text().isEmpty());
      chosen_ = entries_.empty() ? -1 : 0;
      for (int i = 0; i < static_cast<int>(entries_.size()); ++i)
        if (wanted_ != 0 && entries_[static_cast<std::size_t>(i)].version.key == wanted_) chosen_ = i;
      showEntries();
      emit entriesChanged();
    };
  });
}

void RecipesPage::showEntries() {
  const QSignalBlocker quiet(table_), quietAgainst(against_);
  table_->setRowCount(static_cast<int>(entries_.size()));
  against_->clear();
  for (int i = 0; i < static_cast<int>(entries_.size()); ++i) {
    const RecipeVersion& v = entries_[static_cast<std::size_t>(i)].version;
    table_->setItem(i, 0, new QTableWidgetItem(shown(v.name)));
    table_->setItem(i, 1, new QTableWidgetItem(QString::number(v.version)));
    table_->setItem(i, 2, new QTableWidgetItem(wordOf(v.state)));
    against_->addItem(tr("against %1 v%2, %3").arg(shown(v.name)).arg(v.version).arg(wordOf(v.state)));
  }
  if (chosen_ >= 0) table_->selectRow(chosen_);
  compareWithOlder();
  showChosen();
}

void RecipesPage::compareWithOlder() {
  // The next one in the list is the version before, or what the program brings.
  against_->setCurrentIndex(std::min(chosen_ + 1, against_->count() - 1));
}

void RecipesPage::choose(int entry) {
  if (entry < 0 || entry >= static_cast<int>(entries_.size())) return;
  chosen_ = entry;
  wanted_ = entries_[static_cast<std::size_t>(entry)].version.key;
  compareWithOlder();
  showChosen();
}

void RecipesPage::showChosen() {
  if (chosen_ < 0) {
    edit_->setTitle(tr("Tolerances"));
    limits_->setEnabled(false);
    showPermission();
    return;
  }
  limits_->setEnabled(true);
  const Entry& entry = entries_[static_cast<std::size_t>(chosen_)];
  edit_->setTitle(tr("%1 v%2").arg(shown(entry.version.name)).arg(entry.version.version));
  edit_->setNote(entry.version.createdBy.empty()
                     ? wordOf(entry.version.state)
                     : tr("%1, by %2").arg(wordOf(entry.version.state), shown(entry.version.createdBy)));
  editWords_->setText(shown(entry.version.note));
  const auto nominals = nominalDimensions(entry.recipe.section, entry.recipe.parameters);
  for (int i = 0; i < static_cast<int>(kDimensionCount); ++i) {
    const Dimension d = kDimensions[static_cast<std::size_t>(i)];
    const ToleranceLimits& limits = entry.recipe.limits[index(d)];
    const auto number = [&](const std::optional<double>& v, bool signedOne) {
      if (!v) return QStringLiteral("–");
      return signedOne ? deviationText(*v, 3) : numberText(*v, decimalsOf(d));
    };
    const QString cells[] = {spoken(d), number(nominals ? (*nominals)[index(d)] : std::nullopt, false),
                             number(limits.lowerMm, true), number(limits.upperMm, true)};
    for (int column = 0; column < 4; ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      item->setFlags(column < 2 ? Qt::ItemIsEnabled : Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable);
      limits_->setItem(i, column, item);
    }
  }
  name_->setText(shown(entry.recipe.name));
  showSettings();
  showDifference();
  showPermission();
  shareColumns();
}

void RecipesPage::chooseEditor(bool settings) {
  editors_->setCurrentIndex(settings ? 1 : 0);
  limitsButton_->setChecked(!settings);
  settingsButton_->setChecked(settings);
}

void RecipesPage::showSettings() {
  const auto all = settingsOf(entries_[static_cast<std::size_t>(chosen_)].recipe);
  settings_->setRowCount(static_cast<int>(all.size()));
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const RecipeSetting& setting = all[static_cast<std::size_t>(i)];
    auto* words = new QTableWidgetItem(settingWords(setting.key));
    words->setFlags(Qt::ItemIsEnabled);
    words->setData(Qt::UserRole, shown(setting.key));
    words->setToolTip(words->text());
    auto* value = new QTableWidgetItem(setting.text);
    value->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    settings_->setItem(i, 0, words);
    settings_->setItem(i, 1, value);
  }
}

void RecipesPage::showDifference() {
  differences_->setRowCount(0);
  const int other = against_->currentIndex();
  if (chosen_ < 0 || other < 0 || other >= static_cast<int>(entries_.size())) return;
  const auto all = recipeDifferences(entries_[static_cast<std::size_t>(other)].recipe,
                                     entries_[static_cast<std::size_t>(chosen_)].recipe);
  same_->setVisible(all.empty());
  same_->setText(tr("Both are the same."));
  difference_->setNote(all.empty() ? QString() : tr("%n value(s)", nullptr, static_cast<int>(all.size())));
  differences_->setRowCount(static_cast<int>(all.size()));
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const RecipeDifference& d = all[static_cast<std::size_t>(i)];
    const QString cells[] = {settingWords(d.key), settingValue(d.before), settingValue(d.after)};
    for (int column = 0; column < 3; ++column) {
      auto* item = new QTableWidgetItem(cells[column].isEmpty() ? QStringLiteral("–") : cells[column]);
      item->setToolTip(item->text());
      differences_->setItem(i, column, item);
    }
  }
}

void RecipesPage::showPermission() {
  const bool edits = place_.archive != nullptr && place_.session.may(Permission::EditRecipes);
  limits_->setEditTriggers(edits ? QAbstractItemView::DoubleClicked | QAbstractItemView::AnyKeyPressed |
                                       QAbstractItemView::EditKeyPressed
                                 : QAbstractItemView::NoEditTriggers);
  for (QWidget* w : std::initializer_list<QWidget*>{note_, save_, new_, import_, section_, class_})
    w->setEnabled(edits);
  settings_->setEditTriggers(limits_->editTriggers());
  name_->setEnabled(edits);
  tryButton_->setEnabled(chosen_ >= 0 && place_.archive != nullptr);
  // Operators too: what is approved may be chosen by whoever measures.
  const bool approved =
      chosen_ >= 0 && entries_[static_cast<std::size_t>(chosen_)].version.state == RecipeState::Approved;
  use_->setEnabled(approved && place_.session.may(Permission::Measure));
  use_->setToolTip(approved ? QString() : tr("Only an approved recipe is measured with."));
  const bool draft = chosen_ >= 0 && entries_[static_cast<std::size_t>(chosen_)].version.state == RecipeState::Draft;
  const bool own =
      draft && shown(entries_[static_cast<std::size_t>(chosen_)].version.createdBy) == place_.session.user();
  const bool may = place_.session.may(Permission::ApproveRecipes);
  approve_->setEnabled(draft && may && !own);
  reason_->setEnabled(approve_->isEnabled());
  password_->setEnabled(approve_->isEnabled());
  decisionWords_->setText(!draft ? tr("Only a draft is approved.")
                          : !may ? tr("QA approves: sign in.")
                          : own  ? tr("This draft is yours: somebody else approves it.")
                                 : tr("Approval retires the version before; reason and password go with your name into "
                                       "the audit trail."));
}

void RecipesPage::addDraft(Recipe recipe, const std::string& note) {
  reader_->ask("draft",
               [this, recipe = std::move(recipe), note, user = place_.session.user().toStdString()](
                   const Archive* archive, const std::string& problem) mutable -> ArchiveReader::Answer {
                 Expected<RecipeVersion> added = worldError("archive", problem);
                 if (archive != nullptr) {
                   RecipeHistory history(*archive);
                   if (const auto next = history.nextVersion(recipe.name)) recipe.version = *next;
                   added = history.addDraft(recipe, user, note);
                 }
                 return [this, added] {
                   if (added) {
                     wanted_ = added->key;
                     note_->clear();
                     result_->setText(tr("%1 v%2 is kept as a draft.").arg(shown(added->name)).arg(added->version));
                     load();
                   } else {
                     result_->setText(shown(added.error().message()));
                   }
                   emit answered();
                 };
               });
}

void RecipesPage::saveDraft() {
  if (chosen_ < 0) return;
  Recipe recipe = entries_[static_cast<std::size_t>(chosen_)].recipe;
  for (int i = 0; i < static_cast<int>(kDimensionCount); ++i) {
    const Dimension d = kDimensions[static_cast<std::size_t>(i)];
    bool fine = true;
    ToleranceLimits& limits = recipe.limits[index(d)];
    limits.lowerMm = limitFrom(limits_->item(i, 2)->text(), fine);
    limits.upperMm = limitFrom(limits_->item(i, 3)->text(), fine);
    if (!fine || (limits.lowerMm && limits.upperMm && *limits.lowerMm > *limits.upperMm)) {
      refuseAt(limits_, i,
               fine ? tr("%1: the lower limit lies above the upper one; exchange them.").arg(spoken(d))
                    : tr("%1: a limit is a number in mm, or empty for none.").arg(spoken(d)));
      return;
    }
  }
  if (note_->text().trimmed().isEmpty()) {
    result_->setText(tr("Say what is new in the draft."));
    note_->setFocus();
    emit answered();
    return;
  }
  for (int i = 0; i < settings_->rowCount(); ++i) {
    const std::string key = settings_->item(i, 0)->data(Qt::UserRole).toString().toStdString();
    if (setSetting(recipe, key, settings_->item(i, 1)->text())) continue;
    refuseAt(settings_, i, tr("%1: the value is not of its kind.").arg(settings_->item(i, 0)->text()));
    return;
  }
  if (const QString name = name_->text().trimmed(); !name.isEmpty()) recipe.name = name.toStdString();
  // The file's own checks decide: what could not be read back is not kept.
  if (const auto read = parseRecipe(toToml(recipe), recipe.name); !read) {
    for (int i = 0; i < settings_->rowCount(); ++i)
      if (read.error().where.ends_with(settings_->item(i, 0)->data(Qt::UserRole).toString().toStdString())) {
        refuseAt(settings_, i, settings_->item(i, 0)->text() + ' ' + shown(read.error().what));
        return;
      }
    result_->setText(shown(read.error().message()));
    emit answered();
    return;
  }
  addDraft(std::move(recipe), note_->text().trimmed().toStdString());
}

void RecipesPage::newFromClass() {
  const QStringList classes = class_->currentText().split('/');
  auto recipe = makeRecipe(section_->currentText().toStdString(), classes[0].toStdString(), classes[1].toStdString());
  if (recipe) {
    addDraft(std::move(*recipe), "from the class");
    return;
  }
  result_->setText(shown(recipe.error().message()));
  emit answered();
}

void RecipesPage::approve() {
  if (chosen_ < 0) return;
  const std::string reason = reason_->text().trimmed().toStdString(), password = password_->text().toStdString(),
                    user = place_.session.user().toStdString();
  password_->clear();
  reader_->ask("approve",
               [=, this, key = entries_[static_cast<std::size_t>(chosen_)].version.key](
                   const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
                 Expected<void> done = worldError("archive", problem);
                 if (archive != nullptr) {
                   const auto in = UserRegister(*archive).signIn(user, password);
                   if (!in)
                     done = tl::unexpected(in.error());
                   else if (in->result != SignInResult::Welcome)
                     done = inputError("password", "is not yours; nothing was approved");
                   else
                     done = RecipeHistory(*archive).approve(key, user, reason);
                 }
                 return [this, done] {
                   result_->setText(done ? tr("Approved.") : shown(done.error().message()));
                   if (done) {
                     reason_->clear();
                     load();
                   }
                   emit answered();
                 };
               });
}

void RecipesPage::refuseAt(QTableWidget* table, int row, const QString& words) {
  chooseEditor(table == settings_);
  table->setCurrentCell(row, table->columnCount() - 1);
  table->scrollToItem(table->item(row, 0));
  editWords_->setText(words);
  result_->setText(words);
  emit answered();
}

void RecipesPage::useForNextRail() {
  if (chosen_ < 0) return;
  const Entry& entry = entries_[static_cast<std::size_t>(chosen_)];
  const auto taken = place_.line.useRecipe(entry.recipe);
  result_->setText(taken ? tr("%1 v%2 is in force from the next rail; the rail in the gauge keeps what it began with.")
                               .arg(shown(entry.version.name))
                               .arg(entry.version.version)
                         : shown(taken.error().message()));
  if (!taken || place_.archive == nullptr) {
    emit answered();
    return;
  }
  const QString user = place_.session.user().isEmpty() ? QStringLiteral("operator") : place_.session.user();
  reader_->ask(
      "chosen",
      [this, user = user.toStdString(), subject = entry.version.name + " v" + std::to_string(entry.version.version)](
          const Archive* archive, const std::string&) -> ArchiveReader::Answer {
        if (archive != nullptr) (void)AuditTrail(*archive).add(user, "recipe chosen", subject, "for the next rail");
        return [this] { emit answered(); };
      });
}

void RecipesPage::tryOnStoredRails() {
  if (chosen_ < 0) return;
  reader_->ask("stored",
               [this, recipe = entries_[static_cast<std::size_t>(chosen_)].recipe](
                   const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
                 Expected<std::vector<RailLine>> rails = worldError("archive", problem);
                 RailQuery query;
                 query.section = recipe.section.name;
                 query.state = RailState::Finished;
                 query.limit = kMostTried;
                 if (archive != nullptr) rails = RailArchive(*archive).search(query);
                 return [this, rails = std::move(rails), recipe] {
                   if (!rails) {
                     result_->setText(shown(rails.error().message()));
                   } else if (rails->size() < WhatIfDialog::kFewRails) {
                     result_->setText(
                         tr("What if needs at least %1 stored rails of section %2, there are %3: measure more first.")
                             .arg(WhatIfDialog::kFewRails)
                             .arg(shown(recipe.section.name))
                             .arg(rails->size()));
                   } else {
                     if (whatIf_ == nullptr) whatIf_ = new WhatIfDialog(place_, *reader_, this);
                     whatIf_->setRails(recipe, *rails);
                     whatIf_->show();
                     whatIf_->start();
                   }
                   emit answered();
                 };
               });
}

SectionDialog& RecipesPage::sectionDialog() {
  if (sectionDialog_ == nullptr) {
    sectionDialog_ = new SectionDialog(place_, this);
    connect(sectionDialog_, &SectionDialog::made, this, [this](const Recipe& recipe, const QString& from) {
      addDraft(recipe, "section imported from " + from.toStdString());
    });
  }
  return *sectionDialog_;
}

void RecipesPage::importFile() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Import a recipe file"), {}, QStringLiteral("TOML (*.toml)"));
  if (file.isEmpty()) return;
  auto recipe = loadRecipe(file.toStdString());
  if (recipe)
    addDraft(std::move(*recipe), "imported from " + file.toStdString());
  else
    result_->setText(shown(recipe.error().message()));
}

void RecipesPage::exportFile() {
  if (chosen_ < 0) return;
  const Recipe& recipe = entries_[static_cast<std::size_t>(chosen_)].recipe;
  const QString proposal = shown(recipe.name).replace('/', '-').replace(' ', '_') + QStringLiteral(".toml");
  const QString file = QFileDialog::getSaveFileName(this, tr("Export the recipe"), proposal);
  if (file.isEmpty()) return;
  const auto done = writeFile(file.toStdString(), toToml(recipe));
  result_->setText(done ? tr("%1 is written").arg(file) : shown(done.error().message()));
}

}  // namespace vignole
