#pragma once

#include <algorithm>

#include "core/accumulate/shadow_lines.h"
#include "core/accumulate/source_runs.h"

namespace noonmark {

/// Where one end of a run stands on its way: at entry `start` of the step table as seen from the first of
/// some cells, and `perCell` more from each next.
struct RunEnd {
    float start = 0;
    float perCell = 0;
    /// `length`: cells moved in the whole interval; the first cell is `ahead` cells before the end's start.
    static RunEnd over(float length, float ahead) {
        const float perCell = float(StepTable::size) / std::max(length, 1e-6F);
        return {ahead * perCell, perCell};
    }
    [[nodiscard]] int entry(int cell) const {
        constexpr float beyondTable = StepTable::size + 1;
        const float at = start + float(cell) * perCell;
        return int((at < 0 ? -1 : at < beyondTable ? at : beyondTable) + 1);
    }
};

/// What a run shades in an interval: `count` cells from its first on, each at the steps that `rear` has come
/// to and `front` has not passed. Each end reaches half a cell beyond its cell's centre. Where the surface
/// folds over, whichever end is ahead, the steps between the ends in the other order too.
struct RunSweep {
    /// How far each end reaches beyond its cell's centre, cells. The edge lies anywhere up to the next
    /// centre, in the mean at half of the way; but each line is drawn twice, from the first step and from the
    /// last, and the farther of two such guesses is in the mean a sixth of a cell too far.
    static constexpr float reach = 0.5F - 1.0F / 6;

    int count = 0;
    RunEnd rear, front;
    /// Of these cells: from this one on `rear` is behind all the time; before this one `front` is ahead.
    int rearBehindFrom = 0, frontAheadTo = 0;
    bool folds = false;
    RunEnd foldedRear, foldedFront;

    /// `cells`: of the lane.
    RunSweep(const SourceRun& run, const RunRule& rule, int cells) {
        const float firstLength = run.firstM * rule.cellsPerMetre,
                    lastLength = run.lastM * rule.cellsPerMetre;
        const auto width = float(run.last - run.first);
        folds = run.first < run.last && rule.folds(run.firstM, run.lastM);
        count =
            std::max(endOf(run.last, lastLength, cells), folds ? endOf(run.first, firstLength, cells) : 0) -
            run.first;
        rear = RunEnd::over(firstLength, reach);
        front = RunEnd::over(lastLength, -width - reach);
        rearBehindFrom = std::min(count, int(std::min(firstLength, 1e6F)) + 2);
        frontAheadTo = std::min(count, run.last - run.first + 1);
        foldedRear = RunEnd::over(lastLength, reach - width);
        foldedFront = RunEnd::over(firstLength, -reach);
    }

    /// Steps at which cell i of `count` is shaded.
    [[nodiscard]] ShadowMask steps(int i, const StepTable& table) const {
        ShadowMask mask = between(rear, front, i, table);
        if (folds) mask |= between(foldedRear, foldedFront, i, table);
        return mask;
    }

private:
    // A low sun draws lines past any int.
    static int endOf(int cell, float length, int cells) {
        return std::min(cell + 1 + int(std::min(length, 1e6F) + 0.5F), cells);
    }
    static ShadowMask between(const RunEnd& rear, const RunEnd& front, int i, const StepTable& table) {
        return table.before[std::size_t(rear.entry(i))] & ~table.before[std::size_t(front.entry(i))];
    }
};

}  // namespace noonmark
