#pragma once
// Monitor, the operator's page: the drawing, the verdict, the thirteen dimensions, two strips, the last rails.

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "gui/bridge/units.h"
#include "gui/main_window/page.h"
#include "gui/theme/theme.h"
#include "report/profile_drawing.h"

class QButtonGroup;
class QFrame;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace vignole {

class DimensionTable;
class LastRails;
class ProfileCanvas;
class StripChart;
class VerdictPanel;

class MonitorPage : public Page {
  Q_OBJECT

 public:
  /// The recipe outlives the page.
  MonitorPage(const Theme& theme, const Units& units, const Recipe& recipe, QWidget* parent = nullptr);

  void showLine(const LineSnapshot& line, PullDetail detail) override;

  /// The drawing; on every display tick.
  void showProfile(const LineSnapshot& line);
  /// Everything that is read as words and numbers; a few times a second: digits that change faster cannot be read.
  void showFigures(const LineSnapshot& line);

  void setView(ProfileView view);
  void setMagnification(double magnification);  ///< 1 .. 100
  void magnifyMore();
  void magnifyLess();
  void resetMagnification();
  void setByCamera(bool byCamera);
  void setFullView(bool full);
  void setRunning(bool running);  ///< names the button that starts or stops the line

  [[nodiscard]] double magnification() const { return magnification_; }
  [[nodiscard]] bool byCamera() const;
  [[nodiscard]] bool fullView() const { return fullView_; }
  [[nodiscard]] DimensionTable& table() { return *table_; }
  [[nodiscard]] ProfileCanvas& canvas() { return *canvas_; }
  [[nodiscard]] VerdictPanel& verdict() { return *verdict_; }

 signals:
  void runAsked();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeToolbar();
  void bindKeys();
  void back();  ///< one step: full view, then the chosen dimension
  void relabel();
  void retranslate();
  void showUnit();
  void layOut();
  void showStrips(const LineSnapshot& line);
  void pointAtDimension(const LineSnapshot* line);

  const Theme& theme_;
  const Units& units_;
  QFrame* drawingPanel_;
  QFrame* tablePanel_;
  QWidget* toolbar_;
  QButtonGroup* views_;
  QPushButton *less_, *more_, *byCamera_, *before_, *full_, *run_;
  QLabel* magnificationLabel_;
  ProfileCanvas* canvas_;
  std::array<StripChart*, 2> strips_;
  VerdictPanel* verdict_;
  DimensionTable* table_;
  LastRails* lastRails_;
  std::vector<Dimension> stripDimensions_;
  std::optional<Dimension> worst_;
  double magnification_ = 20;
  bool fullView_ = false, running_ = false;
  bool compact_ = false;  ///< buttons of the toolbar without words
};

}  // namespace vignole
