#pragma once

// The folder app/report/files/ writes results as files. This file and answer_files.h write the complete
// set of a study, a comparison or a score through output_folder.h, which writes all files or none; the table
// of receivers is written here, too. Pictures and PDF pages come from app/report/sheets/.

#include <QIODevice>
#include <filesystem>
#include <string>
#include <vector>

#include "app/report/book/book.h"
#include "core/engines/api/shadow_field.h"
#include "core/geo/frame.h"
#include "core/io/files/check_output.h"
#include "core/study/contributions/place_contributions.h"
#include "core/study/study.h"

namespace noonmark {

/// Writes a table of the receivers, RFC 4180 with a heading: x_m, y_m (local metres of the cell's centre),
/// lon_deg, lat_deg (WGS84), gross_min, and continuous_min if continuous shadow was computed. Rows run from
/// south to north, and within each from west to east. False if the device did not accept all data. About 10^6
/// rows a second.
bool writeCellsCsv(const ShadowField& field, const Frame& frame, QIODevice& device);

struct StudyFileOptions {
    bool cellsCsv = false;                      ///< one line per receiver: writeCellsCsv()
    OutputRules rules{};                        ///< which files may be replaced
    int pictureWidth = noonmark::pictureWidth;  ///< of shadow.png, pixels
    LegendChoice legend{};                      ///< of pictures, pages and styles
    std::optional<BookSettings> book{};         ///< also sheets.pdf, a book so laid out
    std::vector<ContributionTable> ofPlaces{};  ///< of single places: a table, and a part of study.json
};

/// The names of the files of writeStudyFiles(), except region.geojson; known before the computation.
std::vector<std::string> studyFileNames(const StudySettings& settings, const StudyFileOptions& options);

/// Writes all outputs of a study into a folder, which is created if missing: shadow.tif with its style for
/// QGIS, shadow.qml; shadow.png, report.pdf, study.json; sheets.pdf on request; region.geojson where the
/// region is not a lon/lat box; cells.csv on request; by_month.tif, .qml and .csv, contributions.csv, .gpkg
/// and .pdf where the study has them. The window and the command line write the same files. Returns the paths
/// written; a file is written completely or not at all. Needs a QGuiApplication (the `offscreen` platform
/// suffices).
Result<std::vector<std::filesystem::path>> writeStudyFiles(const Study& study,
                                                           const std::filesystem::path& folder,
                                                           const StudyFileOptions& options);

}  // namespace noonmark
