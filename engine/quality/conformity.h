#pragma once
// Conformity with a tolerance in the light of the measurement uncertainty: ISO 14253-1, JCGM 106.

#include <optional>
#include <string_view>

#include "engine/quality/sample.h"

namespace vignole {

enum class Conformity { Conforms, DoesNotConform, CannotBeDecided };
[[nodiscard]] std::string_view name(Conformity conformity);  ///< "conforms", "does not conform", "cannot be decided"

/// Limits of a tolerance; one may be missing.
struct ToleranceZone {
  std::optional<double> lower, upper;
};

/// Standard uncertainties by which the zone of acceptance lies inside the tolerance, and that of rejection outside.
/// 2: the expanded uncertainty; 1.645: 5 % risk at a limit (ISO 14253-1:2017).
inline constexpr double kGuardSigmas = 2;

/// Conforms: at least `guardSigmas` u inside; does not: as far outside; else it cannot be decided.
[[nodiscard]] Conformity conformity(double value, double u, const ToleranceZone& tolerance,
                                    double guardSigmas = kGuardSigmas);
/// Zone in which a measured value is accepted. May be empty (low > high): the gauge is too coarse for the tolerance.
[[nodiscard]] ToleranceZone acceptanceZone(double u, const ToleranceZone& tolerance, double guardSigmas = kGuardSigmas);
/// That the true value lies within, given the measured one and nothing else known (JCGM 106, 7).
[[nodiscard]] double conformanceProbability(double value, double u, const ToleranceZone& tolerance);

/// What is known of the rails that come: a normal process.
struct ProcessSpread {
  double mean = 0, sd = 0;
};
struct ConformityRisks {
  double consumer = 0;  ///< a rail is bad and accepted
  double producer = 0;  ///< a rail is good and rejected
  double bad = 0;       ///< a rail is bad
};
/// Global risks (JCGM 106, 9.5) of accepting what is measured within `acceptance`; sd > 0, u > 0.
[[nodiscard]] ConformityRisks conformityRisks(const ProcessSpread& process, double u, const ToleranceZone& tolerance,
                                              const ToleranceZone& acceptance);

}  // namespace vignole
