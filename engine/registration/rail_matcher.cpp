#include "engine/registration/rail_matcher.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/registration/shape_misfit.h"

namespace vignole {
namespace {

// The gate: sections of the catalogue that are hard to tell apart (60E1 and 60E2, 54E3 and 54E4, 49E1 and 49E5) are
// 0.45 mm and more apart on a primitive; rails within tolerance rarely stray half of that.
constexpr double kStrayMm = 0.25;
constexpr double kStrayChi2 = 9;
constexpr int kStrayPoints = 10;
// The verdict, in ShapeMisfit's chi2. Rails of the virtual rig: their own section 0.2-0.6, with a dimension off by
// twice its tolerance up to 4; the nearest other section 2-5; the rest above 8.
constexpr double kFits = 1;               // no other section is tried
constexpr double kHopeless = 8;           // the pose is only roughly one of another section
constexpr double kExplained = 4;          // the other section must fit as well as that of a rail with defects does,
constexpr double kClearlyBetter = 0.5;    // twice as well as the expected one,
constexpr double kLeastDifference = 100;  // and over enough of the outline: sum over its places
constexpr double kMoreStrays = 0.02;      // share of the points

bool strays(const PrimitiveResidual& p) {
  return p.points >= kStrayPoints && p.rmsMm > kStrayMm && p.chi2 > kStrayChi2;
}

}  // namespace

struct RailMatcher::Impl {
  struct Candidate {
    std::string name;
    Registrar registrar;
    ShapeMisfit misfit;
  };

  Impl(const Section& section, std::span<const Section> catalogue, const RegistrationSettings& given)
      : expected(section), settings(given), expectedMisfit(section) {
    candidates.reserve(catalogue.size());
    for (const Section& s : catalogue) candidates.push_back({s.name, Registrar(s, settings), ShapeMisfit(s)});
  }

  void check(std::span<const ProfilePoint> points, double correlatedPoints, Registration& registration) {
    const auto& residuals = registration.primitives;
    if (registration.valid && std::none_of(residuals.begin(), residuals.end(), strays)) return;
    if (registration.primitiveOfPoint.size() != points.size() || points.empty()) return;
    const Misfit own = expectedMisfit.measure(points, registration, correlatedPoints);
    const double withStrays = own.chi2 + Misfit::kWorst * own.strayShare;
    if (registration.valid && withStrays < kFits) return;
    const double scaleMm = withStrays < kHopeless ? settings.trackScaleMm : settings.startScaleMm;
    OtherSection other;
    for (Candidate& candidate : candidates) {
      if (candidate.name == expected.name) continue;
      // From the expected section's pose, which even where it does not fit is about where the rail is.
      candidate.registrar.registerFrom(registration.worldFromSection, scaleMm, points, trial);
      if (!trial.valid) continue;
      const Misfit misfit = candidate.misfit.measure(points, trial, correlatedPoints);
      if (!explainsBetter(misfit, own) || (!other.name.empty() && misfit.chi2 >= other.chi2)) continue;
      other = {candidate.name, misfit.chi2, own.chi2, {}};
    }
    if (!other.name.empty()) name(std::move(other), registration);
  }

  /// Points that stray from both sections say nothing; those that stray from the other alone, that it is none.
  static bool explainsBetter(const Misfit& other, const Misfit& expected) {
    if (other.strayShare > expected.strayShare + kMoreStrays || other.chi2 > kExplained) return false;
    const double own = expected.chi2 + Misfit::kWorst * std::max(0.0, expected.strayShare - other.strayShare);
    return other.chi2 < kClearlyBetter * own && (own - other.chi2) * other.places > kLeastDifference;
  }

  void name(OtherSection other, Registration& registration) const {
    const auto& residuals = registration.primitives;
    std::optional<std::size_t> worst;
    for (std::size_t k = 0; k < residuals.size(); ++k) {
      if (!strays(residuals[k])) continue;
      other.primitives.push_back(static_cast<std::int16_t>(k));
      if (!worst || residuals[k].rmsMm > residuals[*worst].rmsMm) worst = k;
    }
    registration.valid = false;
    registration.reason = "wrong section: looks like " + other.name + " rather than " + expected.name;
    if (worst) registration.reason += ", most of all at " + expected.primitives[*worst].name;
    registration.looksLike = std::move(other);
  }

  std::vector<RailMatch> bestMatch(std::span<const ProfilePoint> points) {
    std::vector<RailMatch> matches;
    for (Candidate& candidate : candidates) {
      candidate.registrar.registerProfile(points, trial);
      matches.push_back({candidate.name, chi2OfAllPoints(points, trial)});
    }
    std::stable_sort(matches.begin(), matches.end(),
                     [](const RailMatch& a, const RailMatch& b) { return a.chi2 < b.chi2; });
    return matches;
  }

  Section expected;
  RegistrationSettings settings;
  ShapeMisfit expectedMisfit;
  std::vector<Candidate> candidates;
  Registration trial;
};

RailMatcher::RailMatcher(const Section& expected, std::span<const Section> catalogue,
                         const RegistrationSettings& settings)
    : impl_(std::make_unique<Impl>(expected, catalogue, settings)) {}
RailMatcher::~RailMatcher() = default;
RailMatcher::RailMatcher(RailMatcher&&) noexcept = default;
RailMatcher& RailMatcher::operator=(RailMatcher&&) noexcept = default;

void RailMatcher::check(std::span<const ProfilePoint> points, double correlatedPoints, Registration& registration) {
  impl_->check(points, correlatedPoints, registration);
}
std::vector<RailMatch> RailMatcher::bestMatch(std::span<const ProfilePoint> points) { return impl_->bestMatch(points); }

}  // namespace vignole
