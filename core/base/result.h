#pragma once

// The folder core/base holds what every other folder uses: Result and Error (this file), Warnings about
// single features (warnings.h), Progress (progress.h), units (units.h), Stopwatch, the
// program's version, whole numbers from untrusted JSON (json_number.h), and the guard that every call to GDAL
// needs (gdal_calls.h). It includes no other folder of core.

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <type_traits>
#include <utility>

namespace noonmark {

/// What kind of reason an error has, for callers that act on it. Texts are for people and are never compared.
enum class ErrorKind {
    input,        ///< something in a file or a setting is wrong
    unsupported,  ///< nothing is wrong, but this engine or reader does not take it; another may
    limit,        ///< too large: memory, or a bound that the message names
    cancelled,    ///< stopped through a stop token
    internal,     ///< a defect of the program
};

/// Why something could not be done, in words that a planner understands.
struct Error {
    std::string what;    ///< what is wrong: "The file holds no polygons"
    std::string where;   ///< file, feature or field; empty when there is no place
    std::string advice;  ///< what to do about it; may be empty
    ErrorKind kind = ErrorKind::input;

    /// One line: "where: what. advice"
    [[nodiscard]] std::string text() const;
};

/// A value, or the reason why there is none. Functions do not throw across their interface. It must not be
/// ignored: tl::expected, which has the contract of all its functions, is not [[nodiscard]] by itself.
template <class T>
class [[nodiscard]] Result : public tl::expected<T, Error> {
public:
    using Base = tl::expected<T, Error>;
    using Base::Base;
    Result() = default;
    Result(const Base& other) : Base(other) {}
    Result(Base&& other) : Base(std::move(other)) {}

    // The library's own chain asks each link for a tl::expected by that name; these take a Result as well.
    template <class F>
    auto and_then(F&& next) & {
        return chain(*this, std::forward<F>(next));
    }
    template <class F>
    auto and_then(F&& next) const& {
        return chain(*this, std::forward<F>(next));
    }
    template <class F>
    auto and_then(F&& next) && {
        return chain(std::move(*this), std::forward<F>(next));
    }

private:
    template <class Self, class F>
    static auto chain(Self&& self, F&& next) {
        if constexpr (std::is_void_v<T>) {
            using Next = std::invoke_result_t<F>;
            return self ? Next(std::forward<F>(next)())
                        : Next(tl::unexpect, std::forward<Self>(self).error());
        } else {
            using Next = std::invoke_result_t<F, decltype(*std::forward<Self>(self))>;
            return self ? Next(std::forward<F>(next)(*std::forward<Self>(self)))
                        : Next(tl::unexpect, std::forward<Self>(self).error());
        }
    }
};

/// `return failure("The file holds no polygons", path, "Export the building footprints as polygons");`
/// Of kind `input`; the next three are of the kinds that they name.
[[nodiscard]] tl::unexpected<Error> failure(std::string what, std::string where = {},
                                            std::string advice = {});
[[nodiscard]] tl::unexpected<Error> unsupported(std::string what, std::string where = {},
                                                std::string advice = {});
[[nodiscard]] tl::unexpected<Error> limitReached(std::string what, std::string where = {},
                                                 std::string advice = {});
[[nodiscard]] tl::unexpected<Error> internalError(std::string what, std::string where = {});

/// The error of work that was stopped through its stop token.
[[nodiscard]] tl::unexpected<Error> cancelled();
[[nodiscard]] inline bool isCancelled(const Error& error) { return error.kind == ErrorKind::cancelled; }

}  // namespace noonmark
