#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace noonmark {

/// One of the values that an enumeration has.
template <class E>
struct Choice {
    E value;
    std::string_view key;
    std::string_view label = {};  ///< NM_TEXT
};

// Clang before 17 deduces no arguments of aggregates.
template <class E, class... Texts>
Choice(E, Texts...) -> Choice<E>;

/// Empty for a value without a choice.
template <class E>
std::string_view keyOf(std::span<const Choice<E>> choices, E value) {
    for (const Choice<E>& choice : choices)
        if (choice.value == value) return choice.key;
    return {};
}

template <class E>
std::optional<E> findChoice(std::span<const Choice<E>> choices, std::string_view key) {
    for (const Choice<E>& choice : choices)
        if (choice.key == key) return choice.value;
    return std::nullopt;
}

}  // namespace noonmark
