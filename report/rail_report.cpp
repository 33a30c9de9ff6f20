#include "report/rail_report.h"

#include <QBuffer>
#include <QGuiApplication>
#include <algorithm>
#include <cctype>

#include "engine/files/atomic_file.h"
#include "report/rail_pages.h"
#include "report/rail_picture.h"

namespace vignole {

namespace {

std::string lowerExtension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

QByteArray pngOf(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  if (!buffer.open(QIODevice::WriteOnly) || !image.save(&buffer, "PNG")) return {};
  return bytes;
}

}  // namespace

Expected<void> writeRailReport(const RailReport& report, const std::filesystem::path& file) {
  const std::string extension = lowerExtension(file);
  if (extension != ".pdf" && extension != ".png")
    return inputError(file.string(), "a report is written as .pdf or .png; give the file one of these extensions");
  if (report.summary == nullptr || report.recipe == nullptr)
    return inputError(file.string(), "no rail to report on: the report needs a summary and its recipe");
  if (qGuiApp == nullptr) return worldError(file.string(), "pages need a QGuiApplication before they can be painted");
  const QByteArray bytes = extension == ".pdf" ? railPdf(report) : pngOf(railPicture(report, lightPalette()));
  if (bytes.isEmpty()) return worldError(file.string(), "the pages could not be painted; is there enough memory?");
  return writeFile(file, std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

}  // namespace vignole
