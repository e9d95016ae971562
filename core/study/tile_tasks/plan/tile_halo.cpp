#include "core/study/tile_tasks/plan/tile_halo.h"

#include <algorithm>
#include <glm/common.hpp>

namespace noonmark {

namespace {

template <class Visit>
void forEachCell(const OccluderSurvey& survey, const Box2& box, const Visit& visit) {
    const OccluderSurvey::Range range = survey.cellsIn(box);
    for (int row = range.firstRow; row < range.endRow; ++row)
        for (int column = range.firstColumn; column < range.endColumn; ++column)
            visit(survey.grid().index(column, row));
}

float lowestGround(const OccluderSurvey& survey, const Box2& tile) {
    float lowest = std::numeric_limits<float>::infinity();
    forEachCell(survey, tile,
                [&](std::size_t cell) { lowest = std::min(lowest, survey.cells()[cell].lowestGroundM); });
    return lowest;
}

float longestSide(const OccluderSurvey& survey, const Box2& box) {
    float longest = 0;
    forEachCell(survey, box,
                [&](std::size_t cell) { longest = std::max(longest, survey.cells()[cell].longestM); });
    return longest;
}

}  // namespace

TileHalo findHalo(const OccluderSurvey& survey, const ShadowReach& reach, const Grid& grid) {
    const Box2 tile{{float(grid.westM), float(grid.southM)}, {float(grid.eastM()), float(grid.northM())}};
    const float ground = lowestGround(survey, tile);
    TileHalo halo{.occluders = tile};
    for (std::size_t i = 0; i < survey.cells().size(); ++i) {
        const OccluderSurvey::Cell& cell = survey.cells()[i];
        if (cell.highestM == OccluderSurvey::Cell::nothing) continue;
        const Box2 box = survey.boxOf(i);
        if (reach.touches(box, double(cell.highestM) - double(ground), tile)) halo.occluders.add(box);
    }
    // Twice: parts that overlap a part of a building decide, with their own outlines, whose part it is.
    const float around = 2 * longestSide(survey, halo.occluders) + 1;
    halo.reads = {halo.occluders.low - around, halo.occluders.high + around};
    halo.reads.low = glm::max(halo.reads.low, survey.boxOf(0).low);
    halo.reads.high = glm::min(halo.reads.high, survey.boxOf(survey.cells().size() - 1).high);
    halo.reads.add(halo.occluders);
    forEachCell(survey, halo.reads, [&](std::size_t i) {
        const OccluderSurvey::Cell& cell = survey.cells()[i];
        halo.buildings += cell.buildings;
        halo.points += cell.points;
        halo.overhangTriangles += cell.overhangTriangles;
    });
    forEachCell(survey, tile,
                [&](std::size_t cell) { halo.buildingsInTile += survey.cells()[cell].buildings; });
    return halo;
}

}  // namespace noonmark
