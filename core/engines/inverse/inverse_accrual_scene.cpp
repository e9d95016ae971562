#include "core/engines/inverse/inverse_accrual_scene.h"

#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "core/base/stopwatch.h"
#include "core/engines/inverse/line_leg.h"

namespace noonmark {

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
