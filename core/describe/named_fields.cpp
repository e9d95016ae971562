#include "core/describe/named_fields.h"

#include <cmath>

namespace noonmark {

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
        if (!number) return unfitValue(facts);
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

}  // namespace noonmark
