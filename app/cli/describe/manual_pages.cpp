#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "app/cli/describe/describe.h"

namespace noonmark::cli {

namespace {

constexpr std::size_t roffColumns = 78;  // the manual's source has no longer lines

// Text of which each character is printed as it is; every hyphen is one that can be copied into a shell.
std::string roffLiteral(std::string_view text) {
    std::string roff;
    for (const char c : text) {
        if (c == '\\')
            roff += "\\e";
        else if (c == '-')
            roff += "\\-";
        else if (c == '\'')
            roff += "\\(aq";
        else
            roff += c;
    }
    return !roff.empty() && roff[0] == '.' ? "\\&" + roff : roff;
}

// A word of a sentence: hyphens between letters stay hyphens.
std::string roffWord(const std::string& word) {
    const bool isOption = word.starts_with('-') || word.starts_with("(-") || word.starts_with("`-");
    std::string roff;
    for (const char c : word) roff += c == '\\' ? "\\e" : c == '-' && isOption ? "\\-" : std::string(1, c);
    return roff.starts_with('.') || roff.starts_with('\'') ? "\\&" + roff : roff;
}

bool endsSentence(const std::string& word) { return word.size() > 1 && word.ends_with('.'); }

// Sentences, each on lines of its own and broken between words, as the manual's macros want them.
std::string roffSentences(const std::string& text) {
    std::string roff;
    std::size_t column = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
        const std::string plain = text.substr(begin, end - begin);
        begin = end + 1;
        if (plain.empty()) continue;
        const std::string word = roffWord(plain);
        if (column > 0) roff += column + 1 + word.size() > roffColumns ? '\n' : ' ';
        column = roff.empty() || roff.back() == '\n' ? word.size() : column + 1 + word.size();
        roff += word;
        if (endsSentence(plain)) {
            roff += '\n';
            column = 0;
        }
    }
    if (!roff.ends_with('\n')) roff += '\n';
    return roff;
}

bool mentions(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

std::string joined(const std::vector<std::string>& words) { return joinWords(words, ", "); }

// What the sentence of an option leaves unsaid.
std::string remarksOn(const OptionDescription& option) {
    const ValueDescription& value = option.value;
    const auto isMentioned = [&](const std::string& word) { return mentions(option.text, word); };
    std::string remarks;
    if (!value.choices.empty() && !std::ranges::all_of(value.choices, isMentioned))
        remarks += fmt::format(" Values: {}.", joined(value.choices));
    if (!value.limits.empty() && !isMentioned(value.limits))
        remarks += fmt::format(" Range: {}.", value.limits);
    if (!option.defaultValue.empty() && !isMentioned("default"))
        remarks += fmt::format(" Default: {}.", option.defaultValue);
    if (option.required) remarks += " Required.";
    if (option.repeats && !isMentioned("repeated")) remarks += " Several may be given.";
    if (!option.needs.empty()) remarks += fmt::format(" Only with {}.", joined(option.needs));
    if (!option.excludes.empty()) remarks += fmt::format(" Not with {}.", joined(option.excludes));
    return remarks;
}

std::string optionHead(const OptionDescription& option, bool positional) {
    std::string head;
    for (const std::string& name : option.names)
        head +=
            fmt::format("{}\\f{}{}\\fR", head.empty() ? "" : ", ", positional ? 'I' : 'B', roffLiteral(name));
    if (!option.value.name.empty()) head += fmt::format(" \\fI{}\\fR", roffLiteral(option.value.name));
    return head;
}

std::string optionEntry(const OptionDescription& option, bool positional) {
    const std::string text = option.text + (option.text.ends_with('.') ? "" : ".") + remarksOn(option);
    return ".TP\n" + optionHead(option, positional) + '\n' + roffSentences(text);
}

std::string synopsisOf(const CommandDescription& command) {
    std::string line = fmt::format("\\fB{}\\fR", roffLiteral(joinWords(command.words, " ")));
    if (!command.options.empty()) line += " [\\fIOPTION\\fR ...]";
    for (const OptionDescription& positional : command.positionals)
        line +=
            fmt::format(" {}\\fI{}\\fR{}{}", positional.required ? "" : "[", roffLiteral(positional.names[0]),
                        positional.repeats ? " ..." : "", positional.required ? "" : "]");
    if (!command.commands.empty()) line += " \\fICOMMAND\\fR";
    return line + '\n';
}

std::string literalLines(const std::string& text) {
    std::string roff = ".nf\n";
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = roffLiteral(std::string_view(text).substr(begin, end - begin));
        roff += line.empty() ? ".sp\n" : line + '\n';
        begin = end + 1;
    }
    return roff + ".fi\n";
}

std::string optionsOf(const CommandDescription& command) {
    std::string roff;
    for (const OptionDescription& positional : command.positionals) roff += optionEntry(positional, true);
    for (const OptionDescription& option : command.options) roff += optionEntry(option, false);
    return roff;
}

// The options of a command within another command's page, and those of the commands below it.
std::string nestedCommand(const CommandDescription& command) {
    std::string roff = fmt::format(".SS \"{}\"\n", roffLiteral(commandPath(command, " ")));
    roff += roffSentences(command.text + ".") + ".PP\n" + synopsisOf(command) + optionsOf(command);
    if (!command.examples.empty()) roff += ".PP\n" + literalLines(command.examples);
    for (const CommandDescription& sub : command.commands) roff += nestedCommand(sub);
    return roff;
}

std::string commandList(const CommandDescription& program) {
    std::string roff = ".SH COMMANDS\n";
    for (const CommandDescription& command : program.commands)
        roff += fmt::format(".TP\n\\fB{}\\fR(1)\n{}", roffLiteral(joinWords(command.words, "-")),
                            roffSentences(command.text + "."));
    return roff;
}

std::string sectionText(const ManualSection& section) {
    std::string roff = fmt::format(".SH \"{}\"\n", section.title);
    for (const std::string& line : section.lines)
        roff += line.starts_with('\t') ? roffSentences(line.substr(1))
                                       : fmt::format(".TP\n\\fB{}\\fR\n", roffLiteral(line));
    return roff;
}

std::string seeAlso(const std::vector<std::string>& pages) {
    std::string roff = ".SH \"SEE ALSO\"\n";
    for (const std::string& page : pages)
        roff += fmt::format(".BR {} (1){}\n", roffLiteral(page), page == pages.back() ? "" : ",");
    return roff;
}

std::string upperCase(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::toupper(c)); });
    return text;
}

std::string pageHead(const CommandDescription& command, const std::string& page, const ManualFacts& facts) {
    std::string roff = fmt::format(
        ".\\\" Written by noonmark\\-cli describe from the command line's own description.\n"
        ".TH {} 1 {} \"Noonmark {}\" \"Noonmark manual\"\n.SH NAME\n{} \\-\n",
        upperCase(page), facts.date, facts.version, roffLiteral(page));
    std::string text = command.text;
    if (text.ends_with('.')) text.pop_back();
    roff += roffSentences(text) + ".SH SYNOPSIS\n" + synopsisOf(command);
    return roff;
}

DescriptionFile commandPage(const CommandDescription& command, const ManualFacts& facts) {
    const std::string page = joinWords(command.words, "-");
    std::string roff = pageHead(command, page, facts);
    roff += ".SH DESCRIPTION\n" + roffSentences(command.text + ".") + ".SH OPTIONS\n" + optionsOf(command);
    if (!command.commands.empty()) roff += ".SH COMMANDS\n";
    for (const CommandDescription& sub : command.commands) roff += nestedCommand(sub);
    if (!command.examples.empty()) roff += ".SH EXAMPLES\n" + literalLines(command.examples);
    return {page + ".1", roff + seeAlso({command.words.front()})};
}

DescriptionFile programPage(const CommandDescription& program, const ManualFacts& facts) {
    const std::string& page = program.words.front();
    std::string roff = pageHead(program, page, facts) + ".SH DESCRIPTION\n" + roffSentences(program.text);
    roff += ".SH OPTIONS\n" + optionsOf(program);
    if (!program.commands.empty()) roff += commandList(program);
    if (!program.examples.empty()) roff += ".SH EXAMPLES\n" + literalLines(program.examples);
    for (const ManualSection& section : facts.sections) roff += sectionText(section);
    std::vector<std::string> others = facts.seeAlso;
    for (const CommandDescription& command : program.commands)
        others.push_back(joinWords(command.words, "-"));
    return {page + ".1", others.empty() ? roff : roff + seeAlso(others)};
}

}  // namespace

std::vector<DescriptionFile> writeManualPages(const CommandDescription& program, const ManualFacts& facts) {
    std::vector<DescriptionFile> pages{programPage(program, facts)};
    for (const CommandDescription& command : program.commands) pages.push_back(commandPage(command, facts));
    return pages;
}

}  // namespace noonmark::cli
