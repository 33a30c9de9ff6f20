#include "report/typeface.h"

#include <QFontDatabase>
#include <QString>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace vignole {

namespace {

const QString kRoboto = QStringLiteral("Roboto");
const QString kFallback = QStringLiteral("DejaVu Sans");
const QString kChinese = QStringLiteral("Noto Sans CJK SC");

/// fontconfig may not know a font that is installed (no cache, another prefix): load the files themselves.
void loadFromFiles(const QString& folder, const QStringList& files) {
  for (const QString& file : files) QFontDatabase::addApplicationFont(folder + file);
}

QStringList availableFamilies() {
  if (!QFontDatabase::hasFamily(kRoboto))
    loadFromFiles(
        QStringLiteral("/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/"),
        {QStringLiteral("Roboto-Regular.ttf"), QStringLiteral("Roboto-Medium.ttf"), QStringLiteral("Roboto-Bold.ttf")});
  if (!QFontDatabase::hasFamily(kFallback))
    loadFromFiles(QStringLiteral("/usr/share/fonts/truetype/dejavu/"),
                  {QStringLiteral("DejaVuSans.ttf"), QStringLiteral("DejaVuSans-Bold.ttf")});
  QStringList families;
  for (const QString& family : {kRoboto, kFallback, kChinese})
    if (QFontDatabase::hasFamily(family)) families << family;
  return families;
}

}  // namespace

QFont typeface(double sizePx, QFont::Weight weight) {
  static const QStringList families = availableFamilies();
  QFont font;
  if (!families.isEmpty()) font.setFamilies(families);
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(sizePx))));
  font.setWeight(weight);
  // The same advance widths on a screen, in a picture and on paper: tables measured once fit everywhere.
  font.setHintingPreference(QFont::PreferNoHinting);
  // Spacing of a sixty-fourth of a pixel switches ligatures off: "profile" is found and copied letter by letter.
  font.setLetterSpacing(QFont::AbsoluteSpacing, 1.0 / 64);
  return font;
}

}  // namespace vignole
