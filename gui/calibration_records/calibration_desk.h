#pragma once
// The calibrations that the archive keeps, and the one way in which another one comes into force: with a name, a
// reason, an entry in the audit trail, and the line using it from the next rail on.

#include <QObject>
#include <functional>
#include <memory>
#include <vector>

#include "engine/archive/calibration_history.h"
#include "gui/bridge/workplace.h"

namespace vignole {

class ArchiveReader;

/// One of the archive, as it was kept.
struct KeptCalibration {
  StoredCalibration entry;
  RigCalibration calibration;
  std::string problem;  ///< cannot be read
  bool ofThisRig = false;
};

class CalibrationDesk : public QObject {
  Q_OBJECT

 public:
  explicit CalibrationDesk(Workplace& place, QObject* parent = nullptr);
  ~CalibrationDesk() override;

  void load();
  [[nodiscard]] const std::vector<KeptCalibration>& all() const { return all_; }   ///< newest first
  [[nodiscard]] const std::vector<CalibrationUse>& uses() const { return uses_; }  ///< newest first
  [[nodiscard]] const QString& problem() const { return problem_; }                ///< why there is no history
  /// Empty, or why nobody or not this person may put one in force: a sentence with what to do.
  [[nodiscard]] QString hindrance() const;
  /// `done` in the window's thread; empty: it is in force. A calibration that is kept already is not kept twice.
  void putInForce(const RigCalibration& calibration, const QString& reason, std::function<void(const QString&)> done);

 signals:
  void changed();

 private:
  Workplace& place_;
  std::unique_ptr<ArchiveReader> reader_;
  std::vector<KeptCalibration> all_;
  std::vector<CalibrationUse> uses_;
  QString problem_;
};

}  // namespace vignole
