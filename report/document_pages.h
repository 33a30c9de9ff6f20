#pragma once
// A document set in type on A4 pages.

#include <filesystem>
#include <string>

#include "engine/geometry/expected.h"
#include "report/document.h"

namespace vignole {

/// Written whole or not at all; .pdf. Tables break between rows and repeat their head; nothing else is torn apart.
/// Needs a QGuiApplication.
[[nodiscard]] Expected<void> writeDocument(const Document& document, const std::string& programVersion,
                                           const std::filesystem::path& file);

}  // namespace vignole
