#include "gui/monitor/judgement.h"

#include <algorithm>
#include <cmath>

#include "gui/theme/inscription.h"
#include "report/dimension_text.h"

namespace vignole {

namespace {

QString metres(double m, int places = 1) { return QString::number(m, 'f', places) + " m"; }

double positionM(const LineSnapshot& line) { return line.latest ? line.latest->profile.positionMm / 1000 : 0; }

const DimensionResult* latestOf(const LineSnapshot& line, Dimension d) {
  return line.latest ? &line.latest->measurement.dimensions[index(d)] : nullptr;
}

bool hasLimit(const Recipe& recipe, Dimension d) {
  return recipe.limits[index(d)].lowerMm || recipe.limits[index(d)].upperMm;
}

/// "0.032 above the limit", for a value outside.
QString beyondLimit(double value, const std::optional<double>& lower, const std::optional<double>& upper, int places) {
  if (upper && value > *upper) return numberText(value - *upper, places) + QStringLiteral(" above the limit");
  if (lower && value < *lower) return numberText(*lower - value, places) + QStringLiteral(" below the limit");
  return QStringLiteral("beyond the limit");
}

/// "from 37.0 m on" or "from 12.0 to 14.5 m".
QString stretch(const DimensionException& e, double nowM) {
  if (nowM - e.toM < 0.5) return QStringLiteral("from %1 on").arg(metres(e.fromM));
  return QStringLiteral("from %1 to %2").arg(QString::number(e.fromM, 'f', 1), metres(e.toM));
}

struct Excess {
  const DimensionSummary* summary;
  const DimensionException* exception;
};

/// One per dimension out of tolerance: its latest stretch.
std::vector<Excess> excesses(const LineSnapshot& line) {
  std::vector<Excess> found;
  if (!line.rail) return found;
  for (const DimensionSummary& d : line.rail->dimensions)
    if (!d.exceptions.empty()) found.push_back({&d, &d.exceptions.back()});
  return found;
}

QString excessSentence(const Excess& excess, double nowM) {
  const DimensionSummary& s = *excess.summary;
  return QStringLiteral("%1 %2 %3")
      .arg(inscribed(s.dimension),
           beyondLimit(excess.exception->worstMm, s.lowerMm, s.upperMm, decimalsOf(s.dimension)),
           stretch(*excess.exception, nowM));
}

QString joined(const QStringList& names) {
  if (names.size() <= 1) return names.join(QString());
  return names.mid(0, names.size() - 1).join(", ") + " and " + names.last();
}

std::vector<UnmeasuredDimension> unmeasuredWithLimits(const LineSnapshot& line) {
  std::vector<UnmeasuredDimension> found;
  for (const UnmeasuredDimension& u : line.unmeasured)
    if (hasLimit(*line.recipe, u.dimension)) found.push_back(u);
  return found;
}

QStringList nearNames(const LineSnapshot& line) {
  QStringList names;
  for (const Dimension d : kDimensions)
    if (const auto* r = latestOf(line, d); r && r->verdict == Verdict::Near) names << inscribed(d);
  return names;
}

/// What keeps the rail from being measured, in one clause: "camera 3 lost".
QString cause(const LineSnapshot& line, const std::string& reason) {
  if (line.lostCameras.empty()) return QString::fromStdString(reason);
  QStringList cameras;
  for (const LostCamera& lost : line.lostCameras) cameras << QString::number(lost.camera + 1);
  return (cameras.size() == 1 ? QStringLiteral("camera %1 lost") : QStringLiteral("cameras %1 lost"))
      .arg(joined(cameras));
}

VerdictText notValid(const LineSnapshot& line, const std::vector<UnmeasuredDimension>& missing) {
  QStringList names;
  for (const UnmeasuredDimension& u : missing) names << inscribed(u.dimension);
  const QString which = names.size() > 4 ? QStringLiteral("%1 dimensions").arg(names.size()) : joined(names);
  return {StateSymbol::NotMeasured, QStringLiteral("Not valid"),
          QStringLiteral("%1 not measured from %2 on: %3")
              .arg(which, metres(missing.front().fromM, 2), cause(line, missing.front().reason)),
          false};
}

VerdictText outOfTolerance(const LineSnapshot& line) {
  QStringList parts;
  for (const Excess& e : excesses(line)) parts << excessSentence(e, positionM(line));
  if (const QStringList near = nearNames(line); !near.isEmpty()) parts << joined(near) + " near limit";
  if (parts.isEmpty()) parts << QStringLiteral("single profiles outside the limits");
  return {StateSymbol::Out, QStringLiteral("Out of tolerance"), parts.join(";  "), false};
}

VerdictText nearLimit(const LineSnapshot& line) {
  QStringList parts;
  for (const Dimension d : kDimensions) {
    const auto* r = latestOf(line, d);
    if (!r || r->verdict != Verdict::Near || !r->valueMm) continue;
    const double toUpper = r->upperMm ? *r->upperMm - *r->valueMm : 1e9;
    const double toLower = r->lowerMm ? *r->valueMm - *r->lowerMm : 1e9;
    const double distance = std::min(toUpper, toLower);
    parts << (distance >= 0 ? QStringLiteral("%1 %2 inside the limit, closer than U")
                            : QStringLiteral("%1 %2 outside the limit, by less than U"))
                 .arg(inscribed(d), numberText(std::abs(distance), decimalsOf(d)));
  }
  if (parts.isEmpty()) {
    QStringList names;
    for (const DimensionSummary& d : line.rail->dimensions)
      if (d.verdict == Verdict::Near) names << inscribed(d.dimension);
    parts << (names.isEmpty() ? QStringLiteral("within the guard band earlier on this rail")
                              : joined(names) + QStringLiteral(" within the guard band earlier on this rail"));
  }
  return {StateSymbol::Near, QStringLiteral("Near limit"), parts.join(";  "), false};
}

VerdictText good(const LineSnapshot& line) {
  int judged = 0;
  for (const Dimension d : kDimensions) judged += hasLimit(*line.recipe, d) ? 1 : 0;
  return {StateSymbol::Good, QStringLiteral("Good"),
          QStringLiteral("%1 dimensions within limits up to %2").arg(judged).arg(metres(positionM(line), 2)), false};
}

VerdictText liveVerdict(const LineSnapshot& line) {
  if (!line.rail || !line.latest) {
    const bool running = line.state != LineState::Idle && line.state != LineState::Stopped;
    return {running ? StateSymbol::Armed : StateSymbol::Idle, QStringLiteral("Waiting for a rail"),
            running ? QStringLiteral("the gauge is ready; values appear with the head of the rail")
                    : QStringLiteral("the line is not running: Ctrl+R starts it"),
            false};
  }
  if (const auto missing = unmeasuredWithLimits(line); !missing.empty()) return notValid(line, missing);
  switch (line.rail->verdict) {
    case Verdict::Fail:
      return outOfTolerance(line);
    case Verdict::Near:
      return nearLimit(line);
    case Verdict::Pass:
      return good(line);
    case Verdict::NoLimit:
      return {StateSymbol::NoLimit, QStringLiteral("No limits"),
              QStringLiteral("the recipe gives no tolerance to any dimension"), false};
    case Verdict::NotMeasured:
      break;
  }
  QStringList names;
  for (const DimensionSummary& d : line.rail->dimensions)
    if (d.verdict == Verdict::NotMeasured && hasLimit(*line.recipe, d.dimension)) names << inscribed(d.dimension);
  return {StateSymbol::NotMeasured, QStringLiteral("Not valid"),
          names.isEmpty() ? QStringLiteral("this rail was not measured completely")
                          : joined(names.mid(0, 4)) + QStringLiteral(" not measured on enough of this rail"),
          false};
}

}  // namespace

StateWord lineState(LineState state) {
  switch (state) {
    case LineState::Idle:
      return {StateSymbol::Idle, QStringLiteral("Idle")};
    case LineState::Armed:
      return {StateSymbol::Armed, QStringLiteral("Armed")};
    case LineState::Measuring:
      return {StateSymbol::Measuring, QStringLiteral("Measuring")};
    case LineState::Silent:
      return {StateSymbol::Fault, QStringLiteral("No profiles")};
    case LineState::Stopped:
      return {StateSymbol::Idle, QStringLiteral("Stopped")};
    case LineState::Fault:
      return {StateSymbol::Fault, QStringLiteral("Fault")};
  }
  return {};
}

VerdictText railVerdict(const LineSnapshot& line) {
  // A rail that passes unseen is not good, however good its head was.
  if (line.latest && (line.state == LineState::Silent || line.state == LineState::Fault))
    return {
        StateSymbol::NotMeasured, QStringLiteral("Not valid"),
        QStringLiteral("no profiles since %1, %2 ago. Hold this rail.").arg(metres(positionM(line), 2), age(line.ageS)),
        true};
  VerdictText text = liveVerdict(line);
  if (!line.held()) return text;
  text.held = true;
  text.sentence = QStringLiteral("held: last profile at %1, %2 ago").arg(metres(positionM(line), 2), age(line.ageS));
  return text;
}

GaugeTrust gaugeTrust(const LineSnapshot& line) {
  GaugeTrust trust;
  const auto lost = line.lostCameras.size();
  trust.cameras = QStringLiteral("%1 of %2 cameras, %3 profiles/s")
                      .arg(kCameraCount - static_cast<int>(lost))
                      .arg(kCameraCount)
                      .arg(QString::number(line.profilesPerS, 'f', 1));
  if (line.state == LineState::Silent) trust.cameras = QStringLiteral("no profiles for %1").arg(age(line.ageS));
  trust.provenance = QStringLiteral("calibration %1")
                         .arg(QString::fromStdString(line.calibrationMethod).section(QStringLiteral(" ("), 0, 0));
  const bool running = line.state == LineState::Measuring || line.state == LineState::Armed;
  if (lost > 0 || line.state == LineState::Fault || line.state == LineState::Silent) {
    trust.symbol = StateSymbol::NotMeasured;
    trust.word = QStringLiteral("Not trusted");
  } else if (!running || !line.latest) {
    trust.symbol = StateSymbol::NoLimit;
    trust.word = QStringLiteral("No data");
    trust.cameras = running ? QStringLiteral("no profile yet") : QStringLiteral("the line is not running");
  } else if (line.rail && line.recentIncomplete * 100 > line.rail->profiles && line.rail->profiles > 50) {
    // More than one trigger in a hundred is not normal production any more.
    trust.symbol = StateSymbol::Near;
    trust.word = QStringLiteral("Degraded");
    trust.provenance =
        QStringLiteral("%1 of %2 incomplete").arg(count(line.recentIncomplete), count(line.rail->profiles));
  } else {
    trust.symbol = StateSymbol::Good;
    trust.word = QStringLiteral("Trusted");
  }
  return trust;
}

std::optional<AlarmSentence> highestAlarm(const LineSnapshot& line) {
  const QString rail = line.rail ? QString::fromStdString(line.rail->rail.id) : QString();
  if (line.state == LineState::Fault)
    return AlarmSentence{1, QStringLiteral("Measurement ended: %1").arg(QString::fromStdString(line.error)),
                         QStringLiteral("Hold the rail; start the line again.")};
  if (line.state == LineState::Silent)
    return AlarmSentence{1, QStringLiteral("No profiles for %1").arg(age(line.ageS)),
                         QStringLiteral("Hold the rail; check encoder, trigger and cameras.")};
  if (!line.lostCameras.empty()) {
    const QString cameras = cause(line, {});
    const bool values = unmeasuredWithLimits(line).empty();
    return AlarmSentence{
        1,
        QString(cameras).replace(0, 1, 'C') +
            (values ? QStringLiteral(": profiles are incomplete") : QStringLiteral(": rails are not fully measured")),
        QStringLiteral("Hold the rail; check power and cable of camera %1.").arg(line.lostCameras.front().camera + 1)};
  }
  if (const auto missing = unmeasuredWithLimits(line); !missing.empty() && line.state == LineState::Measuring)
    return AlarmSentence{
        1,
        QStringLiteral("%1 not measured: %2")
            .arg(inscribed(missing.front().dimension), QString::fromStdString(missing.front().reason)),
        QStringLiteral("Hold the rail from %1; check windows and lasers.").arg(metres(missing.front().fromM))};
  if (const auto out = excesses(line); !out.empty()) {
    QStringList names;
    double fromM = out.front().summary->exceptions.front().fromM;
    for (const Excess& e : out) {
      names << inscribed(e.summary->dimension);
      fromM = std::min(fromM, e.summary->exceptions.front().fromM);
    }
    return AlarmSentence{2, QStringLiteral("Rail %1 out of tolerance: %2").arg(rail, joined(names)),
                         QStringLiteral("Mark the rail from %1; tell the roller.").arg(metres(fromM))};
  }
  if (const GaugeTrust trust = gaugeTrust(line); trust.symbol == StateSymbol::Near) {
    // The commonest reason says where to look.
    std::string worst;
    std::uint64_t most = 0;
    for (const auto& [reason, n] : line.triggers.reasons)
      if (n > most) {
        most = n;
        worst = reason;
      }
    return AlarmSentence{3, QStringLiteral("Profiles are missing: %1").arg(trust.provenance),
                         worst.empty() ? QStringLiteral("Look at Pipeline (H).")
                                       : QStringLiteral("Most often %1.").arg(QString::fromStdString(worst))};
  }
  return {};
}

QString quietSentence(const LineSnapshot& line) {
  switch (line.state) {
    case LineState::Idle:
    case LineState::Stopped:
      return QStringLiteral("The line is stopped: Ctrl+R starts it");
    case LineState::Armed:
      return QStringLiteral("Ready for the next rail");
    default:
      return QStringLiteral("No alarm on this rail");
  }
}

std::optional<double> limitShare(Dimension dimension, const DimensionResult& r) {
  if (!r.valueMm || (!r.lowerMm && !r.upperMm)) return {};
  // rails.md: the lower limit of HF judges HF_min; FC is judged on what is concave only.
  const double high = dimension == Dimension::FC ? std::max(0.0, *r.valueMm) : *r.valueMm;
  const double low = dimension == Dimension::HF && r.secondMm ? *r.secondMm : high;
  double share = -1e9;
  if (r.upperMm && *r.upperMm != r.nominalMm)
    share = std::max(share, (high - r.nominalMm) / (*r.upperMm - r.nominalMm));
  if (r.lowerMm && *r.lowerMm != r.nominalMm) share = std::max(share, (low - r.nominalMm) / (*r.lowerMm - r.nominalMm));
  return share;
}

std::vector<Dimension> nearestToLimits(const LineSnapshot& line, std::size_t wanted,
                                       const std::vector<Dimension>& shown) {
  constexpr double kStay = 0.1;
  std::vector<std::pair<double, Dimension>> ranked;
  for (const Dimension d : kDimensions) {
    const auto* r = latestOf(line, d);
    const auto share = r ? limitShare(d, *r) : std::nullopt;
    const bool stays = std::find(shown.begin(), shown.end(), d) != shown.end();
    if (share)
      ranked.emplace_back(*share + (stays ? kStay : 0), d);
    else if (hasLimit(*line.recipe, d))
      ranked.emplace_back(stays ? -1 + kStay : -1, d);
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Dimension> nearest;
  for (std::size_t i = 0; i < std::min(wanted, ranked.size()); ++i) nearest.push_back(ranked[i].second);
  // Those that were shown keep their place, newcomers take what is free.
  if (shown.size() == nearest.size())
    for (std::size_t place = 0; place < shown.size(); ++place)
      if (const auto at = std::find(nearest.begin(), nearest.end(), shown[place]); at != nearest.end())
        std::iter_swap(at, nearest.begin() + static_cast<std::ptrdiff_t>(place));
  return nearest;
}

std::optional<Dimension> worstOutside(const LineSnapshot& line) {
  std::optional<Dimension> worst;
  double most = 0;
  for (const Dimension d : kDimensions)
    if (const auto* r = latestOf(line, d); r && r->verdict == Verdict::Fail)
      if (const auto share = limitShare(d, *r); share && *share > most) {
        most = *share;
        worst = d;
      }
  return worst;
}

}  // namespace vignole
