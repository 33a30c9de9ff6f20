#include "gui/monitor/judgement.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "gui/theme/inscription.h"
#include "report/dimension_text.h"
#include "report/engine_words.h"

namespace vignole {

namespace {

struct Judgement {
  Q_DECLARE_TR_FUNCTIONS(Judgement)
};

QString metres(double m, int places = 1) { return numberText(m, places) + " m"; }

double positionM(const LineSnapshot& line) { return line.latest ? line.latest->profile.positionMm / 1000 : 0; }

const DimensionResult* latestOf(const LineSnapshot& line, Dimension d) {
  return line.latest ? &line.latest->measurement.dimensions[index(d)] : nullptr;
}

bool hasLimit(const Recipe& recipe, Dimension d) {
  return recipe.limits[index(d)].lowerMm || recipe.limits[index(d)].upperMm;
}

/// "from 37.0 m on" or "from 12.0 to 14.5 m".
QString stretch(const DimensionException& e, double nowM) {
  if (nowM - e.toM < 0.5) return Judgement::tr("from %1 on").arg(metres(e.fromM));
  return Judgement::tr("from %1 to %2").arg(numberText(e.fromM, 1), metres(e.toM));
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

/// "WT 0.032 above the limit from 37.0 m on"
QString excessSentence(const Excess& excess, double nowM, LengthUnit unit) {
  const DimensionSummary& s = *excess.summary;
  const double worst = excess.exception->worstMm;
  const QString name = inscribed(s.dimension), where = stretch(*excess.exception, nowM);
  const auto length = [&](double mm) { return lengthText(mm, decimalsOf(s.dimension), unit); };
  if (s.upperMm && worst > *s.upperMm)
    return Judgement::tr("%1 %2 above the limit %3").arg(name, length(worst - *s.upperMm), where);
  if (s.lowerMm && worst < *s.lowerMm)
    return Judgement::tr("%1 %2 below the limit %3").arg(name, length(*s.lowerMm - worst), where);
  return Judgement::tr("%1 beyond the limit %2").arg(name, where);
}

QString joined(const QStringList& names) {
  if (names.size() <= 1) return names.join(QString());
  return Judgement::tr("%1 and %2").arg(names.mid(0, names.size() - 1).join(Judgement::tr(", ")), names.last());
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
  if (line.lostCameras.empty()) return inWords(reason);
  QStringList cameras;
  for (const LostCamera& lost : line.lostCameras) cameras << QString::number(lost.camera + 1);
  return (cameras.size() == 1 ? Judgement::tr("camera %1 lost") : Judgement::tr("cameras %1 lost"))
      .arg(joined(cameras));
}

VerdictText notValid(const LineSnapshot& line, const std::vector<UnmeasuredDimension>& missing) {
  QStringList names;
  for (const UnmeasuredDimension& u : missing) names << inscribed(u.dimension);
  const QString which = names.size() > 4 ? Judgement::tr("%1 dimensions").arg(names.size()) : joined(names);
  return {StateSymbol::NotMeasured, Judgement::tr("Not valid"),
          Judgement::tr("%1 not measured from %2 on: %3")
              .arg(which, metres(missing.front().fromM, 2), cause(line, missing.front().reason)),
          false};
}

VerdictText outOfTolerance(const LineSnapshot& line, LengthUnit unit) {
  QStringList parts;
  for (const Excess& e : excesses(line)) parts << excessSentence(e, positionM(line), unit);
  if (const QStringList near = nearNames(line); !near.isEmpty())
    parts << Judgement::tr("%1 near limit").arg(joined(near));
  if (parts.isEmpty()) parts << Judgement::tr("single profiles outside the limits");
  return {StateSymbol::Out, Judgement::tr("Out of tolerance"), parts.join(QStringLiteral(";  ")), false};
}

VerdictText nearLimit(const LineSnapshot& line, LengthUnit unit) {
  QStringList parts;
  for (const Dimension d : kDimensions) {
    const auto* r = latestOf(line, d);
    if (!r || r->verdict != Verdict::Near || !r->valueMm) continue;
    const double toUpper = r->upperMm ? *r->upperMm - *r->valueMm : 1e9;
    const double toLower = r->lowerMm ? *r->valueMm - *r->lowerMm : 1e9;
    const double distance = std::min(toUpper, toLower);
    parts << (distance >= 0 ? Judgement::tr("%1 %2 inside the limit, closer than U")
                            : Judgement::tr("%1 %2 outside the limit, by less than U"))
                 .arg(inscribed(d), lengthText(std::abs(distance), decimalsOf(d), unit));
  }
  if (parts.isEmpty()) {
    QStringList names;
    for (const DimensionSummary& d : line.rail->dimensions)
      if (d.verdict == Verdict::Near) names << inscribed(d.dimension);
    parts << (names.isEmpty() ? Judgement::tr("within the guard band earlier on this rail")
                              : Judgement::tr("%1 within the guard band earlier on this rail").arg(joined(names)));
  }
  return {StateSymbol::Near, Judgement::tr("Near limit"), parts.join(QStringLiteral(";  ")), false};
}

VerdictText good(const LineSnapshot& line) {
  int judged = 0;
  for (const Dimension d : kDimensions) judged += hasLimit(*line.recipe, d) ? 1 : 0;
  return {StateSymbol::Good, Judgement::tr("Good"),
          Judgement::tr("%1 dimensions within limits up to %2").arg(judged).arg(metres(positionM(line), 2)), false};
}

VerdictText liveVerdict(const LineSnapshot& line, LengthUnit unit) {
  if (!line.rail || !line.latest) {
    const bool running = line.state != LineState::Idle && line.state != LineState::Stopped;
    return {running ? StateSymbol::Armed : StateSymbol::Idle, Judgement::tr("Waiting for a rail"),
            running ? Judgement::tr("the gauge is ready; values appear with the head of the rail")
                    : Judgement::tr("the line is not running: Ctrl+R starts it"),
            false};
  }
  if (const auto missing = unmeasuredWithLimits(line); !missing.empty()) return notValid(line, missing);
  switch (line.rail->verdict) {
    case Verdict::Fail:
      return outOfTolerance(line, unit);
    case Verdict::Near:
      return nearLimit(line, unit);
    case Verdict::Pass:
      return good(line);
    case Verdict::NoLimit:
      return {StateSymbol::NoLimit, Judgement::tr("No limits"),
              Judgement::tr("the recipe gives no tolerance to any dimension"), false};
    case Verdict::NotMeasured:
      break;
  }
  QStringList names;
  for (const DimensionSummary& d : line.rail->dimensions)
    if (d.verdict == Verdict::NotMeasured && hasLimit(*line.recipe, d.dimension)) names << inscribed(d.dimension);
  return {StateSymbol::NotMeasured, Judgement::tr("Not valid"),
          names.isEmpty() ? Judgement::tr("this rail was not measured completely")
                          : Judgement::tr("%1 not measured on enough of this rail").arg(joined(names.mid(0, 4))),
          false};
}

}  // namespace

StateWord lineState(LineState state) {
  switch (state) {
    case LineState::Idle:
      return {StateSymbol::Idle, Judgement::tr("Idle")};
    case LineState::Armed:
      return {StateSymbol::Armed, Judgement::tr("Armed")};
    case LineState::Measuring:
      return {StateSymbol::Measuring, Judgement::tr("Measuring")};
    case LineState::Silent:
      return {StateSymbol::Fault, Judgement::tr("No profiles")};
    case LineState::Stopped:
      return {StateSymbol::Idle, Judgement::tr("Stopped")};
    case LineState::Fault:
      return {StateSymbol::Fault, Judgement::tr("Fault")};
  }
  return {};
}

VerdictText railVerdict(const LineSnapshot& line, LengthUnit unit) {
  // A rail that passes unseen is not good, however good its head was.
  if (line.latest && (line.state == LineState::Silent || line.state == LineState::Fault))
    return {
        StateSymbol::NotMeasured, Judgement::tr("Not valid"),
        Judgement::tr("no profiles since %1, %2 ago. Hold this rail.").arg(metres(positionM(line), 2), age(line.ageS)),
        true};
  VerdictText text = liveVerdict(line, unit);
  if (!line.held()) return text;
  text.held = true;
  text.sentence = Judgement::tr("held: last profile at %1, %2 ago").arg(metres(positionM(line), 2), age(line.ageS));
  return text;
}

GaugeTrust gaugeTrust(const LineSnapshot& line) {
  GaugeTrust trust;
  const auto lost = line.lostCameras.size();
  trust.cameras = Judgement::tr("%1 of %2 cameras, %3 profiles/s")
                      .arg(kCameraCount - static_cast<int>(lost))
                      .arg(kCameraCount)
                      .arg(numberText(line.profilesPerS, 1));
  if (line.state == LineState::Silent) trust.cameras = Judgement::tr("no profiles for %1").arg(age(line.ageS));
  trust.provenance =
      Judgement::tr("calibration %1").arg(inWords(line.calibrationMethod).section(QStringLiteral(" ("), 0, 0));
  const bool running = line.state == LineState::Measuring || line.state == LineState::Armed;
  if (lost > 0 || line.state == LineState::Fault || line.state == LineState::Silent) {
    trust.symbol = StateSymbol::NotMeasured;
    trust.word = Judgement::tr("Not trusted");
  } else if (!running || !line.latest) {
    trust.symbol = StateSymbol::NoLimit;
    trust.word = Judgement::tr("No data");
    trust.cameras = running ? Judgement::tr("no profile yet") : Judgement::tr("the line is not running");
  } else if (line.rail && line.recentIncomplete * 100 > line.rail->profiles && line.rail->profiles > 50) {
    // More than one trigger in a hundred is not normal production any more.
    trust.symbol = StateSymbol::Near;
    trust.word = Judgement::tr("Degraded");
    trust.provenance =
        Judgement::tr("%1 of %2 incomplete").arg(count(line.recentIncomplete), count(line.rail->profiles));
  } else {
    trust.symbol = StateSymbol::Good;
    trust.word = Judgement::tr("Trusted");
  }
  return trust;
}

QString widestTrustWord() {
  QString widest;
  for (const QString& word :
       {Judgement::tr("Not trusted"), Judgement::tr("No data"), Judgement::tr("Degraded"), Judgement::tr("Trusted")})
    if (word.size() > widest.size()) widest = word;
  return widest;
}

QString quietSentence(const LineSnapshot& line) {
  switch (line.state) {
    case LineState::Idle:
    case LineState::Stopped:
      return Judgement::tr("The line is stopped: Ctrl+R starts it");
    case LineState::Armed:
      return Judgement::tr("Ready for the next rail");
    default:
      return Judgement::tr("No alarm on this rail");
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
