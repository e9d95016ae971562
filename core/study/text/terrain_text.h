#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/city/terrain/terrain.h"
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

}  // namespace noonmark
