#include "app/cli/base/command_line.h"

#include <exception>
#include <ostream>
#include <string>
#include <string_view>

#include "app/cli/base/command.h"
#include "app/cli/clean_output.h"
#include "app/cli/commands/point_command.h"
#include "app/cli/commands/question_commands.h"
#include "app/cli/help_format.h"
#include "app/cli/tiles/tiles_command.h"
#include "app/input/build_facts.h"
#include "core/base/clean_text.h"
#include "core/base/process.h"
#include "core/simd/instruction_set.h"

namespace noonmark::cli {

namespace {

void say(const Console& console, const std::string& text) {
    console.err << "noonmark-cli: " << cleanText(text) << '\n';
}

// For the parser, groups of options are commands without a name.
bool isCommand(const CLI::App* app) { return !app->get_name().empty(); }

// The parser only reports that a command is missing; this names the unknown word.
std::string reasonOf(const CLI::ParseError& error, const CLI::App& app, int argc, const char* const* argv) {
    std::string words;
    const CLI::App* last = &app;
    int next = 1;
    for (; !last->get_subcommands().empty(); ++next) {
        last = last->get_subcommands().front();
        words += last->get_name() + ' ';
    }
    const bool wantsCommand = !last->get_subcommands(isCommand).empty();
    if (!wantsCommand || next >= argc || argv[next][0] == '-') return error.what();
    return "There is no command '" + words + argv[next] + "'";
}

// The parser would take the next word as the value.
std::string emptyOption(int argc, const char* const* argv) {
    for (int i = 1; i < argc; ++i)
        if (const std::string_view word = argv[i]; word.starts_with("--") && word.ends_with('='))
            return std::string(word.substr(0, word.size() - 1));
    return {};
}

int parseAndRun(CLI::App& app, const Run& run, int argc, const char* const* argv, const Console& console) {
    if (const std::string option = emptyOption(argc, argv); !option.empty()) {
        say(console, option + "= has no value (--help shows the options)");
        return exitUsage;
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& information) {  // --help, --version
        return app.exit(information, console.out, console.err);
    } catch (const CLI::ParseError& error) {
        say(console, reasonOf(error, app, argc, argv) + " (--help shows the options)");
        return exitUsage;
    }
    return run(console);
}

// A script must not take incompletely written output for success.
int checkWritten(const Console& console, int code) {
    console.out.flush();
    if (console.out || code != exitOk) return code;
    say(console, "The output could not be written completely. Check that the disk has free space");
    return exitFailed;
}

}  // namespace

int fail(const Console& console, const Error& error, ExitCode code) {
    say(console, error.text());
    return isCancelled(error) ? exitCancelled : code;
}

int runCommandLine(int argc, const char* const* argv, const Console& given) {
    CleanOutput clean(given.out);
    std::ostream out(&clean);
    letLargeWritesFail();
    const Console console{out, given.err, given.watched};
    try {
        if (const auto chosen = useInstructionSetOfEnvironment(); !chosen)
            return fail(console, chosen.error(), exitUsage);
        CLI::App app("Measures the shadows that buildings cast on a city.", "noonmark-cli");
        app.formatter(std::make_shared<HelpFormat>());
        app.set_version_flag("--version", buildFactsText);
        app.require_subcommand(1);
        Run run;
        addSampleCommand(app, run);
        addInfoCommand(app, run);
        addImportCommand(app, run);
        addSunCommand(app, run);
        addStudyCommand(app, run);
        addCityStudyCommand(app, run);
        addTilesCommand(app, run);
        addBenchCommand(app, run);
        addProjectCommand(app, run);
        addImpactCommand(app, run);
        addScoreCommand(app, run);
        addScenariosCommand(app, run);
        addPlacesCommand(app, run);
        addByPlaceCommand(app, run);
        addScreenCommand(app, run);
        addTimelineCommand(app, run);
        addPointCommand(app, run);
        addReviewCommand(app, run);
        addQuestionCommands(app, run);
        addVerifyCommand(app, run);
        addEnginesCommand(app, run);
        addDevicesCommand(app, run);
        addDescribeCommand(app, run);
        return checkWritten(console, parseAndRun(app, run, argc, argv, console));
    } catch (const std::exception& error) {
        say(console, error.what());
        return exitFailed;
    }
}

}  // namespace noonmark::cli
