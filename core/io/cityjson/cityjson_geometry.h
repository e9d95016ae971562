#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/io/cityjson/cityjson_model.h"

namespace noonmark {

/// Which geometry of an object to choose.
struct LodChoice {
    std::optional<double> wished;  ///< the wanted level of detail; empty: the highest that exists
};

/// Fills `object.body` and `object.footprint` from the object's "geometry". Of the levels of detail 1 and
/// above it takes the highest that does not exceed the wanted one, else the lowest; solids before surfaces.
/// Surfaces with indices beyond `vertexCount` are dropped with a warning, which names the object as `where`.
void chooseGeometry(const nlohmann::json& geometries, const LodChoice& choice, std::size_t vertexCount,
                    const std::string& where, CityJsonObject& object, Warnings& warnings);

}  // namespace noonmark
