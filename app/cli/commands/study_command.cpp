#include <fmt/format.h>
#include <filesystem>
#include <fstream>
#include <memory>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/command_line.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/options/sheet_options.h"
#include "app/cli/options/study_options.h"
#include "app/cli/study/study_request.h"
#include "app/input/all_engines.h"
#include "app/report/files/element_files.h"
#include "app/report/files/output_folder.h"
#include "app/report/files/study_files.h"
#include "core/describe/command_options.h"
#include "core/io/styles/qgis_style.h"
#include "core/study/elements/element_tables.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/provenance/repeat_command.h"
#include "core/study/study_fields.h"
#include "core/study/text/breakdown_text.h"
#include "core/study/text/height_facts_text.h"
#include "core/study/text/region_text.h"
#include "core/study/tiles/tile_maps.h"
#include "core/study/tiles/tiled_study.h"

namespace noonmark::cli {

namespace {

void addSource(ElementStudy& study, const StudyRequest& request) {
    const LoadedCity& loaded = request.loaded;
    study.provenance = provenanceOf(request);
    study.heights = loaded.read.heights;
    study.warnings.insert(study.warnings.begin(), loaded.read.warnings.begin(), loaded.read.warnings.end());
    study.seconds["read"] = loaded.seconds;
    study.seconds["total"] += loaded.seconds;
}

/// What was measured, and the book of it.
struct Measured {
    ElementStudy study;
    BookSettings book;
    std::shared_ptr<const ProjectFile> project;
};

// The file of windows is described before the computation, so that its hash is that of what was read.
tl::expected<Measured, Failure> measureElements(const StudyOptions& options, const SheetOptions& layout,
                                                const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    if (auto ok = orCode(checkElementOptions(options), exitUsage); !ok)
        return tl::make_unexpected(ok.error());
    std::optional<InputFile> windows;
    if (options.points == ElementPlaces::windows) {
        auto file = orCode(describeInputFile(options.elements.windows), exitUsage);
        if (!file) return tl::make_unexpected(file.error());
        windows = *std::move(file);
    }
    auto request = parseStudyRequest(options, elementFileNames(*options.points), progress, interrupt.token());
    if (!request) return tl::make_unexpected(request.error());
    auto book = orCode(bookSettingsOf(layout, sheetsOf(*request)), exitUsage);
    if (!book) return tl::make_unexpected(book.error());
    book->legend = options.legend;
    auto study = runElementStudy(request->loaded.read.city, request->settings, request->elements, progress,
                                 interrupt.token());
    if (!study)
        return tl::make_unexpected(
            Failure{study.error(), study.error().kind == ErrorKind::input ? exitUsage : exitFailed});
    study->glazingInput = windows;
    addSource(*study, *request);
    return Measured{*std::move(study), *std::move(book), request->project};
}

std::string errorText(const ElementStudy& study) {
    if (!study.error)
        return study.engineKey == referenceEngine ? "none: it is the reference" : "not measured";
    return describe(*study.error);
}

void printElements(const ElementStudy& study, const std::vector<std::filesystem::path>& files,
                   std::ostream& out) {
    const ElementFigures figures = computeFigures(study);
    Table table;
    if (const auto headline = makeDoubtHeadline(study.heights)) table.add("unit of heights", *headline);
    if (const auto headline = makeStandHeadline(study.heights)) table.add("bases", *headline);
    table.add("period", formatText(study.settings.period));
    table.add("engine", describeEngine(study));
    table.add("steps", fmt::format("{} with the sun up, {} left out below the horizon",
                                   withCommas(study.sun.steps.size()), withCommas(study.sun.belowHorizon)));
    table.add("receivers on", std::string(nameOf(study.elements.places)));
    addFigures(table, listElementLines(figures, listFiguresWithTrees(study)));
    table.add("error against rays", errorText(study));
    table.add("time", fmt::format("{:.2f} s", study.seconds.at("total")));
    table.print(out);
    out << "\nFiles\n";
    for (const auto& file : files) out << "  " << file.string() << '\n';
    printWarnings(out, study.warnings);
}

/// Runs `study` at points (--receivers facades, windows, plane): reads, measures, writes the files and prints
/// a table, or study.json. Returns the exit code.
int runElements(const StudyOptions& options, const SheetOptions& layout, const Console& console) {
    const OffscreenQt qt;
    const auto measured = measureElements(options, layout, console);
    if (!measured) return fail(console, measured.error().error, measured.error().code);
    const ElementStudy& study = measured->study;
    const auto files = writeElementFiles(study, measured->book, options.out,
                                         outputRulesOf(options, study.provenance.inputs));
    if (!files) return fail(console, files.error(), exitFailed);
    if (const auto copied = copyProjectOf(measured->project, options); !copied)
        return fail(console, copied.error(), exitFailed);
    if (!options.json)
        printElements(study, *files, console.out);
    else if (std::ifstream file(std::filesystem::path(options.out) / "study.json"); file)
        console.out << file.rdbuf() << '\n';
    return exitOk;
}

/// A study, and the book that is wanted of it.
struct Answered {
    Study study;
    std::optional<BookSettings> book;
    std::shared_ptr<const ProjectFile> project;
};

Result<std::optional<BookSettings>> bookOf(const StudyOptions& options, const SheetOptions& sheets,
                                           const StudyRequest& request) {
    if (!sheets.wanted) return std::nullopt;
    return bookSettingsOf(sheets, sheetsOf(request)).map([&](BookSettings book) {
        book.legend = options.legend;
        return std::optional(std::move(book));
    });
}

tl::expected<Answered, Failure> computed(const StudyOptions& options, const SheetOptions& sheets,
                                         const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    StudyFileOptions files{.cellsCsv = options.cellsCsv};
    if (sheets.wanted) files.book.emplace();
    auto request =
        parseStudyRequest(options, studyFileNames(options.settings, files), progress, interrupt.token());
    if (!request) return tl::make_unexpected(request.error());
    auto book = orCode(bookOf(options, sheets, *request), exitUsage);
    if (!book) return tl::make_unexpected(book.error());
    auto study = orCode(runStudy(request->loaded.read.city, request->settings, progress, interrupt.token(),
                                 enginesWith(request->settings.engine)),
                        exitFailed);
    if (!study) return tl::make_unexpected(study.error());
    addSource(*study, *request);
    return Answered{*std::move(study), *std::move(book), request->project};
}

Result<std::vector<std::filesystem::path>> writeFiles(const Answered& answered, const StudyOptions& options) {
    const OffscreenQt qt;
    auto files = writeStudyFiles(answered.study, options.out,
                                 {.cellsCsv = options.cellsCsv,
                                  .rules = outputRulesOf(options, answered.study.provenance.inputs),
                                  .pictureWidth = options.pictureWidth,
                                  .legend = options.legend,
                                  .book = answered.book});
    if (!files) return files;
    return copyProjectOf(answered.project, options).map([&] { return *std::move(files); });
}

// As it was written: its times of writing are not known before.
void printFile(const std::filesystem::path& folder, const char* name, std::ostream& out) {
    if (std::ifstream file(folder / name); file) out << file.rdbuf() << '\n';
}

int runStudyCommand(const StudyOptions& options, const SheetOptions& layout, const Console& console) {
    if (options.points && layout.wanted)
        return fail(console,
                    {"A study of points has its sheets always", "--sheets",
                     "Leave it out: elements.pdf is the book of sheets"},
                    exitUsage);
    if (options.points) return runElements(options, layout, console);
    if (const auto ok = checkElementOptions(options); !ok) return fail(console, ok.error(), exitUsage);
    const auto answered = computed(options, layout, console);
    if (!answered) return fail(console, answered.error().error, answered.error().code);
    const auto files = writeFiles(*answered, options);
    if (!files) return fail(console, files.error(), exitFailed);
    if (options.json)
        printFile(options.out, "study.json", console.out);
    else
        printStudy(answered->study, *files, console.out);
    return exitOk;
}

}  // namespace

void addStudyCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<StudyOptions>();
    const auto layout = std::make_shared<SheetOptions>();
    CLI::App* command =
        app.add_subcommand("study", "Measure the shadow over a region and write maps, figures and a report");
    addStudyOptions(*command, *options, ReceiverChoice::cellsAndPoints);
    addElementOptions(*command, *options);
    addElevationSheetOptions(*command, *layout);
    addSheetSwitch(*command, *layout);
    addPieceOptions(*command, *options);
    addLegendOptions(*command, options->legend);
    command->footer(
        "A first study:\n"
        "  noonmark-cli study sample:central-park-south --start 2026-03-21 --from 09:00 --hours 6 \\\n"
        "    --zone America/New_York --region -73.9845,40.7620,-73.9690,40.7735 --cell 2 --out out\n"
        "Sunlight of every window of a file, as elements.csv and elements.gpkg:\n"
        "  noonmark-cli study city.gpkg --start 2026-01-01 --days 365 --window sunrise..sunset --zone "
        "Europe/Amsterdam \\\n"
        "    --region city --receivers windows --windows windows.gpkg --out out\n"
        "Steps with the sun below the horizon are left out; shares of time refer to the time with the sun "
        "above it.");
    command->callback([options, layout, &run] {
        run = [options, layout](const Console& console) {
            return runStudyCommand(*options, *layout, console);
        };
    });
}

namespace {

constexpr const char* mapName = "shadow.tif";
constexpr const char* jsonName = "study.json";
constexpr const char* monthMapName = "by_month.tif";
constexpr const char* monthTableName = "by_month.csv";
constexpr const char* styleName = "shadow.qml";
constexpr const char* monthStyleName = "by_month.qml";

struct CityStudyOptions {
    StudyOptions study;
    int tileCells = TiledStudySettings::defaultTileCells;
};

// The maps with trees of these columns, without ending.
std::vector<std::string> namesOfTreeMaps(const StudySettings& settings, TreeColumns columns) {
    std::vector<std::string> names;
    for (const TileMap& map : listTileMaps(settings, {}, columns))
        if (map.withoutTrees) names.push_back(map.name);
    return names;
}

std::vector<std::string> namesOf(const StudySettings& settings) {
    std::vector<std::string> names{mapName, styleName, jsonName};
    if (settings.byMonth) names.insert(names.end(), {monthMapName, monthStyleName, monthTableName});
    for (const std::string& map : namesOfTreeMaps(settings, settings.trees))
        names.insert(names.end(), {map + ".tif", map + ".qml"});
    return names;
}

tl::expected<TiledStudy, Failure> computed(const CityStudyOptions& options, const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    const auto request =
        parseStudyRequest(options.study, namesOf(options.study.settings), progress, interrupt.token());
    if (!request) return tl::make_unexpected(request.error());
    const std::filesystem::path file = std::filesystem::path(options.study.out) / mapName;
    const FileTags tags = makeProvenanceTags(provenanceOf(*request));
    auto tiled =
        orCode(runTiledStudy(request->loaded.read.city, {request->settings, options.tileCells, tags}, file,
                             progress, interrupt.token(), enginesWith(request->settings.engine)),
               exitFailed);
    if (tiled) addSource(tiled->study, *request);
    return tiled;
}

Result<std::vector<std::filesystem::path>> writeTexts(const TiledStudy& tiled, const std::string& json,
                                                      const StudyOptions& options) {
    const Study& study = tiled.study;
    OutputFolder files(options.out, outputRulesOf(options, study.provenance.inputs));
    const std::string style =
        rasterStyle(makeShadowScale(study.statistics, study.field.sunlitMinutesPerDay, options.legend));
    files.add(styleName, textContent(style));
    files.add(jsonName, textContent(json));
    if (study.settings.byMonth) {
        files.add(monthStyleName, textContent(rasterStyle(makeMonthScale(study.sun, options.legend))));
        files.add(monthTableName, textContent(monthsCsv(tiled.months, study.provenance,
                                                        listMonthsWithTrees(tiled.withTrees))));
    }
    for (const std::string& map : namesOfTreeMaps(study.settings, tiled.treeColumns))
        files.add(map + ".qml", textContent(map.starts_with(monthMap)
                                                ? rasterStyle(makeMonthScale(study.sun, options.legend))
                                                : style));
    if (needsRegionFile(study))
        files.add(regionFileName, textContent(regionGeoJson(study.settings.region, study.city.frame)));
    return std::move(files).result();
}

int runCityStudy(const CityStudyOptions& options, const Console& console) {
    const auto tiled = computed(options, console);
    if (!tiled) return fail(console, tiled.error().error, tiled.error().code);
    const std::string json =
        extendRepeat(tiledStudyJson(*tiled), listLegendOptions(options.study.legend, false));
    const std::filesystem::path folder = options.study.out;
    auto files = writeTexts(*tiled, json, options.study);
    if (!files) return fail(console, files.error(), exitFailed);
    files->insert(files->begin(), folder / mapName);
    if (tiled->study.settings.byMonth) files->insert(files->begin() + 1, folder / monthMapName);
    for (const std::string& map : namesOfTreeMaps(tiled->study.settings, tiled->treeColumns))
        files->push_back(folder / (map + ".tif"));
    if (options.study.json)
        console.out << json << '\n';
    else
        printStudy(*tiled, *files, console.out);
    return exitOk;
}

}  // namespace

void addCityStudyCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<CityStudyOptions>();
    CLI::App* command = app.add_subcommand(
        "city-study", "Run a study over a region of any size, tile by tile; resume it after an interruption");
    addStudyOptions(*command, options->study);
    addMonthOption(*command, options->study.settings);
    addFieldOptions(*command, treeFields().of(options->study.settings));
    addLegendOptions(*command, options->study.legend);
    command->add_option(flags::tile, options->tileCells, "Cells per side of a tile")
        ->capture_default_str()
        ->check(CLI::Range(TiledStudySettings::minTileCells, TiledStudySettings::maxTileCells))
        ->type_name("CELLS");
    command->footer(
        "A year of a whole city:\n"
        "  noonmark-cli city-study city.osm.pbf --start 2026-01-01 --days 365 --from 08:00 --hours 8 \\\n"
        "    --zone America/New_York --region city --out city\n"
        "Writes shadow.tif and study.json. After an interruption run the same command again: it computes "
        "only the missing tiles.");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runCityStudy(*options, console); };
    });
}

}  // namespace noonmark::cli
