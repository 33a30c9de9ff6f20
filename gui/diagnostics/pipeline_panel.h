#pragma once
// The pipeline as a picture: the fourteen stages of the paper's Fig. 2 with their times, the queues between them, and
// where every trigger went.

#include <QWidget>

#include "gui/bridge/line.h"
#include "gui/theme/theme.h"

namespace vignole {

/// How the window itself keeps up; shown beside the pipeline.
struct WindowHealth {
  double turnP99Ms = 0, turnMaxMs = 0;
};

class PipelinePanel : public QWidget {
  Q_OBJECT

 public:
  explicit PipelinePanel(const Theme& theme, QWidget* parent = nullptr);
  void show(const LineSnapshot& line, const WindowHealth& window);
  [[nodiscard]] QSize sizeHint() const override { return {816, 680}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {540, 380}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] const StageStatistics* stage(const std::string& name) const;
  void paintStages(QPainter& painter, const QRectF& area) const;
  void paintStage(QPainter& painter, const QRectF& box, const std::string& name) const;
  void paintQueue(QPainter& painter, const QRectF& box, const std::string& stageBehind, bool upright = false) const;
  void paintLedger(QPainter& painter, const QRectF& area) const;
  void paintReasons(QPainter& painter, const QRectF& area) const;

  const Theme& theme_;
  std::vector<StageStatistics> stages_;
  TriggerLedger triggers_;
  double profilesPerS_ = 0, expectedPerS_ = 0;
  WindowHealth window_;
};

}  // namespace vignole
