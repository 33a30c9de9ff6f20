#pragma once
// Monitor, the operator's page: the drawing, the verdict, the thirteen dimensions, two strips, the last rails.

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "gui/main_window/page.h"
#include "gui/monitor/pipeline_panel.h"
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
  MonitorPage(const Theme& theme, const Recipe& recipe, QWidget* parent = nullptr);

  void showLine(const LineSnapshot& line, PullDetail detail) override;
  void setWindowHealth(const WindowHealth& window) { window_ = window; }

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
  void setPipelineShown(bool shown);

  [[nodiscard]] double magnification() const { return magnification_; }
  [[nodiscard]] bool byCamera() const;
  [[nodiscard]] bool fullView() const { return fullView_; }
  [[nodiscard]] bool pipelineShown() const { return pipelineShown_; }
  [[nodiscard]] DimensionTable& table() { return *table_; }
  [[nodiscard]] ProfileCanvas& canvas() { return *canvas_; }
  [[nodiscard]] VerdictPanel& verdict() { return *verdict_; }

 signals:
  void fullViewChanged(bool full);
  void pipelineShownChanged(bool shown);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeToolbar();
  void layOut();
  void showStrips(const LineSnapshot& line);
  void pointAtDimension(const LineSnapshot* line);

  const Theme& theme_;
  QFrame* drawingPanel_;
  QFrame* tablePanel_;
  QWidget* toolbar_;
  QButtonGroup* views_;
  QPushButton *less_, *more_, *byCamera_;
  QLabel* magnificationLabel_;
  ProfileCanvas* canvas_;
  PipelinePanel* pipeline_;
  std::array<StripChart*, 2> strips_;
  VerdictPanel* verdict_;
  DimensionTable* table_;
  LastRails* lastRails_;
  std::vector<Dimension> stripDimensions_;
  std::optional<Dimension> worst_;
  double magnification_ = 20;
  WindowHealth window_{};
  bool fullView_ = false, pipelineShown_ = false;
};

}  // namespace vignole
