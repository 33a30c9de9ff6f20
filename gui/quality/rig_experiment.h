#pragma once
// The paper's section IV on the virtual rig: the same rail inspected several times by the same rig, with other wander,
// vibration, scale, speckle and noise. The truth of every profile is known.

#include <QObject>
#include <QTimer>
#include <atomic>
#include <mutex>
#include <thread>

#include "engine/simulator/virtual_rig.h"
#include "gui/quality/measured_runs.h"

namespace vignole {

struct RigExperimentResult {
  std::vector<MeasuredRun> runs;
  RunReference truth;
  std::string problem;  ///< one line; empty: all runs are whole
};

class RigExperiment : public QObject {
  Q_OBJECT

 public:
  explicit RigExperiment(QObject* parent = nullptr);
  ~RigExperiment() override;  ///< cancels and joins

  /// `rig`: its seed draws the rail, its pass seeds are ours. Does nothing while one is under way.
  void start(VirtualRigSettings rig, Recipe recipe, double lengthMm, int runs);
  void cancel();  ///< asks; finished() comes all the same
  [[nodiscard]] bool running() const { return running_; }
  [[nodiscard]] const RigExperimentResult& result() const { return result_; }

 signals:
  void progressed(int percent);
  void finished();

 private:
  void work(const std::stop_token& stop, VirtualRigSettings rig, const Recipe& recipe, double lengthMm, int runs);

  bool running_ = false;
  std::atomic<std::uint64_t> done_ = 0, all_ = 1;
  RigExperimentResult result_;
  std::mutex mutex_;
  RigExperimentResult made_;
  QTimer ticks_;
  std::jthread thread_;
};

}  // namespace vignole
