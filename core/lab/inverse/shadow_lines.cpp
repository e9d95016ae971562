#include "core/lab/inverse/shadow_lines.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace noonmark {

namespace {

// Offset of the shadow of a point one metre up from the point below it, metres.
glm::dvec2 throwOf(glm::dvec3 sun) { return -glm::dvec2(sun.x, sun.y) / sun.z; }

// The sun's great circle intersects a horizontal plane in a straight line, so one number gives the shadow's
// position on it.
std::vector<double> fractions(const SunInterval& interval) {
    const glm::dvec2 start = throwOf(interval.first);
    const glm::dvec2 way = throwOf(interval.last) - start;
    const double length2 = way.x * way.x + way.y * way.y;
    std::vector<double> result;
    for (int step = 0; step < interval.steps; ++step) {
        const glm::dvec2 at = throwOf(interval.at(step)) - start;
        result.push_back(length2 == 0 ? 0 : std::clamp((at.x * way.x + at.y * way.y) / length2, 0.0, 1.0));
    }
    return result;
}

/// Draws one block of lanes.
class BlockDrawing {
public:
    BlockDrawing(const LinePass& pass, const LaneSources& sources, int block, LaneMasks& masks)
        : pass_(pass), sources_(sources), block_(block), masks_(masks) {
        runs_.fill(UnfinishedRuns(pass.rule));
    }

    void draw() {
        turnRows();
        findChanges();
        for (int lane = 0; lane < Lanes::perBlock; ++lane) change(lane, 0, {}, sourcesAt(0, lane));
        for (int at = 1; at < sources_.majors; ++at)
            for (unsigned bits = changed_[std::size_t(at)]; bits != 0; bits &= bits - 1) {
                const int lane = std::countr_zero(bits);
                change(lane, at, sourcesAt(at - 1, lane), sourcesAt(at, lane));
            }
        for (int lane = 0; lane < Lanes::perBlock; ++lane)
            change(lane, sources_.majors, sourcesAt(sources_.majors - 1, lane), {});
        turnRows();
    }

private:
    // While being drawn, rows of masks are in the order of motion.
    void turnRows() {
        if (!pass_.reversed) return;
        for (int lane = 0; lane < Lanes::perBlock; ++lane)
            std::reverse(masks_.lane(block_, lane), masks_.lane(block_, lane) + masks_.majors);
    }

    void findChanges() {
        changed_.resize(std::size_t(sources_.majors));
        const std::size_t first = sources_.line(block_, majorAt(0));
        markChanges({&sources_.heightM[first], &sources_.building[first],
                     pass_.reversed ? -sources_.levels : sources_.levels, sources_.levels},
                    sources_.majors, pass_.rule, changed_.data());
    }

    void change(int lane, int at, const CellSources& before, const CellSources& now) {
        runs_[std::size_t(lane)].change(at, before, now, [&](const SourceRun& run) { drawRun(lane, run); });
    }

    void drawRun(int lane, const SourceRun& run) {
        const RunSweep sweep(run, pass_.rule, masks_.majors);
        const CellRange cells = wanted(lane, run.first, sweep.count);
        if (cells.first >= cells.end) return;
        ShadowMask* row = masks_.lane(block_, lane) + run.first;
        const ShadowMask* before = pass_.table.before.data();
        shadeCells(before, sweep.plain, cells, row);
        if (sweep.folds) shadeCells(before, sweep.folded, cells, row);
    }

    // Of `count` cells from position `first` on, the range from the first to the last wanted one.
    [[nodiscard]] CellRange wanted(int lane, int first, int count) const {
        const std::size_t line = masks_.firstLine(block_);
        const auto next = [&](int major) {
            return masks_.nextWanted[line + std::size_t(major)].values[lane];
        };
        const auto last = [&](int major) {
            return masks_.lastWanted[line + std::size_t(major)].values[lane];
        };
        const int end = first + count, turned = masks_.majors - 1;
        if (pass_.reversed)
            return {turned - last(turned - first) - first, turned - next(turned + 1 - end) + 1 - first};
        return {next(first) - first, last(end - 1) + 1 - first};
    }

    [[nodiscard]] int majorAt(int at) const { return pass_.reversed ? sources_.majors - 1 - at : at; }
    [[nodiscard]] CellSources sourcesAt(int at, int lane) const {
        return sources_.of(block_, majorAt(at), lane);
    }

    const LinePass& pass_;
    const LaneSources& sources_;
    int block_;
    LaneMasks& masks_;
    std::array<UnfinishedRuns, Lanes::perBlock> runs_;
    std::vector<std::uint16_t> changed_;
};

class ProcessorDrawer final : public ShadowLineDrawer {
public:
    Result<void> draw(const LinePass& pass, const LaneSources& sources, LaneMasks& masks) override {
        for (int block = 0; block < masks.blocks(); ++block) BlockDrawing(pass, sources, block, masks).draw();
        return {};
    }
    [[nodiscard]] int blocksAtOnce(int) const override { return 1; }
    [[nodiscard]] std::string describe() const override { return "lines drawn on the processor"; }
};

}  // namespace

ShadowMotion computeForwardMotion(const SunInterval& interval) {
    return {throwOf(interval.last) - throwOf(interval.first), fractions(interval)};
}

ShadowMotion computeBackwardMotion(const SunInterval& interval) {
    ShadowMotion motion = computeForwardMotion(interval);
    motion.shift = -motion.shift;
    for (double& fraction : motion.fraction) fraction = 1 - fraction;
    return motion;
}

StepTable::StepTable(const std::vector<double>& fraction) {
    // Positions along the line in ascending order: the steps themselves if forward, the steps in reverse if
    // backward.
    const bool falling = fraction.size() > 1 && fraction.front() > fraction.back();
    std::vector<double> ordered = fraction;
    if (falling) std::reverse(ordered.begin(), ordered.end());
    const int steps = int(ordered.size());
    before.push_back(0);
    std::vector<ShadowMask> upTo{0};
    for (int position = 0; position < steps; ++position)
        upTo.push_back(upTo.back() | ShadowMask{1} << (falling ? steps - 1 - position : position));
    for (int entry = 0; entry < size + 2; ++entry) {
        const double share = double(entry) / size;
        const auto beyond = std::upper_bound(ordered.begin(), ordered.end(), entry >= size ? 2.0 : share);
        before.push_back(upTo[std::size_t(beyond - ordered.begin())]);
    }
}

LinePass::LinePass(const Lanes& lanes, const ShadowMotion& motion, float steepestM) : table(motion.fraction) {
    const auto along = float((lanes.alongX() ? motion.shift.x : motion.shift.y) / lanes.grid().cellM);
    rule = {std::abs(along), steepestM};
    reversed = along < 0;
}

std::unique_ptr<ShadowLineDrawer> makeShadowLineDrawer() { return std::make_unique<ProcessorDrawer>(); }

}  // namespace noonmark
