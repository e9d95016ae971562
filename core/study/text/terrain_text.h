#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/city/terrain/terrain.h"
#include "core/study/terrain_coverage.h"

namespace noonmark {

/// Where a terrain comes from, what was done to it and how far it is off, as one sentence for people.
std::string textOf(const Terrain& terrain);

/// What lies beyond the terrain, as a sentence; empty where nothing does.
std::string textOf(const TerrainCoverage& coverage);

/// The terrain as study.json and info have it: {"text", "method", "columns", "rows", "cell_m", "source",
/// ...}; lengths in metres.
nlohmann::ordered_json terrainJson(const Terrain& terrain);
nlohmann::ordered_json coverageJson(const TerrainCoverage& coverage);

/// The source, and the places of the posts to the last bit, as the project file has them (column `source` of
/// its table `terrain`: docs/project-file.md).
std::string sourceText(const Terrain& terrain);

/// Takes them from such a text. One without them leaves the posts as they are, and a source of which nothing
/// is known. False: the posts' places make no sense.
bool takeSource(const std::string& text, Terrain& terrain);

}  // namespace noonmark
