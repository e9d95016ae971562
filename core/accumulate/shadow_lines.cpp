#include "core/accumulate/shadow_lines.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/accumulate/change_map.h"
#include "core/accumulate/horizon/lanes16.h"
#include "core/accumulate/lanes.h"
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

// Shades each of some cells at the steps that `rear` has come to and `front` has not passed.
NOONMARK_EVERY_ISA void shadeBetween(const ShadowMask* before, RunEnd rear, RunEnd front, int count,
                                     ShadowMask* row) {
    for (int i = 0; i < count; ++i) row[i] |= before[rear.entry(i)] & ~before[front.entry(i)];
}

/// The masks of one lane, in the order in which shadows move over it.
class LanePen {
public:
    void start(std::size_t cells) {
        row_.resize(cells);
        open_.assign(cells + 1, 0);
    }

    /// In order.
    void setMask(int at, ShadowMask mask) {
        row_[std::size_t(at)] = mask;
        open_[std::size_t(at) + 1] = open_[std::size_t(at)] + (mask != ~ShadowMask{0});
    }

    void draw(const SourceRun& run, const StepTable& table, const RunRule& rule) {
        const RunSweep sweep(run, rule, int(row_.size()));
        if (open_[std::size_t(run.first + sweep.count)] == open_[std::size_t(run.first)]) return;
        ShadowMask* row = &row_[std::size_t(run.first)];
        const ShadowMask* before = table.before.data();
        shadeBetween(before, sweep.rear, sweep.front, sweep.count, row);
        if (sweep.folds) shadeBetween(before, sweep.foldedRear, sweep.foldedFront, sweep.count, row);
    }

    [[nodiscard]] ShadowMask mask(int at) const { return row_[std::size_t(at)]; }

private:
    std::vector<ShadowMask> row_;
    std::vector<std::uint32_t> open_;  // cells before this one whose masks were not full
};

struct DrawWith {
    LanePen& pen;
    const StepTable& table;
    const RunRule& rule;
    void operator()(const SourceRun& run) const { pen.draw(run, table, rule); }
};

/// Neighbouring lanes walked side by side, so that the cells at hand lie next to each other in memory.
class LaneBlock {
public:
    static int lanesABlock(const Lanes& lanes) { return lanes.alongX() ? 1 : 64; }

    LaneBlock(const Grid& grid, const Lanes& lanes, const StepTable& table, const RunRule& rule,
              bool reversed)
        : lanes_(lanes), size_(grid.size()), table_(table), rule_(rule), reversed_(reversed) {}

    void draw(int first, int end, const ShadowSources& sources, const ChangeMap& changes,
              std::span<ShadowMask> masks) {
        start(first, end);
        for (Lane& lane : lanesAtWork_)
            forEachCell(lane, [&](int at, std::size_t cell) { lane.pen.setMask(at, masks[cell]); });
        for (Lane& lane : lanesAtWork_) begin(lane, sources);
        forEachChange(changes, [&](Lane& lane, int at, std::size_t cell, std::size_t before) {
            lane.runs.change(at, sourcesOf(sources, before), sourcesOf(sources, cell),
                             DrawWith{lane.pen, table_, rule_});
        });
        for (Lane& lane : lanesAtWork_) finish(lane, sources);
        for (Lane& lane : lanesAtWork_)
            forEachCell(lane, [&](int at, std::size_t cell) { masks[cell] = lane.pen.mask(at); });
    }

private:
    struct Lane {
        int number = 0;
        Lanes::Stretch stretch;
        OpenRuns runs;
        LanePen pen;
    };

    void start(int first, int end) {
        firstLane_ = first;
        lanesAtWork_.resize(std::size_t(end - first));
        from_ = std::numeric_limits<int>::max();
        to_ = 0;
        for (int number = first; number < end; ++number) {
            Lane& lane = lanesAtWork_[std::size_t(number - first)];
            lane.number = number;
            lane.stretch = lanes_.stretch(number);
            lane.runs = OpenRuns(rule_);
            lane.pen.start(std::size_t(lane.stretch.end - lane.stretch.first));
            from_ = std::min(from_, lane.stretch.first);
            to_ = std::max(to_, lane.stretch.end);
        }
    }

    // Where the lane is entered and left, in the order of motion.
    [[nodiscard]] std::size_t firstCell(const Lane& lane) const {
        return lanes_.cell(lane.number, reversed_ ? lane.stretch.end - 1 : lane.stretch.first);
    }
    [[nodiscard]] std::size_t lastCell(const Lane& lane) const {
        return lanes_.cell(lane.number, reversed_ ? lane.stretch.first : lane.stretch.end - 1);
    }

    void begin(Lane& lane, const ShadowSources& sources) const {
        if (lane.stretch.first == lane.stretch.end) return;
        lane.runs.change(0, {}, sourcesOf(sources, firstCell(lane)), DrawWith{lane.pen, table_, rule_});
    }

    void finish(Lane& lane, const ShadowSources& sources) const {
        const auto [first, end] = lane.stretch;
        if (first == end) return;
        lane.runs.finish(end - first - 1, sourcesOf(sources, lastCell(lane)),
                         DrawWith{lane.pen, table_, rule_});
    }

    /// The cells of one major position: those of lanes side by side lie side by side in memory, where there
    /// is more than one.
    struct Front {
        int major = 0;
        int firstLane = 0;
        std::size_t count = 0;
        std::size_t cell = 0;    ///< of the first lane
        std::size_t before = 0;  ///< the one before it in the order of motion, where there is one
    };

    /// body(front), in the order of motion.
    template <class Body>
    void forEachFront(const Body& body) const {
        for (int k = from_; k < to_; ++k) {
            const int major = reversed_ ? from_ + to_ - 1 - k : k;
            const int majorBefore = std::clamp(reversed_ ? major + 1 : major - 1, from_, to_ - 1);
            const auto [low, high] = lanes_.lanesAt(major);
            const int first = std::max(low, firstLane_);
            const int end = std::min(high, firstLane_ + int(lanesAtWork_.size()));
            if (first < end)
                body(Front{major, first, std::size_t(end - first), lanes_.cell(first, major),
                           lanes_.cell(first, majorBefore)});
        }
    }

    Lane& laneOf(const Front& front, std::size_t aside) {
        return lanesAtWork_[std::size_t(front.firstLane - firstLane_) + aside];
    }

    [[nodiscard]] int position(const Lane& lane, int major) const {
        return reversed_ ? lane.stretch.end - 1 - major : major - lane.stretch.first;
    }

    /// body(position in the order of motion, cell).
    template <class Body>
    void forEachCell(const Lane& lane, const Body& body) const {
        const auto [first, end] = lane.stretch;
        for (int at = 0; at < end - first; ++at)
            body(at, lanes_.cell(lane.number, reversed_ ? end - 1 - at : first + at));
    }

    /// body(lane, position in the order of motion, cell, the cell before it): where the sources change. A
    /// change is marked between a cell and the one before it in the order of major positions.
    template <class Body>
    void forEachChange(const ChangeMap& changes, const Body& body) {
        forEachFront([&](const Front& front) {
            changes.forEachFrom(reversed_ ? front.before : front.cell, front.count, [&](std::size_t aside) {
                Lane& lane = laneOf(front, aside);
                if (const int at = position(lane, front.major); at > 0)
                    body(lane, at, front.cell + aside, front.before + aside);
            });
        });
    }

    [[nodiscard]] CellSources sourcesOf(const ShadowSources& sources, std::size_t cell) const {
        CellSources found;
        for (std::size_t place = cell; found.count < sources.levels; ++found.count, place += size_) {
            if (sources.heightM[place] <= 0) break;
            found.heightM[std::size_t(found.count)] = sources.heightM[place];
            found.building[std::size_t(found.count)] = sources.building[place];
        }
        return found;
    }

    const Lanes& lanes_;
    std::size_t size_;
    const StepTable& table_;
    RunRule rule_;
    bool reversed_;
    std::vector<Lane> lanesAtWork_;
    int firstLane_ = 0;
    int from_ = 0, to_ = 0;  // major positions of the block
};

class ProcessorDrawer final : public ShadowLineDrawer {
public:
    Result<void> draw(const Grid& grid, const ShadowSources& sources, const ShadowMotion& motion,
                      std::span<ShadowMask> masks, std::stop_token stop) override {
        const Lanes lanes(grid, motion.shift);
        const StepTable table(motion.fraction);
        const float alongLanes = float((lanes.alongX() ? motion.shift.x : motion.shift.y) / grid.cellM);
        const RunRule rule{std::abs(alongLanes), sources.steepestM};
        const ChangeMap changes(grid, lanes, sources, {alongLanes, sources.steepestM});
        const int wide = LaneBlock::lanesABlock(lanes);
        tbb::parallel_for(
            tbb::blocked_range<int>(0, (lanes.count() + wide - 1) / wide), [&](const auto& range) {
                LaneBlock block(grid, lanes, table, rule, alongLanes < 0);
                for (int i = range.begin(); i < range.end() && !stop.stop_requested(); ++i)
                    block.draw(i * wide, std::min((i + 1) * wide, lanes.count()), sources, changes, masks);
            });
        if (stop.stop_requested()) return cancelled();
        return {};
    }

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

std::unique_ptr<ShadowLineDrawer> makeShadowLineDrawer() { return std::make_unique<ProcessorDrawer>(); }

}  // namespace noonmark
