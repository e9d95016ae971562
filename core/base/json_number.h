#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace noonmark {

/// Reads a whole number from untrusted JSON (nlohmann's, any kind). Json::get() accepts every number, also
/// one that `Integer` cannot hold: -1 becomes the largest unsigned value, and 1e300 an arbitrary one. Throws
/// std::out_of_range for a number that is not whole or that Integer cannot hold, and nlohmann's type_error
/// for a value that is not a number.
template <std::integral Integer, class Json>
Integer wholeNumberFrom(const Json& json) {
    constexpr double maxExact = 9007199254740992;  // 2^53; above it double cannot hold every whole number
    if (json.is_number_unsigned()) {
        if (const auto number = json.template get<std::uint64_t>(); std::in_range<Integer>(number))
            return Integer(number);
    } else if (json.is_number_integer()) {
        if (const auto number = json.template get<std::int64_t>(); std::in_range<Integer>(number))
            return Integer(number);
    } else if (const auto number = json.template get<double>();
               std::abs(number) <= maxExact && number == std::floor(number)) {
        if (std::in_range<Integer>(std::int64_t(number))) return Integer(number);
    }
    throw std::out_of_range("a number that is not whole, or out of range");
}

/// Reads a whole number from a member of an object; returns `otherwise` if there is no such member.
template <std::integral Integer, class Json>
Integer wholeNumberIn(const Json& json, const char* member, Integer otherwise) {
    const auto found = json.find(member);
    return found == json.end() ? otherwise : wholeNumberFrom<Integer>(*found);
}

/// The number that a CSV text with so many decimals states (CsvText): so JSON and CSV round halves alike.
inline double roundAsText(double value, int decimals) {
    if (!std::isfinite(value)) return value;
    std::array<char, 400> digits{};  // the largest double has 309 before its point
    const auto end = std::to_chars(digits.begin(), digits.end(), value, std::chars_format::fixed, decimals);
    std::from_chars(digits.begin(), end.ptr, value);
    return value;
}

}  // namespace noonmark
