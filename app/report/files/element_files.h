#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/book/book.h"
#include "app/report/book/review/glazing_book.h"
#include "core/io/files/check_output.h"
#include "core/study/elements/element_map.h"

namespace noonmark {

/// How the layer of points is drawn: by the column that the legend shows, where it was measured.
LayerStyle styleColumn(const ElementMap& map, const LegendChoice& legend);

/// The names of the files of writeElementFiles(), except region.geojson.
std::vector<std::string> elementFileNames(ElementPlaces places);

/// Writes elements.csv, elements.gpkg, elements.glb (element_models.h), study.json and, of facades and
/// windows, elements.pdf (book/answer_books.h) into a folder, which is created if missing, and region.geojson
/// where only a polygon states the region. Returns the paths written; all files or none. Needs a
/// QGuiApplication.
Result<std::vector<std::filesystem::path>> writeElementFiles(const ElementStudy& study,
                                                             const BookSettings& settings,
                                                             const std::filesystem::path& folder,
                                                             const OutputRules& rules);

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
