#include <fmt/format.h>
#include <filesystem>
#include <memory>

#include "app/cli/base/command.h"
#include "app/cli/describe/describe.h"
#include "app/input/build_facts.h"
#include "app/input/window_arguments.h"
#include "core/base/version.h"
#include "core/describe/command_options.h"
#include "core/io/files/write_text.h"
#include "core/lab/lab_engines.h"
#include "core/review/library/rule_library.h"

namespace noonmark::cli {

namespace {

struct DescribeOptions {
    std::string format;
    std::string out;
};

std::vector<std::string> engineKeys() {
    std::vector<std::string> keys;
    for (const auto& [info, make] : coreAndLabEngines()) keys.emplace_back(info.key);
    return keys;
}

std::vector<std::string> ruleKeys() {
    std::vector<std::string> keys;
    if (const auto library = RuleLibrary::load())
        for (const Rule& rule : library->rules()) keys.push_back(rule.key);
    return keys;
}

KnownWords knownWords() { return {{"ENGINE", engineKeys()}, {"KEY", ruleKeys()}, {"RULE", ruleKeys()}}; }

ManualSection environmentSection() {
    return {"ENVIRONMENT",
            {"NOONMARK_ISA",
             "\tInstruction set that the engines use: sse4, avx2, avx512 or neon (default: the widest "
             "of this processor). The results are the same with each."}};
}

ManualFacts commandLineFacts() {
    return {std::string(version()),
            std::string(buildFacts().releaseDate),
            {{"EXIT STATUS",
              {"0", "\tDone.", "1", "\tThe work failed.", "2",
               "\tThe command line is wrong, or a file cannot be read.", "130", "\tCancelled with Ctrl+C."}},
             environmentSection()},
            {"noonmark"}};
}

ManualFacts windowFacts() {
    return {std::string(version()),
            std::string(buildFacts().releaseDate),
            {{"EXIT STATUS", {"0", "\tThe window was closed.", "2", "\tThe command line is wrong."}},
             environmentSection()},
            {"noonmark-cli"}};
}

std::vector<DescriptionFile> describePrograms(const std::string& format,
                                              const CommandDescription& commandLine,
                                              const CommandDescription& window) {
    if (format == "bash") return {writeBashCompletion(commandLine), writeBashCompletion(window)};
    if (format == "zsh") return {writeZshCompletion(commandLine), writeZshCompletion(window)};
    if (format == "fish") return {writeFishCompletion(commandLine), writeFishCompletion(window)};
    std::vector<DescriptionFile> pages = writeManualPages(commandLine, commandLineFacts());
    for (DescriptionFile& page : writeManualPages(window, windowFacts())) pages.push_back(std::move(page));
    return pages;
}

int runDescribe(const DescribeOptions& options, const CLI::App& program, const Console& console) {
    CLI::App window;
    WindowArguments arguments;
    addWindowArguments(window, arguments);
    const auto files = options.format == "help"
                           ? std::vector{writeHelpSource(program)}
                           : describePrograms(options.format, describeProgram(program, knownWords()),
                                              describeProgram(window));
    for (const auto& [name, text] : files) {
        if (options.out.empty())
            console.out << text;
        else if (const auto written = writeText(std::filesystem::path(options.out) / name, text); !written)
            return fail(console, written.error(), exitFailed);
    }
    return exitOk;
}

}  // namespace

// Hidden: it serves the build (cmake/NoonmarkInstall.cmake).
void addDescribeCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<DescribeOptions>();
    CLI::App* command =
        app.add_subcommand("describe", "Write manual pages, completions for a shell, or texts of help");
    command->group("");
    command->add_option("format", options->format, "man, bash, zsh, fish or help")
        ->required()
        ->check(CLI::IsMember({"man", "bash", "zsh", "fish", "help"}))
        ->type_name("FORMAT");
    command
        ->add_option(flags::out, options->out,
                     "Existing folder for the files, which are replaced (default: print)")
        ->type_name("DIR");
    command->callback([options, &app, &run] {
        run = [options, &app](const Console& console) { return runDescribe(*options, app, console); };
    });
}

namespace {

void addHelp(const CLI::App& command, const std::string& before, std::string words, std::string& source) {
    const std::string name = before.empty() ? command.get_name() : before + " " + command.get_name();
    if (!before.empty()) words += (words.empty() ? "" : " ") + command.get_name();
    source += fmt::format("    {{\"{}\", R\"help({})help\"}},\n", words,
                          command.get_formatter()->make_help(&command, name, CLI::AppFormatMode::Normal));
    for (const CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; }))
        if (!below->get_name().empty()) addHelp(*below, name, words, source);
}

}  // namespace

DescriptionFile writeHelpSource(const CLI::App& program) {
    std::string texts;
    addHelp(program, "", "", texts);
    return {"help_texts.cpp",
            "#include \"app/launcher/help_texts.h\"\n\n"
            "namespace noonmark::launcher {\n\n"
            "namespace {\nconstexpr HelpText texts[] = {\n" +
                texts +
                "};\n}  // namespace\n\n"
                "std::span<const HelpText> helpTexts() { return texts; }\n\n"
                "}  // namespace noonmark::launcher\n"};
}

}  // namespace noonmark::cli
