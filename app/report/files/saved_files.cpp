#include "app/report/files/saved_files.h"

#include <QGuiApplication>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/report/book/answer_books.h"
#include "app/report/book/print_book.h"
#include "app/report/files/answer_files.h"
#include "app/report/files/element_files.h"
#include "app/report/maps/answer_legends.h"
#include "app/report/maps/write_png.h"
#include "core/describe/text.h"
#include "core/io/styles/qgis_style.h"
#include "core/io/write_raster.h"
#include "core/receivers/place_names.h"
#include "core/receivers/rasterize.h"
#include "core/study/by_place/place_tables.h"
#include "core/study/elements/element_models.h"
#include "scenarios/project/results/saved_answer.h"

namespace noonmark {

namespace {

using Values = std::vector<float>;

Grid gridOf(const std::vector<Place>& places, double cellM) {
    constexpr double maxCells = 16e6;
    const Box2 box = bounds(places);
    const glm::dvec2 size = glm::dvec2(box.high) - glm::dvec2(box.low);
    while (size.x * size.y / (cellM * cellM) > maxCells) cellM *= 2;
    return {box.low.x, box.low.y, cellM, std::max(1, int(std::ceil(size.x / cellM))),
            std::max(1, int(std::ceil(size.y / cellM)))};
}

/// A figure of each place.
struct PlaceBand {
    std::string name, unit;
    std::vector<double> ofPlaces;
};

// Of the period and of each date.
std::vector<PlaceColours> listMaps(const SunOfCities& all, ShownAs show) {
    std::vector<PlaceColours> maps{{.legend = {.show = show}}};
    for (std::size_t date = 0; date < all.baseline.settings.dates.size(); ++date)
        maps.push_back({.legend = {.show = show}, .date = date});
    return maps;
}

PlaceBand makeBand(const SunOfCities& all, const PlaceColours& map) {
    const SunByPlace& sun = shownCity(all);
    const ShownSunOrShadow shown = chooseShown(sun, map);
    const std::string when = map.date ? "on " + formatText(sun.settings.dates[*map.date]) : "a day";
    PlaceBand band{
        (shown.isShadow ? "minutes of shadow " : "hours of sun ") + when, shown.isShadow ? "min" : "h", {}};
    for (const SunOfPlace& of : sun.sun) band.ofPlaces.push_back(shown.of(hoursOf(of, map.date)));
    return band;
}

std::vector<PlaceBand> listBands(const SunOfCities& all) {
    std::vector<PlaceBand> bands;
    for (const PlaceColours& map : listMaps(all, ShownAs::sun)) bands.push_back(makeBand(all, map));
    if (!all.compared.empty()) {
        PlaceBand& change =
            bands.emplace_back(PlaceBand{"change of sun from " + all.baseline.name, "min/day", {}});
        for (const SunChange& of : all.compared.back().changes) change.ofPlaces.push_back(60 * of.meanHours);
    }
    for (const PlaceColours& map : listMaps(all, ShownAs::shadow))
        if (chooseShown(shownCity(all), map).isShadow) bands.push_back(makeBand(all, map));
    return bands;
}

// Those of the column that the answer states, then those with trees.
std::vector<PlaceBand> listAllBands(const SunOfCities& all) {
    std::vector<PlaceBand> bands = listBands(all);
    for (const TreeColumns column : listSunColumns(all)) {
        const auto with = inColumn(all, column);
        if (!with) continue;
        for (PlaceBand& band : listBands(*with)) {
            band.name += fmt::format(", {}", describeTrees(column));
            bands.push_back(std::move(band));
        }
    }
    return bands;
}

// Counted from 1. `all`: of all columns.
std::size_t bandOf(const SunOfCities& all, const PlaceColours& colours) {
    PlaceColours map{.legend = {.show = ShownAs::sun}, .date = colours.date};
    if (chooseShown(shownCity(all), colours).isShadow) map.legend.show = ShownAs::shadow;
    std::string name = makeBand(all, map).name;
    if (colours.column.value_or(TreeColumns::without) != TreeColumns::without)
        name += fmt::format(", {}", describeTrees(*colours.column));
    const std::vector<PlaceBand> bands = listAllBands(all);
    return std::size_t(std::ranges::find(bands, name, &PlaceBand::name) - bands.begin()) + 1;
}

// Small places lie on top.
std::vector<std::size_t> listLargestFirst(const std::vector<Place>& places) {
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<double> areas;
    for (const Place& place : places) areas.push_back(area(place));
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return areas[i]; });
    return order;
}

Result<void> writePlaceRaster(const SunOfCities& sun, const City& city, const PlaceMapStyle& look,
                              const std::filesystem::path& file) {
    const std::vector<Place>& places = sun.baseline.places;
    const Grid grid = gridOf(places, look.cellM);
    const std::vector<PlaceBand> bands = listAllBands(sun);
    std::vector<Values> values(bands.size(),
                               Values(std::size_t(grid.columns) * std::size_t(grid.rows), std::nanf("")));
    for (const std::size_t place : listLargestFirst(places))
        for (const std::uint32_t cell : collectCells(places[place].polygons, grid))
            for (std::size_t band = 0; band < bands.size(); ++band)
                values[band][cell] = float(bands[band].ofPlaces[place]);
    std::vector<RasterBand> written;
    for (std::size_t band = 0; band < bands.size(); ++band)
        written.push_back({bands[band].name, bands[band].unit, &values[band]});
    return writeGeoTiff(file, city.frame, grid, written, look.tags);
}

// The values of the band are those of the legend.
std::string styleOfBand(const SunOfCities& all, const SunOfCities& shown, const PlaceColours& colours) {
    ColourScale scale = makeScale(shownCity(shown), colours);
    if (scale.quantity.isSun()) scale.of = ColourScale::Of::wanted;
    scale.quantity = {};
    scale.paintsZero = true;
    return rasterStyle(scale, bandOf(all, colours));
}

std::string placeMapName(const std::optional<CivilDate>& date) {
    return date ? "sun_by_place_" + formatText(*date) : "sun_by_place";
}

// The picture of the places and the style of their band.
void addPlaceMap(OutputFolder& files, const SunOfCities& all, const std::shared_ptr<const SunOfCities>& sun,
                 const City& city, const PlaceMapStyle& look) {
    const std::vector<CivilDate>& dates = shownCity(*sun).settings.dates;
    const std::string name =
        placeMapName(look.colours.date ? std::optional(dates[*look.colours.date]) : std::nullopt);
    files.add(name + ".qml", textContent(styleOfBand(all, *sun, look.colours)));
    files.add(name + ".png", [sun, city, look](QIODevice& device) {
        return writePng(paintPlacesMap(shownCity(*sun), city, look.colours, look.widthPx), look.tags, device);
    });
}

}  // namespace

std::vector<std::string> placeMapNames(std::span<const CivilDate> dates) {
    std::vector<std::string> names{"sun_by_place.tif", "sun_by_place.qml", "sun_by_place.png"};
    for (const CivilDate& date : dates)
        names.insert(names.end(), {placeMapName(date) + ".qml", placeMapName(date) + ".png"});
    return names;
}

void addPlaceMaps(OutputFolder& files, std::shared_ptr<const SunOfCities> sun, const SunShown& shown,
                  const City& city, const PlaceMapStyle& look) {
    files.add("sun_by_place.tif", [sun, city, look](const std::filesystem::path& file) {
        return writePlaceRaster(*sun, city, look, file);
    });
    PlaceMapStyle of = look;
    of.colours = shown.colours;
    of.colours.date.reset();
    addPlaceMap(files, *sun, shown.sun, city, of);
    for (std::size_t date = 0; date < shownCity(*sun).settings.dates.size(); ++date) {
        of.colours.date = date;
        addPlaceMap(files, *sun, shown.sun, city, of);
    }
}

namespace {

using FileNames = std::vector<std::string>;

// Key, value and definition of each figure.
std::string figuresCsv(const std::vector<FigureLine>& lines) {
    CsvText csv({"figure", "value", "definition"});
    for (const FigureLine& line : lines)
        csv.text(std::string(line.figure->key))
            .number(line.value, line.figure->decimals)
            .text(std::string(line.figure->definition))
            .endRow();
    return csv.take();
}

}  // namespace

const FileNames& savedMapNames() {
    static const FileNames names{"result.tif", "result.qml", "result.png", "result.pdf", "result.json"};
    return names;
}

const FileNames& savedPointNames() {
    static const FileNames names{"elements.csv", "elements.gpkg", "elements.glb", "result.json"};
    return names;
}

FileNames savedPlaceNames(std::span<const CivilDate> dates) {
    FileNames names{"places.gpkg", contributionTableFile, contributionLayerFile, "result.json"};
    for (const PlaceTable& table : placeTables()) names.emplace_back(table.file);
    std::ranges::move(placeMapNames(dates), std::back_inserter(names));
    return names;
}

const FileNames& savedFigureNames() {
    static const FileNames names{"figures.csv", "result.pdf", "result.json"};
    return names;
}

namespace {

// Of the map with these trees; that without where it was not saved.
std::size_t bandOfTrees(const SavedResult& result, TreeColumns trees) {
    const auto found = std::ranges::find(result.layers, grossLayer + layerEnding(trees), &SavedLayer::name);
    return found == result.layers.end() ? 1 : std::size_t(found - result.layers.begin()) + 1;
}

void addSettings(OutputFolder& files, const SavedResult& result, const SavedStyle& look) {
    files.add("result.json", textContent(result.settings));
    if (look.sheets) files.add(sheetsFileName, textContent(*look.sheets));
}

}  // namespace

WrittenFiles writeSavedMaps(const SavedResult& result, const SavedOrigin& origin, const SavedSource& source,
                            const std::function<SavedSheet(const SavedMaps&)>& makeSheetOf,
                            const std::filesystem::path& folder, const SavedStyle& look) {
    if (qGuiApp == nullptr) return failure("Pictures and reports need a QGuiApplication", folder.string());
    const Region region = makeSavedRegion(result, origin, source.regions);
    const Sheet sheet = makeSheet(result, origin, makeSheetOf({source.city, region, look.scale, look.legend}),
                                  region, source);
    const FileTags tags{{"RESULT", result.name}, {"SCENARIO", result.scenario}};
    std::vector<RasterBand> bands;
    for (const SavedLayer& layer : result.layers) bands.push_back({layer.name, layer.unit, &layer.values});
    OutputFolder files(folder, look.rules);
    files.add("result.tif", [&](const std::filesystem::path& file) {
        return writeGeoTiff(file, source.city.frame, result.grid, bands, tags);
    });
    files.add("result.qml",
              textContent(rasterStyle(coloursOf(sheet.map.legend), bandOfTrees(result, look.legend.trees))));
    files.add("result.png", [&](QIODevice& device) {
        return writePng(makePicture(sheet, look.pictureWidth), tags, device);
    });
    files.add("result.pdf", [&](QIODevice& device) { return writePdf(sheet, device); });
    addSettings(files, result, look);
    return std::move(files).result();
}

WrittenFiles writeSavedPoints(const SavedResult& result, const SavedElements& points, const City& city,
                              const std::filesystem::path& folder, const SavedStyle& look) {
    const ElementTable table = makeElementTable(points.map, city, points.source);
    const LayerStyle style = styleColumn(points.map, look.legend);
    OutputFolder files(folder, look.rules);
    files.add("elements.csv", textContent(toCsv(table)));
    files.add("elements.gpkg",
              [&](const std::filesystem::path& file) { return writeElementsGeoPackage(file, table, style); });
    files.add("elements.glb", textContent(toGlb(points.map)));
    addSettings(files, result, look);
    return std::move(files).result();
}

WrittenFiles writeSavedPlaces(const SavedResult& result, SunOfCities sun,
                              const std::vector<ContributionTable>& ofPlaces, const City& city,
                              const std::filesystem::path& folder, const SavedStyle& look) {
    sun.baseline.city = city;
    const ElementTable table = makeTable(sun.baseline, sun.compared);
    OutputFolder files(folder, look.rules);
    for (const PlaceTable& one : placeTables())
        files.add(one.file, textContent(toCsv(one.make(sun.baseline, sun.compared))));
    const auto all = std::make_shared<const SunOfCities>(sun);
    const SunShown shown = showColumn(all, {look.legend, {}});
    files.add("places.gpkg", [&](const std::filesystem::path& file) {
        return writePlacesGeoPackage(file, city.frame, sun.baseline.places, table,
                                     makeStyle(shown.sun->baseline, shown.colours));
    });
    addPlaceMaps(files, all, shown, city,
                 {.colours = shown.colours,
                  .cellM = result.grid.cellM > 0 ? result.grid.cellM : PlaceMapStyle().cellM,
                  .tags = {{"RESULT", result.name}, {"SCENARIO", result.scenario}}});
    addPlaceContributions(files, ofPlaces, city, {});
    addSettings(files, result, look);
    return std::move(files).result();
}

WrittenFiles writeSavedFigures(const SavedResult& result, const SavedOrigin& origin,
                               const SavedSource& source, const std::vector<FigureLine>& lines,
                               const std::filesystem::path& folder, const BookSettings& book,
                               const OutputRules& rules) {
    if (qGuiApp == nullptr) return failure("Pictures and reports need a QGuiApplication", folder.string());
    auto pages = printBook(makeSavedBook(result, origin, source, lines, book));
    if (!pages) return tl::make_unexpected(pages.error());
    OutputFolder files(folder, rules);
    files.add("figures.csv", textContent(figuresCsv(lines)));
    files.add("result.pdf", textContent(pages->toStdString()));
    files.add("result.json", textContent(result.settings));
    return std::move(files).result();
}

}  // namespace noonmark
