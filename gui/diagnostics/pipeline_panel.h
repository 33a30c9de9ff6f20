#pragma once
// The pipeline as a picture: the fourteen stages of the paper's Fig. 2 with their times, and the queues between them.

#include <QStringList>
#include <QWidget>

#include "gui/bridge/line.h"
#include "gui/theme/theme.h"

namespace vignole {

/// Who takes what has been measured, behind the last stage.
struct Consumer {
  QString name, note;
  std::size_t queued = 0, highWater = 0, capacity = 0;  ///< capacity 0: there is no queue
  bool near = false, out = false;                       ///< falls behind, fails
};

class PipelinePanel : public QWidget {
  Q_OBJECT

 public:
  explicit PipelinePanel(const Theme& theme, QWidget* parent = nullptr);
  void show(const LineSnapshot& line);
  void setConsumers(std::vector<Consumer> consumers);
  [[nodiscard]] QSize sizeHint() const override { return {1400, 380}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {900, 250}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] const StageStatistics* stage(const std::string& name) const;
  void paintStages(QPainter& painter, const QRectF& area) const;
  void paintStage(QPainter& painter, const QRectF& box, const std::string& name) const;
  void paintTallStage(QPainter& painter, const QRectF& box, const std::string& name, const QStringList& notes) const;
  void paintQueue(QPainter& painter, const QRectF& box, const std::string& stageBehind) const;
  void paintQueue(QPainter& painter, const QRectF& box, std::size_t depth, std::size_t highWater, std::size_t capacity,
                  bool dropped) const;
  void paintConsumers(QPainter& painter, double fromX, double middleY, const QRectF& area) const;
  void paintLegend(QPainter& painter) const;
  void paintBox(QPainter& painter, const QRectF& box, bool near, bool out) const;
  [[nodiscard]] bool behind(const std::string& name) const;

  const Theme& theme_;
  std::vector<StageStatistics> stages_;
  std::vector<Consumer> consumers_;
  QStringList profileNotes_, measureNotes_;
  TriggerLedger triggers_;
  double expectedPerS_ = 0;
};

}  // namespace vignole
