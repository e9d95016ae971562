#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/measures/error_sample.h"
#include "core/measures/statistics.h"

namespace noonmark {

/// The stored result of one tile of a study, except for its cells, which are in a raster file, or its lines
/// of JSON.
struct TileResult {
    std::size_t number = 0;  ///< tile number in the TilePlan
    ShadowSums sums;
    std::vector<double> monthMinutes{};  ///< of each month: sum over the receivers; empty unless wanted
    /// Sums that only some measures have, by name; their tiles are added up
    std::map<std::string, double> figures{};
    std::size_t lines = 0;  ///< of JSON in the tile's file; 0: the file is a raster
    bool hasTrees = false;  ///< the city that it read has some, which are not measured
    Cost cost;
    std::string engineKey;  ///< key of the engine that computed it; empty if there was nothing to do
    std::string engine;     ///< its name for display
    std::vector<ComparedCell> compared;  ///< cells compared with the ray reference
    double seconds = 0;
    double errorSeconds = 0;  ///< the part of `seconds` spent on `compared`

    /// Hash of everything that the tile was computed from; empty if the journal's own study says it all
    std::string contentHash{};
    std::uintmax_t fileBytes = 0;  ///< size of the tile's file; 0: not known
    std::string fileSha256{};      ///< of the tile's file; empty: not known

    /// Without a file.
    [[nodiscard]] bool empty() const { return sums.receivers == 0 && lines == 0; }
};

/// One line of a journal, from which the same value is read back, to the last bit.
nlohmann::json toJson(const TileResult& result);
/// Nothing if the JSON is not a TileResult.
std::optional<TileResult> tileResultFrom(const nlohmann::json& json);

}  // namespace noonmark
