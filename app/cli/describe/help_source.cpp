#include <fmt/format.h>

#include "app/cli/describe/describe.h"

namespace noonmark::cli {

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
