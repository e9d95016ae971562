#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/book/review/glazing_book.h"
#include "core/io/files/check_output.h"

namespace noonmark {

/// The files of a review of windows: review.json, windows.csv, windows.gpkg and sheets.pdf.
std::vector<std::string> glazingFileNames();

/// Writes the files of a review of windows into a folder, which is created if missing; all or none. Returns
/// the paths written. Needs a QGuiApplication. Errors of makeGlazingBook()
/// and of writing.
Result<std::vector<std::filesystem::path>> writeGlazingFiles(const GlazingBookSource& source,
                                                             const BookSettings& settings,
                                                             const std::filesystem::path& folder,
                                                             bool byteOrderMark, const OutputRules& rules,
                                                             Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
