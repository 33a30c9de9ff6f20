#include "report/state_symbol.h"

#include <QImage>
#include <gtest/gtest.h>
#include <vector>

#include "painted_rail.h"

namespace vignole::test {

namespace {

const std::vector<StateSymbol> kAll = {
    StateSymbol::Good, StateSymbol::NoLimit, StateSymbol::Near,  StateSymbol::Out,       StateSymbol::NotMeasured,
    StateSymbol::Held, StateSymbol::Idle,    StateSymbol::Armed, StateSymbol::Measuring, StateSymbol::Fault};

/// As on a monochrome print: ink or no ink, by contrast with the ground.
QImage monochrome(StateSymbol symbol, const Palette& palette, int side) {
  QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
  image.fill(palette.panel);
  QPainter painter(&image);
  paintSymbol(painter, QRectF(0, 0, side, side), symbol, palette);
  painter.end();
  const int ground = qGray(palette.panel.rgb());
  QImage ink(side, side, QImage::Format_ARGB32);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      ink.setPixel(x, y, std::abs(qGray(image.pixel(x, y)) - ground) > 60 ? 0xff000000u : 0xffffffffu);
  return ink;
}

}  // namespace

class SymbolsOfATheme : public testing::TestWithParam<bool> {
 protected:
  const Palette& palette_ = GetParam() ? darkPalette() : lightPalette();
};

TEST_P(SymbolsOfATheme, DifferByShapeAlone) {
  for (const int side : {16, 24, 80})
    for (std::size_t a = 0; a < kAll.size(); ++a)
      for (std::size_t b = a + 1; b < kAll.size(); ++b)
        EXPECT_GT(differentPixels(monochrome(kAll[a], palette_, side), monochrome(kAll[b], palette_, side)),
                  side * side / 20)
            << "symbols " << a << " and " << b << " at " << side << " px";
}

TEST_P(SymbolsOfATheme, StayInTheirBox) {
  for (const StateSymbol symbol : kAll) {
    QImage image(64, 64, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::white);
    QPainter painter(&image);
    paintSymbol(painter, QRectF(16, 16, 32, 32), symbol, palette_);
    painter.end();
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x)
        if (x < 15 || x > 48 || y < 15 || y > 48) {
          ASSERT_EQ(image.pixelColor(x, y), QColor(Qt::white)) << x << ' ' << y;
        }
  }
}

INSTANTIATE_TEST_SUITE_P(Themes, SymbolsOfATheme, testing::Values(false, true),
                         [](const auto& theme) { return theme.param ? "Dark" : "Light"; });

TEST(StateSymbol, EveryVerdictHasItsOwn) {
  EXPECT_EQ(symbolOf(Verdict::Pass), StateSymbol::Good);
  EXPECT_EQ(symbolOf(Verdict::Near), StateSymbol::Near);
  EXPECT_EQ(symbolOf(Verdict::Fail), StateSymbol::Out);
  EXPECT_EQ(symbolOf(Verdict::NotMeasured), StateSymbol::NotMeasured);
  EXPECT_EQ(symbolOf(Verdict::NoLimit), StateSymbol::NoLimit);
}

TEST(StateSymbol, LeavesThePainterAsItWas) {
  QImage image(32, 32, QImage::Format_ARGB32_Premultiplied);
  QPainter painter(&image);
  painter.setPen(QPen(Qt::green, 3));
  paintSymbol(painter, QRectF(0, 0, 32, 32), StateSymbol::Near, lightPalette());
  EXPECT_EQ(painter.pen(), QPen(Qt::green, 3));
}

}  // namespace vignole::test
