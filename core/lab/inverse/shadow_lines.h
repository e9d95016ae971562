#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/engines/common/run_counter.h"
#include "core/lab/graph/interval_engine.h"
#include "core/lab/inverse/lanes.h"

namespace noonmark {

/// How shadows move over flat ground during an interval: at step k, the shadow of a point h metres up is
/// displaced from its start by h x fraction[k] x shift.
struct ShadowMotion {
    glm::dvec2 shift{};  ///< metres per metre of height, from the start of the line to its end
    std::vector<double>
        fraction;  ///< one per step, 0 to 1, monotone: rising forward from t1, falling backward from tn
};
ShadowMotion computeForwardMotion(
    const SunInterval& interval);  ///< lines begin at the shadow's position at the first step
ShadowMotion computeBackwardMotion(
    const SunInterval& interval);  ///< lines begin at the shadow's position at the last step

/// A lookup table for the steps that have been passed at a position along a line, indexed by the fraction of
/// the line. Used by all drawers.
class StepTable {
public:
    static constexpr int size = 4096;
    explicit StepTable(const std::vector<double>& fraction);

    /// Bits of the steps up to a fraction of the line; all steps beyond its end. Entry 0 is for positions
    /// before the start; then follow `size` entries to the end and two beyond it.
    std::vector<ShadowMask> before;
};

/// One pass over the lanes: forward from the first step, or backward from the last.
struct LinePass {
    StepTable table;
    RunRule rule;
    bool reversed = false;  ///< shadows move towards lower major positions

    /// `steepestM`: see RunRule; for the instant of the sources.
    LinePass(const Lanes& lanes, const ShadowMotion& motion, float steepestM);
};

/// Draws the line of every source into the masks of the positions: bit k is set where the shadow lies at step
/// k. Neighbours on a lane whose occluding points are adjacent on one building are drawn as one run: it moves
/// as a whole, and shades a cell from the step at which its front reaches the cell to the step at which its
/// rear leaves it.
class ShadowLineDrawer {
public:
    virtual ~ShadowLineDrawer() = default;
    /// ORs into `masks`, which has as many blocks as `sources`. May be called concurrently if blocksAtOnce()
    /// is 1.
    [[nodiscard]] virtual Result<void> draw(const LinePass& pass, const LaneSources& sources,
                                            LaneMasks& masks) = 0;
    /// How many blocks a call should have: 1 for a drawer that leaves parallelism to its callers, all of
    /// `blocks` for a separate device.
    [[nodiscard]] virtual int blocksAtOnce(int blocks) const = 0;
    [[nodiscard]] virtual std::string describe() const = 0;
};

/// Draws on the processor.
std::unique_ptr<ShadowLineDrawer> makeShadowLineDrawer();

/// Position of one end of a run on its way, as an entry of the step table: `start` as seen from the first of
/// some cells, and `perCell` more for each following cell.
struct RunEnd {
    float start = 0;
    float perCell = 0;
    /// `length`: cells moved during the whole interval; the first cell is `ahead` cells before the end's
    /// start.
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

/// Some cells of a run, counted from its first. Each is shaded at the steps that `rear` has reached and
/// `front` has not passed.
struct SweepPart {
    RunEnd rear, front;
    int first = 0, end = 0;  ///< cells that may be shaded
    /// From cell rearBehindFrom on, `rear` is behind at all steps; before cell frontAheadTo, `front` is ahead
    /// at all steps.
    int rearBehindFrom = 0, frontAheadTo = 0;

    [[nodiscard]] ShadowMask steps(int i, const StepTable& table) const {
        if (i < first || i >= end) return 0;
        return table.before[std::size_t(rear.entry(i))] & ~table.before[std::size_t(front.entry(i))];
    }
};

/// The cells that a run shades during an interval: `count` cells from its first on. Each end of the run
/// reaches `reach` beyond its cell's centre. If the surface folds over, the steps between the ends in reverse
/// order are shaded too, whichever end is ahead.
struct RunSweep {
    /// How far each end reaches beyond its cell's centre, cells. The edge may lie anywhere up to the next
    /// centre, on average halfway. But each line is drawn twice, from the first step and from the last, and
    /// the farther of two such guesses is on average a sixth of a cell too far.
    static constexpr float reach = 0.5F - 1.0F / 6;

    int count = 0;
    bool folds = false;
    SweepPart plain, folded;

    /// `cells`: number of cells of the lane.
    RunSweep(const SourceRun& run, const RunRule& rule, int cells) {
        const float first = run.firstM * rule.cellsPerMetre, last = run.lastM * rule.cellsPerMetre;
        folds = run.first < run.last && rule.folds(run.firstM, run.lastM);
        count =
            std::max(endOf(run.last, last, cells), folds ? endOf(run.first, first, cells) : 0) - run.first;
        const int width = run.last - run.first;
        plain = {RunEnd::over(first, reach),
                 RunEnd::over(last, -float(width) - reach),
                 0,
                 count,
                 cellsIn(first) + 2,
                 width + 1};
        if (folds) fold(first, last, float(width));
    }

    /// Steps at which cell i of `count` is shaded.
    [[nodiscard]] ShadowMask steps(int i, const StepTable& table) const {
        return plain.steps(i, table) | (folds ? folded.steps(i, table) : 0);
    }

private:
    // The first end moves farther than the last and overtakes it: from some cell on nothing is left between
    // them, and the part in reverse order begins near that cell. The limits allow for one uncertain cell.
    void fold(float first, float last, float width) {
        const float parts = first - last;
        plain.end = std::min(count, cellsIn((reach * last + (width + reach) * first) / parts) + 2);
        folded = {RunEnd::over(last, reach - width),
                  RunEnd::over(first, -reach),
                  0,
                  count,
                  cellsIn(last + width) + 2,
                  1};
        folded.first = std::max(0, cellsIn(((width - reach) * first - reach * last) / parts) - 1);
    }

    // Lines of a low sun may be longer than any int.
    static int cellsIn(float length) { return int(std::min(length, 1e6F)); }
    static int endOf(int cell, float length, int cells) {
        return std::min(cell + 1 + cellsIn(length + 0.5F), cells);
    }
};

/// Cells of a run, counted from its first.
struct CellRange {
    int first = 0;
    int end = 0;
};

/// Sets in `row` the steps at which a part of a run shades its cells, for those in `cells`. `before`: that of
/// the StepTable. Cost: some 2 ns per cell.
void shadeCells(const ShadowMask* before, const SweepPart& part, const CellRange& cells, ShadowMask* row);

/// A block's sources in the order in which shadows move.
struct SourceLines {
    const CacheLine<float>* heightM;
    const CacheLine<std::uint32_t>* building;
    std::ptrdiff_t step;  ///< Lines from one position to the next; negative if shadows move against the lanes
    int levels;
};

/// changed[at], for `at` from 1 to places - 1: a bit for each lane on which the sources of a position do not
/// simply continue those of the previous one. Extra bits do no harm; changes slightly below the folding limit
/// are marked too.
void markChanges(const SourceLines& lines, int places, const RunRule& rule, std::uint16_t* changed);

}  // namespace noonmark
