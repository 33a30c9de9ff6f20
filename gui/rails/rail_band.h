#pragma once
// A rail from head to tail as a band: exceptions, where the replay is; a press goes there.

#include <QVector>
#include <QWidget>

#include "gui/theme/theme.h"
#include "report/state_symbol.h"

namespace vignole {

struct BandStretch {
  double fromM = 0, toM = 0;
  StateSymbol symbol = StateSymbol::Out;
};

class RailBand : public QWidget {
  Q_OBJECT

 public:
  explicit RailBand(const Theme& theme, QWidget* parent = nullptr);
  void setRail(double lengthM, QVector<BandStretch> stretches);
  void setPosition(double positionM);
  [[nodiscard]] QSize sizeHint() const override { return {600, 72}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {260, 72}; }

 signals:
  void positionAsked(double positionM);

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  [[nodiscard]] double xOf(double positionM) const;
  void ask(double x);

  const Theme& theme_;
  double lengthM_ = 0, positionM_ = 0;
  QVector<BandStretch> stretches_;
};

}  // namespace vignole
