#pragma once
// Quality: does the gauge repeat, and is it right? Runs of the same rail from the archive, a table or the virtual rig,
// laid over each other: the paper's Fig. 9, Table VI and Table V, ISO 5725 figures with their outlier tests.

#include <memory>
#include <vector>

#include "engine/archive/rail_archive.h"
#include "gui/bridge/workplace.h"
#include "gui/main_window/page.h"
#include "gui/quality/runs_study.h"
#include "gui/quality/study_report.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace vignole {

class ArchiveReader;
class Panel;
class RigExperiment;
class RunsPlot;

class QualityPage : public Page {
  Q_OBJECT

 public:
  enum class Source { Archive, File, VirtualRig };

  explicit QualityPage(Workplace& place, QWidget* parent = nullptr);
  ~QualityPage() override;
  void showLine(const LineSnapshot& line, PullDetail detail) override;

  void load();                        ///< which rails there are
  void setRun(int row, bool chosen);  ///< of the list
  void setSource(Source source);
  void openRuns(const QString& file);       ///< a CSV of runs
  void openReference(const QString& file);  ///< a CSV of a CMM or a MiniProf
  void runExperiment();                     ///< five inspections on the virtual rig; while one runs: cancels it
  void showKind(RunsStudyKind kind);
  void study();  ///< the chosen runs, anew
  void choose(Dimension dimension);
  void saveReport(const QString& pdfFile);
  void saveValues(const QString& csvFile);

  [[nodiscard]] const std::vector<RailLine>& rails() const { return rails_; }
  [[nodiscard]] Dimension chosen() const { return dimension_; }
  [[nodiscard]] const std::shared_ptr<const RunsStudy>& studied() const { return study_; }
  /// Of the chosen dimension; null: none.
  [[nodiscard]] const RepeatabilityResult* result() const;
  [[nodiscard]] const AccuracyResult* accuracy() const;
  [[nodiscard]] QString words() const;  ///< what is said below the runs

 signals:
  void railsChanged();
  void resultChanged();  ///< an answer has come, good or not
  void saved();          ///< a file is written, or could not be

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  using Runs = std::vector<MeasuredRun>;
  QWidget* makeRuns();
  QWidget* makeResult();
  void bindKeys();
  void retranslate();
  void showRuns();
  void showSource();
  void showStudy();
  void showRepeatability();
  void showAccuracy();
  void showTable();
  void showFigures();
  void refuse(const QString& problem);
  void studyStored(const std::vector<RailLine>& chosen);
  void studyRead(const Runs& chosen);
  void answer(const Expected<RunsStudy>& study, const Recipe& recipe);
  [[nodiscard]] QString lengthText(double mm, bool withSign = false) const;
  [[nodiscard]] QString conditions() const;

  Workplace& place_;
  std::unique_ptr<ArchiveReader> reader_;
  Source source_ = Source::Archive;
  RunsStudyKind kind_ = RunsStudyKind::Repeatability;
  Dimension dimension_ = Dimension::RH;
  std::vector<RailLine> rails_;
  Runs fileRuns_, rigRuns_;
  QString fileName_;
  RunReference fileReference_, rigTruth_;
  std::shared_ptr<const RunsStudy> study_;
  std::shared_ptr<const Recipe> recipe_;  ///< whose limits `study_` was judged by
  QString problem_;
  std::unique_ptr<RigExperiment> experiment_;
  Panel *runPanel_, *upperPanel_, *lowerPanel_, *tablePanel_, *figurePanel_;
  QPushButton *repeatabilityButton_, *accuracyButton_;
  QComboBox *sources_, *window_, *length_;
  QTableWidget *runs_, *table_, *figures_;
  QPushButton *open_, *reference_, *experimentButton_, *compare_, *report_, *export_;
  QProgressBar* progress_;
  QLabel *words_, *symbol_, *verdict_, *reason_;
  RunsPlot *upper_, *lower_;
};

}  // namespace vignole
