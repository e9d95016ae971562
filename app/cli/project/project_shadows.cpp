#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <ostream>

#include "app/cli/interrupt.h"
#include "app/cli/offscreen_qt.h"
#include "app/cli/options/number_range.h"
#include "app/cli/options/overwrite_option.h"
#include "app/cli/progress_line.h"
#include "app/cli/project/change_project.h"
#include "app/cli/project/project_commands.h"
#include "app/cli/project/project_question.h"
#include "app/cli/table.h"
#include "app/input/output_rules.h"
#include "app/report/files/shadow_files.h"
#include "core/measures/outlines/day_isochrones.h"
#include "core/measures/place_run.h"
#include "core/study/shadow_drawings.h"
#include "core/study/text/warnings_json.h"
#include "core/sun/window_steps.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

namespace {

using Json = nlohmann::ordered_json;

struct ShadowOptions {
    std::string file, from, to, zone, region, out;
    std::vector<std::string> days, times, places;
    std::vector<double> isochroneHours;
    int everyMin = 0;
    ShadowFileSettings files;
    DrawingSettings drawing;
    bool overwrite = false;
    bool json = false;
};

const std::map<std::string, ShadowFormat> formatNames{{"dxf", ShadowFormat::dxf},
                                                      {"gpkg", ShadowFormat::geoPackage},
                                                      {"geojson", ShadowFormat::geoJson},
                                                      {"svg", ShadowFormat::svg}};
const std::map<std::string, DrawingPlane> planeNames{{"local", DrawingPlane::local},
                                                     {"utm", DrawingPlane::utm}};

/// Minutes since midnight, in order.
Result<std::vector<std::chrono::minutes>> timesOfDay(const ShadowOptions& options) {
    std::vector<std::chrono::minutes> times;
    for (const std::string& text : options.times) {
        const auto time = parseTimeOfDay(text);
        if (!time) return tl::make_unexpected(time.error());
        times.push_back(*time);
    }
    for (int minute = 0; options.everyMin > 0 && minute < 24 * 60; minute += options.everyMin)
        times.emplace_back(minute);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    if (times.empty())
        return failure("The times are missing", "times", "Give --times 09:00,12:00 or --every 60");
    return times;
}

struct NamedWindow {
    DayWindow window;
    std::string clock;  // "09:00"
};

Result<std::vector<NamedWindow>> windowsOf(const ShadowOptions& options, const Zone& zone) {
    const auto times = timesOfDay(options);
    if (!times) return tl::make_unexpected(times.error());
    std::vector<NamedWindow> windows;
    for (const std::string& text : options.days) {
        const auto day = parseDate(text);
        if (!day) return tl::make_unexpected(day.error());
        for (const std::chrono::minutes time : *times)
            windows.push_back({{*day, zone.instantAt(*day, time), 1}, formatText(time)});
    }
    std::ranges::stable_sort(windows, {}, [](const NamedWindow& named) { return named.window.from; });
    return windows;
}

DrawnTime timeOf(const NamedWindow& named, const SunStep& sun, const Zone& zone) {
    const std::string day = formatText(named.window.date);
    std::string digits = named.clock;
    std::erase(digits, ':');
    return {day + "_" + digits, day, fmt::format("{} {} {}", day, named.clock, zone.name()), sun};
}

/// The times with the sun up. A time that was asked for by name and has no sun gives a warning.
Result<std::vector<DrawnTime>> drawnTimes(const ShadowOptions& options, const City& city,
                                          Warnings& warnings) {
    const auto zone = Zone::named(options.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    const auto named = windowsOf(options, *zone);
    if (!named) return tl::make_unexpected(named.error());
    std::vector<DayWindow> windows;
    for (const NamedWindow& one : *named) windows.push_back(one.window);
    const auto sun = computeSunSteps(windows, {.stepMinutes = 1}, observerOfPlaces(city));
    if (!sun) return tl::make_unexpected(sun.error());
    std::vector<DrawnTime> times;
    for (std::size_t i = 0; i < windows.size(); ++i) {
        if (sun->days[i].count > 0)
            times.push_back(timeOf((*named)[i], sun->steps[sun->days[i].first], *zone));
        else if (options.everyMin == 0)
            warnings.push_back({WarningKind::leftOut, "a time with the sun below the horizon",
                                formatText(windows[i].date) + " " + (*named)[i].clock});
    }
    if (!times.empty()) return times;
    return failure("The sun is below the horizon at all times", "times", "Choose other times or days");
}

Result<Box2> boxOfPlaces(const std::vector<std::string>& names, const Project& project) {
    Box2 box;
    for (const std::string& name : names) {
        const auto place = findPlace(project, name);
        if (!place) return tl::make_unexpected(place.error());
        for (const Footprint& polygon : place->polygons) box.add(bounds(polygon));
    }
    return box;
}

Result<DrawingSettings> drawingSettings(const ShadowOptions& options, const Project& project,
                                        const City& city) {
    DrawingSettings settings = options.drawing;
    if (!options.region.empty()) {
        const auto region = regionIn(project, city, options.region);
        if (!region) return tl::make_unexpected(region.error());
        settings.area = bounds(*region);
    } else if (!options.places.empty()) {
        const auto box = boxOfPlaces(options.places, project);
        if (!box) return tl::make_unexpected(box.error());
        settings.area = *box;
    }
    return settings;
}

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
    for (const std::string& day : options.days) {
        const auto start = parseDate(day);
        if (!start) return tl::make_unexpected(start.error());
        Period period;
        period.start = *start;
        period.days = 1;
        period.from = std::chrono::minutes(0);
        period.hours = 24;
        period.zone = options.zone;
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
    const auto times = drawnTimes(options, before->city, answer.warnings);
    if (!times) return tl::make_unexpected(times.error());
    const auto settings = drawingSettings(options, project, before->city);
    if (!settings) return tl::make_unexpected(settings.error());
    if (const auto may = checkOutputs(options.out, shadowFileNames(*times, options.files), outputs); !may)
        return tl::make_unexpected(may.error());
    const Interrupt interrupt;
    ProgressLine progress(console);
    auto drawing = drawShadows(before->city, options.to.empty() ? nullptr : &after->city, project.places,
                               *times, *settings, progress, interrupt.token());
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
    command.add_option("--from", options.from, "The baseline: the scenario to compare with")
        ->default_val(existingCity)
        ->type_name("NAME");
    command.add_option("--to", options.to, "The scenario to draw (default: the baseline alone)")
        ->type_name("NAME");
    command.add_option("--day", options.days, "A day; may be repeated")
        ->required()
        ->delimiter(',')
        ->type_name("YYYY-MM-DD");
    CLI::Option* times =
        command.add_option("--times", options.times, "Times of day")->delimiter(',')->type_name("HH:MM,...");
    command.add_option("--every", options.everyMin, "Every so many minutes while the sun is up")
        ->check(within(1, 720))
        ->excludes(times)
        ->type_name("MIN");
    command
        .add_option("--isochrones", options.isochroneHours,
                    "Add lines of so many hours of shadow, from sunrise to sunset of each day")
        ->delimiter(',')
        ->check(within(0.1, 24))
        ->type_name("HOURS,...");
    command.add_option("--zone", options.zone, "Time zone of the times")->required()->type_name("ZONE");
    CLI::Option* region = command.add_option(
        "--region", options.region,
        "Draw the box around this region or place, a box in degrees, a polygon or a file (default: as far as "
        "the shadows of what changes reach)");
    region->type_name("REGION");
    command.add_option("--place", options.places, "Draw the box around this place; may be repeated")
        ->allow_extra_args(false)
        ->excludes(region)
        ->type_name("NAME");
}

void addOutputs(CLI::App& command, ShadowOptions& options) {
    const auto names = [](const std::string& text) { return CLI::detail::to_lower(text); };
    command.add_option("--format", options.files.formats, "Formats to write (default: dxf,gpkg)")
        ->delimiter(',')
        ->transform(CLI::CheckedTransformer(formatNames, names).description(""))
        ->type_name("dxf,gpkg,geojson,svg");
    command.add_option("--plane", options.files.plane, "Plane of DXF and GeoPackage: local (default) or utm")
        ->transform(CLI::CheckedTransformer(planeNames, names).description(""))
        ->type_name("local|utm");
    command.add_option("--scale", options.files.scale, "Scale of SVG: 1:SCALE")
        ->capture_default_str()
        ->check(within(50, 100000))
        ->type_name("SCALE");
    command.add_option("--cell", options.drawing.cellM, "Size of a cell on terrain, m")
        ->capture_default_str()
        ->check(within(ReceiverSettings::minCellM, ReceiverSettings::maxCellM))
        ->type_name("M");
    command.add_option("--out", options.out, "Folder for the files")->required()->type_name("DIR");
    addOverwriteOption(command, options.overwrite);
    command.add_flag("--json", options.json, "Print only JSON to standard output");
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
