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
