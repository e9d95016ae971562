#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "scenarios/impact/impact.h"

namespace noonmark {

/// Cells that were built over or became ground, as runs in grid order: [first cell, how many, "building" or
/// "ground"].
nlohmann::ordered_json changedCellsJson(const std::vector<CellChange>& change);

/// Back, for so many cells. Throws nlohmann's exceptions, or std::invalid_argument, where it is of another
/// shape.
std::vector<CellChange> parseChangedCells(const nlohmann::ordered_json& json, std::size_t cells);

}  // namespace noonmark
