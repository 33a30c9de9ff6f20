#pragma once
// Health between calibrations: what the seams of normal production say of each camera, rail by rail.

#include "gui/bridge/seam_watch.h"
#include "gui/bridge/units.h"
#include "gui/theme/panel.h"
#include "gui/theme/theme.h"

class QLabel;
class QTableWidget;

namespace vignole {

class PlotPicture;

class DriftPanel : public Panel {
  Q_OBJECT

 public:
  DriftPanel(const Theme& theme, const Units& units, QWidget* parent = nullptr);
  void show(std::shared_ptr<const DriftTrack> track);
  void retranslate();
  [[nodiscard]] QString words() const;

 private:
  void fill();

  const Theme& theme_;
  const Units& units_;
  std::shared_ptr<const DriftTrack> track_;
  QLabel* words_;
  PlotPicture* plot_;
  QTableWidget* cameras_;
};

}  // namespace vignole
