#include <fmt/format.h>

#include <algorithm>

#include "app/cli/describe/describe.h"

namespace noonmark::cli {

namespace {

std::string bashFunction(const CommandDescription& program) {
    std::string name = "_" + program.words.front();
    std::ranges::replace(name, '-', '_');
    return name;
}

// The list of words between single quotes; no name of a command, option or choice contains a quote or a
// space.
std::string bashWords(const std::vector<std::string>& words) { return "'" + joinWords(words, " ") + "'"; }

// The patterns of a case: every command below the program by its path, "/project/new".
std::string bashPaths(const CommandDescription& program) {
    std::string paths;
    for (const CommandDescription* command : listCommands(program))
        if (command->words.size() > 1)
            paths +=
                fmt::format("{}/{}", paths.empty() ? "" : " | \\\n            ", commandPath(*command, "/"));
    return paths;
}

std::string bashValue(const ValueDescription& value) {
    std::string calls;
    if (!value.choices.empty()) calls += fmt::format("add_words {}; ", bashWords(value.choices));
    if (value.takesFiles) calls += "add_files; ";
    if (value.takesFolders) calls += "add_folders; ";
    return calls + "return";
}

std::string bashOptionCases(const CommandDescription& command) {
    std::string cases;
    for (const OptionDescription& option : command.options) {
        if (option.value.name.empty()) continue;
        std::string patterns;
        for (const std::string& name : option.names)
            patterns +=
                fmt::format("{}'/{} {}'", patterns.empty() ? "" : " | ", commandPath(command, "/"), name);
        cases += fmt::format("        {}) {} ;;\n", patterns, bashValue(option.value));
    }
    return cases;
}

std::string bashWordCase(const CommandDescription& command) {
    std::vector<std::string> options;
    for (const OptionDescription& option : command.options)
        options.insert(options.end(), option.names.begin(), option.names.end());
    std::vector<std::string> words;
    for (const CommandDescription& sub : command.commands) words.push_back(sub.words.back());
    bool files = false;
    for (const OptionDescription& positional : command.positionals) {
        words.insert(words.end(), positional.value.choices.begin(), positional.value.choices.end());
        files = files || positional.value.takesFiles;
    }
    return fmt::format("        '/{}') options={} words={}{} ;;\n", commandPath(command, "/"),
                       bashWords(options), bashWords(words), files ? " files=yes" : "");
}

}  // namespace

DescriptionFile writeBashCompletion(const CommandDescription& program) {
    const std::string& name = program.words.front();
    std::string optionCases;
    std::string wordCases;
    for (const CommandDescription* command : listCommands(program)) {
        optionCases += bashOptionCases(*command);
        wordCases += bashWordCase(*command);
    }
    const std::string paths = bashPaths(program);
    const std::string walk = paths.empty()
                                 ? ""
                                 : fmt::format(
                                       "    for word in \"${{COMP_WORDS[@]:1:COMP_CWORD - 1}}\"; do\n"
                                       "        case \"${{path%/}}/$word\" in\n            {})\n"
                                       "            path=\"${{path%/}}/$word\" ;;\n        esac\n    done\n",
                                       paths);
    // "--cell=2" reaches the function as three words, because bash splits them at the equals sign.
    std::string text = fmt::format(
        R"bash(# Completion of {0} for bash, written by "noonmark-cli describe" from the command line's own description.

{1}() {{
    local current="${{COMP_WORDS[COMP_CWORD]}}" previous="${{COMP_WORDS[COMP_CWORD - 1]}}"
    local path=/ options='' words='' files='' word
    if [[ $current == '=' ]]; then
        current=''
    elif [[ $previous == '=' && $COMP_CWORD -gt 1 ]]; then
        previous="${{COMP_WORDS[COMP_CWORD - 2]}}"
    fi
{2}    add_words() {{ mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen -W "$1" -- "$current"); }}
    add_files() {{ compopt -o filenames 2>/dev/null; mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen -f -- "$current"); }}
    add_folders() {{ compopt -o filenames 2>/dev/null; mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen -d -- "$current"); }}
    COMPREPLY=()
    case "$path $previous" in
{3}    esac
    case "$path" in
{4}    esac
    if [[ $current == -* ]]; then
        add_words "$options"
        return
    fi
    add_words "$words"
    if [[ -n $files ]]; then add_files; fi
}}

complete -F {1} {0}
)bash",
        name, bashFunction(program), walk, optionCases, wordCases);
    return {name, std::move(text)};
}

}  // namespace noonmark::cli
