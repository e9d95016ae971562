#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <ostream>

#include "app/cli/base/change_project.h"
#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/project/drawn_times.h"
#include "app/cli/project/project_commands.h"
#include "app/input/load_city.h"
#include "app/report/files/answer_files.h"
#include "core/city/trees/tree.h"
#include "core/describe/command_options.h"
#include "core/measures/outlines/day_isochrones.h"
#include "core/measures/places/place_run.h"
#include "core/study/shadow_drawings.h"
#include "core/study/text/error_text.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

namespace {

using Json = nlohmann::ordered_json;

struct ShadowOptions {
    std::string file, from, to, out;
    DrawnTimeChoice when;
    DrawnAreaOptions where;
    std::vector<double> isochroneHours;
    ShadowFileSettings files;
    DrawingSettings drawing;
    bool overwrite = false;
    bool json = false;
};

const std::map<std::string, ShadowFormat> formatNames{{"dxf", ShadowFormat::dxf},
                                                      {"gpkg", ShadowFormat::geoPackage},
                                                      {"geojson", ShadowFormat::geoJson},
                                                      {"svg", ShadowFormat::svg}};

struct ShadowAnswer {
    ShadowDrawing drawing;
    Warnings warnings;
};

/// Lines of equal hours of shadow from sunrise to sunset of each day.
Result<void> addIsochrones(const ShadowOptions& options, const City& city, ShadowDrawing& drawing,
                           Progress& progress, const std::stop_token& stop) {
    IsochroneSettings settings{drawing.area, {}, {}};
    for (const double hours : options.isochroneHours) settings.levelsMin.push_back(hours * 60);
    std::ranges::sort(settings.levelsMin);
    for (const std::string& day : options.when.days) {
        const auto start = parseDate(day);
        if (!start) return tl::make_unexpected(start.error());
        Period period;
        period.start = *start;
        period.days = 1;
        period.from = std::chrono::minutes(0);
        period.hours = 24;
        period.zone = options.when.zone;
        const auto sun = computeDaylightSteps(period, observerOfPlaces(city), stop);
        if (!sun) return tl::make_unexpected(sun.error());
        auto lines = traceDayIsochrones(city, *sun, settings, progress, stop);
        if (!lines) return tl::make_unexpected(lines.error());
        drawing.isochrones.push_back({day, lines->cellM, std::move(lines->lines)});
        drawing.notes.push_back(fmt::format("Lines of equal hours of shadow on {}: {}, cells of {:g} m", day,
                                            lines->engine, lines->cellM));
    }
    return {};
}

Result<ShadowAnswer> computeDrawing(const ShadowOptions& options, const ProjectFile& disk,
                                    const OutputRules& outputs, const Console& console) {
    const Project& project = disk.project();
    const auto before = cityOf(project, options.from);
    if (!before) return tl::make_unexpected(before.error());
    const auto after = cityOf(project, options.to.empty() ? options.from : options.to);
    if (!after) return tl::make_unexpected(after.error());
    ShadowAnswer answer;
    if (const auto given = checkTimesGiven(options.when); !given) return tl::make_unexpected(given.error());
    const auto times = listDrawnTimes(options.when, before->city, answer.warnings);
    if (!times) return tl::make_unexpected(times.error());
    std::ranges::move(warnOfTrees(after->city.trees), std::back_inserter(answer.warnings));
    const auto area = findDrawnArea(options.where, project, before->city);
    if (!area) return tl::make_unexpected(area.error());
    DrawingSettings settings = options.drawing;
    settings.area = *area;
    if (const auto may = checkOutputs(options.out, shadowFileNames(*times, options.files), outputs); !may)
        return tl::make_unexpected(may.error());
    const Interrupt interrupt;
    ProgressLine progress(console);
    auto drawing = drawShadows(before->city, options.to.empty() ? nullptr : &after->city, project.places,
                               *times, settings, progress, interrupt.token());
    if (!drawing) return tl::make_unexpected(drawing.error());
    answer.drawing = *std::move(drawing);
    if (!options.isochroneHours.empty()) {
        const auto done = addIsochrones(options, after->city, answer.drawing, progress, interrupt.token());
        if (!done) return tl::make_unexpected(done.error());
    }
    answer.drawing.notes.push_back(options.to.empty()
                                       ? "Shadows of " + options.from
                                       : fmt::format("From {} to {}", options.from, options.to));
    if (!project.attribution.empty()) answer.drawing.notes.push_back(project.attribution);
    return answer;
}

using Paths = std::vector<std::filesystem::path>;

void printDrawing(const ShadowAnswer& answer, const Paths& written, std::ostream& out) {
    for (const DrawnMoment& moment : answer.drawing.moments) {
        const ShadowOutlines& outlines = moment.outlines;
        out << fmt::format(
            "{}  sun at azimuth {:5.1f}, altitude {:4.1f} deg; shadow {:.1f} m2, incremental {:.1f} m2, "
            "gained "
            "{:.1f} m2\n",
            moment.time.clock, moment.time.sun.azimuthDeg, moment.time.sun.altitudeDeg,
            area(outlines.baseline), area(outlines.incremental), area(outlines.gained));
    }
    for (const auto& file : written) out << fmt::format("{} written\n", file.string());
    printWarnings(out, answer.warnings);
}

void printJson(const ShadowAnswer& answer, const Paths& written, std::ostream& out) {
    Json moments = Json::array(), files = Json::array();
    for (const DrawnMoment& moment : answer.drawing.moments)
        moments.push_back({{"time", moment.time.clock},
                           {"name", moment.time.name},
                           {"azimuth_deg", moment.time.sun.azimuthDeg},
                           {"altitude_deg", moment.time.sun.altitudeDeg},
                           {"baseline_m2", area(moment.outlines.baseline)},
                           {"incremental_m2", area(moment.outlines.incremental)},
                           {"gained_m2", area(moment.outlines.gained)},
                           {"cell_m", moment.outlines.cellM}});
    for (const auto& file : written) files.push_back(file.string());
    const Box2& box = answer.drawing.area;
    out << toJsonText({{"area", {box.low.x, box.low.y, box.high.x, box.high.y}},
                       {"moments", moments},
                       {"files", files},
                       {"warnings", warningsJson(answer.warnings)}})
        << '\n';
}

int runShadows(const ShadowOptions& options, const Console& console) {
    const OffscreenQt qt;
    const auto disk = ProjectFile::open(options.file);
    if (!disk) return fail(console, disk.error(), exitUsage);
    const OutputRules outputs = outputRules({options.file}, disk->project().inputs, options.overwrite);
    const auto answer = computeDrawing(options, *disk, outputs, console);
    if (!answer) return fail(console, answer.error(), exitUsage);
    OutputFolder files(options.out, outputs);
    addShadowFiles(files, answer->drawing, options.files);
    const auto written = std::move(files).result();
    if (!written) return fail(console, written.error(), exitFailed);
    if (options.json)
        printJson(*answer, *written, console.out);
    else
        printDrawing(*answer, *written, console.out);
    return exitOk;
}

void addQuestion(CLI::App& command, ShadowOptions& options) {
    addProjectFile(command, options.file);
    command.add_option(flags::from, options.from, "The baseline: the scenario to compare with")
        ->default_val(existingCity)
        ->type_name("NAME");
    command.add_option(flags::to, options.to, "The scenario to draw (default: the baseline alone)")
        ->type_name("NAME");
    addDrawnTimeOptions(command, options.when)->required();
    command
        .add_option("--isochrones", options.isochroneHours,
                    "Add lines of so many hours of shadow, from sunrise to sunset of each day")
        ->delimiter(',')
        ->check(within(0.1, 24))
        ->type_name("HOURS,...");
    addDrawnAreaOptions(command, options.where);
}

void addOutputs(CLI::App& command, ShadowOptions& options) {
    const auto names = [](const std::string& text) { return CLI::detail::to_lower(text); };
    command.add_option("--format", options.files.formats, "Formats to write (default: dxf,gpkg)")
        ->delimiter(',')
        ->transform(CLI::CheckedTransformer(formatNames, names).description(""))
        ->type_name("dxf,gpkg,geojson,svg");
    addPlaneOption(command, options.files.plane, "Plane of DXF and GeoPackage: local (default) or utm");
    command.add_option("--scale", options.files.scale, "Scale of SVG: 1:SCALE")
        ->capture_default_str()
        ->check(within(50, 100000))
        ->type_name("SCALE");
    command.add_option("--cell", options.drawing.cellM, "Size of a cell on terrain, m")
        ->capture_default_str()
        ->check(within(ReceiverSettings::minCellM, ReceiverSettings::maxCellM))
        ->type_name("M");
    command.add_option(flags::out, options.out, "Folder for the files")->required()->type_name("DIR");
    addOverwriteOption(command, options.overwrite);
    addJsonFlag(command, options.json);
}

}  // namespace

void addProjectShadows(CLI::App& project, Run& run) {
    const auto options = std::make_shared<ShadowOptions>();
    CLI::App* command = project.add_subcommand(
        "shadows", "Write the outlines of shadows at chosen times for CAD, GIS and drawing programs");
    addQuestion(*command, *options);
    addOutputs(*command, *options);
    command->footer(
        "noonmark-cli project shadows town.noonmark.gpkg --from Existing --to Tower --day 2026-03-21 \\\n"
        "    --times 09:00,12:00,15:00 --zone America/New_York --out shadows --format dxf,gpkg,svg");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runShadows(*options, console); };
    });
}

}  // namespace noonmark::cli
