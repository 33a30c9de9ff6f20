#pragma once
// The pipeline as a picture: the fourteen stages of the paper's Fig. 2 with their times, and the queues between them.

#include <QWidget>

#include "gui/bridge/line.h"
#include "gui/theme/theme.h"

namespace vignole {

class PipelinePanel : public QWidget {
  Q_OBJECT

 public:
  explicit PipelinePanel(const Theme& theme, QWidget* parent = nullptr);
  void show(const LineSnapshot& line);
  [[nodiscard]] QSize sizeHint() const override { return {1400, 380}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {900, 250}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] const StageStatistics* stage(const std::string& name) const;
  void paintStages(QPainter& painter, const QRectF& area) const;
  void paintStage(QPainter& painter, const QRectF& box, const std::string& name) const;
  void paintQueue(QPainter& painter, const QRectF& box, const std::string& stageBehind) const;

  const Theme& theme_;
  std::vector<StageStatistics> stages_;
  TriggerLedger triggers_;
  double expectedPerS_ = 0;
};

}  // namespace vignole
