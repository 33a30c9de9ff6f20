#pragma once
// The last rails as a row of verdicts, the one under way at the right end.

#include <QWidget>
#include <vector>

#include "gui/bridge/line.h"
#include "gui/theme/theme.h"
#include "report/state_symbol.h"

namespace vignole {

class LastRails : public QWidget {
  Q_OBJECT

 public:
  explicit LastRails(const Theme& theme, QWidget* parent = nullptr);
  void show(const LineSnapshot& line);
  [[nodiscard]] QSize sizeHint() const override { return {1055, 96}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {300, 56}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Tile {
    QString id, word;
    StateSymbol symbol = StateSymbol::NoLimit;
    bool now = false;
  };
  void paintTile(QPainter& painter, const QRectF& box, const Tile& tile) const;

  const Theme& theme_;
  std::vector<Tile> tiles_;
  QString summary_;
};

}  // namespace vignole
