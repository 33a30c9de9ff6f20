#include "gui/theme/inscription.h"

#include <QImage>
#include <gtest/gtest.h>

#include "gui/theme/theme.h"

namespace vignole {
namespace {

TEST(Inscription, LimitsAreShortAndSigned) {
  EXPECT_EQ(shortSigned(0.6), QStringLiteral("+0.6"));
  EXPECT_EQ(shortSigned(-1.2), QChar(0x2212) + QStringLiteral("1.2"));
  EXPECT_EQ(shortSigned(-1e-12), QStringLiteral("0"));
  EXPECT_EQ(shortSigned(0.75), QStringLiteral("+0.75"));
}

TEST(Inscription, ThousandsAreParted) {
  EXPECT_EQ(count(999), QStringLiteral("999"));
  EXPECT_EQ(count(71204), QStringLiteral("71") + QChar(0x2009) + QStringLiteral("204"));
  EXPECT_EQ(count(1234567).size(), 9);
}

TEST(Inscription, AgesGrowCoarser) {
  EXPECT_EQ(age(1.24), QStringLiteral("1.2 s"));
  EXPECT_EQ(age(42.9), QStringLiteral("42 s"));
  EXPECT_EQ(age(134), QStringLiteral("2 min 14 s"));
  EXPECT_EQ(age(3 * 3600 + 5 * 60), QStringLiteral("3 h 5 min"));
}

TEST(Inscription, SubscriptIsNarrowerThanTheLetter) {
  const QFont font = uiFont(24, 500);
  EXPECT_LT(inscriptionWidth(font, "FT_r"), inscriptionWidth(font, "FTr"));
  EXPECT_GT(inscriptionWidth(font, "FT_r"), inscriptionWidth(font, "FT"));
  EXPECT_EQ(inscriptionWidth(font, "RH"), inscriptionWidth(font, "R") + inscriptionWidth(font, "H"));
}

TEST(Inscription, TooLongASentenceEndsWithinItsRoom) {
  QImage image(600, 40, QImage::Format_ARGB32);
  QPainter painter(&image);
  const QString sentence = QStringLiteral("WT 0.032 above the limit from 37.0 m on;  RAS_l near limit");
  const QFont font = uiFont(22);
  const double full = inscriptionWidth(font, sentence);
  EXPECT_DOUBLE_EQ(paintInscription(painter, 0, 30, font, sentence), full);
  const double cut = paintInscription(painter, 0, 30, font, sentence, full * 0.6);
  EXPECT_LE(cut, full * 0.6);
  EXPECT_GT(cut, full * 0.3);
}

}  // namespace
}  // namespace vignole
