#include "app/report/files/saved_files.h"

#include <QGuiApplication>

#include "app/report/book/answer_book.h"
#include "app/report/book/print_book.h"
#include "app/report/files/output_folder.h"
#include "app/report/files/place_maps.h"
#include "app/report/maps/element_legend.h"
#include "app/report/maps/write_png.h"
#include "core/io/styles/raster_style.h"
#include "core/io/write_raster.h"
#include "core/study/elements/element_gltf.h"

namespace noonmark {

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

const FileNames& savedPlaceNames() {
    static const FileNames names = [] {
        FileNames all{"places.csv", "places.gpkg", keptContributionsFile, "result.json"};
        all.insert(all.end(), placeMapNames().begin(), placeMapNames().end());
        return all;
    }();
    return names;
}

const FileNames& savedFigureNames() {
    static const FileNames names{"figures.csv", "result.pdf", "result.json"};
    return names;
}

WrittenFiles writeSavedMaps(const SavedResult& result, const SavedOrigin& origin, const SavedSource& source,
                            const std::function<SavedSheet(const SavedMaps&)>& makeSheetOf,
                            const std::filesystem::path& folder, const SavedLook& look) {
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
    files.add("result.qml", textContent(rasterStyle(coloursOf(sheet.map.legend))));
    files.add("result.png", [&](QIODevice& device) {
        return writePng(makePicture(sheet, look.pictureWidth), tags, device);
    });
    files.add("result.pdf", [&](QIODevice& device) { return writePdf(sheet, device); });
    files.add("result.json", textContent(result.settings));
    return std::move(files).result();
}

WrittenFiles writeSavedPoints(const SavedResult& result, const SavedElements& points, const City& city,
                              const std::filesystem::path& folder, const LegendChoice& legend,
                              const OutputRules& rules) {
    const ElementTable table = makeElementTable(points.map, city, points.source);
    const LayerStyle style = makeStyle(coloursOf(makeLegend(points.map, ShadowMeasure::gross, legend)));
    OutputFolder files(folder, rules);
    files.add("elements.csv", textContent(toCsv(table)));
    files.add("elements.gpkg",
              [&](const std::filesystem::path& file) { return writeElementsGeoPackage(file, table, style); });
    files.add("elements.glb", textContent(toGlb(points.map)));
    files.add("result.json", textContent(result.settings));
    return std::move(files).result();
}

WrittenFiles writeSavedPlaces(const SavedResult& result, SunOfCities sun,
                              const std::vector<KeptContributions>& ofPlaces, const City& city,
                              const std::filesystem::path& folder, const LegendChoice& legend,
                              const OutputRules& rules) {
    sun.baseline.city = city;
    const ElementTable table = makeTable(sun.baseline, sun.compared);
    OutputFolder files(folder, rules);
    files.add("places.csv", textContent(toCsv(table)));
    files.add("places.gpkg", [&](const std::filesystem::path& file) {
        return writePlacesGeoPackage(file, city.frame, sun.baseline.places, table,
                                     makeStyle(sun.baseline, {legend, {}}));
    });
    addPlaceMaps(files, std::make_shared<const SunOfCities>(sun), city,
                 {.colours = {legend, {}},
                  .cellM = result.grid.cellM > 0 ? result.grid.cellM : PlaceMapLook().cellM,
                  .tags = {{"RESULT", result.name}, {"SCENARIO", result.scenario}}});
    if (!ofPlaces.empty()) files.add(keptContributionsFile, textContent(contributionsCsv(ofPlaces, {})));
    files.add("result.json", textContent(result.settings));
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
