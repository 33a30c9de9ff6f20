#pragma once
// A section looked at, or brought along: read from a DXF, a JSON or a MiniProf design, drawn with its primitives named,
// or refused with the first open gap on the drawing.

#include <QDialog>
#include <optional>

#include "engine/recipe/recipe.h"
#include "gui/bridge/workplace.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace vignole {

class SectionDrawing;

class SectionDialog : public QDialog {
  Q_OBJECT

 public:
  explicit SectionDialog(Workplace& place, QWidget* parent = nullptr);
  void showSection(const Section& section);  ///< to look at
  void openFile(const QString& file);        ///< to bring along
  /// Keeps the section's file beside the archive; made() has a recipe of it.
  void make();
  [[nodiscard]] const std::optional<Section>& section() const { return section_; }
  [[nodiscard]] QString words() const;
  [[nodiscard]] const SectionDrawing& drawing() const { return *drawing_; }

 signals:
  void made(const Recipe& recipe, const QString& from);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void read();
  void showFacts();

  Workplace& place_;
  QString file_;
  std::optional<Section> section_;
  SectionDrawing* drawing_;
  QTableWidget* table_;
  QLabel *words_, *facts_, *nameWord_, *classWord_;
  QLineEdit* name_;
  QComboBox* class_;
  QPushButton *open_, *make_, *close_;
};

}  // namespace vignole
