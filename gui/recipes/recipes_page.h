#pragma once
// Recipes: what is measured and how, with versions; drafts with other tolerances, what differs, approval by somebody
// else than the author.

#include <memory>
#include <vector>

#include "engine/archive/recipe_history.h"
#include "engine/recipe/recipe.h"
#include "gui/bridge/workplace.h"
#include "gui/main_window/page.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;
class QTableWidget;

namespace vignole {

class ArchiveReader;
class Panel;
class SectionDialog;
class WhatIfDialog;

class RecipesPage : public Page {
  Q_OBJECT

 public:
  explicit RecipesPage(Workplace& place, QWidget* parent = nullptr);
  ~RecipesPage() override;
  void showLine(const LineSnapshot& line, PullDetail detail) override;

  /// One that can be chosen: of the program (key 0) or of the archive.
  struct Entry {
    RecipeVersion version;
    Recipe recipe;
  };
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  void choose(int entry);
  [[nodiscard]] int chosen() const { return chosen_; }
  [[nodiscard]] SectionDialog& sectionDialog();
  [[nodiscard]] const WhatIfDialog* whatIfDialog() const { return whatIf_; }  ///< null: not asked yet
  [[nodiscard]] QString words() const;                                        ///< what came of the last command
  void load();

 signals:
  void entriesChanged();
  void answered();  ///< to a draft, an approval, an import, a choice

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeList();
  QWidget* makeEdit();
  QWidget* makeDecision();
  void retranslate();
  void showEntries();
  void compareWithOlder();
  void showChosen();
  void showDifference();
  void showPermission();
  void showSettings();
  void shareColumns();
  void chooseEditor(bool settings);
  void saveDraft();
  void refuseAt(QTableWidget* table, int row, const QString& words);
  void useForNextRail();
  void tryOnStoredRails();
  void newFromClass();
  void approve();
  void importFile();
  void exportFile();
  void addDraft(Recipe recipe, const std::string& note);

  Workplace& place_;
  std::unique_ptr<ArchiveReader> reader_;
  std::vector<Entry> entries_;
  int chosen_ = -1;
  std::int64_t wanted_ = 0;  ///< key of the entry to be chosen when they come
  Panel *list_, *edit_, *difference_, *decision_;
  QTableWidget *table_, *limits_, *settings_, *differences_;
  QStackedWidget* editors_;
  QComboBox *section_, *class_, *against_;
  QLineEdit *name_, *note_, *reason_, *password_;
  QPushButton *new_, *import_, *export_, *sectionButton_, *tryButton_, *save_, *approve_, *use_;
  QPushButton *limitsButton_, *settingsButton_;
  QLabel *empty_, *onLine_, *editWords_, *same_, *decisionWords_, *result_;
  SectionDialog* sectionDialog_ = nullptr;
  WhatIfDialog* whatIf_ = nullptr;
};

}  // namespace vignole
