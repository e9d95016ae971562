#include "core/study/tile_tasks/plan/tile_load.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>

#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/study/provenance/study_hash.h"

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

namespace {

// Measured on tiles of New York, loaded machine: docs/scale.md.
constexpr double secondsToReadABuilding = 100e-6;
constexpr double secondsToWriteACell = 0.25e-6;
constexpr double programBytes = 150e6;
constexpr double bytesOfABuilding = 10000;
constexpr double bytesOfAPoint = 600;
constexpr double bytesOfACell = 400;
constexpr double bytesOfAPost = 250;

double secondsOf(const std::string& engine, const EstimatedSeconds& seconds, bool level) {
    if (engine == "ray") return seconds.ray;
    if (engine == "projected") return seconds.projected;
    if (engine == "auto") return std::min(level ? seconds.projected : seconds.ray, seconds.horizon + 2);
    return seconds.horizon;
}

}  // namespace

TileCost estimateTile(const TileHalo& halo, const Grid& tile, const StudySettings& settings,
                      const SunSteps& sun, std::size_t terrainPosts, const EngineList& engines) {
    const bool level = terrainPosts == 0 && settings.receivers.places == ReceiverPlaces::ground;
    const EngineLoad load{.receivers = tile.size(),
                          .rows = std::size_t(tile.rows),
                          .cellAreaM2 = tile.cellAreaM2(),
                          .steps = sun.steps.size(),
                          .bins = binCount(sun, HorizonSweepSettings{}),
                          .buildings = halo.buildings,
                          .overhangTriangles = halo.overhangTriangles,
                          .terrainCells = terrainPosts,
                          .level = level};
    const EngineEntry* engine = findEngine(engines, settings.engine);
    const double engineBytes = engine == nullptr ? 0 : engine->info.bytesPerCell;
    const double readBytes = double(halo.buildings) * bytesOfABuilding + double(halo.points) * bytesOfAPoint;
    const double ownBytes = programBytes + double(tile.size()) * (bytesOfACell + engineBytes) +
                            double(terrainPosts) * bytesOfAPost +
                            2 * double(sun.steps.size()) * double(sizeof(SunStep));
    return {secondsOf(settings.engine, estimateSeconds(load), level) +
                double(halo.buildings) * secondsToReadABuilding + double(tile.size()) * secondsToWriteACell,
            ownBytes + readBytes, readBytes};
}

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

void addHash(OccluderSurvey::Cell& cell, std::string_view hash) {
    cell.hashSum[0] += numberFrom(hash.substr(0, 16));
    cell.hashSum[1] += numberFrom(hash.substr(16, 16));
}

void count(OccluderSurvey::Cell& cell, const Building& building) {
    ++cell.buildings;
    for (const Part& part : building.parts) {
        std::size_t points = part.mesh ? part.mesh->vertices.size() : part.footprint.outer.size();
        for (const Ring& hole : part.footprint.holes) points += hole.size();
        cell.points += std::uint32_t(points);
        if (part.isOverhanging) cell.overhangTriangles += std::uint32_t(4 * points);
    }
    addHash(cell, hashBuilding(building));
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
    if (city.trees) addTrees(*city.trees, counted);
}

void OccluderSurvey::addTrees(const Trees& trees, const Box2& counted) {
    for (const Tree& tree : trees.trees) {
        const glm::vec2 place(tree.place);
        if (!holds(counted, place)) continue;
        const Range range = cellsIn({place - tree.crownDiameterM / 2, place + tree.crownDiameterM / 2});
        for (int row = range.firstRow; row < range.endRow; ++row)
            for (int column = range.firstColumn; column < range.endColumn; ++column) {
                Cell& cell = cells_[grid_.index(column, row)];
                cell.highestM = std::max(cell.highestM, tree.groundM + tree.heightM);
                cell.longestM = std::max(cell.longestM, tree.crownDiameterM);
            }
        addHash(cells_[grid_.index(range.firstColumn, range.firstRow)], hashTree(tree, trees.leafDays));
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
