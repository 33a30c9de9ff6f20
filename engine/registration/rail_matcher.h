#pragma once
// Which section of the catalogue a profile is of.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/profile/profile.h"
#include "engine/rail/section.h"
#include "engine/registration/registration.h"

namespace vignole {

struct RailMatch {
  std::string rail;
  double chi2 = 0;  ///< chi2OfAllPoints at the best pose
};

/// Keeps what registers to every section. One per thread. Same points, same verdict, whatever came before.
class RailMatcher {
 public:
  /// `catalogue`: may hold the expected section as well.
  RailMatcher(const Section& expected, std::span<const Section> catalogue, const RegistrationSettings& settings);
  ~RailMatcher();
  RailMatcher(RailMatcher&&) noexcept;
  RailMatcher& operator=(RailMatcher&&) noexcept;

  /// After a registration to the expected section. Where a primitive strays too far from its points, or nothing fits,
  /// the other sections are tried; if one explains the profile (ShapeMisfit) and the expected one does not, the
  /// registration is no longer valid, and says what it looks like and which primitives differ.
  void check(std::span<const ProfilePoint> points, double correlatedPoints, Registration& registration);

  /// Every section of the catalogue, best first.
  [[nodiscard]] std::vector<RailMatch> bestMatch(std::span<const ProfilePoint> points);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vignole
