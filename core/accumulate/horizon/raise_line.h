#pragma once

#include <span>

namespace noonmark {

/// One wall as one line of a sheared tile sees it. `along` and q count from the line's own beginning.
struct WallOnLine {
    float along;        ///< of the wall where it meets the line's edge (fraction 0)
    float slope;        ///< of `along` against the fraction
    float lowQ, highQ;  ///< the fractions that it shades: lowQ <= fraction < highQ
    float farthest;     ///< highest `along` of the wall within the line
    float rise;         ///< height, such that rise / (distance in `along`) is the tangent of the horizon
    float nearest;      ///< it shades cells at a greater distance, below 0 too
    int first, end;     ///< cells that it can shade, in `along`; 0 <= first <= end
};

/// Raises the horizons of a line's cells to those that the wall gives them. `fractions` and `horizons`
/// (tangents, one a cell) start on a cache line and are padded to whole ones. Cells before the wall, or
/// beside it, stay as they are; a cell on the wall gets a horizon above any sun. The same bits on every
/// instruction set. About 1 ns a cell, less where skipped.
void raiseLine(const WallOnLine& wall, const float* fractions, float* horizons, float* lowest);

/// The lowest horizon of every 16 cells, to begin with. `horizons`: 16 for each of `lowest`, on a cache line.
void lowestOfSixteens(const float* horizons, std::span<float> lowest);

}  // namespace noonmark
