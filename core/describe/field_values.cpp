#include "core/describe/field_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <charconv>
#include <cmath>

namespace noonmark {

namespace {

std::vector<double> numbersIn(const Value& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return {double(*whole)};
    if (const auto* number = std::get_if<double>(&value)) return {*number};
    if (const auto* numbers = std::get_if<std::vector<double>>(&value)) return *numbers;
    return {};
}

std::string unitOf(const Field& field) {
    return field.unit.empty() ? std::string() : fmt::format(" {}", field.unit);
}

// Why the field cannot have this number; empty: it can. Numbers by name give fractions for whole numbers, and
// numbers for yes or no.
std::string faultOf(const Field& field, const Value& value, double number) {
    const bool isFraction = std::holds_alternative<double>(value);
    if (field.kind == ValueKind::yesNo) return "is neither yes nor no";
    if (field.range && !field.range->holds(number)) return "is out of range";
    return field.kind == ValueKind::whole && isFraction ? "is no whole number" : std::string();
}

tl::unexpected<Error> refused(const Field& field, double number, const std::string& fault) {
    const std::string range = rangeText(field);
    return failure(fmt::format("{}: {:g}{} {}", field.label, number * field.shownTimes, unitOf(field), fault),
                   std::string(nameOf(field)), range.empty() ? std::string() : fmt::format("Give {}", range));
}

bool isStated(const Described& settings, const Field& field, bool extras) {
    const bool matters = field.role == SettingRole::question || (extras && field.role == SettingRole::extra);
    return matters && settings.applies(field);
}

}  // namespace

const Field& fieldWithKey(std::span<const Field> rows, std::string_view key) {
    return *std::ranges::find(rows, key, &Field::key);
}

std::string rangeText(const Field& field) {
    if (field.kind == ValueKind::yesNo) return "yes or no";
    if (!field.range) return {};
    const double times = field.shownTimes;
    return fmt::format("{:g} to {:g}{}", field.range->min * times, field.range->max * times, unitOf(field));
}

Result<void> checkRanges(const Described& settings) {
    for (const Field& field : settings.fields) {
        const Value value = settings.get(field);
        for (const double number : numbersIn(value))
            if (const std::string fault = faultOf(field, value, number); !fault.empty())
                return refused(field, number, fault);
    }
    return {};
}

std::string questionText(const Described& settings, bool extras) {
    std::string text;
    for (const Field& field : settings.fields) {
        if (!isStated(settings, field, extras)) continue;
        // The length keeps a value that holds the separator apart from the next field.
        const std::string value = formatText(settings.get(field));
        text += fmt::format("{}{}{}={}:{};", field.group, field.group.empty() ? "" : ".", field.key,
                            value.size(), value);
    }
    return text;
}

namespace {

// A number that is none of the field's kind stays what it is: whoever takes it refuses it.
Value valueOf(ValueKind kind, double number) {
    if (kind == ValueKind::yesNo && (number == 0 || number == 1)) return number == 1;
    const bool isWhole = number == std::floor(number) && std::abs(number) < 1e15;  // false for NaN
    if (kind == ValueKind::whole && isWhole) return std::int64_t(number);
    return number;
}

struct ToNumber {
    std::optional<double> operator()(bool yes) const { return yes ? 1 : 0; }
    std::optional<double> operator()(std::int64_t whole) const { return double(whole); }
    std::optional<double> operator()(double number) const { return number; }
    std::optional<double> operator()(const auto&) const { return std::nullopt; }
};

}  // namespace

std::optional<double> asNumber(const Value& value) { return std::visit(ToNumber(), value); }

namespace {

Field heldByKey(Field row) {
    row.get = [key = row.key, kind = row.kind, standard = row.standard](const void* object) {
        const auto& numbers = *static_cast<const NamedNumbers*>(object);
        const auto held = numbers.find(key);
        return held == numbers.end() ? standard : valueOf(kind, held->second);
    };
    row.set = [facts = static_cast<const FieldFacts&>(row), standard = row.standard](
                  void* object, const Value& value) -> Result<void> {
        auto& numbers = *static_cast<NamedNumbers*>(object);
        const auto number = asNumber(value);
        if (!number) return refuseValue(facts);
        const std::string key(facts.key);
        if (value == standard)
            numbers.erase(key);
        else
            numbers[key] = *number;
        return {};
    };
    row.applies = {};
    return row;
}

}  // namespace

std::vector<Field> asNamedNumbers(std::span<const Field> fields) {
    std::vector<Field> rows;
    for (const Field& field : fields) rows.push_back(heldByKey(field));
    return rows;
}

Result<void> readNamedNumbers(const Editable& settings, const NamedNumbers& numbers) {
    for (const Field& field : settings.fields) {
        const auto held = numbers.find(field.key);
        if (held == numbers.end()) continue;
        if (auto set = settings.set(field, valueOf(field.kind, held->second)); !set) return set;
    }
    return {};
}

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
    return refuseValue(field);
}

}  // namespace noonmark
