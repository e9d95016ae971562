#pragma once

// The folder core/io/trees reads trees from files of their own and joins those of all files into a city. The
// names of fields are in core/io/heights/tree_fields.h, OpenStreetMap's trees in
// core/io/osm/read_osm_buildings.h.

#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/io/heights/tree_fields.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

/// The trees of one file.
struct TreesRead {
    std::vector<ReadTree> trees;
    Warnings warnings;
    std::string attribution;
};

/// What an inventory does not state itself.
struct TreeReading {
    std::optional<std::string> crs = std::nullopt;  ///< of files that state none
    TreeFieldChoices fields = {};  ///< of a raster, whose cells are heights, the unit of `height`
};

/// Reads an inventory of trees: a vector file of points, or a table with columns of longitude and latitude
/// (or easting and northing in `crs`), or an OpenStreetMap file, or a raster of canopy heights
/// (read_trees_gdal.cpp). A feature that cannot be used is left out with a warning. Error: the file cannot be
/// read, holds no points, or more than 5 million trees; cancelled(). Some 10 us a tree. Backend:
/// read_trees_gdal.cpp.
Result<TreesRead> readTrees(const std::filesystem::path& file, const TreeReading& how, Progress& progress,
                            const std::stop_token& stop);

/// The trees that a city has and those of these files, on its ground and complete (completeTree); null where
/// there are none. Of trees that stand within half a metre of each other the first stays, with a warning for
/// each other one; so does a cell of a canopy raster that was read before; trees more than `farAwayM` from
/// the middle of the city's buildings are left out with a warning. Leaf days are those assumed for the city's
/// latitude. O(trees log trees).
std::shared_ptr<const Trees> joinTrees(const std::vector<ReadTree>& read, const City& city, double farAwayM,
                                       Warnings& warnings);

}  // namespace noonmark
