#pragma once

#include <new>
#include <string>
#include <utility>

#include "core/base/result.h"

namespace noonmark {

/// What the error says if memory runs out: "There is not enough memory for this study".
struct OutOfMemory {
    std::string what = "this study";  ///< the work
    std::string where = {};           ///< the part that needs it: "cached horizons"; may be empty
    std::string advice = "Choose a smaller region or larger cells";

    [[nodiscard]] tl::unexpected<Error> error() const {
        return limitReached("There is not enough memory for " + what, where, advice);
    }
};

/// Calls `work`, which returns a Result. Where memory runs out (std::bad_alloc), calls `drop`, which releases
/// what is half done, and returns the error of `lack` (ErrorKind::limit). The one place that catches it, for
/// everything that Engine's own functions do not guard.
template <class Work, class Drop>
std::invoke_result_t<Work> guardMemory(const OutOfMemory& lack, Work&& work, Drop&& drop) {
    try {
        return std::forward<Work>(work)();
    } catch (const std::bad_alloc&) {
        std::forward<Drop>(drop)();
        return lack.error();
    }
}

template <class Work>
std::invoke_result_t<Work> guardMemory(const OutOfMemory& lack, Work&& work) {
    return guardMemory(lack, std::forward<Work>(work), [] {});
}

}  // namespace noonmark
