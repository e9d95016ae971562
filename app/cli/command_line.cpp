#include "app/cli/command_line.h"

#include <algorithm>
#include <exception>
#include <ostream>
#include <string>

#include "app/cli/command.h"
#include "core/version.h"

namespace noonmark::cli {

namespace {

void say(const Console& console, std::string text) {
    std::ranges::replace(text, '\n', ' ');
    console.err << "noonmark-cli: " << text << '\n';
}

// Groups of options are commands without a name to the parser.
bool isCommand(const CLI::App* app) { return !app->get_name().empty(); }

// The parser only misses a command; a person wants to hear which word was none.
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

int parseAndRun(CLI::App& app, const Run& run, int argc, const char* const* argv, const Console& console) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // --help, --version
        return app.exit(asked, console.out, console.err);
    } catch (const CLI::ParseError& error) {
        say(console, reasonOf(error, app, argc, argv) + " (--help shows the options)");
        return exitUsage;
    }
    return run(console);
}

}  // namespace

int fail(const Console& console, const Error& error, ExitCode code) {
    say(console, error.text());
    return isCancelled(error) ? exitCancelled : code;
}

int runCommandLine(int argc, const char* const* argv, const Console& console) {
    try {
        CLI::App app("Measures the shadows of buildings on a city.", "noonmark-cli");
        app.set_version_flag("--version", "Noonmark " + std::string(version()));
        app.require_subcommand(1);
        Run run;
        addSampleCommand(app, run);
        addInfoCommand(app, run);
        addImportCommand(app, run);
        addSunCommand(app, run);
        addStudyCommand(app, run);
        addCityStudyCommand(app, run);
        addBenchCommand(app, run);
        addProjectCommand(app, run);
        addImpactCommand(app, run);
        addScoreCommand(app, run);
        addEnginesCommand(app, run);
        addDevicesCommand(app, run);
        return parseAndRun(app, run, argc, argv, console);
    } catch (const std::exception& error) {
        say(console, error.what());
        return exitFailed;
    }
}

}  // namespace noonmark::cli
