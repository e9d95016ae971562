#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <utility>
#include <vector>

#include "core/engines/common/run_counter.h"
#include "core/engines/ray/ray_scene.h"
#include "core/geo/grid.h"
#include "core/simd/cache_line.h"

namespace noonmark {

/// Neighbouring cells of a lane whose occluding points are adjacent on one building. Positions count cells in
/// the shadow's direction of motion; heights of the occluding points in metres.
struct SourceRun {
    int first = 0;
    int last = 0;
    float firstM = 0;
    float lastM = 0;
    std::uint32_t building = 0;
};

/// How the shadows of two neighbouring occluding points move. `cellsPerMetre`: cells that the shadow of a
/// point one metre up moves during the whole interval. `steepestM`: largest height difference between
/// neighbouring cells on one surface.
struct RunRule {
    float cellsPerMetre = 0;
    float steepestM = 0;
    static constexpr float foldedBy = -1.5F;  ///< cells by which a shadow is ahead of the previous one

    [[nodiscard]] constexpr bool sameSurface(float beforeM, float afterM) const {
        const float higher = afterM - beforeM;
        return (higher <= steepestM) & (higher >= -steepestM);
    }
    /// Whether the second shadow falls behind the first on the way, so that the surface folds over between
    /// them.
    [[nodiscard]] constexpr bool folds(float beforeM, float afterM) const {
        return (afterM - beforeM) * cellsPerMetre < foldedBy;
    }
};

/// The sources that shade one cell, nearest first, each on a different building.
struct CellSources {
    std::array<float, RayScene::maxLevels> heightM;
    std::array<std::uint32_t, RayScene::maxLevels> building;
    int count = 0;
};

/// Joins the sources of a lane's cells into runs. Only needs the cells where a source begins or ends; in
/// between, each source continues.
class UnfinishedRuns {
public:
    explicit UnfinishedRuns(const RunRule& rule = {}) : rule_(rule) {}

    /// `before`: the sources of the previous cell. Passes the runs that end there to `draw`.
    template <class Draw>
    void change(int cell, const CellSources& before, const CellSources& sources, const Draw& draw) {
        reachUpTo(cell - 1, before);
        Runs& next = runs_[1 - now_];
        for (int i = 0; i < sources.count; ++i)
            next[std::size_t(i)] =
                started(cell, sources.heightM[std::size_t(i)], sources.building[std::size_t(i)], draw);
        for (int i = 0; i < count_; ++i)
            if (runs_[now_][std::size_t(i)].last != goesOn) draw(runs_[now_][std::size_t(i)]);
        now_ = 1 - now_;
        count_ = sources.count;
    }

    /// Ends the lane after the cell `last`.
    template <class Draw>
    void finish(int last, const CellSources& sources, const Draw& draw) {
        change(last + 1, sources, {}, draw);
    }

private:
    static constexpr int goesOn = -1;

    void reachUpTo(int cell, const CellSources& sources) {
        for (int i = 0; i < count_; ++i) {
            runs_[now_][std::size_t(i)].last = cell;
            runs_[now_][std::size_t(i)].lastM = sources.heightM[std::size_t(i)];
        }
    }

    // Where the surface folds over, the two cells form a run of their own.
    template <class Draw>
    SourceRun started(int cell, float heightM, std::uint32_t building, const Draw& draw) {
        SourceRun run{cell, cell, heightM, heightM, building};
        for (int i = 0; i < count_; ++i) {
            SourceRun& open = runs_[now_][std::size_t(i)];
            if (open.last == goesOn || open.building != building || !rule_.sameSurface(open.lastM, heightM))
                continue;
            if (rule_.folds(open.lastM, heightM)) {
                draw({cell - 1, cell, open.lastM, heightM, building});
                break;
            }
            run.first = open.first;
            run.firstM = open.firstM;
            open.last = goesOn;
            break;
        }
        return run;
    }

    using Runs = std::array<SourceRun, RayScene::maxLevels>;
    RunRule rule_;
    std::array<Runs, 2> runs_{};  // open runs before and after the next change
    std::size_t now_ = 0;
    int count_ = 0;
};

/// The cells of a grid grouped into parallel lanes, each cell on exactly one: a shadow that moves in
/// `direction` stays on its lane to within half a cell. Lanes can be processed in parallel, because none
/// writes to another's cells.
///
/// Along the major axis (x if the direction is more east-west than north-south) a lane has one position per
/// column; across it, minor = lane + bend(major), where the bend is the direction's slope rounded to whole
/// cells. Every lane has all major positions; where it leaves the grid its positions are not cells.
class Lanes {
public:
    /// Number of adjacent lanes that are processed together.
    static constexpr int perBlock = 16;

    /// `direction`: metres, any length; zero counts as east.
    Lanes(const Grid& grid, glm::dvec2 direction);

    [[nodiscard]] int count() const { return laneCount_; }
    [[nodiscard]] int blocks() const { return (laneCount_ + perBlock - 1) / perBlock; }
    [[nodiscard]] bool alongX() const { return alongX_; }
    [[nodiscard]] int majors() const { return alongX_ ? grid_.columns : grid_.rows; }
    [[nodiscard]] int minors() const { return alongX_ ? grid_.rows : grid_.columns; }
    [[nodiscard]] const Grid& grid() const { return grid_; }

    /// Minor displacement of a lane from one major position to the next, before rounding: at most 1.
    [[nodiscard]] double slope() const { return slope_; }
    /// Minor position of lane 0 without its bend; negative if there are lanes that enter the grid late.
    [[nodiscard]] int firstLane() const { return firstLane_; }

    /// Minor position of a lane; a cell if it is 0 to minors() - 1.
    [[nodiscard]] int minor(int lane, int major) const {
        return lane + firstLane_ + bend_[std::size_t(major)];
    }
    /// minor(lane, major) - lane - firstLane() by major position.
    [[nodiscard]] const std::vector<int>& bend() const { return bend_; }
    [[nodiscard]] bool onGrid(int minor) const { return unsigned(minor) < unsigned(minors()); }

    /// Grid index of a cell.
    [[nodiscard]] std::size_t cellAt(int major, int minor) const {
        return alongX_ ? grid_.index(major, minor) : grid_.index(minor, major);
    }

private:
    Grid grid_;
    bool alongX_ = true;
    double slope_ = 0;
    int firstLane_ = 0;
    int laneCount_ = 0;
    std::vector<int> bend_;  // by major position; monotone
};

/// The masks of some blocks of lanes, as a target for drawing.
struct LaneMasks {
    int majors = 0;
    std::vector<ShadowMask> masks;  ///< blocks x lanes of a block x majors
    /// Blocks x majors: for each lane the first position from this one on, and the last one up to this one,
    /// whose mask is wanted; majors and -1 if there is none. Masks of unwanted positions are unspecified
    /// after drawing.
    std::vector<CacheLine<std::int32_t>> nextWanted, lastWanted;

    /// Leaves the contents unspecified.
    void resize(int majorCount, int blocks) {
        majors = majorCount;
        masks.resize(std::size_t(blocks) * Lanes::perBlock * std::size_t(majors));
        nextWanted.resize(std::size_t(blocks) * std::size_t(majors));
        lastWanted.resize(nextWanted.size());
    }
    [[nodiscard]] int blocks() const { return int(nextWanted.size()) / majors; }

    /// Sets the wanted positions of a block; wanted(major, lane).
    void ask(int block, const auto& wanted) {
        CacheLine<std::int32_t>*next = &nextWanted[firstLine(block)], *last = &lastWanted[firstLine(block)];
        CacheLine<std::int32_t> seen;
        std::ranges::fill(seen.values, -1);
        for (int major = 0; major < majors; last[major++] = seen)
            for (int lane = 0; lane < Lanes::perBlock; ++lane)
                seen.values[lane] = wanted(major, lane) ? major : seen.values[lane];
        std::ranges::fill(seen.values, majors);
        for (int major = majors - 1; major >= 0; next[major--] = seen)
            for (int lane = 0; lane < Lanes::perBlock; ++lane)
                seen.values[lane] = last[major].values[lane] == major ? major : seen.values[lane];
    }

    /// Index of major position 0 of a block in nextWanted and lastWanted.
    [[nodiscard]] std::size_t firstLine(int block) const { return std::size_t(block) * std::size_t(majors); }
    [[nodiscard]] ShadowMask* lane(int block, int lane) {
        return &masks[std::size_t(block * Lanes::perBlock + lane) * std::size_t(majors)];
    }
    [[nodiscard]] const ShadowMask* lane(int block, int lane) const {
        return &masks[std::size_t(block * Lanes::perBlock + lane) * std::size_t(majors)];
    }
};

/// The shadow sources of the cells of some blocks of lanes at one instant: the heights of up to `levels`
/// occluding points on the way to the sun, nearest first, each on a different building (paper, section 5: the
/// slices of the inverse accrual map). A Line holds the lanes of a block at one major position, so a shadow
/// that moves along a lane is read from consecutive Lines.
struct LaneSources {
    int levels = 0;
    int majors = 0;
    std::vector<CacheLine<float>>
        heightM;  ///< blocks x majors x levels; above the ground, metres; 0: no occluder
    std::vector<CacheLine<std::uint32_t>> building;  ///< the same shape; `nobody` if there is no occluder
    static constexpr std::uint32_t nobody = ~std::uint32_t{0};

    /// Leaves the contents unspecified.
    void resize(int levelCount, int majorCount, int blocks = 1) {
        levels = levelCount;
        majors = majorCount;
        heightM.resize(std::size_t(blocks) * std::size_t(majors) * std::size_t(levels));
        building.resize(heightM.size());
    }

    [[nodiscard]] std::size_t line(int block, int major, int level = 0) const {
        return (std::size_t(block) * std::size_t(majors) + std::size_t(major)) * std::size_t(levels) +
               std::size_t(level);
    }

    /// `lane`: within its block.
    [[nodiscard]] CellSources of(int block, int major, int lane) const {
        CellSources found;
        for (std::size_t at = line(block, major); found.count < levels; ++found.count, ++at) {
            const float height = heightM[at].values[lane];
            if (height <= 0) break;
            found.heightM[std::size_t(found.count)] = height;
            found.building[std::size_t(found.count)] = building[at].values[lane];
        }
        return found;
    }

    /// Whether the cell is in shadow.
    [[nodiscard]] bool shades(int block, int major, int lane) const {
        return heightM[line(block, major)].values[lane] > 0;
    }
};

static_assert(Lanes::perBlock == sizeof(CacheLine<float>) / sizeof(float));

}  // namespace noonmark
