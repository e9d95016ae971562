#pragma once

#include <nlohmann/json.hpp>

#include "core/study/study.h"

namespace noonmark {

/// `error` of study.json: always the same keys, null if nothing was measured; `why_not` says why.
nlohmann::ordered_json errorJson(const Study& study);

/// The error alone, with positions in the frame's local metres and in degrees.
nlohmann::ordered_json errorJson(const SampledError& error, const Frame& frame);

}  // namespace noonmark
