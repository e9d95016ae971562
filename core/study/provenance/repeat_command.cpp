#include "core/study/provenance/repeat_command.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>

#include "core/describe/command_options.h"
#include "core/io/formats/format.h"
#include "core/io/settings/read_settings.h"
#include "core/study/study_fields.h"
#include "core/study/text/region_text.h"

namespace noonmark {

namespace {

// The engine that was picked, unless its options or the requested results need another one.
std::string engineToName(const RepeatQuestion& question) {
    const StudySettings& settings = question.settings;
    const bool plain = settings.engineSettings.empty() && !settings.byMonth && !settings.contributions;
    return plain && !question.engineKey.empty() ? question.engineKey : settings.engine;
}

// The settings as the command names them: the region by a name or file, and the engine that was used.
StudySettings settingsToName(const RepeatQuestion& question) {
    StudySettings settings = question.settings;
    settings.region.name = question.provenance.region;
    settings.engine = engineToName(question);
    return settings;
}

void addSettings(CommandLineText& line, const RepeatQuestion& question) {
    const StudySettings settings = settingsToName(question);
    const std::string_view region = flagOf(studyFields().rows(), "region");
    for (const CommandOption& option : listOptions(studyFields().of(settings), question.flags))
        if (question.namesCity || option.name != region) line.option(option);
    for (const CommandOption& option : question.options) line.option(option);
}

/// True for a file that is read because another file needs it: not named on the command line.
bool isCompanion(const InputFile& file, const std::vector<InputFile>& inputs) {
    return std::ranges::any_of(inputs, [&](const InputFile& input) {
        const auto companions = listCompanionFiles(input.path);
        return std::ranges::find(companions, file.path) != companions.end();
    });
}

// Inventories of trees have an option of their own.
bool hasOption(const InputFile& file, const std::optional<ReadSettings>& reading) {
    return reading && std::ranges::find(reading->treeFiles, file.path.string()) != reading->treeFiles.end();
}

// File names, or paths if two names are equal: paths do not hold elsewhere, but they distinguish the files.
void addInputs(CommandLineText& line, const Provenance& provenance) {
    const std::vector<InputFile>& inputs = provenance.inputs;
    std::set<std::filesystem::path> names;
    std::vector<const InputFile*> named;
    for (const InputFile& input : inputs)
        if (!isCompanion(input, inputs) && !hasOption(input, provenance.reading)) named.push_back(&input);
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

void addSource(CommandLineText& line, const RepeatQuestion& question) {
    const Provenance& provenance = question.provenance;
    if (namesProject(provenance)) {
        line.file(provenance.project->file);
        if (question.namesCity && !provenance.project->baseline)
            line.option(flags::scenario, provenance.project->scenario.name);
        return;
    }
    addCityFiles(line, provenance);
}

std::string regionOf(const Study& study) {
    const std::string& known = study.provenance.region;
    return known.empty() ? formatRegion(study.settings.region, study.city) : known;
}

}  // namespace

bool namesCityFiles(const Provenance& provenance) {
    return !provenance.inputs.empty() && provenance.reading.has_value();
}

void addCityFiles(CommandLineText& line, const Provenance& provenance) {
    addInputs(line, provenance);
    for (const CommandOption& option : listOptions(readSettingsFields().of(*provenance.reading)))
        line.option(option);
}

Result<std::string> makeRepeatCommand(const RepeatQuestion& question, std::size_t width) {
    if (!namesProject(question.provenance) && !namesInputs(question))
        return notRepeatable(question.provenance);
    CommandLineText line("noonmark-cli " + question.command);
    addSource(line, question);
    addSettings(line, question);
    line.option(flags::out, "repeated");
    return line.wrapped(width);
}

Result<std::string> makeRepeatCommand(const Study& study, std::size_t width, const std::string& command,
                                      std::vector<CommandOption> more) {
    RepeatQuestion question{command, study.settings, study.provenance, study.field.engineKey};
    question.provenance.region = regionOf(study);
    question.options = std::move(more);
    return makeRepeatCommand(question, width);
}

bool needsRegionFile(const Study& study) { return regionOf(study) == regionFileName; }

namespace {

// A parcel of a rule with lines has two reviews.
std::vector<std::string> namesOf(const std::vector<PlaceReview>& reviews) {
    std::vector<std::string> names;
    for (const PlaceReview& review : reviews)
        if (std::ranges::find(names, review.name) == names.end()) names.push_back(review.name);
    return names;
}

}  // namespace

void addRule(CommandLineText& line, const Rule& rule) {
    line.option(flags::rule, rule.key);
    for (const auto& [choice, option] : rule.chosen)
        line.option(flags::choose, fmt::format("{}={}", choice, option));
    if (!rule.file.empty()) line.option(flags::rules, ".");
}

Result<std::string> makeRepeatCommand(const ReviewStudy& study, const ReviewLabels& labels,
                                      std::size_t width) {
    const auto& project = labels.provenance.project;
    if (!project || !project->saved())
        return failure(
            "No command can repeat this review yet: the project has not been saved in the state that was "
            "reviewed",
            fmt::format("scenario '{}'", labels.to), "Save the project, then export again");
    CommandLineText line("noonmark-cli review run");
    line.file(project->file);
    addRule(line, study.rule);
    line.option(flags::from, labels.from);
    line.option(flags::to, labels.to);
    line.option({flags::places, labels.places.empty() ? namesOf(study.places) : labels.places});
    ReviewSettings settings = study.settings;
    settings.year = study.year;
    for (const CommandOption& option : listOptions(reviewFields().of(settings))) line.option(option);
    for (const CommandOption& option : labels.sheets) line.option(option);
    line.option(flags::out, "repeated");
    return line.wrapped(width);
}

}  // namespace noonmark
