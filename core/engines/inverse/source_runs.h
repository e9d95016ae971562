#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "core/engines/ray/ray_scene.h"

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

}  // namespace noonmark
