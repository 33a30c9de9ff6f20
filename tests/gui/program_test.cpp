// The program as a person starts it.

#include <QFile>
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <gtest/gtest.h>

namespace vignole {
namespace {

struct Outcome {
  int exitCode = -1;
  QByteArray out, err;
};

Outcome start(const QStringList& arguments) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.remove("QT_QPA_PLATFORM");
  environment.remove("DISPLAY");
  environment.remove("WAYLAND_DISPLAY");
  process.setProcessEnvironment(environment);
  process.start(VIGNOLE_PROGRAM, arguments);
  if (!process.waitForFinished(120000)) {
    process.kill();
    process.waitForFinished();
    return {};
  }
  return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

void expectOneLine(const Outcome& outcome, const QByteArray& naming) {
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_TRUE(outcome.out.isEmpty()) << outcome.out.constData();
  EXPECT_EQ(outcome.err.count('\n'), 1) << outcome.err.constData();
  EXPECT_TRUE(outcome.err.contains(naming)) << outcome.err.constData();
}

TEST(Program, RefusesWhatItDoesNotKnowInOneLine) {
  expectOneLine(start({"--colour", "red"}), "--colour");
  expectOneLine(start({"--page", "cellar", "--screenshot", "x.png"}), "cellar");
  expectOneLine(start({"--theme", "pink"}), "pink");
  expectOneLine(start({"--size", "huge"}), "huge");
  expectOneLine(start({"--recipe", "no-such-rail"}), "no-such-rail");
  expectOneLine(start({"--deviation", "XX=1"}), "XX");
  expectOneLine(start({"--fault", "explode"}), "explode");
  expectOneLine(start({"--effect", "magic=on"}), "magic");
}

TEST(Program, HelpAndVersionGoToStdout) {
  const Outcome help = start({"--help"});
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_TRUE(help.out.contains("--screenshot"));
  EXPECT_TRUE(start({"--version"}).out.startsWith("vignole "));
}

TEST(Program, WithoutADisplayItSaysSo) {
  const Outcome outcome = start({});
  EXPECT_EQ(outcome.exitCode, 3);
  EXPECT_TRUE(outcome.err.contains("display")) << outcome.err.constData();
}

TEST(Program, WritesAPictureOfMonitor) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("monitor.png");
  const Outcome outcome =
      start({"--page", "monitor", "--screenshot", file, "--theme", "dark", "--size", "1366x768", "--after", "2"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err.constData();
  EXPECT_TRUE(outcome.err.isEmpty()) << outcome.err.constData();
  const QImage picture(file);
  EXPECT_EQ(picture.size(), QSize(1366, 768));
  EXPECT_LT(picture.pixelColor(3, 300).lightness(), 60) << "dark theme";
}

TEST(Program, APictureThatCannotBeWrittenIsAnError) {
  const Outcome outcome = start({"--screenshot", "/no/such/folder/x.png", "--after", "0"});
  EXPECT_EQ(outcome.exitCode, 3);
  EXPECT_TRUE(outcome.err.contains("/no/such/folder/x.png")) << outcome.err.constData();
}

TEST(Program, SelfTestPrintsOneJsonDocument) {
  const Outcome outcome = start({"--self-test", "4"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err.constData();
  QJsonParseError error;
  const QJsonObject json = QJsonDocument::fromJson(outcome.out, &error).object();
  ASSERT_EQ(error.error, QJsonParseError::NoError) << outcome.out.constData();
  const QJsonObject triggers = json["triggers"].toObject();
  for (const char* key : {"seen", "measured", "incomplete", "lost"})
    EXPECT_TRUE(triggers.contains(QLatin1String(key))) << key;
  EXPECT_GT(triggers["seen"].toInt(), 0);
  EXPECT_GT(triggers["measured"].toInt(), 0);
  for (const char* key : {"p50", "p99", "max"})
    EXPECT_TRUE(json["event_loop_ms"].toObject().contains(QLatin1String(key))) << key;
  EXPECT_GT(json["gui_cpu_share"].toDouble(), 0);
  EXPECT_GT(json["engine_cpu_share"].toDouble(), 0);
  EXPECT_GT(json["rss_mb"].toObject()["start"].toDouble(), 10);
}

}  // namespace
}  // namespace vignole
