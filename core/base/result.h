#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>

namespace noonmark {

/// Why something could not be done, in words that a planner understands.
struct Error {
    std::string what;    ///< what is wrong: "The file holds no polygons"
    std::string where;   ///< file, feature or field; empty when there is no place
    std::string advice;  ///< what to do about it; may be empty

    /// One line: "where: what. advice"
    [[nodiscard]] std::string text() const;
};

/// A value, or the reason why there is none. Functions of the house do not throw across their interface.
template <class T>
using Result = tl::expected<T, Error>;

/// `return failure("The file holds no polygons", path, "Export the building footprints as polygons");`
[[nodiscard]] tl::unexpected<Error> failure(std::string what, std::string where = {},
                                            std::string advice = {});

/// The error of work that was stopped through its stop token.
[[nodiscard]] tl::unexpected<Error> cancelled();
[[nodiscard]] bool isCancelled(const Error& error);

}  // namespace noonmark
