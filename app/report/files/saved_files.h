#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/sheets/saved_report.h"
#include "core/io/files/check_output.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// result.tif with its style result.qml, result.png, result.pdf and result.json; of points elements.csv,
/// elements.gpkg, elements.glb and result.json.
std::vector<std::string> savedFileNames(const SavedResult& result);

/// Of a study at points: its tables, as they were when it was saved. Of others: the maps of a saved result, a
/// band each, its picture and its page (saved_report.h), and its settings and figures as they were saved.
/// `scale`: of a comparison. `width` of the picture in pixels: see makePicture(). Returns the paths written;
/// all files or none. Error: the result cannot be read (readSavedAnswer), or a file cannot be written. Needs
/// a QGuiApplication (the `offscreen` platform suffices).
Result<std::vector<std::filesystem::path>> writeSavedFiles(
    const SavedResult& result, const SavedSource& source, const ChangeScale& scale,
    const std::filesystem::path& folder, const OutputRules& rules = {}, int width = pictureWidth,
    const LegendChoice& legend = {});

}  // namespace noonmark
