#pragma once
// Diagnostics, the technician's page: the pipeline as a picture, where every trigger went, cameras, computer, window.

#include <array>
#include <memory>
#include <optional>

#include "gui/bridge/self_test.h"
#include "gui/bridge/workplace.h"
#include "gui/diagnostics/computer_watch.h"
#include "gui/main_window/page.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace vignole {

class Panel;
class PipelinePanel;
class SupportBundle;

class DiagnosticsPage : public Page {
  Q_OBJECT

 public:
  /// Workplace and watchdog outlive the page.
  DiagnosticsPage(Workplace& place, const EventLoopWatchdog& watchdog, QWidget* parent = nullptr);
  void showLine(const LineSnapshot& line, PullDetail detail) override;

  /// Everything that a person who helps from afar wants to know, as JSON; no names, no passwords.
  [[nodiscard]] QByteArray supportText() const;
  /// A folder of its own is made in `parent`: state, recipe, calibration, pictures of the cameras. False: one is being
  /// written already.
  bool saveSupport(const QString& parent);
  [[nodiscard]] const QTableWidget& ledger() const { return *ledger_; }
  [[nodiscard]] const QTableWidget& computer() const { return *computer_; }
  [[nodiscard]] const QTableWidget& cameras() const { return *cameras_; }
  [[nodiscard]] QString note() const;  ///< what became of the last bundle

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void showLedger(const LineSnapshot& line);
  void showCameras(const LineSnapshot& line);
  void showConsumers();
  void showComputer();
  void showShares();
  void supportPressed();
  void showSupport();

  Workplace& place_;
  const EventLoopWatchdog& watchdog_;
  Panel *pipelinePanel_, *ledgerPanel_, *cameraPanel_, *computerPanel_;
  PipelinePanel* pipeline_;
  QTableWidget *ledger_, *cameras_, *computer_;
  QLabel *cameraNote_, *supportNote_;
  QPushButton* support_;
  QProgressBar* progress_;
  SupportBundle* bundle_;
  ComputerWatch computerWatch_;
  std::shared_ptr<const ComputerState> computerState_;
  LineSnapshot last_;
  ProcessUse before_;
  std::array<std::uint64_t, kCameraCount> framesBefore_{};
  std::array<double, kCameraCount> framesPerS_{};
  double framesSince_ = 0, cpuShare_ = 0, windowShare_ = 0, picturesPerS_ = 0;
  int pictures_ = 0;  ///< display ticks since `before_`
  QString supportFolder_, supportSaid_;
};

}  // namespace vignole
