#pragma once

#include <stop_token>

#include "core/io/cityjson/cityjson_model.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

/// Makes the terrain of the piece from the TIN of the data, if it has one. The vertices are in local metres
/// (placeCity).
void addTin(const CityJsonData& data, const std::string& file, FilePiece& piece);

/// Adds the buildings of the data to a piece. An object without a parent and all objects below it are one
/// building; its solids are parts. An object without a solid or surface is extruded from its footprint of
/// level of detail 0, by its measured height, else its storeys, else the default. On all cores. False when
/// stopped.
bool addBuildings(const CityJsonData& data, const ReadSettings& settings, const std::string& file,
                  FilePiece& piece, Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
