#include "app/report/files/shadow_files.h"

#include "core/io/shadows/drawing_tables.h"

namespace noonmark {

namespace {

std::string svgName(const DrawnTime& time) { return "shadows_" + time.name + ".svg"; }

void addGeoJson(OutputFolder& files, const ShadowDrawing& drawing) {
    for (const DrawingTable& table : makeDrawingTables(drawing))
        files.add(table.name + ".geojson", [&drawing, name = table.name](const std::filesystem::path& file) {
            return writeShadowsGeoJson(file, drawing, name);
        });
}

}  // namespace

std::vector<std::string> shadowFileNames(const std::vector<DrawnTime>& times,
                                         const ShadowFileSettings& settings) {
    std::vector<std::string> names;
    if (settings.formats.contains(ShadowFormat::dxf)) names.emplace_back("shadows.dxf");
    if (settings.formats.contains(ShadowFormat::geoPackage)) names.emplace_back("shadows.gpkg");
    if (settings.formats.contains(ShadowFormat::geoJson))
        for (const char* layer : {"shadows", "buildings", "places", "fan", "isochrones", "distances"})
            names.push_back(std::string(layer) + ".geojson");
    if (settings.formats.contains(ShadowFormat::svg))
        for (const DrawnTime& time : times) names.push_back(svgName(time));
    return names;
}

void addShadowFiles(OutputFolder& files, const ShadowDrawing& drawing, const ShadowFileSettings& settings) {
    const auto wants = [&](ShadowFormat format) { return settings.formats.contains(format); };
    if (wants(ShadowFormat::dxf))
        files.add("shadows.dxf", [&drawing, plane = settings.plane](const std::filesystem::path& file) {
            return writeShadowsDxf(file, drawing, plane);
        });
    if (wants(ShadowFormat::geoPackage))
        files.add("shadows.gpkg", [&drawing, plane = settings.plane](const std::filesystem::path& file) {
            return writeShadowsGeoPackage(file, drawing, plane);
        });
    if (wants(ShadowFormat::geoJson)) addGeoJson(files, drawing);
    if (wants(ShadowFormat::svg))
        for (const DrawnMoment& moment : drawing.moments)
            files.add(svgName(moment.time), textContent(drawShadowsSvg(drawing, moment, settings.scale)));
}

}  // namespace noonmark
