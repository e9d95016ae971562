#pragma once

#include <filesystem>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "app/report/book/review/review_book.h"
#include "app/report/files/output_folder.h"
#include "core/base/progress.h"
#include "core/io/files/check_output.h"
#include "core/io/shadows/write_shadows.h"

namespace noonmark {

enum class ShadowFormat { dxf, geoPackage, geoJson, svg };

struct ShadowFileSettings {
    std::set<ShadowFormat> formats{ShadowFormat::dxf, ShadowFormat::geoPackage};
    DrawingPlane plane = DrawingPlane::local;
    double scale = 2000;  ///< of SVG
};

/// The names of the files of a drawing: shadows.dxf, shadows.gpkg; shadows.geojson, and buildings, places,
/// fan, isochrones and distances .geojson; shadows_TIME.svg for each time. Before the drawing is made, some
/// of them may not come about.
std::vector<std::string> shadowFileNames(const std::vector<DrawnTime>& times,
                                         const ShadowFileSettings& settings);

/// Adds the files to a folder's set. `drawing` must live until the set is written.
void addShadowFiles(OutputFolder& files, const ShadowDrawing& drawing, const ShadowFileSettings& settings);

/// The files of a review: review.json, review.csv, sheets.pdf, shadows.dxf and shadows.gpkg.
std::vector<std::string> reviewFileNames();

struct ReviewFileSettings {
    bool byteOrderMark = false;  ///< review.csv begins with one, by which Excel recognises UTF-8
    OutputRules rules;           ///< which files may be replaced
};

/// Draws the shadows of the rule's days and hours, and writes the files of a review into a folder, which is
/// created if missing; all or none. `sheets`: the book of makeReviewBook(). Returns the paths written. Needs
/// a QGuiApplication; may run on any thread. Errors of drawReviewShadows(), and of writing; cancelled().
Result<std::vector<std::filesystem::path>> writeReviewFiles(const ReviewBookSource& source,
                                                            const Book& sheets,
                                                            const ReviewFileSettings& settings,
                                                            const std::filesystem::path& folder,
                                                            Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
