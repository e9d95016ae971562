#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/book/book.h"
#include "core/io/files/check_output.h"
#include "core/study/elements/element_study.h"

namespace noonmark {

/// The names of the files of writeElementFiles(), except region.geojson.
std::vector<std::string> elementFileNames(ElementPlaces places);

/// Writes elements.csv, elements.gpkg, elements.glb (element_gltf.h), study.json and, of facades and windows,
/// elements.pdf (book/element_book.h) into a folder, which is created if missing, and region.geojson where
/// only a polygon states the region. Returns the paths written; all files or none. Needs a QGuiApplication.
Result<std::vector<std::filesystem::path>> writeElementFiles(const ElementStudy& study,
                                                             const BookSettings& settings,
                                                             const std::filesystem::path& folder,
                                                             const OutputRules& rules);

}  // namespace noonmark
