#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/measures/error_sample.h"
#include "core/measures/statistics.h"

namespace noonmark {

/// What is kept of one tile of a study, beside its cells in a raster file.
struct TileResult {
    std::size_t number = 0;  ///< in the TilePlan
    ShadowSums sums;
    Cost cost;
    std::string engineKey;               ///< of the engine that did it; empty where there was nothing to do
    std::string engine;                  ///< in words
    std::vector<ComparedCell> compared;  ///< with the ray reference
    double seconds = 0;
    double errorSeconds = 0;  ///< of those, for `compared`

    [[nodiscard]] bool empty() const { return sums.receivers == 0; }
};

/// One line of a journal: the same value comes back, to the last bit.
nlohmann::json toJson(const TileResult& result);
/// Nothing where the JSON is not one.
std::optional<TileResult> tileResultFrom(const nlohmann::json& json);

}  // namespace noonmark
