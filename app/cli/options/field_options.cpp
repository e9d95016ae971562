#include "app/cli/options/field_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "app/cli/options/shared_options.h"
#include "core/describe/field_values.h"

namespace noonmark::cli {

namespace {

/// Adds the options of one table.
class FieldAdder {
public:
    FieldAdder(CLI::App& command, const Editable& settings, const FieldOptions& options)
        : command_(command), settings_(settings), options_(options) {}

    void add() {
        for (const Field& field : settings_.fields)
            if (!field.flag.empty()) added_.emplace(field.flag, addOption(field));
        for (const Field& field : settings_.fields) join(field);
    }

private:
    CLI::Option* addOption(const Field& field) {
        if (field.kind == ValueKind::yesNo) return addYes(field);
        CLI::Option* option = isList(field) ? addList(field) : addSingle(field);
        if (field.range)
            option->check(within(field.range->min * field.shownTimes, field.range->max * field.shownTimes));
        if (!field.choices.empty()) option->transform(CLI::IsMember(keysOf(field), CLI::ignore_case));
        if (showsDefault(field)) option->default_str(formatShown(field, field.standard));
        return option->type_name(hintOf(field));
    }

    CLI::Option* addYes(const Field& field) {
        const bool value = !field.flag.starts_with("--no-");
        return command_.add_flag_callback(
            nameOn(field), [take = taker(field), value] { take(value); }, std::string(field.help));
    }

    CLI::Option* addSingle(const Field& field) {
        return command_.add_option_function<std::string>(
            nameOn(field),
            [take = taker(field), &field](const std::string& text) { take(valueOf(field, text)); },
            std::string(field.help));
    }

    CLI::Option* addList(const Field& field) {
        CLI::Option* option = command_.add_option_function<std::vector<std::string>>(
            nameOn(field),
            [take = taker(field), &field](const std::vector<std::string>& pieces) {
                take(field.kind == ValueKind::texts ? Value(pieces)
                                                    : valueOf(field, fmt::to_string(fmt::join(pieces, ","))));
            },
            std::string(field.help));
        if (field.kind == ValueKind::numbers) option->delimiter(',');
        return option->allow_extra_args(options_.listsTakeBlanks && field.kind == ValueKind::numbers);
    }

    // What an option does with its value. Copies what it needs: the adder is gone when a command is parsed.
    [[nodiscard]] std::function<void(const Value&)> taker(const Field& field) const {
        return [settings = settings_, given = options_.given, &field](const Value& value) {
            if (auto set = settings.set(field, value); !set) throw refused(field, set.error());
            if (given) given->emplace(field.flag);
        };
    }

    static Value valueOf(const Field& field, const std::string& text) {
        auto value = parseValue(field, text);
        if (!value) throw refused(field, value.error());
        return *std::move(value);
    }

    static CLI::ValidationError refused(const Field& field, const Error& error) {
        const std::string advice = error.advice.empty() ? std::string() : ". " + error.advice;
        return CLI::ValidationError(std::string(field.flag), error.what + advice);
    }

    void join(const Field& field) const {
        const auto own = added_.find(field.flag);
        if (own == added_.end()) return;
        for (const std::string_view flag : field.excludes)
            if (const auto other = added_.find(flag); other != added_.end())
                own->second->excludes(other->second);
        if (const auto needed = added_.find(field.needs); needed != added_.end())
            own->second->needs(needed->second);
    }

    [[nodiscard]] std::string nameOn(const Field& field) const {
        const auto other = options_.names.find(field.flag);
        return other == options_.names.end() ? std::string(field.flag) : other->second;
    }

    static bool isList(const Field& field) {
        return field.kind == ValueKind::texts || field.kind == ValueKind::numbers ||
               field.kind == ValueKind::namedNumbers;
    }

    static std::vector<std::string> keysOf(const Field& field) {
        std::vector<std::string> keys;
        for (const KeyedLabel& choice : field.choices) keys.emplace_back(choice.key);
        return keys;
    }

    // A help that tells the default in its own words needs no second one.
    static bool showsDefault(const Field& field) {
        return field.hasDefault && !formatText(field.standard).empty() &&
               field.help.find("default") == std::string_view::npos;
    }

    static std::string hintOf(const Field& field) {
        std::string hint(field.hint.empty() ? field.unit : field.hint);
        if (field.hint.empty())
            std::ranges::transform(hint, hint.begin(), [](unsigned char c) { return char(std::toupper(c)); });
        return hint;
    }

    CLI::App& command_;
    Editable settings_;
    const FieldOptions& options_;
    std::map<std::string_view, CLI::Option*> added_;
};

}  // namespace

void addFieldOptions(CLI::App& command, const Editable& settings, const FieldOptions& options) {
    FieldAdder(command, settings, options).add();
}

}  // namespace noonmark::cli
