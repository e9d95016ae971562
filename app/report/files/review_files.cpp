#include "app/report/files/review_files.h"

#include "app/report/book/print_book.h"
#include "core/io/shadows/drawing_tables.h"
#include "core/study/shadow_drawings.h"
#include "core/study/text/error_words.h"

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

namespace {

constexpr const char* utf8Mark = "\xEF\xBB\xBF";

Result<ShadowDrawing> drawShadows(const ReviewBookSource& source, Progress& progress,
                                  const std::stop_token& stop) {
    return drawReviewShadows(source.study, source.baseline, source.scenario, source.places, progress, stop)
        .map([&](ShadowDrawing drawing) {
            drawing.notes.push_back("From " + source.labels.from + " to " + source.labels.to);
            return drawing;
        });
}

}  // namespace

std::vector<std::string> reviewFileNames() {
    return {"review.json", "review.csv", "sheets.pdf", "shadows.dxf", "shadows.gpkg"};
}

Result<std::vector<std::filesystem::path>> writeReviewFiles(const ReviewBookSource& source,
                                                            const Book& sheets,
                                                            const ReviewFileSettings& settings,
                                                            const std::filesystem::path& folder,
                                                            Progress& progress, const std::stop_token& stop) {
    if (auto may = checkOutputs(folder, reviewFileNames(), settings.rules); !may)
        return tl::make_unexpected(may.error());
    const auto drawing = drawShadows(source, progress, stop);
    if (!drawing) return tl::make_unexpected(drawing.error());
    const auto pdf = printBook(sheets);
    if (!pdf) return tl::make_unexpected(pdf.error());
    OutputFolder files(folder, settings.rules);
    files.add("review.json", textContent(toJsonText(reviewJson(source.study, source.labels)) + "\n"));
    files.add("review.csv",
              textContent((settings.byteOrderMark ? utf8Mark : "") + reviewCsv(source.study, source.labels)));
    files.add("sheets.pdf", textContent(pdf->toStdString()));
    addShadowFiles(files, *drawing, {});
    return std::move(files).result();
}

}  // namespace noonmark
