#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"

namespace noonmark {

/// Which geometry of an object to choose.
struct LodChoice {
    std::optional<double> wished;  ///< the wanted level of detail; empty: the highest that exists
};

/// Of ReadSettings::lod. Error: not a number.
Result<LodChoice> parseLodChoice(const std::string& lod);

/// What a geometry is chosen by.
struct LodRank {
    double lod = 0;
    bool solid = false;
};

/// Whether `a` is the better choice: of the levels of detail the highest that does not exceed the wanted one,
/// else the lowest; solids before surfaces.
bool isBetter(const LodRank& a, const LodRank& b, const LodChoice& choice);

}  // namespace noonmark
