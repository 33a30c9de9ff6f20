// Widgets without a screen: one application for all tests, and no warning of Qt passes unseen.

#include <QApplication>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>

#include "gui/theme/theme.h"

namespace {

void failOnWarning(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message) {
  if (type == QtDebugMsg || type == QtInfoMsg) return;
  // The platform without a screen says so of every window that has a least size or comes to the front.
  if (message == QStringLiteral("This plugin does not support propagateSizeHints()") ||
      message == QStringLiteral("This plugin does not support raise()"))
    return;
  ADD_FAILURE() << "Qt warns: " << message.toStdString();
}

}  // namespace

int main(int argc, char** argv) {
  setenv("QT_QPA_PLATFORM", "offscreen", 0);
  ::testing::InitGoogleTest(&argc, argv);
  QApplication app(argc, argv);
  if (auto fonts = vignole::installFonts(); !fonts) {
    std::fprintf(stderr, "%s\n", fonts.error().message().c_str());
    return 3;
  }
  qInstallMessageHandler(failOnWarning);
  return RUN_ALL_TESTS();
}
