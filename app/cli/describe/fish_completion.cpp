#include <fmt/format.h>

#include <algorithm>

#include "app/cli/describe/describe.h"

namespace noonmark::cli {

namespace {

std::string fishText(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '\'' || c == '\\') escaped += '\\';
        escaped += c;
    }
    return "'" + escaped + "'";
}

std::string fishFunction(const CommandDescription& program) {
    std::string name = "__" + program.words.front() + "_at";
    std::ranges::replace(name, '-', '_');
    return name;
}

std::string fishValue(const ValueDescription& value) {
    if (value.name.empty()) return {};
    std::string flags = value.takesFiles || value.takesFolders ? " -r" : " -x";
    if (value.takesFolders) return " -x -a '(__fish_complete_directories)'";
    if (!value.choices.empty()) flags += fmt::format(" -a {}", fishText(joinWords(value.choices, " ")));
    return flags + (value.takesFiles ? " -F" : "");
}

// "-l cell -x -d 'Size of a cell'"
std::string fishOption(const OptionDescription& option) {
    std::string flags;
    for (const std::string& name : option.names)
        flags += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    return fmt::format("{}{} -d {}", flags, fishValue(option.value), fishText(option.text));
}

std::string fishCommand(const CommandDescription& command, const std::string& start) {
    const std::string begin = fmt::format("{} '{}'\"", start, commandPath(command, "/"));
    std::string lines;
    for (const CommandDescription& sub : command.commands)
        lines += fmt::format("{} -a {} -d {}\n", begin, sub.words.back(), fishText(sub.text));
    for (const OptionDescription& positional : command.positionals) {
        if (!positional.value.choices.empty())
            lines += fmt::format("{} -a {}\n", begin, fishText(joinWords(positional.value.choices, " ")));
        if (positional.value.takesFiles) lines += begin + " -F\n";
    }
    for (const OptionDescription& option : command.options) lines += begin + fishOption(option) + '\n';
    return lines;
}

}  // namespace

DescriptionFile writeFishCompletion(const CommandDescription& program) {
    const std::string& name = program.words.front();
    std::vector<std::string> paths;
    std::string lines;
    const std::string start = fmt::format("complete -c {} -n \"{}", name, fishFunction(program));
    for (const CommandDescription* command : listCommands(program)) {
        if (command->words.size() > 1) paths.push_back(commandPath(*command, "/"));
        lines += fishCommand(*command, start);
    }
    std::string text = fmt::format(
        R"fish(# Completion of {0} for fish, written by "noonmark-cli describe" from the command line's own description.

# Whether the words before the cursor lead to that command: "project/new", or "" for the program.
function {1}
    set -l path
    for word in (commandline -opc)[2..-1]
        set -l longer (string join / -- $path $word)
        if contains -- $longer {2}
            set path $longer
        end
    end
    test "$path" = "$argv[1]"
end

complete -c {0} -f
)fish",
        name, fishFunction(program), joinWords(paths, " "));
    return {name + ".fish", text + lines};
}

}  // namespace noonmark::cli
