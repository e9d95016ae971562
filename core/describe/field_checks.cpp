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

tl::unexpected<Error> outOfRange(const Field& field, double number) {
    const std::string unit = field.unit.empty() ? std::string() : fmt::format(" {}", field.unit);
    const double times = field.shownTimes;
    return failure(
        fmt::format("{}: {:g}{} is out of range", field.label, number * times, unit),
        std::string(nameOf(field)),
        fmt::format("Give {:g} to {:g}{}", field.range->min * times, field.range->max * times, unit));
}

bool isStated(const Described& settings, const Field& field, bool extras) {
    const bool matters = field.role == SettingRole::question || (extras && field.role == SettingRole::extra);
    return matters && settings.applies(field);
}

}  // namespace

Result<void> checkRanges(const Described& settings) {
    for (const Field& field : settings.fields) {
        if (!field.range) continue;
        for (const double number : numbersIn(settings.get(field)))
            if (!field.range->holds(number)) return outOfRange(field, number);
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
