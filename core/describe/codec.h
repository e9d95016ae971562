#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/describe/choice.h"

namespace noonmark {

/// Numbers by name, such as the options of an engine.
using NamedNumbers = std::map<std::string, double, std::less<>>;

/// What a field holds, for interfaces that do not know the type of its member. std::monostate: not set.
using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<double>,
                           std::vector<std::string>, NamedNumbers>;

/// Both ends are included.
struct ValueRange {
    double min = 0;
    double max = 0;
    /// False for not-a-number.
    [[nodiscard]] bool holds(double number) const { return number >= min && number <= max; }
};

/// The alternatives of Value as interfaces treat them. A choice is the key of one of the field's choices, as
/// text.
enum class ValueKind { yesNo, whole, number, text, choice, numbers, texts, namedNumbers };

/// How a member of type M is converted to and from a Value.
template <class M>
struct Codec {
    ValueKind kind = ValueKind::text;
    std::function<Value(const M&)> toValue;
    std::function<Result<M>(const Value&)> fromValue;  ///< an error without text: of another kind
};

namespace fields {

/// The codec of types that are an alternative of Value themselves.
template <class M>
Codec<M> plainCodec(ValueKind kind) {
    return {kind, [](const M& value) { return Value(value); },
            [](const Value& value) -> Result<M> {
                if (const auto* held = std::get_if<M>(&value)) return *held;
                return failure({});
            }};
}

template <class M>
constexpr ValueKind kindOf() {
    if constexpr (std::is_same_v<M, std::vector<double>>) return ValueKind::numbers;
    if constexpr (std::is_same_v<M, std::vector<std::string>>) return ValueKind::texts;
    if constexpr (std::is_same_v<M, NamedNumbers>) return ValueKind::namedNumbers;
    return ValueKind::text;
}

/// The number that people mean by this float: 0.001, not 0.0010000000474974513.
double writtenAs(float number);

}  // namespace fields

/// The codec of numbers, texts, yes or no, lists and named numbers.
template <class M>
Codec<M> codecOf() {
    if constexpr (std::is_same_v<M, bool>) {
        return fields::plainCodec<M>(ValueKind::yesNo);
    } else if constexpr (std::is_integral_v<M>) {
        return {ValueKind::whole, [](M value) { return Value(std::int64_t(value)); },
                [](const Value& value) -> Result<M> {
                    const auto* held = std::get_if<std::int64_t>(&value);
                    if (!held || !std::in_range<M>(*held)) return failure({});
                    return M(*held);
                }};
    } else if constexpr (std::is_same_v<M, double>) {
        return {ValueKind::number, [](double value) { return Value(value); },
                [](const Value& value) -> Result<double> {
                    if (const auto* whole = std::get_if<std::int64_t>(&value)) return double(*whole);
                    if (const auto* held = std::get_if<double>(&value)) return *held;
                    return failure({});
                }};
    } else if constexpr (std::is_same_v<M, float>) {
        return {ValueKind::number, [](float value) { return Value(fields::writtenAs(value)); },
                [](const Value& value) -> Result<float> {
                    return codecOf<double>().fromValue(value).map([](double held) { return float(held); });
                }};
    } else if constexpr (std::is_same_v<M, std::filesystem::path>) {
        return {ValueKind::text, [](const M& value) { return Value(value.string()); },
                [](const Value& value) -> Result<M> {
                    if (const auto* held = std::get_if<std::string>(&value)) return M(*held);
                    return failure({});
                }};
    } else {
        return fields::plainCodec<M>(fields::kindOf<M>());
    }
}

/// The codec of a type that is written as text.
template <class M>
Codec<M> textCodec(std::function<std::string(const M&)> format, Result<M> (*parse)(std::string_view)) {
    return {ValueKind::text, [format](const M& held) { return Value(format(held)); },
            [parse](const Value& value) -> Result<M> {
                if (const auto* text = std::get_if<std::string>(&value)) return parse(*text);
                return failure({});
            }};
}

/// The codec of an enumeration. The choices outlive the codec.
template <class E>
Codec<E> choiceCodec(std::span<const Choice<E>> choices) {
    return {ValueKind::choice, [choices](E held) { return Value(std::string(keyOf(choices, held))); },
            [choices](const Value& value) -> Result<E> {
                const auto* key = std::get_if<std::string>(&value);
                const auto found = key ? findChoice(choices, *key) : std::nullopt;
                if (!found) return failure({});
                return *found;
            }};
}

/// The codec of a member that may be unset; an empty text unsets it, too.
template <class M>
Codec<std::optional<M>> orUnset(const Codec<M>& codec) {
    return {codec.kind,
            [codec](const std::optional<M>& held) { return held ? codec.toValue(*held) : Value(); },
            [codec](const Value& value) -> Result<std::optional<M>> {
                if (value == Value() || value == Value(std::string())) return std::optional<M>();
                auto read = codec.fromValue(value);
                if (!read) return tl::make_unexpected(read.error());
                return std::optional<M>(*std::move(read));
            }};
}

}  // namespace noonmark
