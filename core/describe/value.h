#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace noonmark {

/// Numbers by name, such as the options of an engine.
using NamedNumbers = std::map<std::string, double, std::less<>>;

/// What a field holds, for surfaces that do not know the type of its member. std::monostate: not set.
using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<double>,
                           std::vector<std::string>, NamedNumbers>;

/// Both ends are included.
struct ValueRange {
    double min = 0;
    double max = 0;
    /// False for not-a-number.
    [[nodiscard]] bool holds(double number) const { return number >= min && number <= max; }
};

/// The alternatives of Value as surfaces treat them. A choice is the key of one of the field's choices, as
/// text.
enum class ValueKind { yesNo, whole, number, text, choice, numbers, texts, namedNumbers };

}  // namespace noonmark
