#pragma once
// Diagnostics, the technician's page: the pipeline as a picture, where every trigger went, cameras, computer, window.

#include <array>

#include "gui/bridge/self_test.h"
#include "gui/bridge/workplace.h"
#include "gui/main_window/page.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace vignole {

class Panel;
class PipelinePanel;

class DiagnosticsPage : public Page {
  Q_OBJECT

 public:
  /// Workplace and watchdog outlive the page.
  DiagnosticsPage(Workplace& place, const EventLoopWatchdog& watchdog, QWidget* parent = nullptr);
  void showLine(const LineSnapshot& line, PullDetail detail) override;

  /// Everything that a person who helps from afar wants to know, as JSON; no names, no passwords.
  [[nodiscard]] QByteArray supportText() const;
  [[nodiscard]] const QTableWidget& ledger() const { return *ledger_; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void showLedger(const LineSnapshot& line);
  void showCameras(const LineSnapshot& line);
  void showComputer();
  void saveSupport();

  Workplace& place_;
  const EventLoopWatchdog& watchdog_;
  Panel *pipelinePanel_, *ledgerPanel_, *cameraPanel_, *computerPanel_;
  PipelinePanel* pipeline_;
  QTableWidget *ledger_, *cameras_, *computer_;
  QLabel* cameraNote_;
  QPushButton* support_;
  LineSnapshot last_;
  ProcessUse before_;
  std::array<std::uint64_t, kCameraCount> framesBefore_{};
  std::array<double, kCameraCount> framesPerS_{};
  double framesSince_ = 0, cpuShare_ = 0, windowShare_ = 0;
};

}  // namespace vignole
