#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/progress_line.h"
#include "app/cli/base/study_table.h"
#include "app/cli/options/picture_option.h"
#include "app/cli/study/study_request.h"
#include "app/input/all_engines.h"
#include "app/report/files/output_folder.h"
#include "core/describe/command_flags.h"
#include "core/io/styles/raster_style.h"
#include "core/study/provenance/provenance_tags.h"
#include "core/study/provenance/repeat_command.h"
#include "core/study/text/breakdown_text.h"
#include "core/study/text/region_text.h"
#include "core/study/tiles/tile_maps.h"
#include "core/study/tiles/tiled_study.h"

namespace noonmark::cli {

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

std::vector<std::string> namesOf(const StudySettings& settings) {
    std::vector<std::string> names{mapName, styleName, jsonName};
    if (settings.byMonth) names.insert(names.end(), {monthMapName, monthStyleName, monthTableName});
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
        files.add(monthTableName, textContent(monthsCsv(tiled.months, study.provenance)));
    }
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
    if (options.study.json)
        console.out << json << '\n';
    else
        printStudy(tiled->study, *files, console.out);
    return exitOk;
}

}  // namespace

void addCityStudyCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<CityStudyOptions>();
    CLI::App* command = app.add_subcommand(
        "city-study", "Run a study over a region of any size, tile by tile; resume it after an interruption");
    addStudyOptions(*command, options->study);
    addMonthOption(*command, options->study.settings);
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
