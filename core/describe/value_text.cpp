#include "core/describe/value_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

namespace noonmark {

namespace {

template <class Number>
std::optional<Number> numberIn(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::vector<std::string> splitAtCommas(const std::string& text) {
    std::vector<std::string> pieces;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        pieces.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return pieces;
}

std::optional<Value> numbersIn(const std::string& text) {
    std::vector<double> numbers;
    for (const std::string& piece : splitAtCommas(text)) {
        const auto number = numberIn<double>(
            std::string_view(piece).substr(std::min(piece.find_first_not_of(' '), piece.size())));
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

std::optional<double> numberOrYes(std::string_view text) {
    if (text == "yes") return 1;
    if (text == "no") return 0;
    return numberIn<double>(text);
}

std::optional<Value> namedNumbersIn(const std::string& text) {
    NamedNumbers numbers;
    for (const std::string& piece : splitAtCommas(text)) {
        const auto equals = piece.find('=');
        if (equals == 0 || equals == std::string::npos) return std::nullopt;
        const auto number = numberOrYes(std::string_view(piece).substr(equals + 1));
        if (!number) return std::nullopt;
        numbers[piece.substr(0, equals)] = *number;
    }
    return numbers;
}

std::optional<Value> choiceIn(const Field& field, const std::string& text) {
    if (std::ranges::find(field.choices, text, &KeyedLabel::key) == field.choices.end()) return std::nullopt;
    return text;
}

template <class T>
std::optional<Value> asValue(const std::optional<T>& read) {
    return read ? std::optional<Value>(*read) : std::nullopt;
}

std::optional<Value> valueIn(const Field& field, const std::string& text) {
    switch (field.kind) {
        case ValueKind::yesNo:
            return text == "yes"  ? std::optional<Value>(true)
                   : text == "no" ? std::optional<Value>(false)
                                  : std::nullopt;
        case ValueKind::whole:
            return asValue(numberIn<std::int64_t>(text));
        case ValueKind::number:
            return asValue(numberIn<double>(text));
        case ValueKind::text:
            return text;
        case ValueKind::choice:
            return choiceIn(field, text);
        case ValueKind::numbers:
            return numbersIn(text);
        case ValueKind::texts:
            return splitAtCommas(text);
        case ValueKind::namedNumbers:
            return namedNumbersIn(text);
    }
    return std::nullopt;
}

struct ToText {
    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(bool yes) const { return yes ? "yes" : "no"; }
    std::string operator()(std::int64_t number) const { return fmt::to_string(number); }
    std::string operator()(double number) const { return fmt::to_string(number); }
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(const std::vector<double>& numbers) const {
        return fmt::to_string(fmt::join(numbers, ","));
    }
    std::string operator()(const std::vector<std::string>& texts) const {
        return fmt::to_string(fmt::join(texts, ","));
    }
    std::string operator()(const NamedNumbers& numbers) const {
        std::vector<std::string> pieces;
        for (const auto& [name, number] : numbers) pieces.push_back(fmt::format("{}={}", name, number));
        return fmt::to_string(fmt::join(pieces, ","));
    }
};

}  // namespace

std::string formatText(const Value& value) { return std::visit(ToText(), value); }

std::string formatShown(const Field& field, const Value& value) {
    const auto* number = std::get_if<double>(&value);
    return number != nullptr ? fmt::to_string(*number * field.shownTimes) : formatText(value);
}

Result<Value> parseValue(const Field& field, const std::string& text) {
    if (auto value = valueIn(field, text)) {
        if (auto* number = std::get_if<double>(&*value)) *number /= field.shownTimes;
        return *std::move(value);
    }
    return unfitValue(field);
}

}  // namespace noonmark
