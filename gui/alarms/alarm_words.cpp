#include "gui/alarms/alarm_words.h"

#include <QCoreApplication>
#include <QLocale>

#include "report/engine_words.h"

namespace vignole {

namespace {

struct AlarmWords {
  Q_DECLARE_TR_FUNCTIONS(AlarmWords)
};

/// Here for the translators alone: what the engine's standard rules say.
[[maybe_unused]] constexpr const char* kOfRules[] = {
    QT_TRANSLATE_NOOP("AlarmRule", "A camera does not answer while a rail passes."),
    QT_TRANSLATE_NOOP("AlarmRule", "Its quarter of the profile is missing; rails pass unmeasured."),
    QT_TRANSLATE_NOOP(
        "AlarmRule",
        "Check power and network cable of the camera, then Diagnostics; stop the line if it does not come back."),
    QT_TRANSLATE_NOOP("AlarmRule", "Too many triggers give no complete profile."),
    QT_TRANSLATE_NOOP("AlarmRule", "Stretches of the rail are not measured."),
    QT_TRANSLATE_NOOP("AlarmRule", "See Diagnostics for the camera that loses frames; check network load and trigger."),
    QT_TRANSLATE_NOOP("AlarmRule", "Too many profiles do not fit the section of the recipe."),
    QT_TRANSLATE_NOOP("AlarmRule", "The dimensions of this rail are not to be trusted."),
    QT_TRANSLATE_NOOP("AlarmRule",
                      "Check that the recipe is the one of the rail that runs; look at Stripes for glare or scale."),
    QT_TRANSLATE_NOOP("AlarmRule", "The measurement has stopped while a rail passes."),
    QT_TRANSLATE_NOOP("AlarmRule", "Rails pass unmeasured."),
    QT_TRANSLATE_NOOP("AlarmRule", "Start the measurement; if it stops again, save a support bundle in Diagnostics."),
    QT_TRANSLATE_NOOP("AlarmRule", "A rail has a stretch out of tolerance."),
    QT_TRANSLATE_NOOP("AlarmRule", "The rail must not be delivered as it is."),
    QT_TRANSLATE_NOOP("AlarmRule",
                      "Mark the rail, see its exceptions on Rails, tell the rolling mill which dimension and where."),
    QT_TRANSLATE_NOOP("AlarmRule", "The rail looks like another section than that of the recipe."),
    QT_TRANSLATE_NOOP("AlarmRule", "It is judged by the wrong tolerances."),
    QT_TRANSLATE_NOOP("AlarmRule", "Choose the recipe of the rail that is rolled."),
    QT_TRANSLATE_NOOP("AlarmRule", "The calibration in force is refused, missing or out of date."),
    QT_TRANSLATE_NOOP("AlarmRule", "Uncertainties are not what the reports state."),
    QT_TRANSLATE_NOOP("AlarmRule", "Calibrate, or bring back an earlier calibration."),
    QT_TRANSLATE_NOOP("AlarmRule", "The seam between two cameras has moved in normal production."),
    QT_TRANSLATE_NOOP("AlarmRule", "Dimensions across the seam are biased by about as much."),
    QT_TRANSLATE_NOOP(
        "AlarmRule",
        "Check the mounting of the cameras beside the seam; calibrate the range finders at the next pause."),
    QT_TRANSLATE_NOOP("AlarmRule", "A camera loses frames."),
    QT_TRANSLATE_NOOP("AlarmRule", "Profiles are incomplete now and then."),
    QT_TRANSLATE_NOOP("AlarmRule", "Check cable, switch and packet size of the camera."),
    QT_TRANSLATE_NOOP("AlarmRule", "Much of a laser line is saturated."),
    QT_TRANSLATE_NOOP("AlarmRule", "Points on bright patches are less certain."),
    QT_TRANSLATE_NOOP("AlarmRule", "Shorten the exposure of the camera or clean the window."),
    QT_TRANSLATE_NOOP("AlarmRule", "A laser line is faint."),
    QT_TRANSLATE_NOOP("AlarmRule", "Points are missing or uncertain."),
    QT_TRANSLATE_NOOP("AlarmRule", "Clean the windows, check the laser, lengthen the exposure."),
    QT_TRANSLATE_NOOP("AlarmRule", "The rig is warmer than its calibration allows."),
    QT_TRANSLATE_NOOP("AlarmRule", "Positions of cameras and lasers move."),
    QT_TRANSLATE_NOOP("AlarmRule", "Check cooling and air; calibrate if it stays so."),
    QT_TRANSLATE_NOOP("AlarmRule", "The disk is nearly full."),
    QT_TRANSLATE_NOOP("AlarmRule", "Records of rails cannot be kept."),
    QT_TRANSLATE_NOOP("AlarmRule", "Prune the archive or enlarge the disk."),
    QT_TRANSLATE_NOOP("AlarmRule", "The archive does not answer."),
    QT_TRANSLATE_NOOP("AlarmRule", "Rails are measured; their records wait on this machine's disk."),
    QT_TRANSLATE_NOOP("AlarmRule", "Check database and network; records are sent when it is back."),
    QT_TRANSLATE_NOOP("AlarmRule", "The queues of the measurement fill up."),
    QT_TRANSLATE_NOOP("AlarmRule", "Profiles will be dropped."),
    QT_TRANSLATE_NOOP("AlarmRule", "Close what else runs on this machine; lower the trigger rate."),
    QT_TRANSLATE_NOOP("AlarmRule", "A toleranced dimension is not measured while a rail passes."),
    QT_TRANSLATE_NOOP("AlarmRule", "The rail cannot be judged by it."),
    QT_TRANSLATE_NOOP("AlarmRule", "Clean windows and check lasers; see Stripes for where the line is missing."),
    QT_TRANSLATE_NOOP("AlarmRule", "The window answers slowly."),
    QT_TRANSLATE_NOOP("AlarmRule", "What it shows is late; the measurement goes on."),
    QT_TRANSLATE_NOOP("AlarmRule", "Close what else runs on this machine; see Diagnostics."),
};

/// "WT from 12.30 m" -> "WT"
QString firstWord(const std::string& text) { return QString::fromStdString(text.substr(0, text.find(' '))); }

}  // namespace

QString ruleWords(const std::string& english) { return QCoreApplication::translate("AlarmRule", english.c_str()); }

QString alarmTitle(const AlarmRule& rule, const std::string& source, const std::vector<std::string>& details) {
  if (rule.id == "rail.out-of-tolerance" && !details.empty()) {
    QStringList names;
    for (const std::string& detail : details)
      if (const QString name = firstWord(detail); !names.contains(name)) names << name;
    QString which = names.join(AlarmWords::tr(", "));
    if (names.size() > 1)
      which = AlarmWords::tr("%1 and %2").arg(names.mid(0, names.size() - 1).join(AlarmWords::tr(", ")), names.last());
    const QString rail = QString::fromStdString(source).section(' ', 1);
    return AlarmWords::tr("Rail %1 out of tolerance: %2").arg(rail, which);
  }
  if (rule.id == "camera.lost" && !source.empty())
    return AlarmWords::tr("Camera %1 lost").arg(QString::fromStdString(source).section(' ', -1));
  QString cause = ruleWords(rule.cause);
  while (cause.endsWith('.') || cause.endsWith(QChar(0x3002))) cause.chop(1);
  if (source.empty() || source == "line" || source == "pipeline" || source == "archive" || source == "calibration" ||
      source == "window" || source == "disk")
    return cause;
  return AlarmWords::tr("%1: %2").arg(cause, inWords(source));
}

QString causeWords(const AlarmRule& rule, const Alarm& alarm) {
  QStringList details;
  for (const std::string& d : alarm.details) details << inWords(d);
  if (alarm.value)
    details << QStringLiteral("%1 %2").arg(QLocale().toString(*alarm.value, 'f', 1), QString::fromStdString(rule.unit));
  return details.isEmpty() ? ruleWords(rule.cause) : details.join(QStringLiteral("; "));
}

QString personWord(const std::string& who) {
  if (who.empty()) return QStringLiteral("–");
  return who == "operator" ? inWords(who) : QString::fromStdString(who);
}

QDateTime localTime(AlarmTime time) { return QDateTime::fromMSecsSinceEpoch(time.time_since_epoch().count()); }

}  // namespace vignole
