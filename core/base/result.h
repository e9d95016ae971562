#pragma once

// The folder core/base holds what every other folder uses: Result and Error (this file), Warnings about
// single features (warnings.h), Progress (progress.h, progress_share.h), units (units.h), Stopwatch, the
// program's version, whole numbers from untrusted JSON (json_number.h), and the guard that every call to GDAL
// needs (gdal_calls.h). It includes no other folder of core.

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>

namespace noonmark {

/// Why something failed, in words that a planner understands.
struct Error {
    std::string what;    ///< what is wrong: "The file holds no polygons"
    std::string where;   ///< file, feature or field; empty if the error has no location
    std::string advice;  ///< what the user can do about it; may be empty

    /// One line: "where: what. advice"
    [[nodiscard]] std::string text() const;
};

/// A value, or the reason why there is none. Functions of this program do not throw across their interfaces.
template <class T>
using Result = tl::expected<T, Error>;

/// `return failure("The file holds no polygons", path, "Export the building footprints as polygons");`
[[nodiscard]] tl::unexpected<Error> failure(std::string what, std::string where = {},
                                            std::string advice = {});

/// The error of work that was stopped through its stop token.
[[nodiscard]] tl::unexpected<Error> cancelled();
[[nodiscard]] bool isCancelled(const Error& error);

}  // namespace noonmark
