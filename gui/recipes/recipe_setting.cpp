#include "gui/recipes/recipe_setting.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <map>

#include "engine/recipe/recipe_fields.h"
#include "gui/theme/inscription.h"
#include "report/dimension_text.h"

namespace vignole {

namespace {

/// Whose words these are, for translators.
struct Words {
  Q_DECLARE_TR_FUNCTIONS(RecipeSetting)
};

const std::map<std::string, const char*>& wordsByKey() {
  static const std::map<std::string, const char*> kWords = {
      {"section", QT_TRANSLATE_NOOP("RecipeSetting", "Section")},
      {"profile_class", QT_TRANSLATE_NOOP("RecipeSetting", "Profile class")},
      {"straightness_class", QT_TRANSLATE_NOOP("RecipeSetting", "Straightness class")},
      {"parameters.rfh_from_axis_mm", QT_TRANSLATE_NOOP("RecipeSetting", "RFH: distance from the axis, mm")},
      {"parameters.hf_half_width_mm", QT_TRANSLATE_NOOP("RecipeSetting", "HF: half width of the crown, mm")},
      {"parameters.hw_depth_mm", QT_TRANSLATE_NOOP("RecipeSetting", "HW: depth below the crown, mm")},
      {"parameters.hwa_depth_mm", QT_TRANSLATE_NOOP("RecipeSetting", "HWA: the AREMA depth, mm")},
      {"parameters.ft_inside_mm", QT_TRANSLATE_NOOP("RecipeSetting", "FT: inside the foot edges, mm")},
      {"parameters.ras_depth_mm", QT_TRANSLATE_NOOP("RecipeSetting", "RAS: depth below the crown, mm")},
      {"parameters.wt_height_mm", QT_TRANSLATE_NOOP("RecipeSetting", "WT: height, mm (none: thinnest)")},
      {"parameters.base_inset_mm", QT_TRANSLATE_NOOP("RecipeSetting", "Base line: inside the foot edges, mm")},
      {"stripe.sigma_px", QT_TRANSLATE_NOOP("RecipeSetting", "Line: smoothing σ, px")},
      {"stripe.t_l_dn", QT_TRANSLATE_NOOP("RecipeSetting", "Line: low threshold, DN")},
      {"stripe.t_h_dn", QT_TRANSLATE_NOOP("RecipeSetting", "Line: high threshold, DN")},
      {"stripe.d_px", QT_TRANSLATE_NOOP("RecipeSetting", "Line: longest gap bridged, px")},
      {"stripe.alpha_deg", QT_TRANSLATE_NOOP("RecipeSetting", "Line: largest angle joined, °")},
      {"stripe.min_length_points", QT_TRANSLATE_NOOP("RecipeSetting", "Line: shortest kept, points")},
      {"stripe.max_blocks", QT_TRANSLATE_NOOP("RecipeSetting", "Line: blocks before overload")},
      {"stripe.correction", QT_TRANSLATE_NOOP("RecipeSetting", "Line: pull of bends taken off")},
      {"registration.start_scale_mm", QT_TRANSLATE_NOOP("RecipeSetting", "Registration: scale at first, mm")},
      {"registration.track_scale_mm", QT_TRANSLATE_NOOP("RecipeSetting", "Registration: scale with a start, mm")},
      {"registration.inlier_mm", QT_TRANSLATE_NOOP("RecipeSetting", "Registration: inlier below, mm")},
      {"registration.assign_mm", QT_TRANSLATE_NOOP("RecipeSetting", "Registration: points used within, mm")},
      {"registration.max_rms_mm", QT_TRANSLATE_NOOP("RecipeSetting", "Registration: fails above rms, mm")},
      {"registration.min_inlier_share", QT_TRANSLATE_NOOP("RecipeSetting", "Registration: fails below share")},
      {"measurement.trim_mm", QT_TRANSLATE_NOOP("RecipeSetting", "Measuring: ends left out, mm")},
      {"measurement.min_points", QT_TRANSLATE_NOOP("RecipeSetting", "Measuring: least points")},
      {"measurement.expansion_per_k", QT_TRANSLATE_NOOP("RecipeSetting", "Measuring: expansion, 1/K")},
      {"measurement.max_temperature_c", QT_TRANSLATE_NOOP("RecipeSetting", "Measuring: hottest rail, °C")}};
  return kWords;
}

QString textOf(double value) { return QString::fromStdString(plainNumber(value)); }
QString textOf(int value) { return QString::number(value); }
QString textOf(bool value) { return value ? Words::tr("yes") : Words::tr("no"); }
QString textOf(const LeftRight& value) { return textOf(value.left) + QStringLiteral(" / ") + textOf(value.right); }
QString textOf(const std::optional<double>& value) { return value ? textOf(*value) : QStringLiteral("–"); }

/// As people type: a decimal comma or point, a real minus.
std::optional<double> numberFrom(const QString& text) {
  bool ok = false;
  const double value = QString(text).replace(QChar(0x2212), '-').replace(',', '.').trimmed().toDouble(&ok);
  return ok ? std::optional(value) : std::nullopt;
}

bool read(double& value, const QString& text) {
  const auto number = numberFrom(text);
  if (number) value = *number;
  return number.has_value();
}
bool read(int& value, const QString& text) {
  bool ok = false;
  const int number = text.trimmed().toInt(&ok);
  if (ok) value = number;
  return ok;
}
bool read(bool& value, const QString& text) {
  const QString word = text.trimmed();
  for (const bool which : {true, false})
    if (word.compare(textOf(which), Qt::CaseInsensitive) == 0) {
      value = which;
      return true;
    }
  return false;
}
bool read(LeftRight& value, const QString& text) {
  const QStringList sides = text.split('/');
  if (sides.size() > 2) return false;
  const auto left = numberFrom(sides.first()), right = numberFrom(sides.last());
  if (!left || !right) return false;
  value = {*left, *right};
  return true;
}
bool read(std::optional<double>& value, const QString& text) {
  const QString plain = text.trimmed();
  if (plain.isEmpty() || plain == QStringLiteral("–") || plain == QStringLiteral("-")) {
    value.reset();
    return true;
  }
  const auto number = numberFrom(plain);
  if (number) value = number;
  return number.has_value();
}

}  // namespace

QString settingWords(const std::string& key) {
  if (key.starts_with("tolerance."))
    if (const auto dimension = dimensionFromName(key.substr(10)))
      return Words::tr("%1: limits, mm").arg(spoken(*dimension));
  const auto known = wordsByKey().find(key);
  return known == wordsByKey().end() ? QString::fromStdString(key) : Words::tr(known->second);
}

QString settingValue(const std::string& fileText) {
  const QString text = QString::fromStdString(fileText);
  static const QRegularExpression limit(QStringLiteral("(lower|upper)_mm = ([-+0-9.e]+)"));
  static const QRegularExpression pair(QStringLiteral("^\\[([^,]+), ([^\\]]+)\\]$"));
  if (text.startsWith('{')) {
    QString lower, upper;
    for (auto found = limit.globalMatch(text); found.hasNext();) {
      const auto match = found.next();
      (match.captured(1) == QStringLiteral("lower") ? lower : upper) = deviationText(match.captured(2).toDouble(), 3);
    }
    if (lower.isEmpty() && upper.isEmpty()) return Words::tr("not judged");
    if (lower.isEmpty()) return Words::tr("at most %1").arg(upper);
    if (upper.isEmpty()) return Words::tr("at least %1").arg(lower);
    return Words::tr("%1 to %2").arg(lower, upper);
  }
  if (const auto match = pair.match(text); match.hasMatch())
    return match.captured(1) + QStringLiteral(" / ") + match.captured(2);
  if (text == QStringLiteral("true") || text == QStringLiteral("false")) return textOf(text == QStringLiteral("true"));
  return QString(text).remove('"');
}

std::vector<RecipeSetting> settingsOf(const Recipe& recipe) {
  std::vector<RecipeSetting> settings;
  forEachField(recipe, [&](const char* key, const auto& value, const auto&...) {
    settings.push_back({key, textOf(value)});
  });
  return settings;
}

bool setSetting(Recipe& recipe, const std::string& key, const QString& text) {
  bool good = false;
  forEachField(recipe, [&](const char* here, auto& value, const auto&...) {
    if (key == here) good = read(value, text);
  });
  return good;
}

}  // namespace vignole
