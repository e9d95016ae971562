#include "core/engines/inverse/line_leg.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <mutex>

namespace noonmark {

namespace {

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

}  // namespace

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

}  // namespace noonmark
