#pragma once
// Quality: does the gauge repeat? Runs of the same rail from the archive, laid over each other: the paper's Fig. 9 and
// Table VI, ISO 5725 figures with their outlier tests.

#include <memory>
#include <optional>
#include <vector>

#include "engine/archive/rail_archive.h"
#include "engine/quality/repeatability.h"
#include "gui/bridge/workplace.h"
#include "gui/main_window/page.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace vignole {

class ArchiveReader;
class Panel;
class RunsPlot;

class QualityPage : public Page {
  Q_OBJECT

 public:
  explicit QualityPage(Workplace& place, QWidget* parent = nullptr);
  ~QualityPage() override;
  void showLine(const LineSnapshot& line, PullDetail detail) override;

  void load();                        ///< which rails there are
  void setRun(int row, bool chosen);  ///< of the list
  void study();                       ///< the chosen ones, anew
  void choose(Dimension dimension);
  [[nodiscard]] const std::vector<RailLine>& rails() const { return rails_; }
  [[nodiscard]] const std::optional<RepeatabilityResult>& result() const { return result_; }

 signals:
  void railsChanged();
  void resultChanged();  ///< an answer has come, good or not

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void showResult();
  void saveReport();

  Workplace& place_;
  std::unique_ptr<ArchiveReader> reader_;
  std::vector<RailLine> rails_;
  std::optional<RepeatabilityResult> result_;
  QString problem_;
  Dimension dimension_ = Dimension::RH;
  Panel *runPanel_, *valuePanel_, *rangePanel_, *tablePanel_, *figurePanel_;
  QTableWidget *runs_, *table_, *figures_;
  QComboBox *dimensions_, *window_;
  QPushButton *study_, *export_;
  QLabel *words_, *conditions_;
  RunsPlot *values_, *ranges_;
};

}  // namespace vignole
