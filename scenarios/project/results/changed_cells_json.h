#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "scenarios/impact/impact.h"

namespace noonmark {

/// Cells that became building or ground, as runs in grid order: [first cell, length, "building" or "ground"].
nlohmann::ordered_json changedCellsJson(const std::vector<CellChange>& change);

/// Parses such runs for a grid of `cells` cells. Throws nlohmann's exceptions or std::invalid_argument where
/// the JSON does not match.
std::vector<CellChange> parseChangedCells(const nlohmann::ordered_json& json, std::size_t cells);

}  // namespace noonmark
