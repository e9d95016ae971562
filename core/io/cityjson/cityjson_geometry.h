#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/io/cityjson/cityjson_model.h"

namespace noonmark {

/// How to choose among the geometries of an object.
struct LodChoice {
    std::optional<double> wished;  ///< empty: the highest that is there
};

/// Fills `object.body` and `object.footprint` from the object's "geometry". Among levels of detail 1 and up:
/// the highest that is not above the wished one, else the lowest; solids before surfaces. Surfaces with
/// indices beyond `vertexCount` are dropped with a warning, `where` the object.
void chooseGeometry(const nlohmann::json& geometries, const LodChoice& choice, std::size_t vertexCount,
                    const std::string& where, CityJsonObject& object, Warnings& warnings);

}  // namespace noonmark
