#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/report/book/book.h"
#include "app/report/files/output_folder.h"
#include "app/report/sheets/study_report.h"
#include "core/describe/figure_text.h"
#include "core/io/files/check_output.h"
#include "core/io/files/write_text.h"
#include "core/study/by_place/sun_by_place.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// How the maps of places look.
struct PlaceMapStyle {
    PlaceColours colours{};
    int widthPx = 1920;
    double cellM = 2;  ///< of the raster; doubled until it has at most 16 million cells
    FileTags tags{};
};

/// "sun_by_place.tif"; a picture and a style for QGIS of the period ("sun_by_place.png") and of each date
/// ("sun_by_place_2026-12-21.png").
std::vector<std::string> placeMapNames(std::span<const CivilDate> dates);

/// Adds the maps of the places as the window shows them: pictures, and a raster whose cells have the figures
/// of the smallest place that holds their centre. Bands: hours of sun a day over the period, those on each
/// date, where a baseline is compared the change in minutes, then minutes of shadow likewise. Pictures and
/// styles show sun or shadow as the legend does. Of the last of the cities. `look`: its
/// date is not read. Needs a QGuiApplication.
/// The raster has bands of all columns of trees, those of `sun` first; pictures and styles are of `shown`.
void addPlaceMaps(OutputFolder& files, std::shared_ptr<const SunOfCities> sun, const SunShown& shown,
                  const City& city, const PlaceMapStyle& look);

// The files of saved results. What is written is as it was saved: all files or none. Each function returns
// the paths that it wrote. Error: a file cannot be written. They need a QGuiApplication (the `offscreen`
// platform suffices). `source`: its city may differ from the one that was measured.

using WrittenFiles = Result<std::vector<std::filesystem::path>>;

/// How their maps look, and which files may be replaced.
struct SavedStyle {
    ChangeScale scale{};  ///< of a comparison
    LegendChoice legend{};
    int pictureWidth = noonmark::pictureWidth;  ///< pixels: see makePicture()
    OutputRules rules{};
    std::optional<std::string> sheets{};  ///< a PDF, written as sheetsFileName
};
inline constexpr const char* sheetsFileName = "sheets.pdf";

/// The maps, a band each, with their style; picture, page (study_report.h), settings and figures.
const std::vector<std::string>& savedMapNames();
WrittenFiles writeSavedMaps(const SavedResult& result, const SavedOrigin& origin, const SavedSource& source,
                            const std::function<SavedSheet(const SavedMaps&)>& makeSheetOf,
                            const std::filesystem::path& folder, const SavedStyle& look = {});

/// The tables of points, settings and figures.
const std::vector<std::string>& savedPointNames();
WrittenFiles writeSavedPoints(const SavedResult& result, const SavedElements& points, const City& city,
                              const std::filesystem::path& folder, const SavedStyle& look = {});

/// The tables of places and of what buildings take from some of them, settings and figures.
std::vector<std::string> savedPlaceNames(std::span<const CivilDate> dates);
WrittenFiles writeSavedPlaces(const SavedResult& result, SunOfCities sun,
                              const std::vector<ContributionTable>& ofPlaces, const City& city,
                              const std::filesystem::path& folder, const SavedStyle& look = {});

/// The figures of any result as a table, its pages, settings and figures.
const std::vector<std::string>& savedFigureNames();
WrittenFiles writeSavedFigures(const SavedResult& result, const SavedOrigin& origin,
                               const SavedSource& source, const std::vector<FigureLine>& lines,
                               const std::filesystem::path& folder, const BookSettings& book = {},
                               const OutputRules& rules = {});

}  // namespace noonmark
