#include "core/accumulate/inverse_accrual_scene.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/accumulate/shadow_claims.h"
#include "core/stopwatch.h"

namespace noonmark {

namespace {

// Where so many of the receivers have a full list at both ends, what lies behind may matter in between; where
// so many are found in a shadow of the middle step that no line leads to, it does. Both: shares.
constexpr double crowdedShare = 0.4;

class InverseAccrualScene final : public IntervalScene {
public:
    InverseAccrualScene(InverseAccrualParts parts, const Receivers& receivers)
        : receivers_(receivers),
          parts_(std::move(parts)),
          grid_(padded(receivers.grid, parts_.marginCells)),
          masks_(grid_.size()) {
        cost_.buildingsUsed = parts_.buildingsUsed;
    }

    Result<void> shade(const SunInterval& interval, std::span<ShadowMask> masks,
                       std::stop_token stop) override {
        const StepRange high = highSteps(interval);
        if (high.empty())
            std::ranges::fill(masks, ShadowMask{0});
        else if (const auto drawn = draw(partOf(interval, high), masks, stop); !drawn)
            return tl::make_unexpected(drawn.error());
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

    // Sets all bits. The step in the middle where the interval had to be halved, else 0.
    Result<int> draw(const SunInterval& interval, std::span<ShadowMask> masks, const std::stop_token& stop) {
        findSources(interval, stop);
        if (const auto drawn = drawLines({atFirst_, atLast_, interval}, masks, stop); !drawn)
            return tl::make_unexpected(drawn.error());
        const int middle = interval.steps / 2;
        if (middle == 0 || !crowded()) return 0;
        findMiddle(interval.at(middle), stop);
        if (stop.stop_requested()) return cancelled();
        if (missedInMiddle(middle, masks) <= mostMissedShare) return 0;
        return drawHalves(interval, middle, masks, stop).map([&] { return middle; });
    }

    Result<void> drawHalves(const SunInterval& interval, int middle, std::span<ShadowMask> masks,
                            const std::stop_token& stop) {
        part_.resize(masks.size());
        const SunInterval before = partOf(interval, {0, middle + 1}),
                          after = partOf(interval, {middle, interval.steps});
        if (const auto drawn = drawLines({atFirst_, atMiddle_, before}, masks, stop); !drawn) return drawn;
        if (const auto drawn = drawLines({atMiddle_, atLast_, after}, part_, stop); !drawn) return drawn;
        for (std::size_t i = 0; i < masks.size(); ++i) masks[i] |= part_[i] << middle;
        return {};
    }

    Result<void> drawLines(const IntervalSources& sources, std::span<ShadowMask> masks,
                           const std::stop_token& stop) {
        if (stop.stop_requested()) return cancelled();
        const Stopwatch watch;
        openReceivers();
        const auto& [atFirst, atLast, interval] = sources;
        if (const auto drawn = parts_.drawer->draw(grid_, atFirst, motionForward(interval), masks_, stop);
            !drawn)
            return drawn;
        if (const auto drawn = parts_.drawer->draw(grid_, atLast, motionBackward(interval), masks_, stop);
            !drawn)
            return drawn;
        takeReceivers(sources, masks);
        cost_.seconds["draw"] += watch.seconds();
        return {};
    }

    [[nodiscard]] bool crowded() const {
        const std::size_t deepest = std::size_t(atFirst_.levels - 1) * grid_.size();
        return shareOfReceivers([&](std::size_t, std::size_t cell) {
                   return atFirst_.heightM[deepest + cell] > 0 && atLast_.heightM[deepest + cell] > 0;
               }) > crowdedShare;
    }

    [[nodiscard]] double missedInMiddle(int middle, std::span<const ShadowMask> masks) const {
        return shareOfReceivers([&](std::size_t i, std::size_t cell) {
            return atMiddle_.heightM[cell] > 0 && (masks[i] >> middle & 1) == 0;
        });
    }

    /// Of those for which is(number of the receiver, its cell in the wide grid); one in seven is asked.
    template <class Is>
    [[nodiscard]] double shareOfReceivers(const Is& is) const {
        std::size_t count = 0, asked = 0;
        for (std::size_t i = 0; i < receivers_.cells.size(); i += 7, ++asked)
            count += std::size_t(is(i, wideCell(receivers_.cells[i])));
        return asked == 0 ? 0 : double(count) / double(asked);
    }

    // Adds the bits of some steps.
    Result<void> trace(const SunInterval& interval, StepRange steps, std::span<ShadowMask> masks,
                       const std::stop_token& stop) {
        if (steps.empty()) return {};
        part_.resize(masks.size());
        if (const auto done = parts_.rays->shade(partOf(interval, steps), part_, stop); !done) return done;
        for (std::size_t i = 0; i < masks.size(); ++i) masks[i] |= part_[i] << steps.first;
        return {};
    }

    // As drawn: in halves where they are.
    Result<void> attributeLines(const SunInterval& interval, std::span<std::uint64_t> cellSteps,
                                const std::stop_token& stop) {
        std::vector<ShadowMask> masks(receivers_.cells.size());
        const auto middle = draw(interval, masks, stop);
        if (!middle) return tl::make_unexpected(middle.error());
        std::vector<bool> wanted(grid_.size());
        for (const std::uint32_t cell : receivers_.cells) wanted[wideCell(cell)] = true;
        if (*middle == 0) {
            claimSteps(grid_, {atFirst_, atLast_, interval}, 0, wanted, cellSteps, stop);
        } else {
            const SunInterval before = partOf(interval, {0, *middle + 1}),
                              after = partOf(interval, {*middle, interval.steps});
            claimSteps(grid_, {atFirst_, atMiddle_, before}, 0, wanted, cellSteps, stop);
            claimSteps(grid_, {atMiddle_, atLast_, after}, 1, wanted, cellSteps, stop);
        }
        if (stop.stop_requested()) return cancelled();
        return {};
    }

    // An interval often begins where the last one ended: its sources are there already.
    void findSources(const SunInterval& interval, const std::stop_token& stop) {
        const Stopwatch watch;
        if (knownLast_ && *knownLast_ == interval.first)
            std::swap(atFirst_, atLast_);
        else
            find(interval.first, atFirst_, stop);
        find(interval.last, atLast_, stop);
        knownLast_ = interval.last;
        cost_.seconds["trace"] += watch.seconds();
    }

    void findMiddle(glm::dvec3 towardsSun, const std::stop_token& stop) {
        const Stopwatch watch;
        find(towardsSun, atMiddle_, stop);
        cost_.seconds["trace"] += watch.seconds();
    }

    void find(glm::dvec3 towardsSun, ShadowSources& sources, const std::stop_token& stop) {
        parts_.finder->find(towardsSun, sources, stop);
        cost_.rays += parts_.finder->raysAnInstant();
    }

    // Only receivers' masks are looked at; the others count as full, for a drawer to pass over.
    void openReceivers() {
        std::ranges::fill(masks_, ~ShadowMask{0});
        for (const std::uint32_t cell : receivers_.cells) masks_[wideCell(cell)] = 0;
    }

    // At t1 and at tn the rays know the answer; lines do not.
    void takeReceivers(const IntervalSources& sources, std::span<ShadowMask> masks) const {
        const ShadowMask firstBit = 1, lastBit = ShadowMask{1} << (sources.interval.steps - 1);
        const std::vector<float>&first = sources.atFirst.heightM, &last = sources.atLast.heightM;
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, masks.size(), 8192), [&](const auto& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                const std::size_t cell = wideCell(receivers_.cells[i]);
                const ShadowMask known = (first[cell] > 0 ? firstBit : 0) | (last[cell] > 0 ? lastBit : 0);
                masks[i] = (masks_[cell] & ~(firstBit | lastBit)) | known;
            }
        });
    }

    [[nodiscard]] std::size_t wideCell(std::uint32_t cell) const {
        const int columns = receivers_.grid.columns;
        return grid_.index(int(cell) % columns + parts_.marginCells,
                           int(cell) / columns + parts_.marginCells);
    }

    const Receivers& receivers_;
    InverseAccrualParts parts_;
    Grid grid_;  // with its margin
    ShadowSources atFirst_, atMiddle_, atLast_;
    std::optional<glm::dvec3> knownLast_;
    std::vector<ShadowMask> masks_;  // of the wide grid
    std::vector<ShadowMask> part_;   // of the receivers: some of their steps
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
