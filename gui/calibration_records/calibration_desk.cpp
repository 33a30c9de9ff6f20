#include "gui/calibration_records/calibration_desk.h"

#include <map>

#include "gui/bridge/archive_reader.h"
#include "gui/bridge/calibration_in_force.h"

namespace vignole {

CalibrationDesk::CalibrationDesk(Workplace& place, QObject* parent)
    : QObject(parent), place_(place), reader_(std::make_unique<ArchiveReader>(place.archive ? place.archiveUrl : "")) {}

CalibrationDesk::~CalibrationDesk() { reader_.reset(); }

void CalibrationDesk::load() {
  if (place_.archive == nullptr) {
    problem_ = tr("Calibrations are not kept: %1. Start the program with an archive (--archive FILE).")
                   .arg(QString::fromStdString(place_.archiveProblem));
    emit changed();
    return;
  }
  reader_->ask("load",
               [this, rig = place_.line.calibration()](const Archive* archive,
                                                       const std::string& problem) -> ArchiveReader::Answer {
                 const auto fails = [this](const std::string& why) -> ArchiveReader::Answer {
                   return [this, why] {
                     problem_ = QString::fromStdString(why);
                     emit changed();
                   };
                 };
                 if (archive == nullptr) return fails(problem);
                 const CalibrationHistory history(*archive);
                 auto entries = history.all();
                 if (!entries) return fails(entries.error().message());
                 auto uses = history.uses();
                 if (!uses) return fails(uses.error().message());
                 std::vector<KeptCalibration> all;
                 for (StoredCalibration& entry : *entries) {
                   KeptCalibration kept;
                   auto text = history.text(entry.key);
                   auto calibration = text ? parseCalibration(*text, entry.id) : tl::unexpected<Error>(text.error());
                   if (calibration) {
                     kept.calibration = *std::move(calibration);
                     kept.ofThisRig = ofTheSameRig(kept.calibration, rig);
                   } else {
                     kept.problem = calibration.error().message();
                   }
                   kept.entry = std::move(entry);
                   all.push_back(std::move(kept));
                 }
                 return [this, all = std::move(all), uses = *std::move(uses)] {
                   all_ = all;
                   uses_ = uses;
                   problem_.clear();
                   emit changed();
                 };
               });
}

QString CalibrationDesk::hindrance() const {
  if (!place_.session.may(Permission::Calibrate))
    return tr("Calibrating is the technician's: sign in as technician or QA (Settings, F10).");
  if (place_.archive == nullptr)
    return tr(
        "There is no archive, so a calibration could neither be kept nor reverted: start the program with "
        "--archive FILE.");
  return {};
}

void CalibrationDesk::putInForce(const RigCalibration& calibration, const QString& reason,
                                 std::function<void(const QString&)> done) {
  if (const QString why = hindrance(); !why.isEmpty()) {
    done(why);
    return;
  }
  if (reason.trimmed().isEmpty()) {
    done(tr("Another calibration needs a reason."));
    return;
  }
  reader_->ask("put in force",
               [this, calibration, user = place_.session.user().toStdString(), why = reason.trimmed().toStdString(),
                done = std::move(done)](const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
                 std::string failed = problem;
                 if (archive != nullptr) {
                   failed.clear();
                   CalibrationHistory history(*archive);
                   const auto key = history.add(calibration, user, why);
                   if (!key)
                     failed = key.error().message();
                   else if (const auto put = history.putInForce(*key, user, why); !put)
                     failed = put.error().message();
                 }
                 return [this, failed, calibration, done] {
                   if (failed.empty()) {
                     place_.line.useCalibration(calibration);
                     load();
                   }
                   done(QString::fromStdString(failed));
                 };
               });
}

}  // namespace vignole
