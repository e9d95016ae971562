#include "core/study/provenance/repeat_review.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/describe/command_options.h"

namespace noonmark {

namespace {

// A parcel of a rule with lines has two reviews.
std::vector<std::string> namesOf(const std::vector<PlaceReview>& reviews) {
    std::vector<std::string> names;
    for (const PlaceReview& review : reviews)
        if (std::ranges::find(names, review.name) == names.end()) names.push_back(review.name);
    return names;
}

}  // namespace

void addRule(CommandWords& line, const Rule& rule) {
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
    CommandWords line("noonmark-cli review run");
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
