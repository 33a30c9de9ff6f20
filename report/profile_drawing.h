#pragma once
// The hero of Monitor and of the report: the measured profile over the section, deviations magnified, tolerance band,
// stretches out of tolerance, a dimension drawn as in the paper's Fig. 5.

#include <QPainter>
#include <QRectF>
#include <optional>
#include <string>

#include "engine/measurement/measurement.h"
#include "engine/profile/profile.h"
#include "engine/registration/registration.h"
#include "report/length_unit.h"
#include "report/palette.h"

namespace vignole {

enum class ProfileView { Whole, Head, Web, Foot };

struct ProfileDrawing {
  const Section* section = nullptr;                       ///< required
  const PerDimension<ToleranceLimits>* limits = nullptr;  ///< for the tolerance band; may be null
  const Profile* profile = nullptr;                       ///< null: model only
  const Registration* registration = nullptr;
  const Measurement* measurement = nullptr;
  double magnification = 20;  ///< of deviations, 1 .. 100
  ProfileView view = ProfileView::Whole;
  bool byCamera = false;
  bool beforeRegistration = false;  ///< the points as the cameras saw them, and where registration brought them (Fig. 3)
  bool held = false;                                ///< the source stopped: grey
  std::string heldNote;                             ///< "last profile at 23.18 m, 2 min ago"; below the word Held
  const DimensionParameters* parameters = nullptr;  ///< where the dimensions are taken; null: the defaults
  std::optional<Dimension> selected;
  LengthUnit unit = LengthUnit::Millimetre;
};

/// Fills `area`, legend and scale bars included, ground not. The painter's font is body text (16 px in the mock-ups):
/// it gives the family, and all other text scales with its size. Thread: any that may paint.
void paintProfile(QPainter& painter, const QRectF& area, const ProfileDrawing& drawing, const Palette& palette);

}  // namespace vignole
