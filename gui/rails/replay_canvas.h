#pragma once
// A stored profile drawn as Monitor draws a live one.

#include <QWidget>
#include <memory>

#include "gui/rails/stored_profile.h"
#include "gui/theme/theme.h"
#include "report/profile_drawing.h"

namespace vignole {

class ReplayCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit ReplayCanvas(const Theme& theme, QWidget* parent = nullptr);
  void show(std::shared_ptr<const OpenedRail> rail, std::shared_ptr<const ProfileResult> profile,
            std::optional<Dimension> selected);
  void setBeforeRegistration(bool before);
  void setMessage(const QString& message);  ///< in place of a drawing
  [[nodiscard]] const ProfileDrawing& drawing() const { return drawing_; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {260, 200}; }

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  const Theme& theme_;
  std::shared_ptr<const OpenedRail> rail_;
  std::shared_ptr<const ProfileResult> profile_;
  ProfileDrawing drawing_;
  QString message_;
};

}  // namespace vignole
