#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/files/check_output.h"
#include "core/study/study.h"

namespace noonmark {

struct StudyFileOptions {
    bool cellsCsv = false;  ///< one line a receiver: see cells_csv.h
    OutputRules rules{};    ///< what may be replaced
};

/// The names of writeStudyFiles() but for region.geojson, known before the work is done.
std::vector<std::string> studyFileNames(const StudySettings& settings, const StudyFileOptions& options);

/// Everything a user leaves with, into a folder that is made when missing: shadow.tif, shadow.png,
/// report.pdf, study.json; region.geojson where the region is no lon/lat box; cells.csv on request;
/// by_month.tif and .csv, contributions.csv and .gpkg where the study has them. Returns the paths written.
/// Each file is whole or not there. Needs a QGuiApplication (the `offscreen` platform will do). The same
/// files from the window and the command line.
Result<std::vector<std::filesystem::path>> writeStudyFiles(const Study& study,
                                                           const std::filesystem::path& folder,
                                                           const StudyFileOptions& options);

}  // namespace noonmark
