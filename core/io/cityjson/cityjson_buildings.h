#pragma once

#include <stop_token>

#include "core/io/cityjson/cityjson_model.h"
#include "core/io/read_part.h"

namespace noonmark {

/// Makes the data's TIN (if any) the piece's terrain. The vertices are local metres (placeCity).
void addTin(const CityJsonData& data, const std::string& file, FilePiece& piece);

/// Adds the data's buildings to a piece: an object without a parent and all below it is one building, its
/// solids are parts. What has no solid or surface of its own is extruded from its footprint of level of
/// detail 0, by its measured height, else its storeys, else the default. On all cores. False when stopped.
bool addBuildings(const CityJsonData& data, const ReadSettings& settings, const std::string& file,
                  FilePiece& piece, Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
