#pragma once
// Rails of the virtual rig through extraction and registration, for the drift watch; without the pipeline's threads.

#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>

#include "calibration/drift/drift_watch.h"
#include "engine/optics/rig_uncertainty.h"
#include "engine/profile/stripe_optics.h"
#include "engine/profile/translate.h"
#include "engine/rail/catalogue.h"
#include "engine/simulator/virtual_rig.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole::testing {

/// What the four cameras extracted of one profile: it can be mapped by several calibrations.
using Stripes = std::array<StripeResult, kCameraCount>;

/// Renders and extracts rails of one section before one rig; each rail is another piece of steel.
class RenderedRails {
 public:
  RenderedRails(const std::string& section, std::uint64_t rigSeed, std::uint64_t seed)
      : section_(*findSection(section)), rigSeed_(rigSeed), seed_(seed) {
    calibration_ = rig(0, {})->calibration();
    for (const RangeFinderCalibration& finder : calibration_.rangeFinders)
      extractors_.emplace_back(StripeSettings{}, stripeOptics(finder, {{-110, -25}, {110, 200}}));
    pixels_.resize(1400UL * 1024UL);
  }
  [[nodiscard]] const Section& section() const { return section_; }
  [[nodiscard]] const RigCalibration& calibration() const { return calibration_; }

  /// Profiles of rail number `rail`, some metres apart; temperatures vary from rail to rail.
  [[nodiscard]] std::vector<Stripes> extract(int rail, int profiles, const std::string& fault = {}) {
    const auto virtualRig = rig(rail, fault);
    std::vector<Stripes> all(static_cast<std::size_t>(profiles));
    for (int p = 0; p < profiles; ++p)
      for (std::size_t c = 0; c < kCameraCount; ++c) {
        MutableImageView image{pixels_.data(), 1400, 1024, 1400};
        virtualRig->render(static_cast<int>(c), static_cast<std::uint64_t>(13 + 97 * p), image);
        extractors_[c].extract(image, all[static_cast<std::size_t>(p)][c]);
      }
    return all;
  }

 private:
  [[nodiscard]] std::shared_ptr<const VirtualRig> rig(int rail, const std::string& fault) const {
    VirtualRigSettings settings;
    settings.section = section_;
    settings.parameters = section_.parameters;
    settings.seed = seed_ + static_cast<std::uint64_t>(rail);
    settings.rigSeed = rigSeed_;
    settings.temperatureC = 15 + 20 * (rail % 6);
    if (!fault.empty()) settings.faults.push_back(*parseFault(fault));
    auto made = VirtualRig::create(std::move(settings));
    EXPECT_TRUE(made) << made.error().message();
    return *made;
  }
  Section section_;
  std::uint64_t rigSeed_, seed_;
  RigCalibration calibration_;
  std::vector<StripeExtractor> extractors_;
  std::vector<std::uint8_t> pixels_;
};

/// Profiles by a calibration, registered, into a rail's seams.
class SeamsBy {
 public:
  SeamsBy(const Section& section, const RigCalibration& calibration) : registrar_(section, {}), seams_(section) {
    for (int c = 0; c < kCameraCount; ++c)
      translators_.emplace_back(c, calibration.rangeFinders[static_cast<std::size_t>(c)]);
  }
  [[nodiscard]] std::vector<Seam> operator()(const std::vector<Stripes>& rail) {
    for (const Stripes& stripes : rail) {
      Profile profile;
      PartialContour contour;
      for (std::size_t c = 0; c < kCameraCount; ++c) {
        translators_[c].translate(0, stripes[c], contour);
        profile.points.insert(profile.points.end(), contour.points.begin(), contour.points.end());
      }
      Registration registration;
      registrar_.registerProfile(profile.points, registration);
      seams_.add(profile, registration);
    }
    return seams_.take();
  }

 private:
  Registrar registrar_;
  std::vector<Translator> translators_;
  RailSeams seams_;
};

}  // namespace vignole::testing
