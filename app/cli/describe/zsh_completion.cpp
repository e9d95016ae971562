#include <fmt/format.h>

#include <algorithm>

#include "app/cli/describe/describe.h"

namespace noonmark::cli {

namespace {

// Text between single quotes in a specification of _arguments: brackets and colons have a meaning there.
std::string zshText(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '\'')
            escaped += "'\\''";
        else if (c == '[' || c == ']' || c == ':' || c == '\\')
            escaped += {'\\', c};
        else
            escaped += c;
    }
    return escaped;
}

std::string zshFunction(const CommandDescription& command) { return "_" + joinWords(command.words, "-"); }

std::string zshAction(const ValueDescription& value) {
    const std::string words = joinWords(value.choices, " ");
    if (value.takesFiles && !words.empty())
        return fmt::format("_alternative \"words\\:word\\:({})\" \"files\\:file\\:_files\"", words);
    if (!words.empty()) return fmt::format("({})", words);
    if (value.takesFiles) return "_files";
    return value.takesFolders ? "_files -/" : " ";
}

std::string zshValue(const OptionDescription& option) {
    if (option.value.name.empty()) return {};
    return fmt::format(":{}:{}", zshText(option.value.name), zshAction(option.value));
}

std::string zshOption(const OptionDescription& option) {
    std::string others = joinWords(option.names, " ");
    for (const std::string& excluded : option.excludes) others += " " + excluded;
    const std::string before = option.repeats ? std::string("\\*") : fmt::format("'({})'", others);
    const std::string equals = option.value.name.empty() ? "" : "=";
    std::string lines;
    for (const std::string& name : option.names)
        lines += fmt::format("        {}'{}{}[{}]{}' \\\n", before, name,
                             name.starts_with("--") ? equals : "", zshText(option.text), zshValue(option));
    return lines;
}

std::string zshPositional(const OptionDescription& option) {
    return fmt::format("        '{}:{}:{}' \\\n", option.repeats ? "*" : "", zshText(option.names[0]),
                       zshAction(option.value));
}

std::string zshSubcommands(const CommandDescription& command) {
    std::string list;
    std::string cases;
    for (const CommandDescription& sub : command.commands) {
        list += fmt::format("            '{}:{}'\n", sub.words.back(), zshText(sub.text));
        cases += fmt::format("            {}) {} ;;\n", sub.words.back(), zshFunction(sub));
    }
    return fmt::format(
        "    case $state in\n    command)\n        local -a commands=(\n{}        )\n"
        "        _describe command commands ;;\n    arguments)\n        case $line[1] in\n{}"
        "        esac ;;\n    esac\n",
        list, cases);
}

std::string zshCommand(const CommandDescription& command) {
    const bool nests = !command.commands.empty();
    std::string text = zshFunction(command) +
                       "() {\n    local curcontext=\"$curcontext\" state line\n"
                       "    typeset -A opt_args\n    _arguments -C \\\n";
    for (const OptionDescription& option : command.options) text += zshOption(option);
    for (const OptionDescription& positional : command.positionals) text += zshPositional(positional);
    if (nests) text += "        '1:command:->command' \\\n        '*::argument:->arguments' \\\n";
    text += "        && return\n";
    return text + (nests ? zshSubcommands(command) : "") + "}\n\n";
}

}  // namespace

DescriptionFile writeZshCompletion(const CommandDescription& program) {
    const std::string& name = program.words.front();
    std::string text = fmt::format(
        "#compdef {}\n# Completion of {} for zsh, written by \"noonmark-cli describe\" from "
        "the command line's own description.\n\n",
        name, name);
    for (const CommandDescription* command : listCommands(program)) text += zshCommand(*command);
    return {"_" + name, text + fmt::format("_{} \"$@\"\n", name)};
}

}  // namespace noonmark::cli
