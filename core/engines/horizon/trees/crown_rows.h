#pragma once

#include <cstddef>
#include <span>

#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// Suns of a bin that are weighed together, at the mean tangent of their altitudes.
struct CrownLevel {
    float tan = 0, secant = 1;   ///< of the altitude
    float belowCode = 0;         ///< code of its highest sun + 1
    float perCode = 1;           ///< 1 / (belowCode - code of its lowest sun)
    float inLeaf = 0, bare = 0;  ///< numbers of suns in and out of the leaf season
};

/// A crown before a row of 16 cells, as a quadric cut by two levels. With x from its axis away from the cell,
/// u aside and p the ray's height over the pivot there: inside where a (x2 + u2) + q (p + tan x)2 + c <= 0.
struct CrownOnRow {
    float distance,
        distanceStep;        ///< along the azimuth from the first cell to the axis; from cell to cell, m
    float aside, asideStep;  ///< across it, m
    float a, q, c;
    float pivotM, bottomM, topM;     ///< above the datum of the cells
    float inLeafPerM, barePerM;      ///< optical depth
    const float* groundM = nullptr;  ///< of the 16 cells above the datum; null: 0
};

/// Adds the crown's optical depth at some levels: to [level][cell], 16 floats a level, from the first level
/// of the span on.
void addCrownToRow(const CrownOnRow& crown, std::span<const CrownLevel> levels, float* inLeaf, float* bare);

/// Steps that crowns take from cells at some levels, of those that the cells' horizons leave: each sun counts
/// 1 - exp(-optical depth). A level that a horizon cuts counts by the share of its codes. 16 of each.
void weighRow(std::span<const CrownLevel> levels, const float* inLeaf, const float* bare,
              const HorizonCode* horizons, float* evergreen, float* seasonal);

}  // namespace noonmark
