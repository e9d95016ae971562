#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/city/terrain/terrain.h"
#include "core/city/trees/tree.h"
#include "core/engines/api/shadow_field.h"
#include "core/study/terrain_coverage.h"

namespace noonmark {

/// Origin, processing and deviation of a terrain, as one sentence for display.
std::string formatText(const Terrain& terrain);

/// How much lies beyond the terrain, as a sentence; empty if nothing does.
std::string formatText(const TerrainCoverage& coverage);

/// The terrain as JSON for study.json and info: {"text", "method", "columns", "rows", "cell_m", "source",
/// ...}; lengths in metres.
nlohmann::ordered_json terrainJson(const Terrain& terrain);
nlohmann::ordered_json makeCoverageJson(const TerrainCoverage& coverage);

/// The source, and the positions of the posts to the last bit, as stored in the project file (column `source`
/// of its table `terrain`: docs/project-file.md).
std::string sourceText(const Terrain& terrain);

/// Parses such a text into `terrain`. A text without positions leaves the posts unchanged, and the source
/// unknown. False: the positions of the posts are invalid.
bool takeSource(const std::string& text, Terrain& terrain);

/// How many trees there are, by the source of height and of crown, and when those that lose their leaves have
/// them ("04-15").
nlohmann::ordered_json treesJson(const Trees& trees);
/// The same, and what was measured of them.
nlohmann::ordered_json treesJson(const Trees& trees, const ShadowField& field);

/// "1,204; heights: 1,000 measured, 204 estimated; crowns: 1,204 estimated"
std::string describeTrees(const Trees& trees);
/// "300 can reach a receiver, of 1,204; heights: ...; trunks are left out"
std::string describeTrees(const Trees& trees, std::size_t used);
std::string describeTrees(const Trees& trees, const ShadowField& field);

}  // namespace noonmark
