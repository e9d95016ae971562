#include "app/cli/review/review_source.h"

#include <fstream>
#include <ostream>

#include "app/cli/base/change_project.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/project_options.h"
#include "app/cli/study/study_request.h"
#include "app/input/load_city.h"
#include "app/input/load_project.h"
#include "core/describe/command_options.h"
#include "scenarios/project/project_provenance.h"

namespace noonmark::cli {

namespace {

Result<ReviewSource> openScenarios(const ReviewRunOptions& options, const Console& console) {
    if (auto alone = checkProjectAlone(options.read); !alone) return tl::make_unexpected(alone.error());
    // Without any scenario the existing city is reviewed; a baseline alone says nothing about what to review.
    if (options.to.empty() && !options.from.empty() && options.from != existingCity)
        return failure("The scenario to review is missing", flags::to, "Give --to NAME, a scenario");
    return openProject(options.read.files.front(), console).map([](ProjectFile disk) {
        return ReviewSource{disk.project(), std::move(disk), {}, {}, {}};
    });
}

Result<ReviewSource> readFiles(const ReviewRunOptions& options, const Console& console) {
    for (const std::string& scenario : {options.from, options.to})
        if (!scenario.empty() && scenario != existingCity)
            return failure("Only a project has scenarios", scenario,
                           "Give a project: noonmark-cli project new --help");
    if (!options.windows.asked())
        return failure("Places are reviewed in a project", options.read.files.front(),
                       "Make one: noonmark-cli project new --help; or give --windows or --facades-of");
    return loadCity(options.read, console).map([](LoadedCity loaded) {
        Project project = projectOf(loaded);
        return ReviewSource{std::move(project), {}, std::move(loaded), {}, {}};
    });
}

Result<std::string> zoneOf(const ReviewRunOptions& options, const Project& project) {
    if (!options.settings.zone.empty())
        return Zone::named(options.settings.zone).map([](const Zone& zone) { return zone.name(); });
    if (auto zone = commonZone(project)) return *std::move(zone);
    return failure("The rule's hours need a time zone", "--zone",
                   "Give --zone, for example --zone America/New_York");
}

int yearOf(const ReviewRunOptions& options, const Project& project) {
    if (options.settings.year != 0) return options.settings.year;
    return project.periods.empty() ? 2026 : int(project.periods.front().period.start.year());
}

}  // namespace

Result<ReviewSource> openReviewSource(const ReviewRunOptions& options, const RuleLibrary& library,
                                      const Console& console) {
    auto source = namesProject(options.read) ? openScenarios(options, console) : readFiles(options, console);
    if (!source) return source;
    source->ofRules = library.warnings();
    source->outputs = outputRules(listNamedFiles(options.read), source->project.inputs, options.overwrite);
    const GlazingRunOptions& windows = options.windows;
    if (windows.ofFile) addPlace(source->outputs, windows.elements.windows.string());
    if (windows.asked()) addPlace(source->outputs, windows.region);
    return source;
}

Result<ReviewGround> prepareGround(const ReviewRunOptions& options, const ReviewSource& source,
                                   const std::vector<std::string>& fileNames) {
    const Project& project = source.project;
    const auto zone = zoneOf(options, project);
    if (!zone) return tl::make_unexpected(zone.error());
    const std::string from = options.from.empty() ? existingCity : options.from;
    const std::string to = options.to.empty() ? existingCity : options.to;
    auto before = cityOf(project, from), after = cityOf(project, to);
    if (!before) return tl::make_unexpected(before.error());
    if (!after) return tl::make_unexpected(after.error());
    if (!options.estimate)
        if (const auto may = checkOutputs(options.out, fileNames, source.outputs); !may)
            return tl::make_unexpected(may.error());
    auto sheets = bookSettingsOf(options.sheets, project.sheets);
    if (!sheets) return tl::make_unexpected(sheets.error());
    return ReviewGround{{from, to, std::make_shared<const City>(std::move(before->city)),
                         std::make_shared<const City>(std::move(after->city))},
                        *zone,
                        yearOf(options, project),
                        *std::move(sheets)};
}

Result<std::vector<std::filesystem::path>> writeAnswer(const Answer& answer, const ReviewRunOptions& options,
                                                       const BookSettings& sheets, const ReviewSource& source,
                                                       const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    const AnswerFiles how{.legend = sheets.legend,
                          .byteOrderMark = options.byteOrderMark,
                          .book = sheets,
                          .rules = source.outputs,
                          .progress = &progress,
                          .stop = interrupt.token()};
    return answer.write({}, options.out, how);
}

void printReviewJson(const std::filesystem::path& folder, std::ostream& out) {
    out << std::ifstream(folder / "review.json").rdbuf();
}

}  // namespace noonmark::cli
