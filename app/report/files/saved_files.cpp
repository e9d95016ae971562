#include "app/report/files/saved_files.h"

#include <QGuiApplication>

#include "app/report/files/output_folder.h"
#include "app/report/maps/raster_style.h"
#include "app/report/maps/write_png.h"
#include "core/io/write_raster.h"
#include "core/study/elements/element_gltf.h"

namespace noonmark {

namespace {

Result<std::vector<std::filesystem::path>> writeElements(const SavedResult& result,
                                                         const SavedElements& saved, const City& city,
                                                         const std::filesystem::path& folder,
                                                         const OutputRules& rules) {
    const ElementTable table = makeElementTable(saved.map, city, saved.source);
    OutputFolder files(folder, rules);
    files.add("elements.csv", textContent(toCsv(table)));
    files.add("elements.gpkg",
              [&](const std::filesystem::path& file) { return writeElementsGeoPackage(file, table); });
    files.add("elements.glb", textContent(toGlb(saved.map)));
    files.add("result.json", textContent(result.settings));
    return std::move(files).result();
}

Result<std::vector<std::filesystem::path>> writePlaces(const SavedResult& result, SunOfCities sun,
                                                       const City& city, const std::filesystem::path& folder,
                                                       const OutputRules& rules) {
    sun.baseline.city = city;
    const ElementTable table = makeTable(sun.baseline, sun.compared);
    OutputFolder files(folder, rules);
    files.add("places.csv", textContent(toCsv(table)));
    files.add("places.gpkg", [&](const std::filesystem::path& file) {
        return writePlacesGeoPackage(file, city.frame, sun.baseline.places, table, makeStyle(sun.baseline));
    });
    files.add("result.json", textContent(result.settings));
    return std::move(files).result();
}

}  // namespace

std::vector<std::string> savedFileNames(const SavedResult& result) {
    if (result.kind == "elements") return {"elements.csv", "elements.gpkg", "elements.glb", "result.json"};
    if (result.kind == "by-place") return {"places.csv", "places.gpkg", "result.json"};
    return {"result.tif", "result.qml", "result.png", "result.pdf", "result.json"};
}

Result<std::vector<std::filesystem::path>> writeSavedFiles(
    const SavedResult& result, const SavedSource& source, const ChangeScale& scale,
    const std::filesystem::path& folder, const OutputRules& rules, int width, const LegendChoice& legend) {
    if (qGuiApp == nullptr) return failure("Pictures and reports need a QGuiApplication", folder.string());
    if (auto may = checkOutputs(folder, savedFileNames(result), rules); !may)
        return tl::make_unexpected(may.error());
    const auto answer = readSavedAnswer(result);
    if (!answer) return tl::make_unexpected(answer.error());
    if (const auto* elements = std::get_if<SavedElements>(&answer->answer))
        return writeElements(result, *elements, source.city, folder, rules);
    if (const auto* saved = std::get_if<SavedSunByPlace>(&answer->answer))
        return writePlaces(result, saved->sun, source.city, folder, rules);
    const Region region = makeSavedRegion(result, *answer, source.regions);
    const Sheet sheet = makeSheet(result, *answer, region, source, scale, legend);
    const FileTags tags{{"RESULT", result.name}, {"SCENARIO", result.scenario}};
    std::vector<RasterBand> bands;
    for (const SavedLayer& layer : result.layers) bands.push_back({layer.name, layer.unit, &layer.values});
    OutputFolder files(folder, rules);
    files.add("result.tif", [&](const std::filesystem::path& file) {
        return writeGeoTiff(file, source.city.frame, result.grid, bands, tags);
    });
    files.add("result.qml", textContent(rasterStyle(sheet.map.legend)));
    files.add("result.png",
              [&](QIODevice& device) { return writePng(makePicture(sheet, width), tags, device); });
    files.add("result.pdf", [&](QIODevice& device) { return writePdf(sheet, device); });
    files.add("result.json", textContent(result.settings));
    return std::move(files).result();
}

}  // namespace noonmark
