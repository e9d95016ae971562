#include "app/cli/tiles/study_arguments.h"

#include <algorithm>

namespace noonmark::cli {

std::vector<std::string> listArguments(const CLI::App& command, const std::vector<std::string>& leaveOut) {
    std::vector<std::string> words;
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || !name.starts_with("--")) continue;
        if (std::ranges::find(leaveOut, name) != leaveOut.end()) continue;
        if (option->get_items_expected_max() == 0) {
            words.push_back(name);
            continue;
        }
        for (const std::string& value : option->results()) words.push_back(name + "=" + value);
    }
    return words;
}

Result<StudyArguments> parseArguments(const std::vector<std::string>& arguments) {
    CLI::App parser;
    StudyOptions options;
    addStudyOptions(parser, options);
    std::vector<std::string> words{"city", "--out=folder"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::ranges::reverse(words);  // the parser takes them from the back
    try {
        parser.parse(words);
    } catch (const CLI::ParseError& error) {
        return failure(std::string("The options of the plan cannot be used: ") + error.what(), "plan.json",
                       "Plan again with this version");
    }
    return periodFrom(options.period).map([&](const Period& period) {
        StudyArguments parsed{options.read.settings, options.settings};
        parsed.settings.period = period;
        return parsed;
    });
}

}  // namespace noonmark::cli
