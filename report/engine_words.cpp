#include "report/engine_words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <vector>

#include "report/dimension_text.h"

namespace vignole {

namespace {

// %1, %2 ... stand for what changes: numbers, names, further sentences. The more particular comes first.
constexpr const char* kSentences[] = {
    QT_TRANSLATE_NOOP("Engine", "wrong section: looks like %1 rather than %2"),
    QT_TRANSLATE_NOOP("Engine", "wrong section: looks like %1"),
    QT_TRANSLATE_NOOP("Engine", "not registered: %1"),
    QT_TRANSLATE_NOOP("Engine", "not registered"),
    QT_TRANSLATE_NOOP("Engine", "looks like %1"),
    QT_TRANSLATE_NOOP("Engine",
                      "the points do not agree with %1: %2 lie on it, rms %3 mm; another rail, badly worn, or not a "
                      "rail?"),
    QT_TRANSLATE_NOOP("Engine", "the points do not agree with %1"),
    QT_TRANSLATE_NOOP("Engine", "the section has no web"),
    QT_TRANSLATE_NOOP("Engine", "the points do not determine a pose"),
    QT_TRANSLATE_NOOP("Engine", "the foot edge is not upright"),
    QT_TRANSLATE_NOOP("Engine", "the crown is flat"),
    QT_TRANSLATE_NOOP("Engine", "points do not reach x = %1 from the axis"),
    QT_TRANSLATE_NOOP("Engine", "points do not reach the crown on the axis"),
    QT_TRANSLATE_NOOP("Engine", "points do not reach %1 above the base line"),
    QT_TRANSLATE_NOOP("Engine", "not defined on this section"),
    QT_TRANSLATE_NOOP("Engine", "no point is near the outline of %1"),
    QT_TRANSLATE_NOOP("Engine", "no base line: %1"),
    QT_TRANSLATE_NOOP("Engine", "measurement failed"),
    QT_TRANSLATE_NOOP("Engine", "extraction failed"),
    QT_TRANSLATE_NOOP("Engine", "translation failed"),
    QT_TRANSLATE_NOOP("Engine", "the profile is not registered"),
    QT_TRANSLATE_NOOP("Engine", "no points on %1"),
    QT_TRANSLATE_NOOP("Engine", "only %1 point on %2, %3 are needed"),
    QT_TRANSLATE_NOOP("Engine", "only %1 points on %2, %3 are needed"),
    QT_TRANSLATE_NOOP("Engine", "only %1 points, at least %2 are needed"),
    QT_TRANSLATE_NOOP("Engine", "the points on %1 make no curve"),
    QT_TRANSLATE_NOOP("Engine", "%1 is not fitted"),
    QT_TRANSLATE_NOOP("Engine", "no points"),
    QT_TRANSLATE_NOOP("Engine", "no profiles"),
    QT_TRANSLATE_NOOP("Engine", "no frames"),
    QT_TRANSLATE_NOOP("Engine", "no frame"),
    QT_TRANSLATE_NOOP("Engine", "frame lost"),
    QT_TRANSLATE_NOOP("Engine", "repeated frame"),
    QT_TRANSLATE_NOOP("Engine", "late frame"),
    QT_TRANSLATE_NOOP("Engine", "too late"),
    QT_TRANSLATE_NOOP("Engine", "stopped"),
    QT_TRANSLATE_NOOP("Engine", "source failed"),
    QT_TRANSLATE_NOOP("Engine", "queue overflow"),
    QT_TRANSLATE_NOOP("Engine", "outside of a rail"),
    QT_TRANSLATE_NOOP("Engine", "missed by all cameras"),
    QT_TRANSLATE_NOOP("Engine", "rail %1 has passed: %2"),
    QT_TRANSLATE_NOOP("Engine", "the line was started"),
    QT_TRANSLATE_NOOP("Engine", "the line was stopped"),
    QT_TRANSLATE_NOOP("Engine", "%1 signed in"),
    QT_TRANSLATE_NOOP("Engine", "%1 signed out"),
    QT_TRANSLATE_NOOP("Engine", "good"),
    QT_TRANSLATE_NOOP("Engine", "near limit"),
    QT_TRANSLATE_NOOP("Engine", "out of tolerance"),
    QT_TRANSLATE_NOOP("Engine", "no limits"),
    QT_TRANSLATE_NOOP("Engine", "not valid"),
    QT_TRANSLATE_NOOP("Engine", "%1 from %2 m"),
    QT_TRANSLATE_NOOP("Engine", "camera %1: %2"),
    QT_TRANSLATE_NOOP("Engine", "camera %1"),
    QT_TRANSLATE_NOOP("Engine", "rail %1"),
    QT_TRANSLATE_NOOP("Engine", "line"),
    QT_TRANSLATE_NOOP("Engine", "calibration"),
    QT_TRANSLATE_NOOP("Engine", "archive"),
    QT_TRANSLATE_NOOP("Engine", "pipeline"),
    QT_TRANSLATE_NOOP("Engine", "window"),
    QT_TRANSLATE_NOOP("Engine", "disk"),
    QT_TRANSLATE_NOOP("Engine", "operator"),
    QT_TRANSLATE_NOOP("Engine", "is shorter than %1 characters"),
    QT_TRANSLATE_NOOP("Engine", "the old one is wrong"),
    QT_TRANSLATE_NOOP("Engine", "too many wrong ones; locked until %1"),
    QT_TRANSLATE_NOOP("Engine", "needs a reason; say why"),
    QT_TRANSLATE_NOOP("Engine", "an entry needs who and what"),
    QT_TRANSLATE_NOOP("Engine", "password"),
    QT_TRANSLATE_NOOP("Engine", "there is none"),
    QT_TRANSLATE_NOOP("Engine", "no archive was asked for (--archive)"),
    QT_TRANSLATE_NOOP("Engine", "is no user here"),
    QT_TRANSLATE_NOOP("Engine", "is longer than 1024 bytes"),
    QT_TRANSLATE_NOOP("Engine", "a name has 1 to 64 characters"),
    QT_TRANSLATE_NOOP("Engine", "the first user must be an administrator"),
    QT_TRANSLATE_NOOP("Engine", "is a user already"),
    QT_TRANSLATE_NOOP("Engine", "is the last administrator; make another one first"),
    QT_TRANSLATE_NOOP("Engine", "range finders"),
    QT_TRANSLATE_NOOP("Engine", "exact (virtual rig)"),
    QT_TRANSLATE_NOOP("Engine", "drawing"),
    QT_TRANSLATE_NOOP("Engine", "none (generated numbers)"),
};

struct Sentence {
  const char* english;
  QRegularExpression pattern;
  qsizetype places;
};

std::vector<Sentence> sentences() {
  std::vector<Sentence> all;
  for (const char* english : kSentences) {
    QString pattern = QRegularExpression::escape(QString::fromUtf8(english));
    qsizetype places = 0;
    for (int i = 1; i <= 9; ++i) {
      const QString place = QStringLiteral("\\%%1").arg(i);
      if (!pattern.contains(place)) break;
      pattern.replace(place, QStringLiteral("(.+?)"));
      places = i;
    }
    all.push_back({english, QRegularExpression(QRegularExpression::anchoredPattern(pattern)), places});
    all.back().pattern.optimize();
  }
  return all;
}

QString inWords(const QString& english, int depth) {
  static const std::vector<Sentence> all = sentences();
  static const QRegularExpression number(QStringLiteral("^-?\\d+\\.\\d+$"));
  // "reason (camera 3: frame lost; camera 4: no frame)"
  if (depth < 3 && english.endsWith(')'))
    if (const qsizetype open = english.indexOf(QStringLiteral(" (camera ")); open > 0)
      return inWords(english.left(open), depth + 1) + QStringLiteral(" (") +
             inWords(english.mid(open + 2, english.size() - open - 3), depth + 1) + ')';
  if (depth < 3 && english.contains(QStringLiteral("; camera "))) {
    QStringList parts;
    for (const QString& part : english.split(QStringLiteral("; "))) parts << inWords(part, depth + 1);
    return parts.join(QStringLiteral("; "));
  }
  for (const Sentence& s : all) {
    const QRegularExpressionMatch match = s.pattern.match(english);
    if (!match.hasMatch()) continue;
    QString text = QCoreApplication::translate("Engine", s.english);
    // One after the other would take a % in what is put in for a place.
    for (qsizetype i = s.places; i >= 1; --i) {
      QString part = match.captured(static_cast<int>(i));
      if (number.match(part).hasMatch()) part.replace('.', decimalMark());
      text.replace(QStringLiteral("%%1").arg(i), depth < 3 ? inWords(part, depth + 1) : part);
    }
    return text;
  }
  return english;
}

}  // namespace

QString inWords(const Error& error) { return inWords(error.where) + QStringLiteral(": ") + inWords(error.what); }

QString inWords(const std::string& english) { return inWords(QString::fromStdString(english), 0); }

}  // namespace vignole
