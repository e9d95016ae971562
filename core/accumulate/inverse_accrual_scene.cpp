#include "core/accumulate/inverse_accrual_scene.h"

#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "core/accumulate/line_leg.h"
#include "core/accumulate/shadow_claims.h"
#include "core/stopwatch.h"

namespace noonmark {

namespace {

std::vector<int> allBlocks(const Lanes& lanes) {
    std::vector<int> blocks(std::size_t(lanes.blocks()));
    std::iota(blocks.begin(), blocks.end(), 0);
    return blocks;
}

/// An interval's lanes, and what throws shadows on them at its ends and in its middle. The sun's path is a
/// straight line on the ground, so that its halves have the same lanes.
struct IntervalLanes {
    SunInterval interval;
    Lanes lanes;
    std::unique_ptr<SourceInstant> atFirst, atMiddle, atLast;  // atMiddle: null until it is asked for
    std::vector<int> halved;                                   // blocks that are drawn in halves

    IntervalLanes(const SunInterval& sun, const Grid& grid, const SourceFinder& finder)
        : interval(sun),
          lanes(grid, motionForward(sun).shift),
          atFirst(finder.at(sun.first, lanes)),
          atLast(finder.at(sun.last, lanes)) {}

    [[nodiscard]] int middle() const { return interval.steps / 2; }
    [[nodiscard]] LineLeg whole() const { return {lanes, *atFirst, *atLast, interval, 0}; }
    [[nodiscard]] std::array<LineLeg, 2> halves() const {
        return {LineLeg(lanes, *atFirst, *atMiddle, partOf(interval, {0, middle() + 1}), 0),
                LineLeg(lanes, *atMiddle, *atLast, partOf(interval, {middle(), interval.steps}), middle())};
    }
};

class InverseAccrualScene final : public IntervalScene {
public:
    InverseAccrualScene(InverseAccrualParts parts, const Receivers& receivers)
        : parts_(std::move(parts)),
          grid_(padded(receivers.grid, parts_.marginCells)),
          receivers_(receivers, parts_.marginCells),
          receiverCount_(receivers.cells.size()) {
        cost_.buildingsUsed = parts_.buildingsUsed;
    }

    Result<void> shade(const SunInterval& interval, std::span<ShadowMask> masks,
                       std::stop_token stop) override {
        const StepRange high = highSteps(interval);
        if (high.empty())
            std::ranges::fill(masks, ShadowMask{0});
        else if (const auto drawn = shadeHigh(partOf(interval, high), masks, stop); !drawn)
            return drawn;
        if (high.first > 0 && !high.empty())
            for (ShadowMask& mask : masks) mask <<= high.first;
        for (const StepRange low : lowSteps(interval, high))
            if (const auto traced = trace(interval, low, masks, stop); !traced) return traced;
        return {};
    }

    Result<void> attribute(const SunInterval& interval, std::span<std::uint64_t> cellSteps,
                           std::stop_token stop) override {
        const StepRange high = highSteps(interval);
        for (const StepRange low : lowSteps(interval, high))
            if (!low.empty())
                if (const auto done = parts_.rays->attribute(partOf(interval, low), cellSteps, stop); !done)
                    return done;
        return high.empty() ? Result<void>{} : attributeLines(partOf(interval, high), cellSteps, stop);
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

    // Sets all bits, and notes which blocks are drawn in halves.
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
        of.halved = drawer.missing(*of.atMiddle, of.middle(), mostMissedShare, crowded, masks, stop);
    }

    Result<void> trace(const SunInterval& interval, StepRange low, std::span<ShadowMask> masks,
                       const std::stop_token& stop) {
        if (low.empty()) return {};
        part_.resize(masks.size());
        if (const auto traced = parts_.rays->shade(partOf(interval, low), part_, stop); !traced)
            return traced;
        for (std::size_t i = 0; i < masks.size(); ++i) masks[i] |= part_[i] << low.first;
        return {};
    }

    // As drawn: in halves where they are.
    Result<void> attributeLines(const SunInterval& interval, std::span<std::uint64_t> cellSteps,
                                const std::stop_token& stop) {
        std::vector<ShadowMask> masks(receiverCount_);
        IntervalLanes of(interval, grid_, *parts_.finder);
        if (const auto drawn = draw(of, masks, stop); !drawn) return drawn;
        std::vector<int> undivided;
        std::ranges::set_difference(allBlocks(of.lanes), of.halved, std::back_inserter(undivided));
        claim(of.lanes, of.whole(), undivided, cellSteps, stop);
        if (!of.halved.empty())
            for (const LineLeg& leg : of.halves()) claim(of.lanes, leg, of.halved, cellSteps, stop);
        if (stop.stop_requested()) return cancelled();
        return {};
    }

    // The step that both halves have counts in the first one.
    void claim(const Lanes& lanes, const LineLeg& leg, std::span<const int> blocks,
               std::span<std::uint64_t> cellSteps, const std::stop_token& stop) const {
        tbb::combinable<std::vector<std::uint64_t>> sums(
            [&] { return std::vector<std::uint64_t>(cellSteps.size()); });
        tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
            if (stop.stop_requested()) return;
            LaneSources first, last;
            first.resize(parts_.finder->levels(), lanes.majors());
            last.resize(first.levels, first.majors);
            leg.atFirst.fill(blocks[i], first, 0);
            leg.atLast.fill(blocks[i], last, 0);
            claimSteps({first, last, leg.forward, leg.backward, leg.interval}, leg.firstStep > 0 ? 1 : 0,
                       wantedIn(lanes, blocks[i]), sums.local());
        });
        sums.combine_each([&](const std::vector<std::uint64_t>& sum) {
            for (std::size_t i = 0; i < sum.size(); ++i) cellSteps[i] += sum[i];
        });
    }

    [[nodiscard]] std::vector<bool> wantedIn(const Lanes& lanes, int block) const {
        std::vector<Line<std::uint32_t>> numbers;
        receivers_.find(lanes, block, numbers);
        std::vector<bool> wanted;
        for (const auto& line : numbers)
            for (const std::uint32_t number : line.values) wanted.push_back(number != LaneReceivers::none);
        return wanted;
    }

    InverseAccrualParts parts_;
    Grid grid_;  // with its margin
    LaneReceivers receivers_;
    std::size_t receiverCount_;
    std::vector<ShadowMask> part_;  // of the receivers: some of their steps
    Cost cost_;
};

}  // namespace

Grid padded(const Grid& grid, int cells) {
    Grid wide = grid;
    wide.westM -= cells * grid.cellM;
    wide.southM -= cells * grid.cellM;
    wide.columns += 2 * cells;
    wide.rows += 2 * cells;
    return wide;
}

std::unique_ptr<IntervalScene> inverseAccrualScene(InverseAccrualParts parts, const Receivers& receivers) {
    return std::make_unique<InverseAccrualScene>(std::move(parts), receivers);
}

}  // namespace noonmark
