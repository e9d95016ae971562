#include "core/receivers/made_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>

namespace noonmark {

namespace {

// The arguments with which fillIn() makes `name` of the pattern, found from its end. None: it makes no such
// name.
std::optional<Sentence> match(std::string_view pattern, std::string_view name) {
    Sentence found{pattern, {}};
    const auto addFirst = [&found](std::string_view argument) {
        found.arguments.insert(found.arguments.begin(), std::string(argument));
        return !argument.empty();
    };
    auto mark = pattern.rfind('%');
    const std::string_view end = pattern.substr(mark + 2);  // behind "%1"
    if (!name.ends_with(end)) return std::nullopt;
    name.remove_suffix(end.size());
    for (pattern = pattern.substr(0, mark); !pattern.empty(); pattern = pattern.substr(0, mark)) {
        mark = pattern.rfind('%');
        const std::string_view between = pattern.substr(mark + 2);
        const auto at = name.rfind(between);
        if (at == name.npos || !addFirst(name.substr(at + between.size()))) return std::nullopt;
        name = name.substr(0, at);
    }
    return addFirst(name) ? std::optional(found) : std::nullopt;
}

bool hasDigitsOnly(std::string_view text) {
    return std::ranges::all_of(text, [](unsigned char letter) { return std::isdigit(letter) != 0; });
}

// The same of a pattern that ends with its only argument.
std::optional<Sentence> matchBeginning(std::string_view pattern, std::string_view name) {
    const std::string_view before = pattern.substr(0, pattern.rfind('%'));
    if (!name.starts_with(before) || name.size() == before.size()) return std::nullopt;
    return Sentence{pattern, {std::string(name.substr(before.size()))}};
}

bool countsSources(const Sentence& sentence) {
    return hasDigitsOnly(std::get<std::string>(sentence.arguments[1]));
}

}  // namespace

std::string numberName(std::string_view name, std::size_t number) {
    return number == 1 ? std::string(name) : fmt::format("{} ({})", name, number);
}

std::optional<NumberedName> splitNumber(std::string_view name) {
    const auto open = name.rfind(" (");
    if (open == name.npos || open == 0 || !name.ends_with(')')) return std::nullopt;
    const std::string_view number = name.substr(open), digits = number.substr(2, number.size() - 3);
    if (digits.empty() || !hasDigitsOnly(digits)) return std::nullopt;
    return NumberedName{name.substr(0, open), number};
}

std::optional<Sentence> findMadeName(std::string_view name) {
    for (const std::string_view whole :
         {madeNames::wholeCity, madeNames::cityMiddle, madeNames::aroundBuilding})
        if (name == whole) return Sentence{whole, {}};
    for (const std::string_view pattern : {madeNames::carriageway, madeNames::sidewalks})
        if (auto found = match(pattern, name)) return found;
    if (auto found = matchBeginning(madeNames::around, name)) return found;
    for (const std::string_view pattern : madeNames::winds)
        if (auto found = match(pattern, name)) return found;
    for (const std::string_view pattern : {madeNames::at, madeNames::between})
        if (auto found = match(pattern, name)) return found;
    auto several = match(madeNames::severalSources, name);
    return several && countsSources(*several) ? several : std::nullopt;
}

}  // namespace noonmark
