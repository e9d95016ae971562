#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/io/cityjson/cityjson_model.h"
#include "core/io/cityjson/lod_choice.h"

namespace noonmark {

/// Fills `object.body` and `object.footprint` from the object's "geometry": the body is the best of the
/// levels of detail 1 and above (lod_choice.h). Surfaces with indices beyond `vertexCount` are dropped with a
/// warning, which names the object as `where`.
void chooseGeometry(const nlohmann::json& geometries, const LodChoice& choice, std::size_t vertexCount,
                    const std::string& where, CityJsonObject& object, Warnings& warnings);

}  // namespace noonmark
