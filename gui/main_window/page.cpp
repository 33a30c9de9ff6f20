#include "gui/main_window/page.h"

#include <QCoreApplication>

namespace vignole {

namespace {
constexpr std::array<PageName, kPageCount> kNames = {{
    {QT_TRANSLATE_NOOP("Page", "Monitor"), "monitor", "monitor"},
    {QT_TRANSLATE_NOOP("Page", "Stripes"), "stripes", "stripes"},
    {QT_TRANSLATE_NOOP("Page", "Charts"), "charts", "charts"},
    {QT_TRANSLATE_NOOP("Page", "Rails"), "rails", "rails"},
    {QT_TRANSLATE_NOOP("Page", "Calibration"), "calibration", "calibration"},
    {QT_TRANSLATE_NOOP("Page", "Recipes"), "recipes", "recipes"},
    {QT_TRANSLATE_NOOP("Page", "Quality"), "quality", "quality"},
    {QT_TRANSLATE_NOOP("Page", "Alarms"), "alarms", "alarms"},
    {QT_TRANSLATE_NOOP("Page", "Diagnostics"), "diagnostics", "diagnostics"},
    {QT_TRANSLATE_NOOP("Page", "Settings"), "settings", "settings"},
}};
}  // namespace

const PageName& pageName(PageId page) { return kNames[static_cast<std::size_t>(page)]; }
QString pageWord(PageId page) { return QCoreApplication::translate("Page", pageName(page).word); }

}  // namespace vignole
