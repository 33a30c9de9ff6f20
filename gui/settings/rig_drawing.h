#pragma once
// The rig as the calibration in force has it (the paper's Fig. 1): cameras, their axes and what they see of the light
// plane, along the rail and from its side.

#include <QPolygonF>
#include <QWidget>
#include <array>

#include "engine/geometry/transform2.h"
#include "engine/optics/calibration.h"
#include "engine/rail/section.h"
#include "gui/bridge/units.h"
#include "gui/theme/theme.h"

class QPainter;

namespace vignole {

class RigDrawing : public QWidget {
  Q_OBJECT

 public:
  RigDrawing(const Theme& theme, const Units& units, QWidget* parent = nullptr);
  /// `worldFromSection`: where the rail was seen last.
  void show(const RigCalibration& calibration, const Section& section, const Transform2& worldFromSection);
  /// Of a camera's centre from the point of the light plane that its axis meets, mm; 0 before show().
  [[nodiscard]] double distanceMm(int camera) const { return stations_[static_cast<std::size_t>(camera)].distanceMm; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {480, 300}; }

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Station {
    QString serial;
    Point3 centre = Point3::Zero(), aim = Point3::Zero();  ///< in the world
    double distanceMm = 0, elevationDeg = 0;               ///< elevation: out of the light plane
    QPolygonF field;                                       ///< of view, on the light plane, mm
  };
  /// One of the two views: world mm -> px.
  struct View {
    QRectF area;
    int right = 0;  ///< axis of the world that points right: 0 x, 2 z
    QPointF centreMm;
    double pxPerMm = 1;
    [[nodiscard]] QPointF map(const Point3& p) const;
  };
  [[nodiscard]] View fitted(const QRectF& area, int right) const;
  void paintView(QPainter& painter, const View& view, const QString& title);

  const Theme& theme_;
  const Units& units_;
  std::array<Station, kCameraCount> stations_;
  QPolygonF rail_;  ///< mm in the world
  bool known_ = false;
};

}  // namespace vignole
