#pragma once
// Charts: one dimension of a rail over its length against its limits, beside the rails before; every rail's mean and
// extremes; how often which value.

#include <array>
#include <memory>

#include "gui/bridge/workplace.h"
#include "gui/charts/chart_data.h"
#include "gui/main_window/page.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace vignole {

class ArchiveReader;
class HistogramPlot;
class Panel;
class TolerancePlot;

class ChartsPage : public Page {
  Q_OBJECT

 public:
  explicit ChartsPage(Workplace& place, QWidget* parent = nullptr);
  ~ChartsPage() override;
  void showLine(const LineSnapshot& line, PullDetail detail) override;

  void load(std::int64_t key);  ///< 0: the newest
  void choose(Dimension dimension);
  [[nodiscard]] Dimension dimension() const { return dimension_; }
  [[nodiscard]] const std::shared_ptr<const ChartData>& data() const { return data_; }
  [[nodiscard]] TolerancePlot& chart() { return *chart_; }
  [[nodiscard]] TolerancePlot& perRail() { return *perRail_; }

 signals:
  void dataChanged();

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void bindKeys();
  void retranslate();
  void showAll();
  void showDimensions();
  void showChart();
  void showPerRail();
  void showFigures();
  void layOutTables();
  void showCursor();
  void moveCursor(int values);
  void save();

  Workplace& place_;
  std::unique_ptr<ArchiveReader> reader_;
  std::shared_ptr<const ChartData> data_;
  QString problem_;
  Dimension dimension_ = Dimension::RH;
  std::uint64_t railsPassed_ = 0;
  bool newest_ = true;  ///< follows the newest rail
  Panel *dimensionPanel_, *chartPanel_, *railPanel_, *histogramPanel_, *figurePanel_;
  QTableWidget *dimensions_, *figures_;
  QComboBox* rail_;
  QPushButton *fit_, *export_;
  QLabel *empty_, *cursorText_;
  TolerancePlot *chart_, *perRail_;
  HistogramPlot* histogram_;
};

}  // namespace vignole
