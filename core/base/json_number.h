#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace noonmark {

/// A whole number out of JSON that anybody may have written (nlohmann's, any kind). Json::get() takes every
/// number, also one that `Integer` cannot hold: -1 becomes the largest of all, and 1e300 anything. Throws
/// std::out_of_range for a number that is not whole or that Integer cannot hold, and nlohmann's type_error
/// for what is no number.
template <std::integral Integer, class Json>
Integer wholeNumberFrom(const Json& json) {
    constexpr double mostExact = 9007199254740992;  // 2^53; from there on double leaves numbers out
    if (json.is_number_unsigned()) {
        if (const auto number = json.template get<std::uint64_t>(); std::in_range<Integer>(number))
            return Integer(number);
    } else if (json.is_number_integer()) {
        if (const auto number = json.template get<std::int64_t>(); std::in_range<Integer>(number))
            return Integer(number);
    } else if (const auto number = json.template get<double>();
               std::abs(number) <= mostExact && number == std::floor(number)) {
        if (std::in_range<Integer>(std::int64_t(number))) return Integer(number);
    }
    throw std::out_of_range("a number that is not whole, or out of range");
}

/// The same of a member; `otherwise` where there is none.
template <std::integral Integer, class Json>
Integer wholeNumberIn(const Json& json, const char* member, Integer otherwise) {
    const auto found = json.find(member);
    return found == json.end() ? otherwise : wholeNumberFrom<Integer>(*found);
}

}  // namespace noonmark
