#include "app/report/files/answer_files.h"

#include <QGuiApplication>

#include "app/report/book/answer_book.h"
#include "app/report/book/print_book.h"
#include "app/report/files/output_folder.h"
#include "app/report/maps/write_png.h"
#include "core/io/styles/raster_style.h"
#include "core/io/write_raster.h"
#include "core/study/provenance/command_words.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/text/breakdown_text.h"
#include "core/study/text/region_text.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/settings_json.h"

namespace noonmark {

namespace {

using Path = std::filesystem::path;
constexpr const char* sheetsName = "sheets.pdf";

using Paths = Result<std::vector<Path>>;

std::vector<RasterBand> bandsOf(const Impact& impact) {
    std::vector<RasterBand> bands{{"change of gross shadow", "min/day", &impact.grossMin}};
    if (hasRuns(impact)) bands.push_back({"change of continuous shadow", "min", &impact.continuousMin});
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
                 const std::vector<RasterBand>& bands, const Path& folder, const OutputRules& rules,
                 const std::optional<Book>& book, int width) {
    if (qGuiApp == nullptr) return failure("Pictures and reports need a QGuiApplication", folder.string());
    if (auto may = checkOutputs(folder, namesOf(texts.name, !texts.region.empty(), book.has_value()), rules);
        !may)
        return tl::make_unexpected(may.error());
    const auto pdf = book ? printBook(*book) : QByteArray();
    if (!pdf) return tl::make_unexpected(pdf.error());
    OutputFolder files(folder, rules);
    files.add(texts.name + ".tif",
              [&](const Path& file) { return writeGeoTiff(file, frame, grid, bands, texts.tags); });
    files.add(texts.name + ".qml", textContent(rasterStyle(coloursOf(sheet.map.legend))));
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

Paths writeImpactFiles(const ImpactAnswer& answer, const AnswerSource& source, const ChangeScale& scale,
                       const Path& folder, const OutputRules& rules, const BookSettings* sheets, int width,
                       const LegendChoice& legend) {
    const auto book =
        sheets ? std::optional(makeImpactBook(answer, source, scale, *sheets, legend)) : std::nullopt;
    const Impact& impact = answer.study.total;
    const Frame& frame = source.city.frame;
    return writeFiles(
        {"impact", extendRepeat(impactJson(answer), drawnOptions(scale, legend)), impactCsv(answer),
         regionFileOf(answer.settings.study.region, answer.provenance, frame),
         makeProvenanceTags(answer.provenance)},
        makeSheet(answer, source, scale, legend), impact.grid, frame, bandsOf(impact), folder, rules, book,
        width);
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
                      makeSheet(answer, source, legend), score.grid, frame,
                      {{"shadow score", "", &score.score}}, folder, rules, book, width);
}

std::vector<std::string> impactFileNames(const Provenance& provenance, bool withSheets) {
    return namesOf("impact", needsRegionFile(provenance), withSheets);
}

std::vector<std::string> scoreFileNames(const Provenance& provenance, bool withSheets) {
    return namesOf("score", needsRegionFile(provenance), withSheets);
}

std::vector<std::string> contributionFileNames() {
    return {"contributions.csv", "contributions.gpkg", "by_month.csv"};
}

Result<std::vector<std::filesystem::path>> writeContributionFiles(const Study& study,
                                                                  const PlaceContributions& of,
                                                                  const std::filesystem::path& folder,
                                                                  const OutputRules& rules) {
    if (auto may = checkOutputs(folder, contributionFileNames(), rules); !may)
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
    return std::move(files).result();
}

}  // namespace noonmark
