#include "core/describe/field_checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/describe/value_text.h"

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

}  // namespace noonmark
