#include "core/study/provenance/repeat_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <vector>

#include "core/io/heights/height_text.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/provenance/city_files_command.h"
#include "core/study/text/region_text.h"

namespace noonmark {

namespace {

std::string nameOf(LengthUnit unit) { return std::string(entryOf(unit).key); }

std::string nameOf(TerrainFromBases choice) {
    return choice == TerrainFromBases::always  ? "always"
           : choice == TerrainFromBases::never ? "never"
                                               : "auto";
}

std::string nameOf(Stand choice) { return choice == Stand::terrain ? "terrain" : "absolute"; }

std::string nameOf(TerrainShows choice) { return choice == TerrainShows::ground ? "ground" : "surface"; }

void addReading(CommandWords& line, const ReadSettings& reading) {
    const ReadSettings usual;
    line.unless(reading.heightField.empty(), "--height-field", reading.heightField);
    line.unless(reading.levelsField.empty(), "--levels-field", reading.levelsField);
    if (reading.heightUnit) line.option("--height-unit", nameOf(*reading.heightUnit));
    line.unless(reading.metresPerLevel == usual.metresPerLevel, "--metres-per-level",
                fmt::to_string(reading.metresPerLevel));
    line.unless(reading.defaultHeightM == usual.defaultHeightM, "--default-height",
                fmt::to_string(reading.defaultHeightM));
    line.unless(reading.layer.empty(), "--layer", reading.layer);
    if (reading.crs) line.option("--crs", *reading.crs);
    line.unless(reading.lod.empty(), "--lod", reading.lod);
    line.unless(reading.terrainFromBases == usual.terrainFromBases, "--terrain-from-bases",
                nameOf(reading.terrainFromBases));
    line.unless(reading.stand == usual.stand, "--stand", nameOf(reading.stand));
    line.unless(reading.terrainShows == usual.terrainShows, "--terrain-shows", nameOf(reading.terrainShows));
    line.flag(reading.heightsFromSurface, "--heights-from-surface");
    line.unless(reading.farAwayM == usual.farAwayM, "--far-away", fmt::to_string(reading.farAwayM));
}

void addMesh(CommandWords& line, const ReadSettings& reading) {
    line.unless(reading.upAxis == UpAxis::automatic, "--up", reading.upAxis == UpAxis::z ? "z" : "y");
    line.unless(reading.meshUnit == LengthUnit::metres, "--mesh-unit", nameOf(reading.meshUnit));
    line.unless(reading.meshNorthDeg == 0, "--mesh-north", fmt::to_string(reading.meshNorthDeg));
    if (reading.meshAnchor)
        line.option("--mesh-anchor",
                    fmt::format("{},{}", reading.meshAnchor->lonDeg, reading.meshAnchor->latDeg));
}

std::string windowText(const SolarWindow& window) {
    const auto minutes = [](const char* event, long later) { return fmt::format("{}{:+}m", event, later); };
    return minutes("sunrise", long(window.afterSunrise.count())) + ".." +
           minutes("sunset", -long(window.beforeSunset.count()));
}

void addPeriod(CommandWords& line, const Period& period, const std::string& hourOption) {
    line.option("--start", fmt::format("{:04}-{:02}-{:02}", int(period.start.year()),
                                       unsigned(period.start.month()), unsigned(period.start.day())));
    line.option("--days", fmt::to_string(period.days));
    if (period.window) {
        line.option("--window", windowText(*period.window));
        line.flag(period.window->rule == SunriseRule::centre, "--centre");
    } else {
        line.option(hourOption.c_str(),
                    fmt::format("{:02}:{:02}", period.from.count() / 60, period.from.count() % 60));
        line.option("--hours", fmt::to_string(period.hours));
    }
    line.option("--step", fmt::format("{}", period.stepMinutes));
    line.option("--zone", period.zone);
    line.flag(!period.refraction, "--no-refraction");
}

// The engine that was picked, unless its options or the requested results need another one.
std::string engineToName(const RepeatQuestion& question) {
    const StudySettings& settings = question.settings;
    const bool plain = settings.engineSettings.empty() && !settings.byMonth && !settings.contributions;
    return plain && !question.engineKey.empty() ? question.engineKey : settings.engine;
}

void addSettings(CommandWords& line, const RepeatQuestion& question) {
    const StudySettings& settings = question.settings;
    const StudySettings usual;
    line.unless(settings.pressureHPa == usual.pressureHPa, "--pressure",
                fmt::to_string(settings.pressureHPa));
    line.unless(settings.temperatureC == usual.temperatureC, "--temperature",
                fmt::to_string(settings.temperatureC));
    line.option("--region", question.provenance.region);
    line.option("--cell", fmt::format("{}", settings.receivers.cellM));
    line.unless(settings.receivers.places == usual.receivers.places, "--receivers",
                std::string(nameOf(settings.receivers.places)));
    line.option("--engine", engineToName(question));
    for (const auto& [key, value] : settings.engineSettings)
        line.option("--option", fmt::format("{}={}", key, value));
    for (const RepeatOption& option : question.options) line.option(option);
}

/// True for a file that is read because another file needs it: not named on the command line.
bool goesAlong(const std::filesystem::path& file) {
    static constexpr std::array<std::string_view, 6> extensions{".dbf", ".shx", ".prj",
                                                                ".cpg", ".bin", ".tfw"};
    return std::ranges::find(extensions, file.extension().string()) != extensions.end();
}

// File names, or paths if two names are equal: paths do not hold elsewhere, but they distinguish the files.
void addInputs(CommandWords& line, const std::vector<InputFile>& inputs) {
    std::set<std::filesystem::path> names;
    std::vector<const InputFile*> named;
    for (const InputFile& input : inputs)
        if (!goesAlong(input.path)) named.push_back(&input);
    for (const InputFile* input : named) names.insert(input->path.filename());
    for (const InputFile* input : named)
        line.file(names.size() == named.size() ? input->path.filename().string() : input->path.string());
}

bool namesProject(const Provenance& provenance) { return provenance.project && provenance.project->saved(); }

// The city without edits is that of its files, whether the project is saved or not.
bool namesInputs(const RepeatQuestion& question) {
    const Provenance& provenance = question.provenance;
    const bool asRead = !provenance.project || provenance.project->scenario.edits.empty();
    return !question.needsProject && asRead && namesCityFiles(provenance);
}

tl::unexpected<Error> notRepeatable(const Provenance& provenance) {
    if (!provenance.project)
        return failure(
            "No command can repeat this result: the files that the city was read from are not known", {}, {});
    return failure(
        "No command can repeat this result yet: the project has not been saved in the state that was "
        "measured",
        fmt::format("scenario '{}'", provenance.project->scenario.name),
        "Save the project, then export again: the command names the project file");
}

void addSource(CommandWords& line, const RepeatQuestion& question) {
    const Provenance& provenance = question.provenance;
    if (namesProject(provenance)) {
        line.file(provenance.project->file);
        if (!provenance.project->baseline) line.option("--scenario", provenance.project->scenario.name);
        return;
    }
    addCityFiles(line, provenance);
}

std::vector<RepeatOption> optionsOf(const StudySettings& settings) {
    std::vector<RepeatOption> options;
    if (settings.byMonth) options.push_back({"--by", {"month"}});
    if (settings.contributions) options.push_back({"--contributions", {}});
    addErrorSample(settings.errorSample, options);
    return options;
}

std::string regionOf(const Study& study) {
    const std::string& known = study.provenance.region;
    return known.empty() ? formatRegion(study.settings.region, study.city) : known;
}

}  // namespace

void addErrorSample(const ErrorSampleSettings& sample, std::vector<RepeatOption>& options) {
    if (sample.receivers != ErrorSampleSettings{}.receivers)
        options.push_back({"--error-sample", {fmt::to_string(sample.receivers)}});
}

bool namesCityFiles(const Provenance& provenance) {
    return !provenance.inputs.empty() && provenance.reading.has_value();
}

void addCityFiles(CommandWords& line, const Provenance& provenance) {
    addInputs(line, provenance.inputs);
    addReading(line, *provenance.reading);
    addMesh(line, *provenance.reading);
}

Result<std::string> makeRepeatCommand(const RepeatQuestion& question, std::size_t width) {
    if (!namesProject(question.provenance) && !namesInputs(question))
        return notRepeatable(question.provenance);
    CommandWords line("noonmark-cli " + question.command);
    addSource(line, question);
    addPeriod(line, question.settings.period, question.hourOption);
    addSettings(line, question);
    line.option("--out", "repeated");
    return line.wrapped(width);
}

Result<std::string> makeRepeatCommand(const Study& study, std::size_t width, const std::string& command,
                                      std::vector<RepeatOption> more) {
    RepeatQuestion question{command, study.settings, study.provenance, study.field.engineKey};
    question.provenance.region = regionOf(study);
    question.options = optionsOf(study.settings);
    question.options.insert(question.options.end(), more.begin(), more.end());
    return makeRepeatCommand(question, width);
}

bool needsRegionFile(const Study& study) { return regionOf(study) == regionFileName; }

}  // namespace noonmark
