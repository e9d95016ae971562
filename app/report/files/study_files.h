#pragma once

// The folder app/report/files/ writes results as files. study_files.h and answer_files.h write the complete
// set of a study, a comparison or a score through output_folder.h, which writes all files or none;
// cells_csv.h writes the table of receivers. Pictures and PDF pages come from app/report/sheets/.

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/book/book.h"
#include "core/io/files/check_output.h"
#include "core/study/contributions/place_contributions.h"
#include "core/study/study.h"

namespace noonmark {

struct StudyFileOptions {
    bool cellsCsv = false;                      ///< one line per receiver: see cells_csv.h
    OutputRules rules{};                        ///< which files may be replaced
    int pictureWidth = noonmark::pictureWidth;  ///< of shadow.png, pixels
    LegendChoice legend{};                      ///< of pictures, pages and styles
    std::optional<BookSettings> book{};         ///< also sheets.pdf, a book so laid out
    std::vector<KeptContributions> ofPlaces{};  ///< of single places: a table, and a part of study.json
};

/// The names of the files of writeStudyFiles(), except region.geojson; known before the computation.
std::vector<std::string> studyFileNames(const StudySettings& settings, const StudyFileOptions& options);

/// Writes all outputs of a study into a folder, which is created if missing: shadow.tif
/// with its style for QGIS shadow.qml, shadow.png,
/// report.pdf, study.json; sheets.pdf on request; region.geojson where the region is not a lon/lat box;
/// cells.csv on request; by_month.tif, .qml and .csv, contributions.csv, .gpkg and .pdf where the study has
/// them. The window and the command line write the same files. Returns the paths written; a file is written
/// completely or not at all. Needs a QGuiApplication (the `offscreen` platform suffices).
Result<std::vector<std::filesystem::path>> writeStudyFiles(const Study& study,
                                                           const std::filesystem::path& folder,
                                                           const StudyFileOptions& options);

}  // namespace noonmark
