#include "app/report/files/study_files.h"

#include <QGuiApplication>

#include "app/report/book/answer_book.h"
#include "app/report/book/contribution_book.h"
#include "app/report/book/print_book.h"
#include "app/report/files/cells_csv.h"
#include "app/report/files/output_folder.h"
#include "app/report/maps/write_png.h"
#include "app/report/sheets/study_report.h"
#include "core/io/styles/raster_style.h"
#include "core/io/write_city.h"
#include "core/measures/has_runs.h"
#include "core/study/contributions/contributions.h"
#include "core/study/provenance/command_words.h"
#include "core/study/provenance/provenance_tags.h"
#include "core/study/provenance/repeat_command.h"
#include "core/study/text/breakdown_text.h"
#include "core/study/text/region_text.h"
#include "core/study/tiles/map_bands.h"
#include "core/study/tiles/tile_maps.h"
#include "core/study/timed_study_json.h"

namespace noonmark {

namespace {

Result<void> writeRaster(const Study& study, const std::filesystem::path& file) {
    return writeGeoTiff(file, study.city.frame, study.field.grid,
                        makeMapBands(study.field, hasRuns(study.statistics)),
                        makeProvenanceTags(study.provenance));
}

Result<void> writeMonths(const Study& study, const std::filesystem::path& file) {
    std::vector<RasterBand> bands;
    const ShadowBreakdown& months = *study.breakdown;
    std::vector<std::vector<float>> ofGrid;
    for (std::size_t set = 0; set < months.sets.names.size(); ++set)
        ofGrid.push_back(spreadOverGrid(months, set));
    for (std::size_t set = 0; set < months.sets.names.size(); ++set)
        bands.push_back({months.sets.names[set], "min", &ofGrid[set]});
    return writeGeoTiff(file, study.city.frame, months.grid, bands, makeProvenanceTags(study.provenance));
}

Result<void> writeContributions(const Study& study, const std::filesystem::path& file) {
    const auto rows = listContributions(study.city, *study.breakdown, study.sun.dayCount());
    return writeCityGeoPackage(file, study.city, contributionColumns(rows, study.city.buildings.size()),
                               contributionStyle())
        .map([](const Warnings&) {});
}

}  // namespace

std::vector<std::string> studyFileNames(const StudySettings& settings, const StudyFileOptions& options) {
    std::vector<std::string> names{"shadow.tif", "shadow.qml", "shadow.png", "report.pdf", "study.json"};
    if (options.book) names.emplace_back("sheets.pdf");
    if (settings.byMonth) names.insert(names.end(), {"by_month.tif", "by_month.qml", "by_month.csv"});
    if (settings.contributions)
        names.insert(names.end(), {"contributions.csv", "contributions.gpkg", "contributions.pdf"});
    if (options.cellsCsv) names.emplace_back("cells.csv");
    if (!options.ofPlaces.empty()) names.emplace_back(keptContributionsFile);
    return names;
}

Result<std::vector<std::filesystem::path>> writeStudyFiles(const Study& study,
                                                           const std::filesystem::path& folder,
                                                           const StudyFileOptions& options) {
    if (qGuiApp == nullptr) return failure("Pictures and reports need a QGuiApplication", folder.string());
    std::vector<std::string> names = studyFileNames(study.settings, options);
    if (needsRegionFile(study)) names.emplace_back(regionFileName);
    if (auto may = checkOutputs(folder, names, options.rules); !may) return tl::make_unexpected(may.error());
    OutputFolder files(folder, options.rules);
    files.add("shadow.tif", [&](const std::filesystem::path& file) { return writeRaster(study, file); });
    const std::string style =
        rasterStyle(coloursOf(makeLegend(study.field, ShadowMeasure::gross, options.legend)));
    files.add("shadow.qml", textContent(style));
    files.add("shadow.png", [&](QIODevice& device) {
        return writePng(mapPicture(study, ShadowMeasure::gross, options.pictureWidth, options.legend),
                        makeProvenanceTags(study.provenance), device);
    });
    files.add("report.pdf", [&](QIODevice& device) { return writeReport(study, device, options.legend); });
    files.addLast("study.json", [&](const FileSeconds& seconds) {
        return withContributions(
            extendRepeat(studyJson(study, seconds), listLegendOptions(options.legend, false)),
            options.ofPlaces);
    });
    if (needsRegionFile(study))
        files.add(regionFileName, textContent(regionGeoJson(study.settings.region, study.city.frame)));
    if (options.book) {
        const auto pdf = printBook(makeStudyBook(study, *options.book));
        if (!pdf) return tl::make_unexpected(pdf.error());
        files.add("sheets.pdf", textContent(pdf->toStdString()));
    }
    if (study.breakdown && study.settings.byMonth) {
        files.add("by_month.tif",
                  [&](const std::filesystem::path& file) { return writeMonths(study, file); });
        files.add("by_month.qml", textContent(rasterStyle(makeMonthScale(study.sun, options.legend))));
        files.add("by_month.csv", textContent(monthsCsv(study)));
    }
    if (study.breakdown && study.settings.contributions) {
        files.add("contributions.csv", textContent(contributionsCsv(study)));
        files.add("contributions.gpkg",
                  [&](const std::filesystem::path& file) { return writeContributions(study, file); });
        const auto pdf = printBook(makeContributionBook(study, {.legend = options.legend}));
        if (!pdf) return tl::make_unexpected(pdf.error());
        files.add("contributions.pdf", textContent(pdf->toStdString()));
    }
    if (!options.ofPlaces.empty())
        files.add(keptContributionsFile, textContent(contributionsCsv(options.ofPlaces, study.provenance)));
    if (options.cellsCsv)
        files.add("cells.csv",
                  [&](QIODevice& device) { return writeCellsCsv(study.field, study.city.frame, device); });
    return std::move(files).result();
}

}  // namespace noonmark
