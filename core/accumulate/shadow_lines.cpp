#include "core/accumulate/shadow_lines.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/accumulate/run_sweep.h"

namespace noonmark {

namespace {

// Where the shadow of a point one metre up lies, seen from below it: metres.
glm::dvec2 throwOf(glm::dvec3 sun) { return -glm::dvec2(sun.x, sun.y) / sun.z; }

// The sun's great circle meets a horizontal plane in a straight line, so one number tells where on it the
// shadow is.
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

/// Where an end of a run stands, without what cannot be passed to several instruction sets.
struct Way {
    const ShadowMask* before;
    RunEnd end;
    [[nodiscard]] ShadowMask operator()(int cell) const { return before[end.entry(cell)]; }
};

// Shades each cell of a run at the steps that `rear` has come to and `front` has not passed. Between where
// the rear end comes to and where the front began nothing needs looking up.
NOONMARK_EVERY_ISA void shadeSweep(const Way& rear, const Way& front, const RunSweep& sweep,
                                   ShadowMask* row) {
    const ShadowMask all = rear.before[StepTable::size + 2];
    const int rearTo = sweep.rearBehindFrom, frontFrom = sweep.frontAheadTo;
    const int near = std::min(rearTo, frontFrom), far = std::max(rearTo, frontFrom);
    for (int i = 0; i < near; ++i) row[i] |= rear(i);
    for (int i = rearTo; i < frontFrom; ++i) row[i] |= all;
    for (int i = frontFrom; i < rearTo; ++i) row[i] |= rear(i) & ~front(i);
    for (int i = far; i < sweep.count; ++i) row[i] |= all & ~front(i);
}

NOONMARK_EVERY_ISA void shadeFold(const Way& rear, const Way& front, int count, ShadowMask* row) {
    for (int i = 0; i < count; ++i) row[i] |= rear(i) & ~front(i);
}

constexpr Ints16 counting{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
constexpr Ints16 laneBits = 1 << counting;

/// A block's sources, in the order in which shadows move.
struct SourceLines {
    const Line<float>* heightM;
    const Line<std::uint32_t>* building;
    std::ptrdiff_t step;  // lines from one place to the next; negative where shadows move against the lanes
    int levels;
};

// changed[at]: a bit for each lane on which the sources of a place do not simply go on from the one before. A
// few more do no harm: a little less than what folds counts, too.
NOONMARK_EVERY_ISA void markChanges(const SourceLines& lines, int places, const RunRule& rule,
                                    std::uint16_t* changed) {
    const float steepest = rule.steepestM;
    const float lowest =
        std::max(-steepest, 0.9999F * RunRule::foldedBy / std::max(rule.cellsPerMetre, 1e-9F));
    const Ints16 zero{};
    for (int at = 1; at < places; ++at) {
        Ints16 other{}, beyond{};  // sign bits of what must not be negative
        for (int level = 0; level < lines.levels; ++level) {
            const std::ptrdiff_t now = at * lines.step + level, before = now - lines.step;
            const Floats16 higher = reinterpret_cast<const Floats16&>(lines.heightM[now]) -
                                    reinterpret_cast<const Floats16&>(lines.heightM[before]);
            other |= reinterpret_cast<const Ints16&>(lines.building[now]) ^
                     reinterpret_cast<const Ints16&>(lines.building[before]);
            const Floats16 below = steepest - higher, above = higher - lowest;
            beyond |= reinterpret_cast<const Ints16&>(below) | reinterpret_cast<const Ints16&>(above);
        }
        other = other != zero;
        beyond = beyond < zero;
        Ints16 bits = (other | beyond) & laneBits;
        bits |= __builtin_shuffle(bits, counting ^ 8);
        bits |= __builtin_shuffle(bits, counting ^ 4);
        bits |= __builtin_shuffle(bits, counting ^ 2);
        changed[at] = std::uint16_t(bits[0] | bits[1]);
    }
}

/// Draws one block of lanes.
class BlockDrawing {
public:
    BlockDrawing(const LinePass& pass, const LaneSources& sources, int block, LaneMasks& masks)
        : pass_(pass), sources_(sources), block_(block), masks_(masks) {
        runs_.fill(OpenRuns(pass.rule));
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
    // Rows of masks lie in the order of motion while they are drawn into.
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
        if (!wanted(lane, run.first, run.first + sweep.count)) return;
        ShadowMask* row = masks_.lane(block_, lane) + run.first;
        const ShadowMask* before = pass_.table.before.data();
        shadeSweep({before, sweep.rear}, {before, sweep.front}, sweep, row);
        if (sweep.folds) shadeFold({before, sweep.foldedRear}, {before, sweep.foldedFront}, sweep.count, row);
    }

    // Whether anybody asks for one of the places [first, end).
    [[nodiscard]] bool wanted(int lane, int first, int end) const {
        const Line<std::int32_t>* before = masks_.wanted(block_);
        const int low = pass_.reversed ? masks_.majors - end : first,
                  high = pass_.reversed ? masks_.majors - first : end;
        return before[high].values[lane] != before[low].values[lane];
    }

    [[nodiscard]] int majorAt(int at) const { return pass_.reversed ? sources_.majors - 1 - at : at; }
    [[nodiscard]] CellSources sourcesAt(int at, int lane) const {
        return sources_.of(block_, majorAt(at), lane);
    }

    const LinePass& pass_;
    const LaneSources& sources_;
    int block_;
    LaneMasks& masks_;
    std::array<OpenRuns, Lanes::perBlock> runs_;
    std::vector<std::uint16_t> changed_;
};

class ProcessorDrawer final : public ShadowLineDrawer {
public:
    Result<void> draw(const LinePass& pass, const LaneSources& sources, LaneMasks& masks) override {
        const int blocks = int(masks.wantedBefore.size()) / (masks.majors + 1);
        for (int block = 0; block < blocks; ++block) BlockDrawing(pass, sources, block, masks).draw();
        return {};
    }
    [[nodiscard]] int blocksAtOnce(int) const override { return 1; }
    [[nodiscard]] std::string describe() const override { return "lines drawn on the processor"; }
};

}  // namespace

ShadowMotion motionForward(const SunInterval& interval) {
    return {throwOf(interval.last) - throwOf(interval.first), fractions(interval)};
}

ShadowMotion motionBackward(const SunInterval& interval) {
    ShadowMotion motion = motionForward(interval);
    motion.shift = -motion.shift;
    for (double& fraction : motion.fraction) fraction = 1 - fraction;
    return motion;
}

StepTable::StepTable(const std::vector<double>& fraction) {
    // Positions along the line: the steps themselves forward, the steps in reverse backward.
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
