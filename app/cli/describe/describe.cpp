#include "app/cli/describe/describe.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace noonmark::cli {

namespace {

std::vector<std::string> splitAt(std::string_view text, std::string_view separators) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
        if (end > begin) parts.emplace_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

bool isWord(const std::string& text) {
    return std::ranges::all_of(text, [](unsigned char c) { return std::islower(c) || c == '-'; });
}

// The parser appends what its validators say to the name of a value: "UNIT:{m,ft}", "M:2 to 6",
// "N:INT in [1 - 3660]". Returns where that begins: names have colons too ("HH:MM").
std::size_t endOfName(std::string_view type) {
    for (std::size_t at = type.find(':'); at != std::string_view::npos; at = type.find(':', at + 1)) {
        const std::string_view rest = type.substr(at + 1);
        const bool limits =
            !rest.empty() && (rest[0] == '-' || std::isdigit(static_cast<unsigned char>(rest[0])));
        if (limits || rest.starts_with('{') || rest.starts_with("INT in ") || rest.starts_with("FLOAT in ") ||
            rest.starts_with("UINT in "))
            return at;
    }
    return type.size();
}

// "INT in [1 - 3660]" -> "1 to 3660"
std::string plainLimits(std::string_view limits) {
    const auto open = limits.find('[');
    if (open == std::string_view::npos) return std::string(limits);
    std::string plain(limits.substr(open + 1, limits.size() - open - 2));
    if (const auto dash = plain.find(" - "); dash != std::string::npos) plain.replace(dash, 3, " to ");
    return plain;
}

// Lower-case alternatives of a name are words to type: "W,S,E,N|FILE|city", "dxf,gpkg".
std::vector<std::string> alternativesOf(const std::string& name) {
    std::vector<std::string> words = splitAt(name, "|,");
    if (!std::ranges::all_of(words, isWord)) words = splitAt(name, "|");
    std::erase_if(words, [](const std::string& word) { return !isWord(word); });
    return words;
}

ValueDescription describeValue(const CLI::Option& option, const KnownWords& known) {
    if (option.get_items_expected_max() == 0) return {};
    const std::string type = option.get_type_name();
    const std::size_t end = endOfName(type);
    ValueDescription value{type.substr(0, end), {}, {}, false, false};
    const std::string rest = end < type.size() ? type.substr(end + 1) : std::string();
    if (rest.starts_with('{'))
        value.choices = splitAt(std::string_view(rest).substr(1, rest.find('}') - 1), ",");
    else
        value.limits = plainLimits(rest);
    if (value.choices.empty()) value.choices = alternativesOf(value.name);
    if (const auto words = known.find(value.name); words != known.end()) value.choices = words->second;
    value.takesFiles = value.name.find("FILE") != std::string::npos || value.name.ends_with(".gpkg");
    value.takesFolders = value.name == "DIR";
    return value;
}

std::vector<std::string> namesOf(const std::set<CLI::Option*>& options) {
    std::vector<std::string> names;
    for (const CLI::Option* option : options)
        names.push_back(option->get_lnames().empty() ? option->get_single_name()
                                                     : "--" + option->get_lnames().front());
    std::ranges::sort(names);
    return names;
}

OptionDescription describeOption(const CLI::Option& option, const KnownWords& known) {
    OptionDescription described;
    for (const std::string& name : option.get_snames()) described.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) described.names.push_back("--" + name);
    if (option.get_positional()) described.names = {option.get_name(true)};
    described.text = option.get_description();
    described.value = describeValue(option, known);
    if (!described.value.name.empty()) described.defaultValue = option.get_default_str();
    described.required = option.get_required();
    described.repeats = option.get_expected_max() > 1;
    described.needs = namesOf(option.get_needs());
    described.excludes = namesOf(option.get_excludes());
    return described;
}

// A group of options is a command without a name.
void addOptions(const CLI::App& app, const KnownWords& known, CommandDescription& command) {
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_group().empty()) continue;
        OptionDescription described = describeOption(*option, known);
        auto& list = option->get_positional() ? command.positionals : command.options;
        // Each group has a --help of its own.
        if (std::ranges::find(list, described.names, &OptionDescription::names) == list.end())
            list.push_back(std::move(described));
    }
    for (const CLI::App* group :
         app.get_subcommands([](const CLI::App* sub) { return sub->get_name().empty(); }))
        addOptions(*group, known, command);
}

CommandDescription describeCommand(const CLI::App& app, std::vector<std::string> words,
                                   const KnownWords& known) {
    words.push_back(app.get_name());
    CommandDescription command{words, app.get_description(), app.get_footer(), {}, {}, {}};
    addOptions(app, known, command);
    const auto isShown = [](const CLI::App* sub) {
        return !sub->get_name().empty() && !sub->get_group().empty();
    };
    for (const CLI::App* sub : app.get_subcommands(isShown))
        command.commands.push_back(describeCommand(*sub, words, known));
    return command;
}

void listBelow(const CommandDescription& command, std::vector<const CommandDescription*>& list) {
    list.push_back(&command);
    for (const CommandDescription& sub : command.commands) listBelow(sub, list);
}

}  // namespace

CommandDescription describeProgram(const CLI::App& program, const KnownWords& known) {
    return describeCommand(program, {}, known);
}

std::vector<const CommandDescription*> listCommands(const CommandDescription& program) {
    std::vector<const CommandDescription*> list;
    listBelow(program, list);
    return list;
}

std::string joinWords(const std::vector<std::string>& words, std::string_view between) {
    std::string joined;
    for (const std::string& word : words) joined += (joined.empty() ? "" : std::string(between)) + word;
    return joined;
}

std::string commandPath(const CommandDescription& command, std::string_view between) {
    return joinWords({command.words.begin() + 1, command.words.end()}, between);
}

}  // namespace noonmark::cli
