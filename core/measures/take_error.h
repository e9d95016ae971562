#pragma once

#include <optional>

#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/measures/sampled_error.h"

namespace noonmark {

/// Takes the error of a result, or states in a warning why it was not measured, which fails no study. Error:
/// cancelled().
inline Result<void> takeError(const Result<SampledError>& measured, std::optional<SampledError>& error,
                              Warnings& warnings) {
    if (measured) {
        error = *measured;
        return {};
    }
    if (isCancelled(measured.error())) return tl::make_unexpected(measured.error());
    warnings.push_back(
        {WarningKind::leftOut, "the error against the ray reference", measured.error().text()});
    return {};
}

}  // namespace noonmark
