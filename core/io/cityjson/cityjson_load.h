#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <stop_token>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geo/frame.h"
#include "core/io/cityjson/cityjson_model.h"
#include "core/io/pieces/read_part.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

/// A member of an object; null where there is none, or no object.
const nlohmann::json& memberIn(const nlohmann::json& object, const char* key);

std::string textIn(const nlohmann::json& value);  ///< empty where it is no text

/// The level of detail of a geometry: a text ("3.1") or, before version 1.1, a number. Empty: none.
std::optional<double> lodIn(const nlohmann::json& geometry);

/// Reads CityJSON 1.0, 1.1, 2.0 or CityJSONSeq into plain values. The whole file is held in memory while it
/// is parsed (about ten times its size), a sequence one line at a time. Error: not JSON, not CityJSON, or
/// empty; a feature that cannot be read gives a warning.
Result<CityJsonData> loadCityJson(const std::filesystem::path& file, const ReadSettings& settings,
                                  Progress& progress, const std::stop_token& stop);

/// The area of plants that an object is, by its surfaces; without vertices if it has none.
CityJsonTree makePlantCover(const CityJsonObject& object, TreeFacts facts);

/// Adds the trees of the data to a piece: single ones by their measures, or those of their shapes; areas of
/// plants of 2 m and more as canopy (coverWithCanopy()), with a warning. The vertices are in local metres of
/// the frame.
void addTrees(const CityJsonData& data, const std::string& file, const Frame& frame, FilePiece& piece);

/// Makes the terrain of the piece from the TIN of the data, if it has one. The vertices are in local metres
/// (placeCity).
void addTin(const CityJsonData& data, const std::string& file, FilePiece& piece);

/// Adds the buildings of the data to a piece. An object without a parent and all objects below it are one
/// building; its solids are parts. An object without a solid or surface is extruded from its footprint of
/// level of detail 0, by its measured height, else its storeys, else the default. On all cores. False when
/// stopped.
bool addBuildings(const CityJsonData& data, const ReadSettings& settings, const std::string& file,
                  FilePiece& piece, Progress& progress, const std::stop_token& stop);

/// Transforms the vertices of all blocks to local metres, in place, and removes objects farther than
/// `settings.farAwayM` from the middle of the data (the median of the objects), with a warning. Returns the
/// frame: the given one, or one with its origin in the middle of the remaining objects and z = 0 at the level
/// below which 5 % of the buildings begin (for terrain alone: its lowest point). Error: no coordinate
/// reference system, or coordinates that cannot belong to it; cancelled().
Result<Frame> placeCity(CityJsonData& data, const ReadSettings& settings, const std::string& file,
                        const std::stop_token& stop);

}  // namespace noonmark
