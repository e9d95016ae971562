#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/warnings.h"
#include "core/io/footprints/footprint_scan.h"
#include "core/io/footprints/place_features.h"
#include "core/io/heights/height_facts.h"
#include "core/io/osm/osm_layers.h"
#include "core/io/osm/osm_map.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

/// The tag that a map's trees have, of points and lines, and the tags that describe them.
inline constexpr const char* osmTreeKey = "natural";
const std::vector<std::string>& osmTreeKeys();

/// The trees of a map that was read with them: natural=tree, and natural=tree_row as trees 8 m apart along
/// its line, with a warning for each row.
std::vector<ReadTree> listOsmTrees(const OsmMap& map, Warnings& warnings);

/// Adds the canopy of an area that is natural=wood (coverWithCanopy()), with a warning; of others nothing.
void addOsmWood(const OsmArea& area, std::vector<ReadTree>& trees, Warnings& warnings);

/// Buildings of an OpenStreetMap file, before repair.
struct OsmBuildings {
    std::vector<UnplacedFeature> features;  ///< relations in the file's order, then ways by id
    std::size_t areas = 0;                  ///< areas of any kind in the file
    std::vector<ReadTree> trees;            ///< listOsmTrees() and addOsmWood()
    HeightFacts heights;
    Warnings warnings;
};

/// The format of a file that begins as OpenStreetMap does; nothing for others. The same of its first bytes.
std::optional<OsmFormat> findOsmFormat(const std::filesystem::path& file);
std::optional<OsmFormat> osmFormatOf(std::string_view head);

/// Reads what is tagged building or building:part. GDAL's remarks on shapes go to the GdalCalls of this
/// thread. Errors as readOsmMap(), and of a file without areas or without buildings.
Result<OsmBuildings> readOsmBuildings(const std::filesystem::path& file, OsmFormat format,
                                      const ReadSettings& settings, Progress& progress,
                                      const std::stop_token& stop);

/// Reads the buildings of OpenStreetMap; always the whole file.
Result<FilePiece> readOsmFootprints(const std::filesystem::path& file, const ReadSettings& settings,
                                    Progress& progress, std::stop_token stop);

/// scanFootprints() of OpenStreetMap; its areas are in memory meanwhile.
Result<FootprintScan> scanOsmFootprints(const std::filesystem::path& file, const ReadSettings& settings,
                                        Progress& progress, std::stop_token stop);

}  // namespace noonmark
