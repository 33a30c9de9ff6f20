// vignole: the HMI. Composition root: makes the line, hands it to the window, sets theme and fonts.

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QSettings>
#include <QStandardPaths>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <malloc.h>
#include <unistd.h>

#include "gui/bridge/calibration_in_force.h"
#include "gui/bridge/self_test.h"
#include "gui/bridge/virtual_line.h"
#include "gui/languages/languages.h"
#include "gui/main_window/main_window.h"
#include "gui/main_window/options.h"
#include "gui/main_window/page_round.h"
#include "gui/monitor/dimension_table.h"
#include "gui/monitor/monitor_page.h"

namespace {

using namespace vignole;

enum ExitCode : int { kDone = 0, kBadInput = 2, kWorldFailed = 3 };

int fail(const Error& error) {
  std::fprintf(stderr, "vignole: %s\n", error.message().c_str());
  return error.kind == ErrorKind::Input ? kBadInput : kWorldFailed;
}

bool hasDisplay() { return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY"); }

/// Pictures and self-tests need no display; a person does.
Expected<void> choosePlatform(const Options& options) {
  if (qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) return {};
  if (options.pictures() || (options.unattended() && !hasDisplay()))
    qputenv("QT_QPA_PLATFORM", "offscreen");
  else if (!hasDisplay())
    return worldError("display",
                      "there is none (DISPLAY and WAYLAND_DISPLAY are empty); use vignole-cli inspect, or "
                      "--screenshot FILE for a picture of the window");
  return {};
}

/// Qt would write a warning of its own where a service or a container has no session.
void provideRuntimeDirectory() {
  if (!qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR")) return;
  const QString folder = QDir::tempPath() + QStringLiteral("/vignole-runtime-%1").arg(getuid());
  if (QDir().mkpath(folder) && QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner))
    qputenv("XDG_RUNTIME_DIR", folder.toLocal8Bit());
}

/// Rails are kept where a person sits, or where it is asked for; pictures and self-tests leave nothing behind.
struct Records {
  std::optional<Archive> archive;
  std::unique_ptr<RailWriter> writer;
  std::string url, problem;
};

Records openRecords(const Options& options, bool unattended) {
  Records records;
  records.url = options.archive;
  if (records.url.empty()) {
    if (unattended) {
      records.problem = "no archive was asked for (--archive)";
      return records;
    }
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    QDir().mkpath(folder);
    records.url = (folder + QStringLiteral("/rails.db")).toStdString();
  }
  RailWriterSettings settings;
  settings.place.source = "virtual";
  settings.place.program = VIGNOLE_VERSION;
  auto writer = RailWriter::open(records.url, settings);
  if (!writer) {
    records.problem = writer.error().message();
  } else {
    records.writer = *std::move(writer);
  }
  auto archive = Archive::open(records.url);
  if (archive)
    records.archive = std::move(*archive);
  else
    records.problem = archive.error().message();
  return records;
}

int run(const Options& options) {
  if (auto fonts = installFonts(); !fonts) return fail(fonts.error());
  auto line = VirtualLine::create(options.line);
  if (!line) return fail(line.error());
  Theme theme(options.dark);
  Session session;
  Units units;
  Languages languages;
  if (!options.language.empty()) languages.use(QString::fromStdString(options.language));
  const bool remembers = !options.unattended();
  if (remembers) {
    // What a person chose on this machine, unless the command line says otherwise.
    const QSettings chosen(QStringLiteral("vignole"), QStringLiteral("vignole"));
    if (!options.dark) theme.setDark(chosen.value(QStringLiteral("dark"), false).toBool());
    if (chosen.value(QStringLiteral("inches"), false).toBool()) units.setLength(Units::Length::Inch);
    if (options.language.empty())
      languages.use(chosen.value(QStringLiteral("language"), Languages::ofThisMachine()).toString());
    QObject::connect(&languages, &Languages::changed, [&languages] {
      QSettings(QStringLiteral("vignole"), QStringLiteral("vignole"))
          .setValue(QStringLiteral("language"), languages.code());
    });
    QObject::connect(&theme, &Theme::changed, [&theme] {
      QSettings(QStringLiteral("vignole"), QStringLiteral("vignole")).setValue(QStringLiteral("dark"), theme.dark());
    });
    QObject::connect(&units, &Units::changed, [&units] {
      QSettings(QStringLiteral("vignole"), QStringLiteral("vignole"))
          .setValue(QStringLiteral("inches"), units.length() == Units::Length::Inch);
    });
  }
  Records records = openRecords(options, options.unattended());
  (*line)->record(records.writer.get());
  if (records.archive) {
    auto inForce = calibrationInForce(*records.archive, (*line)->calibration());
    if (!inForce) return fail(inForce.error());
    if (*inForce) (*line)->useCalibration(**inForce);
  }
  Workplace place{theme, **line, session, units};
  place.archive = records.archive ? &*records.archive : nullptr;
  place.archiveUrl = records.url;
  place.archiveProblem = records.problem;
  place.writer = records.writer.get();
  place.languages = &languages;
  MainWindow window(place);
  window.resize(options.size);
  ProcessUse begin = processUse();
  (*line)->start();
  if (options.unattended())
    window.show();
  else
    window.showMaximized();
  if (const auto chosen = dimensionFromName(options.chosenDimension)) window.monitor().table().choose(chosen);
  window.showPage(options.page);
  window.startTicking();
  // Once on a machine, and when it is asked for.
  if (const QSettings chosen(QStringLiteral("vignole"), QStringLiteral("vignole"));
      options.tour || (remembers && !chosen.value(QStringLiteral("tourSeen"), false).toBool()))
    window.startTour();
  if (remembers)
    QObject::connect(&window, &MainWindow::tourLeft, [] {
      QSettings(QStringLiteral("vignole"), QStringLiteral("vignole")).setValue(QStringLiteral("tourSeen"), true);
    });

  int exitCode = kDone;
  std::optional<PageRound> round;
  std::optional<PagePictures> pictures;
  if (options.switchPagesS) round.emplace(window, *options.switchPagesS);
  if (!options.screens.empty()) {
    // The first waits for the line to have something to show.
    QTimer::singleShot(static_cast<int>(options.afterS * 1000), &window, [&] {
      pictures.emplace(window, theme, options.screens, 1.5);
      QObject::connect(&*pictures, &PagePictures::ended, &window, [&](const QString& problem) {
        if (!problem.isEmpty()) exitCode = fail({"--screens", problem.toStdString(), ErrorKind::World});
        QCoreApplication::exit();
      });
    });
  } else if (!options.screenshot.empty()) {
    QTimer::singleShot(static_cast<int>(options.afterS * 1000), &window, [&] {
      window.tick(PullDetail::Everything);
      if (auto saved = savePicture(window, options.screenshot); !saved) exitCode = fail(saved.error());
      QCoreApplication::exit();  // quit() would ask the window, which asks people
    });
  } else if (options.selfTestS) {
    // Shares and memory are those of the running program: fonts, buffers and the first picture come before.
    const double warmUpS = std::min(2.0, *options.selfTestS / 4);
    QTimer::singleShot(static_cast<int>(warmUpS * 1000), &window, [&] { begin = processUse(); });
    QTimer::singleShot(static_cast<int>(*options.selfTestS * 1000), &window, [&] {
      const std::string json =
          selfTestJson((*line)->pull(PullDetail::Everything), window.watchdog(), begin, processUse());
      std::printf("%s\n", json.c_str());
      QCoreApplication::exit();  // quit() would ask the window, which asks people
    });
  }
  const int code = QApplication::exec();
  line->reset();  // joins its threads before the writer goes
  if (records.writer)
    if (auto closed = records.writer->close(); !closed) return fail(closed.error());
  return code != 0 ? code : exitCode;
}

}  // namespace

int main(int argc, char** argv) {
  // Profiles are made by one thread and let go of by another: with an arena a thread the heap spreads to twice its
  // size.
  mallopt(M_ARENA_MAX, 4);
  mallopt(M_MMAP_THRESHOLD, 256 * 1024);
  const OptionsOutcome outcome = readOptions(argc, argv, VIGNOLE_VERSION);
  if (!outcome.options) {
    std::fputs(outcome.text.c_str(), outcome.exitCode == 0 ? stdout : stderr);
    return outcome.exitCode;
  }
  if (auto platform = choosePlatform(*outcome.options); !platform) return fail(platform.error());
  provideRuntimeDirectory();
  int qtArgc = 1;  // the command line is ours; Qt's own options come from its environment variables
  const QApplication app(qtArgc, argv);
  QApplication::setApplicationName(QStringLiteral("vignole"));
  QApplication::setApplicationVersion(QStringLiteral(VIGNOLE_VERSION));
  return run(*outcome.options);
}
