#include "app/report/files/answer_files.h"

#include <fmt/format.h>

#include <QGuiApplication>

#include "app/report/book/answer_books.h"
#include "app/report/book/print_book.h"
#include "app/report/maps/write_png.h"
#include "core/io/shadows/shadow_drawing.h"
#include "core/io/styles/qgis_style.h"
#include "core/io/write_raster.h"
#include "core/study/provenance/command_text.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/shadow_drawings.h"
#include "core/study/text/breakdown_text.h"
#include "core/study/text/error_text.h"
#include "core/study/text/region_text.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/settings_json.h"

namespace noonmark {

namespace {

using Path = std::filesystem::path;
constexpr const char* sheetsName = "sheets.pdf";

using Paths = Result<std::vector<Path>>;

void addBands(std::vector<RasterBand>& bands, const Impact& impact, const std::string& with = {}) {
    bands.push_back({"change of gross shadow" + with, "min/day", &impact.grossMin});
    if (hasRuns(impact))
        bands.push_back({"change of continuous shadow" + with, "min", &impact.continuousMin});
}

// Those without trees first.
std::vector<RasterBand> bandsOf(const ImpactStudy& study) {
    std::vector<RasterBand> bands;
    addBands(bands, study.total);
    for (const ShadeImpact& with : study.withTrees)
        addBands(bands, with.impact, fmt::format(", {}", describeTrees(with.column)));
    return bands;
}

std::vector<RasterBand> bandsOf(const Score& score) {
    std::vector<RasterBand> bands{{"shadow score", "", &score.score}};
    for (const ShadedScore& with : score.withTrees)
        if (!with.score.empty())
            bands.push_back({fmt::format("shadow score, {}", describeTrees(with.column)), "", &with.score});
    return bands;
}

/// The files that comparison and score have in common, with their file name stem.
struct AnswerTexts {
    std::string name;
    std::string json;
    std::string csv;
    std::string region;  ///< region.geojson; empty where the repeat command does not name it
    FileTags tags;       ///< of map and picture
};

std::string regionFileOf(const Region& region, const Provenance& provenance, const Frame& frame) {
    return needsRegionFile(provenance) ? regionGeoJson(region, frame) : std::string();
}

std::vector<std::string> namesOf(const std::string& answer, bool region, bool sheets) {
    std::vector<std::string> names;
    if (sheets) names.emplace_back(sheetsName);
    for (const char* ending : {".tif", ".qml", ".png", ".pdf", ".json", ".csv"})
        names.push_back(answer + ending);
    if (region) names.emplace_back(regionFileName);
    return names;
}

Paths writeFiles(const AnswerTexts& texts, const Sheet& sheet, const Grid& grid, const Frame& frame,
                 const std::vector<RasterBand>& bands, const std::vector<float>& mapped, const Path& folder,
                 const OutputRules& rules, const std::optional<Book>& book, int width) {
    if (qGuiApp == nullptr) return failure("Pictures and reports need a QGuiApplication", folder.string());
    if (auto may = checkOutputs(folder, namesOf(texts.name, !texts.region.empty(), book.has_value()), rules);
        !may)
        return tl::make_unexpected(may.error());
    const auto pdf = book ? printBook(*book) : QByteArray();
    if (!pdf) return tl::make_unexpected(pdf.error());
    OutputFolder files(folder, rules);
    files.add(texts.name + ".tif",
              [&](const Path& file) { return writeGeoTiff(file, frame, grid, bands, texts.tags); });
    files.add(texts.name + ".qml",
              textContent(rasterStyle(coloursOf(sheet.map.legend), numberOf(bands, mapped))));
    files.add(texts.name + ".png",
              [&](QIODevice& device) { return writePng(makePicture(sheet, width), texts.tags, device); });
    files.add(texts.name + ".pdf", [&](QIODevice& device) { return writePdf(sheet, device); });
    files.add(texts.name + ".json", textContent(texts.json));
    files.add(texts.name + ".csv", textContent(texts.csv));
    if (!texts.region.empty()) files.add(regionFileName, textContent(texts.region));
    if (book) files.add(sheetsName, textContent(pdf->toStdString()));
    return std::move(files).result();
}

}  // namespace

std::size_t numberOf(const std::vector<RasterBand>& bands, const std::vector<float>& values) {
    for (std::size_t i = 0; i < bands.size(); ++i)
        if (bands[i].values == &values) return i + 1;
    return 1;
}

Paths writeImpactFiles(const ImpactAnswer& answer, const AnswerSource& source, const ChangeScale& scale,
                       const Path& folder, const OutputRules& rules, const BookSettings* sheets, int width,
                       const LegendChoice& legend) {
    const auto book =
        sheets ? std::optional(makeImpactBook(answer, source, scale, *sheets, legend)) : std::nullopt;
    const Impact& impact = impactOfColumn(answer.study, legend.trees);
    const Frame& frame = source.city.frame;
    return writeFiles(
        {"impact", extendRepeat(impactJson(answer), drawnOptions(scale, legend)), impactCsv(answer),
         regionFileOf(answer.settings.study.region, answer.provenance, frame),
         makeProvenanceTags(answer.provenance)},
        makeSheet(answer, source, scale, legend), impact.grid, frame, bandsOf(answer.study), impact.grossMin,
        folder, rules, book, width);
}

Paths writeScoreFiles(const ScoreAnswer& answer, const AnswerSource& source, const Path& folder,
                      const OutputRules& rules, const BookSettings* sheets, int width,
                      const LegendChoice& legend) {
    const auto book = sheets ? std::optional(makeScoreBook(answer, source, *sheets, legend)) : std::nullopt;
    const Score& score = answer.score;
    const Frame& frame = source.city.frame;
    return writeFiles({"score", extendRepeat(scoreJson(answer), listLegendOptions(legend, true)),
                       scoreCsv(answer), regionFileOf(answer.settings.region, answer.provenance, frame),
                       makeProvenanceTags(answer.provenance)},
                      makeSheet(answer, source, legend), score.grid, frame, bandsOf(score),
                      scoreInColumn(score, legend.trees), folder, rules, book, width);
}

std::vector<std::string> impactFileNames(const Provenance& provenance, bool withSheets) {
    return namesOf("impact", needsRegionFile(provenance), withSheets);
}

std::vector<std::string> scoreFileNames(const Provenance& provenance, bool withSheets) {
    return namesOf("score", needsRegionFile(provenance), withSheets);
}

namespace {

bool areTreesAmong(const std::vector<ContributionTable>& ofPlaces) {
    return std::ranges::any_of(ofPlaces, [](const ContributionTable& of) { return !of.trees.empty(); });
}

}  // namespace

std::vector<std::string> placeContributionNames(const std::vector<ContributionTable>& ofPlaces) {
    if (ofPlaces.empty()) return {};
    std::vector<std::string> names{contributionTableFile, contributionLayerFile};
    if (areTreesAmong(ofPlaces)) names.emplace_back(placeTreesFile);
    return names;
}

void addPlaceContributions(OutputFolder& files, const std::vector<ContributionTable>& ofPlaces,
                           const City& city, const Provenance& provenance) {
    if (ofPlaces.empty()) return;
    files.add(contributionTableFile, textContent(contributionsCsv(ofPlaces, provenance)));
    if (areTreesAmong(ofPlaces)) files.add(placeTreesFile, textContent(placeTreesCsv(ofPlaces, provenance)));
    files.add(contributionLayerFile,
              [layer = makeContributionLayer(ofPlaces, city), frame = city.frame](const Path& file) {
                  return writePolygonsGeoPackage(
                      file, frame, {"contributions", "What buildings and trees take from places"},
                      layer.outlines, layer.table, layer.style);
              });
}

void addTreeContributions(OutputFolder& files, const std::vector<TreeContribution>& trees,
                          const Study& study) {
    if (trees.empty()) return;
    files.add(treeContributionsFile, textContent(treeContributionsCsv(trees, study.city, study.provenance)));
    files.add(treeLayerFile,
              [layer = makeTreeLayer(trees, study.city), frame = study.city.frame](const Path& file) {
                  return writePolygonsGeoPackage(file, frame, {"trees", "What trees take"}, layer.outlines,
                                                 layer.table, layer.style);
              });
}

std::vector<std::string> contributionFileNames(const PlaceContributions& of) {
    std::vector<std::string> names{"contributions.csv", "contributions.gpkg", "by_month.csv"};
    if (!of.trees.empty()) names.insert(names.end(), {treeContributionsFile, treeLayerFile});
    return names;
}

Result<std::vector<std::filesystem::path>> writeContributionFiles(const Study& study,
                                                                  const PlaceContributions& of,
                                                                  const std::filesystem::path& folder,
                                                                  const OutputRules& rules) {
    if (auto may = checkOutputs(folder, contributionFileNames(of), rules); !may)
        return tl::make_unexpected(may.error());
    OutputFolder files(folder, rules);
    files.add("contributions.csv",
              textContent(contributionsCsv(of.rows, of.breakdown.sets, study.provenance)));
    files.add("contributions.gpkg", [&](const std::filesystem::path& file) {
        return writeCityGeoPackage(file, study.city,
                                   contributionColumns(of.rows, study.city.buildings.size()),
                                   contributionStyle())
            .map([](const Warnings&) {});
    });
    files.add("by_month.csv", textContent(monthsCsv(monthsOf(of.breakdown), study.provenance)));
    addTreeContributions(files, of.trees, study);
    return std::move(files).result();
}

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
