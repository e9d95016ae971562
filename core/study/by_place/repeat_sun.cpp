#include "core/describe/command_flags.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/provenance/repeat_command.h"

namespace noonmark {

namespace {

void append(std::vector<CommandOption>& options, const std::vector<CommandOption>& more) {
    options.insert(options.end(), more.begin(), more.end());
}

// The scenarios of a project; one that was measured alone is the baseline of the command.
std::vector<CommandOption> listCities(const SunByPlace& sun, std::span<const ComparedSun> compared) {
    std::vector<CommandOption> options{{flags::baseline, {sun.name}}};
    for (const ComparedSun& one : compared) options.push_back({flags::scenario, {one.sun.name}});
    return options;
}

}  // namespace

Result<std::string> makeRepeatCommand(const SunByPlace& sun, std::span<const ComparedSun> compared,
                                      std::size_t width) {
    if (!sun.asked)
        return failure("No command can repeat this result: how its places were chosen is not known", {}, {});
    RepeatQuestion question{"by-place", sun.settings.study, sun.provenance, {}};
    question.settings.byMonth = question.settings.contributions = false;
    question.needsProject = sun.asked->ofProject || !compared.empty();
    question.namesCity = false;
    const bool namesProject = sun.provenance.project && sun.provenance.project->saved();
    if (namesProject) append(question.options, listCities(sun, compared));
    append(question.options, sun.asked->options);
    append(question.options, listOptions(sunByPlaceFields().of(sun.settings)));
    return makeRepeatCommand(question, width);
}

}  // namespace noonmark
