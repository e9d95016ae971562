#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/footprints/footprint_scan.h"
#include "core/io/heights/tree_fields.h"

namespace noonmark {

/// How a file may hold trees.
enum class TreeContent {
    none,
    inventory,  ///< points or a table whose fields measure or name trees
    points,     ///< points that say nothing of trees
    map,        ///< OpenStreetMap
    canopy,     ///< a raster whose cells are like those of canopy heights: none between crowns
    raster,     ///< any other
};

/// What a file of trees holds, for people who choose its fields.
struct ListedTrees {
    TreeContent content = TreeContent::none;
    std::vector<ListedLayer> layers;     ///< of inventories and points
    std::vector<KnownTreeField> fields;  ///< of the first layer that has some, by their names
};

/// Looks at the first features only: some milliseconds. Error: the file cannot be opened; cancelled().
/// Backend: list_trees_gdal.cpp.
Result<ListedTrees> listTrees(const std::filesystem::path& file, const std::stop_token& stop);

}  // namespace noonmark
