#pragma once
// The hero of Monitor: the measured profile over the section.

#include <QWidget>
#include <memory>
#include <optional>

#include "gui/bridge/line.h"
#include "gui/theme/theme.h"
#include "report/profile_drawing.h"

namespace vignole {

class ProfileCanvas : public QWidget {
  Q_OBJECT

 public:
  /// The recipe of the line outlives the widget.
  ProfileCanvas(const Theme& theme, const Recipe& recipe, QWidget* parent = nullptr);

  void show(const LineSnapshot& line);
  void setView(ProfileView view);
  void setMagnification(double magnification);
  void setByCamera(bool byCamera);
  void setBeforeRegistration(bool before);
  void setUnit(LengthUnit unit);
  void retranslate();
  void setSelected(std::optional<Dimension> dimension);

  [[nodiscard]] const ProfileDrawing& drawing() const { return drawing_; }
  [[nodiscard]] QSize sizeHint() const override { return {784, 600}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Theme& theme_;
  std::shared_ptr<const ProfileResult> result_;  ///< keeps what drawing_ points at
  ProfileDrawing drawing_;
};

}  // namespace vignole
