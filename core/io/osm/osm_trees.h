#pragma once

#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/io/osm/osm_map.h"
#include "core/io/pieces/read_tree.h"

namespace noonmark {

/// The tag that a map's trees have, of points and lines, and the tags that describe them.
inline constexpr const char* osmTreeKey = "natural";
const std::vector<std::string>& osmTreeKeys();

/// The trees of a map that was read with them: natural=tree, and natural=tree_row as trees 8 m apart along
/// its line, with a warning for each row. Woods are left out: they state no trees.
std::vector<ReadTree> listOsmTrees(const OsmMap& map, Warnings& warnings);

}  // namespace noonmark
