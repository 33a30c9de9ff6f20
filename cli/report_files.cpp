#include "cli/report_files.h"

#ifdef VIGNOLE_REPORT
#include <QGuiApplication>
#include <array>

#include "report/document_pages.h"
#include "report/rail_report.h"
#endif

namespace vignole::cli {

Expected<void> checkReportFile(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension != ".pdf" && extension != ".png")
    return inputError(file.string(), "a report is .pdf or .png; name the file accordingly");
#ifdef VIGNOLE_REPORT
  return {};
#else
  return inputError("--report", "this program was built without reports; build it with VIGNOLE_GUI=ON");
#endif
}

Expected<void> checkDocumentFile(const std::filesystem::path& file) {
  if (file.extension() != ".pdf") return inputError(file.string(), "this report is .pdf; name the file accordingly");
  return checkReportFile(file);
}

#ifdef VIGNOLE_REPORT

namespace {

void ensureApplication() {
  static std::array<char, 12> name = {"vignole-cli"};
  static std::array<char*, 2> arguments = {name.data(), nullptr};
  static int count = 1;
  if (QGuiApplication::instance() != nullptr) return;
  // Errors are ours to tell, in one line; what Qt thinks of the environment is nobody's result.
  qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  // Lives until the program ends: Qt's fonts do not survive their application.
  static const QGuiApplication application(count, arguments.data());
}

}  // namespace

Expected<void> writeReport(const RailSummary& summary, const Recipe& recipe,
                           const std::optional<ProfileResult>& example, bool simulation,
                           const std::filesystem::path& file) {
  ensureApplication();
  RailReport report;
  report.summary = &summary;
  report.recipe = &recipe;
  report.example = example ? &*example : nullptr;
  report.programVersion = VIGNOLE_VERSION;
  report.simulation = simulation;
  return writeRailReport(report, file);
}

Expected<void> writeDocumentReport(const Document& document, const std::filesystem::path& file) {
  ensureApplication();
  return writeDocument(document, VIGNOLE_VERSION, file);
}

#else

Expected<void> writeReport(const RailSummary&, const Recipe&, const std::optional<ProfileResult>&, bool,
                           const std::filesystem::path& file) {
  return checkReportFile(file);
}

Expected<void> writeDocumentReport(const Document&, const std::filesystem::path& file) { return checkReportFile(file); }

#endif

}  // namespace vignole::cli
