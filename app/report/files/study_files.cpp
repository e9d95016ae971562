#include "app/report/files/study_files.h"

#include <fmt/format.h>

#include <QGuiApplication>
#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>

#include "app/report/book/answer_books.h"
#include "app/report/book/print_book.h"
#include "app/report/files/answer_files.h"
#include "app/report/files/output_folder.h"
#include "app/report/maps/write_png.h"
#include "app/report/sheets/study_report.h"
#include "core/base/csv_text.h"
#include "core/engines/shade_trees.h"
#include "core/io/styles/qgis_style.h"
#include "core/io/write_city.h"
#include "core/measures/shadow_figures.h"
#include "core/study/contributions/contributions.h"
#include "core/study/provenance/command_text.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/provenance/repeat_command.h"
#include "core/study/study_json.h"
#include "core/study/text/breakdown_text.h"
#include "core/study/text/region_text.h"
#include "core/study/tiles/tile_maps.h"

namespace noonmark {

namespace {

constexpr std::size_t chunkBytes = 1U << 20U;

bool flush(CsvText& csv, QIODevice& device) {
    const std::string text = csv.take();
    return device.write(text.data(), qint64(text.size())) == qint64(text.size());
}

void addCell(CsvText& csv, const ShadowField& field, bool runs, const Frame& frame, int column, int row) {
    const std::size_t cell = field.grid.index(column, row);
    if (std::isnan(field.grossMin[cell])) return;
    const glm::dvec2 centre = field.grid.centre(column, row);
    const LonLat place = frame.lonLatFromLocal(centre);
    csv.number(centre.x, 3).number(centre.y, 3).number(place.lonDeg, 8).number(place.latDeg, 8);
    csv.number(double(field.grossMin[cell]), 3);
    if (runs) csv.number(double(field.continuousMin[cell]), 3);
    for (const ShadeColumn& shade : listShadeColumns(field)) {
        csv.number(double(shade.field->grossMin[cell]), 3);
        if (runs) csv.number(double(shade.field->continuousMin[cell]), 3);
    }
    csv.endRow();
}

}  // namespace

bool writeCellsCsv(const ShadowField& field, const Frame& frame, QIODevice& device) {
    const bool runs = hasRuns(field);
    std::vector<std::string> columns{"x_m", "y_m", "lon_deg", "lat_deg", "gross_min"};
    if (runs) columns.emplace_back("continuous_min");
    for (const ShadeColumn& shade : listShadeColumns(field)) {
        columns.push_back("gross_min" + suffixOf(shade.column));
        if (runs) columns.push_back("continuous_min" + suffixOf(shade.column));
    }
    CsvText csv(columns);
    for (int row = 0; row < field.grid.rows; ++row) {
        for (int column = 0; column < field.grid.columns; ++column)
            addCell(csv, field, runs, frame, column, row);
        if (csv.size() >= chunkBytes && !flush(csv, device)) return false;
    }
    return flush(csv, device);
}

namespace {

Result<void> writeRaster(const Study& study, const std::filesystem::path& file) {
    return writeGeoTiff(file, study.city.frame, study.field.grid,
                        makeMapBands(study.field, hasRuns(study.statistics)),
                        makeProvenanceTags(study.provenance));
}

/// Bands of months, with the minutes that they point to.
struct MonthBands {
    std::vector<RasterBand> bands;
    std::deque<std::vector<float>> ofGrid;
    void add(const ShadowBreakdown& months, const std::string& with = {}) {
        for (std::size_t set = 0; set < months.sets.names.size(); ++set)
            bands.push_back(
                {months.sets.names[set] + with, "min", &ofGrid.emplace_back(spreadOverGrid(months, set))});
    }
};

// Those without trees first.
Result<void> writeMonths(const Study& study, const std::filesystem::path& file) {
    MonthBands all;
    all.add(*study.breakdown);
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
        if (study.shadedMonths && study.shadedMonths->of(column))
            all.add(*study.shadedMonths->of(column), fmt::format(", {}", describeTrees(column)));
    return writeGeoTiff(file, study.city.frame, study.breakdown->grid, all.bands,
                        makeProvenanceTags(study.provenance));
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
    if (settings.contributions && settings.trees != TreeColumns::without)
        names.insert(names.end(), {treeContributionsFile, treeLayerFile});
    if (options.cellsCsv) names.emplace_back("cells.csv");
    std::ranges::move(placeContributionNames(options.ofPlaces), std::back_inserter(names));
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
    const ShadowField& mapped = fieldOfColumn(study.field, options.legend.trees);
    const ColourScale colours = coloursOf(makeLegend(mapped, ShadowMeasure::gross, options.legend));
    const std::size_t band = numberOf(makeMapBands(study.field, hasRuns(study.statistics)), mapped.grossMin);
    files.add("shadow.qml", textContent(rasterStyle(colours, band)));
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
    addTreeContributions(files, listTreeContributions(study), study);
    addPlaceContributions(files, options.ofPlaces, study.city, study.provenance);
    if (options.cellsCsv)
        files.add("cells.csv",
                  [&](QIODevice& device) { return writeCellsCsv(study.field, study.city.frame, device); });
    return std::move(files).result();
}

}  // namespace noonmark
