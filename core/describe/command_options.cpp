#include "core/describe/command_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/describe/field_values.h"

namespace noonmark {

namespace {

std::vector<CommandOption> optionsOf(const Field& field, const Value& value, const FlagNames& names) {
    const auto other = names.find(field.flag);
    const std::string flag = other == names.end() ? std::string(field.flag) : other->second;
    std::vector<CommandOption> options;
    if (const auto* texts = std::get_if<std::vector<std::string>>(&value)) {
        for (const std::string& text : *texts) options.push_back({flag, {text}});
    } else if (const auto* numbers = std::get_if<NamedNumbers>(&value)) {
        for (const auto& [name, number] : *numbers)
            options.push_back({flag, {fmt::format("{}={}", name, number)}});
    } else if (field.kind == ValueKind::yesNo) {
        options.push_back({flag, {}});
    } else {
        options.push_back({flag, {formatShown(field, value)}});
    }
    return options;
}

}  // namespace

std::vector<CommandOption> listOptions(const Described& settings, const FlagNames& names) {
    std::vector<CommandOption> options;
    for (const Field& field : settings.fields) {
        if (field.flag.empty() || !settings.applies(field)) continue;
        const Value value = settings.get(field);
        if (value == Value() || (value == field.standard && !field.restated)) continue;
        for (CommandOption& option : optionsOf(field, value, names)) options.push_back(std::move(option));
    }
    return options;
}

std::string_view flagOf(std::span<const Field> fields, std::string_view key) {
    const auto field = std::ranges::find(fields, key, &Field::key);
    return field == fields.end() ? key : field->flag;
}

bool hasFlag(std::span<const Field> fields, std::string_view flag) {
    return std::ranges::any_of(fields, [&](const Field& field) { return field.flag == flag; });
}

}  // namespace noonmark
