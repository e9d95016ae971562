#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>
#include <exception>
#include <ostream>
#include <set>
#include <streambuf>
#include <string>
#include <string_view>

#include "app/cli/base/command.h"
#include "app/cli/base/command_line.h"
#include "app/cli/commands/question_commands.h"
#include "app/cli/tiles/tiles_command.h"
#include "app/input/build_facts.h"
#include "core/base/process.h"
#include "core/base/safe_text.h"
#include "core/simd/instruction_set.h"

namespace noonmark::cli {

namespace {

/// Passes text on line by line as cleanLines() makes it: whatever a command prints of the names in a
/// stranger's file, it sends no commands to a terminal.
class CleanOutput : public std::streambuf {
public:
    explicit CleanOutput(std::ostream& out) : out_(out) {}
    ~CleanOutput() override;
    CleanOutput(const CleanOutput&) = delete;
    CleanOutput& operator=(const CleanOutput&) = delete;

private:
    int_type overflow(int_type letter) override;
    std::streamsize xsputn(const char* text, std::streamsize size) override;
    int sync() override;
    bool pass(std::size_t size);

    std::ostream& out_;
    std::string waiting_;  ///< the line that has not ended
};

CleanOutput::~CleanOutput() { CleanOutput::sync(); }

CleanOutput::int_type CleanOutput::overflow(int_type letter) {
    if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
    const char one = traits_type::to_char_type(letter);
    return xsputn(&one, 1) == 1 ? letter : traits_type::eof();
}

std::streamsize CleanOutput::xsputn(const char* text, std::streamsize size) {
    waiting_.append(text, std::size_t(size));
    const auto lines = std::string_view(text, std::size_t(size)).rfind('\n');
    if (lines == std::string_view::npos) return size;
    return pass(waiting_.size() - (std::size_t(size) - lines - 1)) ? size : 0;
}

int CleanOutput::sync() { return pass(waiting_.size()) && out_.flush() ? 0 : -1; }

bool CleanOutput::pass(std::size_t size) {
    out_ << cleanLines(std::string_view(waiting_).substr(0, size));
    waiting_.erase(0, size);
    return bool(out_);
}

/// Help as the parser writes it, with the options that an option needs or excludes in alphabetical order. The
/// parser lists them by their addresses, so that two runs would print two orders.
class HelpFormat : public CLI::Formatter {
public:
    [[nodiscard]] std::string make_option_opts(const CLI::Option* option) const override;
};

std::string listOptions(const std::string& label, const std::set<CLI::Option*>& options) {
    std::set<std::string> names;
    for (const CLI::Option* option : options) names.insert(option->get_name());
    return names.empty() ? std::string() : fmt::format(" {}: {}", label, fmt::join(names, " "));
}

std::string HelpFormat::make_option_opts(const CLI::Option* option) const {
    const std::string text = CLI::Formatter::make_option_opts(option);
    if (!option->get_option_text().empty()) return text;
    const std::string needs = get_label("Needs"), excludes = get_label("Excludes");
    const auto lists = std::min(text.find(" " + needs + ":"), text.find(" " + excludes + ":"));
    return text.substr(0, lists) + listOptions(needs, option->get_needs()) +
           listOptions(excludes, option->get_excludes());
}

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
    ignoreFileSizeSignal();
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
