#include "core/study/tile_tasks/plan/occluder_survey.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/study/provenance/study_hash.h"

namespace noonmark {

namespace {

Grid gridAround(const Box2& box, double cellM) {
    const glm::dvec2 size = glm::dvec2(box.high) - glm::dvec2(box.low);
    return {box.low.x, box.low.y, cellM, std::max(1, int(std::ceil(size.x / cellM))),
            std::max(1, int(std::ceil(size.y / cellM)))};
}

int clampedCell(double atM, double firstM, double cellM, int count) {
    return int(std::clamp(std::floor((atM - firstM) / cellM), 0.0, double(count - 1)));
}

std::uint64_t numberFrom(std::string_view hex) {
    std::uint64_t number = 0;
    std::from_chars(hex.data(), hex.data() + hex.size(), number, 16);
    return number;
}

void count(OccluderSurvey::Cell& cell, const Building& building) {
    ++cell.buildings;
    for (const Part& part : building.parts) {
        std::size_t points = part.mesh ? part.mesh->vertices.size() : part.footprint.outer.size();
        for (const Ring& hole : part.footprint.holes) points += hole.size();
        cell.points += std::uint32_t(points);
        if (part.isOverhanging) cell.overhangTriangles += std::uint32_t(4 * points);
    }
    const std::string hash = hashBuilding(building);
    cell.hashSum[0] += numberFrom(std::string_view(hash).substr(0, 16));
    cell.hashSum[1] += numberFrom(std::string_view(hash).substr(16, 16));
}

bool holds(const Box2& box, glm::vec2 point) {
    return point.x >= box.low.x && point.x < box.high.x && point.y >= box.low.y && point.y < box.high.y;
}

}  // namespace

OccluderSurvey::OccluderSurvey(const Box2& box, double cellM)
    : grid_(gridAround(box, cellM)), cells_(grid_.size()) {}

void OccluderSurvey::add(const City& city, const Box2& counted) {
    for (const auto& building : city.buildings) {
        const Box2 box = bounds(*building);
        if (box.empty()) continue;
        const Range range = cellsIn(box);
        const float longest = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
        for (int row = range.firstRow; row < range.endRow; ++row)
            for (int column = range.firstColumn; column < range.endColumn; ++column) {
                Cell& cell = cells_[grid_.index(column, row)];
                cell.highestM = std::max(cell.highestM, topM(*building));
                cell.longestM = std::max(cell.longestM, longest);
            }
        if (!holds(counted, box.low)) continue;
        buildingsBox_.add(box);
        count(cells_[grid_.index(range.firstColumn, range.firstRow)], *building);
    }
}

// Ground between posts lies between their elevations, so that posts next to the cell count too.
void OccluderSurvey::addTerrain(const Terrain& terrain) {
    for (Cell& cell : cells_) cell.lowestGroundM = std::numeric_limits<float>::infinity();
    const auto around = float(2 * terrain.grid.cellM);
    const float lowest = *std::ranges::min_element(terrain.elevationM);
    for (int row = 0; row < terrain.grid.rows; ++row)
        for (int column = 0; column < terrain.grid.columns; ++column) {
            const glm::vec2 post(terrain.grid.centre(column, row));
            const float elevation = terrain.elevationM[terrain.grid.index(column, row)];
            const Range range = cellsIn({post - around, post + around});
            for (int r = range.firstRow; r < range.endRow; ++r)
                for (int c = range.firstColumn; c < range.endColumn; ++c) {
                    Cell& cell = cells_[grid_.index(c, r)];
                    cell.lowestGroundM = std::min(cell.lowestGroundM, elevation);
                }
        }
    for (Cell& cell : cells_)
        if (!std::isfinite(cell.lowestGroundM)) cell.lowestGroundM = lowest;
}

Box2 OccluderSurvey::boxOf(std::size_t cell) const {
    const int column = int(cell % std::size_t(grid_.columns)), row = int(cell / std::size_t(grid_.columns));
    const glm::dvec2 low(grid_.westM + column * grid_.cellM, grid_.southM + row * grid_.cellM);
    return {glm::vec2(low), glm::vec2(low + grid_.cellM)};
}

OccluderSurvey::Range OccluderSurvey::cellsIn(const Box2& box) const {
    return {clampedCell(box.low.x, grid_.westM, grid_.cellM, grid_.columns),
            clampedCell(box.high.x, grid_.westM, grid_.cellM, grid_.columns) + 1,
            clampedCell(box.low.y, grid_.southM, grid_.cellM, grid_.rows),
            clampedCell(box.high.y, grid_.southM, grid_.cellM, grid_.rows) + 1};
}

}  // namespace noonmark
