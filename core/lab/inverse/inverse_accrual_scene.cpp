#include "core/lab/inverse/inverse_accrual_map.h"

#include <tbb/combinable.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <numeric>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/units.h"
#include "core/lab/inverse/lanes.h"
#include "core/receivers/receivers.h"
#include "core/simd/cache_line.h"

namespace noonmark {

namespace {

/// The receivers at the positions of a block of lanes.
class LaneReceivers {
public:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    /// The lanes must be over the receivers' grid extended by `marginCells` on each side. 4 bytes per cell.
    LaneReceivers(const Receivers& receivers, int marginCells);

    /// numbers[major].values[lane]: the receiver's index in Receivers::cells, or none.
    void find(const Lanes& lanes, int block, std::vector<CacheLine<std::uint32_t>>& numbers) const;

private:
    std::vector<std::uint32_t> ofCell_;  // for each cell of the extended grid
};

LaneReceivers::LaneReceivers(const Receivers& receivers, int marginCells) {
    const Grid& grid = receivers.grid;
    const std::size_t wideColumns = std::size_t(grid.columns) + 2 * std::size_t(marginCells);
    ofCell_.assign(wideColumns * (std::size_t(grid.rows) + 2 * std::size_t(marginCells)), none);
    for (std::size_t i = 0; i < receivers.cells.size(); ++i) {
        const int column = int(receivers.cells[i]) % grid.columns,
                  row = int(receivers.cells[i]) / grid.columns;
        ofCell_[std::size_t(row + marginCells) * wideColumns + std::size_t(column + marginCells)] =
            std::uint32_t(i);
    }
}

void LaneReceivers::find(const Lanes& lanes, int block,
                         std::vector<CacheLine<std::uint32_t>>& numbers) const {
    numbers.resize(std::size_t(lanes.majors()));
    const std::size_t across = lanes.cellAt(0, 1) - lanes.cellAt(0, 0);
    for (int major = 0; major < lanes.majors(); ++major) {
        auto& values = numbers[std::size_t(major)].values;
        const int firstMinor = lanes.minor(block * Lanes::perBlock, major);
        const std::uint32_t* column = &ofCell_[lanes.cellAt(major, 0)];
        for (int lane = 0; lane < Lanes::perBlock; ++lane)
            values[lane] =
                lanes.onGrid(firstMinor + lane) ? column[std::size_t(firstMinor + lane) * across] : none;
    }
}

/// Some steps of an interval, with the shadow sources at both ends and the motion of the shadows in between.
struct LineLeg {
    const SourceInstant& atFirst;
    const SourceInstant& atLast;
    SunInterval interval;
    int firstStep;  ///< first step of the leg, in the masks
    LinePass forward, backward;

    LineLeg(const Lanes& lanes, const SourceInstant& first, const SourceInstant& last,
            const SunInterval& interval, int firstStep);
};

/// Working memory for some blocks of lanes, reused for the following blocks.
struct BlockWork {
    LaneSources first, last;
    LaneMasks masks;
    std::vector<std::vector<CacheLine<std::uint32_t>>> numbers;  ///< receiver numbers, one entry per block
};

/// Draws legs, all over the same lanes.
class LegDrawer {
public:
    /// All arguments must outlive it.
    LegDrawer(const Lanes& lanes, const LaneReceivers& receivers, ShadowLineDrawer& drawer, int levels)
        : lanes_(lanes), receivers_(receivers), drawer_(drawer), levels_(levels) {}

    /// Sets the bits of the leg's steps to the receivers' shadow; bits of earlier steps are kept, those of
    /// later steps are cleared. Returns the blocks, ascending, where most receivers have a full list at both
    /// ends, so that ignored occluders may matter in between. All cores.
    Result<std::vector<int>> draw(const LineLeg& leg, std::span<const int> blocks,
                                  std::span<ShadowMask> masks, const std::stop_token& stop) const;

    /// Returns those blocks in which more than the share `maxMissed` of the receivers are in shadow at the
    /// instant although their masks, bit `step`, are not. Checks one receiver in four. All cores.
    [[nodiscard]] std::vector<int> missing(const SourceInstant& instant, int step, double maxMissed,
                                           std::span<const int> blocks, std::span<const ShadowMask> masks,
                                           const std::stop_token& stop) const;

private:
    Result<void> drawBatch(const LineLeg& leg, std::span<const int> blocks, BlockWork& work) const;
    void prepare(const LineLeg& leg, int block, int slot, BlockWork& work) const;

    const Lanes& lanes_;
    const LaneReceivers& receivers_;
    ShadowLineDrawer& drawer_;
    int levels_;
};

constexpr double crowdedShare = 0.4;

// At a leg's first and last step the sources give the shadow exactly; lines do not.
void takeMasks(const LineLeg& leg, const BlockWork& work, int slot, std::span<ShadowMask> masks) {
    const ShadowMask lastBit = ShadowMask{1} << (leg.interval.steps - 1), between = ~(lastBit | 1);
    const ShadowMask kept = fullMask(leg.firstStep);
    for (int major = 0; major < work.masks.majors; ++major)
        for (int lane = 0; lane < Lanes::perBlock; ++lane) {
            const std::uint32_t number = work.numbers[std::size_t(slot)][std::size_t(major)].values[lane];
            if (number == LaneReceivers::none) continue;
            const ShadowMask known = (work.first.shades(slot, major, lane) ? 1 : 0) |
                                     (work.last.shades(slot, major, lane) ? lastBit : 0);
            const ShadowMask drawn = (work.masks.lane(slot, lane)[major] & between) | known;
            masks[number] = (masks[number] & kept) | drawn << leg.firstStep;
        }
}

/// Share of receivers that satisfy is(major, lane, number), among one in `stride` of a block's receivers.
template <class Is>
double shareOf(const std::vector<CacheLine<std::uint32_t>>& numbers, int stride, const Is& is) {
    std::size_t checked = 0, count = 0;
    for (int major = 0; major < int(numbers.size()); ++major)
        for (int lane = major % stride; lane < Lanes::perBlock; lane += stride) {
            const std::uint32_t number = numbers[std::size_t(major)].values[lane];
            if (number == LaneReceivers::none) continue;
            ++checked;
            count += std::size_t(is(major, lane, number));
        }
    return checked == 0 ? 0 : double(count) / double(checked);
}

bool crowded(const BlockWork& work, int slot) {
    const auto full = [&](const LaneSources& sources, int major, int lane) {
        return sources.heightM[sources.line(slot, major, sources.levels - 1)].values[lane] > 0;
    };
    return shareOf(work.numbers[std::size_t(slot)], 4, [&](int major, int lane, std::uint32_t) {
               return full(work.first, major, lane) && full(work.last, major, lane);
           }) > crowdedShare;
}

LineLeg::LineLeg(const Lanes& lanes, const SourceInstant& first, const SourceInstant& last,
                 const SunInterval& sun, int firstStepOfLeg)
    : atFirst(first),
      atLast(last),
      interval(sun),
      firstStep(firstStepOfLeg),
      forward(lanes, computeForwardMotion(sun), computeSteepestRise(sun.first, lanes.grid().cellM)),
      backward(lanes, computeBackwardMotion(sun), computeSteepestRise(sun.last, lanes.grid().cellM)) {}

void LegDrawer::prepare(const LineLeg& leg, int block, int slot, BlockWork& work) const {
    leg.atFirst.fill(block, work.first, slot);
    leg.atLast.fill(block, work.last, slot);
    receivers_.find(lanes_, block, work.numbers[std::size_t(slot)]);
    work.masks.ask(slot, [&numbers = work.numbers[std::size_t(slot)]](int major, int lane) {
        return numbers[std::size_t(major)].values[lane] != LaneReceivers::none;
    });
}

Result<void> LegDrawer::drawBatch(const LineLeg& leg, std::span<const int> blocks, BlockWork& work) const {
    const int count = int(blocks.size());
    work.first.resize(levels_, lanes_.majors(), count);
    work.last.resize(levels_, lanes_.majors(), count);
    work.masks.resize(lanes_.majors(), count);
    std::ranges::fill(work.masks.masks, ShadowMask{0});
    work.numbers.resize(blocks.size());
    tbb::parallel_for(0, count, [&](int slot) { prepare(leg, blocks[std::size_t(slot)], slot, work); });
    if (const auto drawn = drawer_.draw(leg.forward, work.first, work.masks); !drawn) return drawn;
    return drawer_.draw(leg.backward, work.last, work.masks);
}

Result<std::vector<int>> LegDrawer::draw(const LineLeg& leg, std::span<const int> blocks,
                                         std::span<ShadowMask> masks, const std::stop_token& stop) const {
    const std::size_t atOnce = std::size_t(drawer_.blocksAtOnce(int(blocks.size())));
    tbb::enumerable_thread_specific<BlockWork> works;
    std::vector<std::uint8_t> isCrowded(std::size_t(lanes_.blocks()));
    std::optional<Error> error;
    std::mutex failing;
    tbb::parallel_for(std::size_t{0}, (blocks.size() + atOnce - 1) / atOnce, [&](std::size_t batch) {
        if (stop.stop_requested()) return;
        const auto some = blocks.subspan(batch * atOnce, std::min(atOnce, blocks.size() - batch * atOnce));
        BlockWork& work = works.local();
        if (const auto drawn = drawBatch(leg, some, work); !drawn) {
            const std::lock_guard lock(failing);
            error = drawn.error();
            return;
        }
        tbb::parallel_for(0, int(some.size()), [&](int slot) {
            takeMasks(leg, work, slot, masks);
            isCrowded[std::size_t(some[std::size_t(slot)])] = crowded(work, slot);
        });
    });
    if (stop.stop_requested()) return cancelled();
    if (error) return tl::make_unexpected(*error);
    std::vector<int> found;
    std::ranges::copy_if(blocks, std::back_inserter(found),
                         [&](int block) { return isCrowded[std::size_t(block)] != 0; });
    return found;
}

std::vector<int> LegDrawer::missing(const SourceInstant& instant, int step, double maxMissed,
                                    std::span<const int> blocks, std::span<const ShadowMask> masks,
                                    const std::stop_token& stop) const {
    tbb::enumerable_thread_specific<BlockWork> works;
    std::vector<std::uint8_t> misses(blocks.size());
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
        if (stop.stop_requested()) return;
        BlockWork& work = works.local();
        work.first.resize(levels_, lanes_.majors());
        work.numbers.resize(1);
        instant.fill(blocks[i], work.first, 0);
        receivers_.find(lanes_, blocks[i], work.numbers[0]);
        misses[i] = shareOf(work.numbers[0], 4, [&](int major, int lane, std::uint32_t number) {
                        return work.first.shades(0, major, lane) && (masks[number] >> step & 1) == 0;
                    }) > maxMissed;
    });
    std::vector<int> found;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        if (misses[i] != 0) found.push_back(blocks[i]);
    return found;
}

}  // namespace

SunInterval cutInterval(const SunInterval& interval, StepRange part) {
    return {part.first == 0 ? interval.first : interval.at(part.first),
            part.end == interval.steps ? interval.last : interval.at(part.end - 1), part.end - part.first};
}

LowSun::LowSun(double limitDeg) : limitZ_(float(std::sin(Degrees{limitDeg}.radians().value))) {}

StepRange LowSun::stepsAbove(const SunInterval& interval) const {
    StepRange range{0, interval.steps};
    while (!range.empty() && is(glm::vec3(interval.at(range.first)))) ++range.first;
    while (!range.empty() && is(glm::vec3(interval.at(range.end - 1)))) --range.end;
    return range;
}

SunSteps LowSun::of(const SunSteps& directions, bool low) const {
    SunSteps some;
    for (const SunStep& step : directions.steps)
        if (is(step.direction) == low) some.steps.push_back(step);
    return some;
}

namespace {

std::vector<int> allBlocks(const Lanes& lanes) {
    std::vector<int> blocks(std::size_t(lanes.blocks()));
    std::iota(blocks.begin(), blocks.end(), 0);
    return blocks;
}

/// An interval's lanes, and the shadow sources on them at its ends and middle. The sun's path is a straight
/// line on the ground, so both halves have the same lanes.
struct IntervalLanes {
    SunInterval interval;
    Lanes lanes;
    std::unique_ptr<SourceInstant> atFirst, atMiddle, atLast;  // atMiddle: null until it is needed
    std::vector<int> halved;                                   // blocks that are drawn in halves

    IntervalLanes(const SunInterval& sun, const Grid& grid, const SourceFinder& finder)
        : interval(sun),
          lanes(grid, computeForwardMotion(sun).shift),
          atFirst(finder.at(sun.first, lanes)),
          atLast(finder.at(sun.last, lanes)) {}

    [[nodiscard]] int middle() const { return interval.steps / 2; }
    [[nodiscard]] LineLeg whole() const { return {lanes, *atFirst, *atLast, interval, 0}; }
    [[nodiscard]] std::array<LineLeg, 2> halves() const {
        return {
            LineLeg(lanes, *atFirst, *atMiddle, cutInterval(interval, {0, middle() + 1}), 0),
            LineLeg(lanes, *atMiddle, *atLast, cutInterval(interval, {middle(), interval.steps}), middle())};
    }
};

class InverseAccrualScene final : public IntervalScene {
public:
    InverseAccrualScene(InverseAccrualParts parts, const Receivers& receivers)
        : parts_(std::move(parts)),
          grid_(padGrid(receivers.grid, parts_.marginCells)),
          receivers_(receivers, parts_.marginCells),
          receiverCount_(receivers.cells.size()) {
        cost_.buildingsUsed = parts_.buildingsUsed;
    }

    Result<void> shade(const SunInterval& interval, std::span<ShadowMask> masks,
                       std::stop_token stop) override {
        const StepRange high = highSteps(interval);
        if (high.empty())
            std::ranges::fill(masks, ShadowMask{0});
        else if (const auto drawn = shadeHigh(cutInterval(interval, high), masks, stop); !drawn)
            return drawn;
        if (high.first > 0 && !high.empty())
            for (ShadowMask& mask : masks) mask <<= high.first;
        for (const StepRange low : lowSteps(interval, high))
            if (const auto traced = trace(interval, low, masks, stop); !traced) return traced;
        return {};
    }

    [[nodiscard]] Cost cost() const override {
        Cost cost = cost_;
        if (!parts_.rays) return cost;
        const Cost rays = parts_.rays->cost();
        cost.rays += rays.rays;
        cost.buildingsUsed = std::max(cost.buildingsUsed, rays.buildingsUsed);
        for (const auto& [stage, seconds] : rays.seconds) cost.seconds[stage + " low sun"] += seconds;
        return cost;
    }

private:
    [[nodiscard]] StepRange highSteps(const SunInterval& interval) const {
        return parts_.rays ? parts_.lowSun.stepsAbove(interval) : StepRange{0, interval.steps};
    }

    static std::array<StepRange, 2> lowSteps(const SunInterval& interval, StepRange high) {
        return {StepRange{0, high.first}, StepRange{high.end, interval.steps}};
    }

    Result<void> shadeHigh(const SunInterval& interval, std::span<ShadowMask> masks,
                           const std::stop_token& stop) {
        IntervalLanes ofInterval(interval, grid_, *parts_.finder);
        return draw(ofInterval, masks, stop);
    }

    // Sets all bits and determines the blocks that are drawn in halves.
    Result<void> draw(IntervalLanes& of, std::span<ShadowMask> masks, const std::stop_token& stop) {
        const Stopwatch watch;
        const LegDrawer drawer(of.lanes, receivers_, *parts_.drawer, parts_.finder->levels());
        cost_.rays += 2 * parts_.finder->raysAnInstant();
        const auto crowded = drawer.draw(of.whole(), allBlocks(of.lanes), masks, stop);
        if (!crowded) return tl::make_unexpected(crowded.error());
        if (of.middle() > 0 && !crowded->empty()) findHalved(of, drawer, *crowded, masks, stop);
        if (!of.halved.empty())
            for (const LineLeg& leg : of.halves())
                if (const auto drawn = drawer.draw(leg, of.halved, masks, stop); !drawn)
                    return tl::make_unexpected(drawn.error());
        cost_.seconds["find and draw lines"] += watch.seconds();
        return {};
    }

    void findHalved(IntervalLanes& of, const LegDrawer& drawer, std::span<const int> crowded,
                    std::span<const ShadowMask> masks, const std::stop_token& stop) {
        of.atMiddle = parts_.finder->at(of.interval.at(of.middle()), of.lanes);
        cost_.rays += parts_.finder->raysAnInstant();
        of.halved = drawer.missing(*of.atMiddle, of.middle(), maxMissedShare, crowded, masks, stop);
    }

    Result<void> trace(const SunInterval& interval, StepRange low, std::span<ShadowMask> masks,
                       const std::stop_token& stop) {
        if (low.empty()) return {};
        part_.resize(masks.size());
        if (const auto traced = parts_.rays->shade(cutInterval(interval, low), part_, stop); !traced)
            return traced;
        for (std::size_t i = 0; i < masks.size(); ++i) masks[i] |= part_[i] << low.first;
        return {};
    }

    InverseAccrualParts parts_;
    Grid grid_;  // including the margin
    LaneReceivers receivers_;
    std::size_t receiverCount_;
    std::vector<ShadowMask> part_;  // masks of the receivers for some of the steps
    Cost cost_;
};

}  // namespace

Grid padGrid(const Grid& grid, int cells) {
    Grid wide = grid;
    wide.westM -= cells * grid.cellM;
    wide.southM -= cells * grid.cellM;
    wide.columns += 2 * cells;
    wide.rows += 2 * cells;
    return wide;
}

std::unique_ptr<IntervalScene> makeInverseAccrualScene(InverseAccrualParts parts,
                                                       const Receivers& receivers) {
    return std::make_unique<InverseAccrualScene>(std::move(parts), receivers);
}

}  // namespace noonmark
