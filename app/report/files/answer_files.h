#pragma once

#include <filesystem>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "app/report/book/book.h"
#include "app/report/book/review/review_book.h"
#include "app/report/files/output_folder.h"
#include "app/report/maps/change_scale.h"
#include "app/report/sheets/answer_reports.h"
#include "app/report/sheets/sheet.h"
#include "core/base/progress.h"
#include "core/io/files/check_output.h"
#include "core/io/shadows/write_shadows.h"
#include "core/io/write_raster.h"
#include "core/study/contributions/place_contributions.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

/// Writes the files of a comparison into a folder, which is created if missing: impact.tif with
/// its style impact.qml, impact.png,
/// impact.pdf, impact.json, impact.csv, and region.geojson where the repeat command names it. The window and
/// the command line write the same files. `rules`: which files may be replaced.
/// `sheets`: also write sheets.pdf, a book so laid out. `width` of the picture in pixels: see makePicture().
/// Returns the paths written; a file is written completely or not at all. Needs a QGuiApplication (the
/// `offscreen` platform suffices).
Result<std::vector<std::filesystem::path>> writeImpactFiles(
    const ImpactAnswer& answer, const AnswerSource& source, const ChangeScale& scale,
    const std::filesystem::path& folder, const OutputRules& rules = {}, const BookSettings* sheets = nullptr,
    int width = pictureWidth, const LegendChoice& legend = {});

/// The same for a score: score.tif, score.qml, score.png, score.pdf, score.json, score.csv.
Result<std::vector<std::filesystem::path>> writeScoreFiles(
    const ScoreAnswer& answer, const AnswerSource& source, const std::filesystem::path& folder,
    const OutputRules& rules = {}, const BookSettings* sheets = nullptr, int width = pictureWidth,
    const LegendChoice& legend = {});

/// The number of the band with these values, counted from 1; 1 where there is none.
std::size_t numberOf(const std::vector<RasterBand>& bands, const std::vector<float>& values);

/// The names of those files, known before the computation; `provenance` states the region.
std::vector<std::string> impactFileNames(const Provenance& provenance, bool withSheets = false);
std::vector<std::string> scoreFileNames(const Provenance& provenance, bool withSheets = false);

/// contributions.csv and contributions.gpkg of a place, as those of a study, and by_month.csv.
std::vector<std::string> contributionFileNames(const PlaceContributions& of);

/// Writes them, all or none, as what `study` holds of the place. Returns the paths written.
Result<std::vector<std::filesystem::path>> writeContributionFiles(const Study& study,
                                                                  const PlaceContributions& of,
                                                                  const std::filesystem::path& folder,
                                                                  const OutputRules& rules);

enum class ShadowFormat { dxf, geoPackage, geoJson, svg };

struct ShadowFileSettings {
    std::set<ShadowFormat> formats{ShadowFormat::dxf, ShadowFormat::geoPackage};
    DrawingPlane plane = DrawingPlane::local;
    double scale = 2000;  ///< of SVG
};

/// The names of the files of a drawing: shadows.dxf, shadows.gpkg; shadows.geojson, and buildings, places,
/// fan, isochrones and distances .geojson; shadows_TIME.svg for each time. Known before the drawing is made;
/// some of them may not be written.
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

/// contributions_of_places.csv and .gpkg: what buildings take from places that were asked about one by one.
std::vector<std::string> placeContributionNames(const std::vector<ContributionTable>& ofPlaces);
/// Adds them; nothing where there are none. `city`: with the buildings.
void addPlaceContributions(OutputFolder& files, const std::vector<ContributionTable>& ofPlaces,
                           const City& city, const Provenance& provenance);
/// tree_contributions.csv and .gpkg; nothing where there are none. `trees`: of the study's city.
void addTreeContributions(OutputFolder& files, const std::vector<TreeContribution>& trees,
                          const Study& study);

}  // namespace noonmark
