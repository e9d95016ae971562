#include "core/accumulate/shadow_claims.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/accumulate/lanes.h"
#include "core/accumulate/low_sun.h"
#include "core/accumulate/run_sweep.h"

namespace noonmark {

namespace {

constexpr float nobody = std::numeric_limits<float>::infinity();

/// The lowest source of every cell and step of a lane.
class LaneClaims {
public:
    struct Claim {
        float heightM = nobody;
        std::uint32_t building = 0;
    };

    void start(int cells) { claims_.assign(std::size_t(cells) * maxMaskSteps, {}); }

    Claim& at(int cell, int step) { return claims_[std::size_t(cell) * maxMaskSteps + std::size_t(step)]; }

    void claim(int cell, int step, float heightM, std::uint32_t building) {
        Claim& known = at(cell, step);
        if (heightM < known.heightM) known = {heightM, building};
    }

private:
    std::vector<Claim> claims_;
};

// How high the point of a run is whose shadow, a share of the way on, falls on cell i counted from its first.
float heightThere(const SourceRun& run, float cellsPerMetre, float share, int i) {
    const auto width = float(run.last - run.first);
    if (width == 0) return run.firstM;
    const float slope = (run.lastM - run.firstM) / width, way = cellsPerMetre * share;
    const float stretch = 1 + slope * way;
    const float along = std::abs(stretch) < 1e-6F ? 0 : (float(i) - run.firstM * way) / stretch;
    return run.firstM + slope * std::clamp(along, 0.0F, width);
}

/// The lines of one direction: from the first step on, or from the last backward.
class Pass {
public:
    Pass(const Grid& grid, const Lanes& lanes, const ShadowSources& sources, const ShadowMotion& motion)
        : lanes_(lanes), size_(grid.size()), sources_(sources), motion_(motion), table_(motion.fraction) {
        const double along = (lanes.alongX() ? motion.shift.x : motion.shift.y) / grid.cellM;
        rule_ = {float(std::abs(along)), sources.steepestM};
        reversed_ = along < 0;
    }

    void claim(int lane, LaneClaims& claims) const {
        const auto [first, end] = lanes_.stretch(lane);
        const int cells = end - first;
        OpenRuns runs(rule_);
        const auto draw = [&](const SourceRun& run) { claimRun(run, cells, claims); };
        CellSources before, now;
        for (int at = 0; at < cells; ++at, before = now) {
            now = sourcesOf(lanes_.cell(lane, reversed_ ? end - 1 - at : first + at));
            runs.change(at, before, now, draw);
        }
        if (cells > 0) runs.finish(cells - 1, before, draw);
    }

private:
    void claimRun(const SourceRun& run, int cells, LaneClaims& claims) const {
        const RunSweep sweep(run, rule_, cells);
        for (int i = 0; i < sweep.count; ++i) {
            const int cell = reversed_ ? cells - 1 - run.first - i : run.first + i;
            for (ShadowMask steps = sweep.steps(i, table_); steps != 0; steps &= steps - 1) {
                const int step = std::countr_zero(steps);
                const auto share = float(motion_.fraction[std::size_t(step)]);
                claims.claim(cell, step, heightThere(run, rule_.cellsPerMetre, share, i), run.building);
            }
        }
    }

    [[nodiscard]] CellSources sourcesOf(std::size_t cell) const {
        CellSources found{};
        for (std::size_t place = cell; found.count < sources_.levels; ++found.count, place += size_) {
            if (sources_.heightM[place] <= 0) break;
            found.heightM[std::size_t(found.count)] = sources_.heightM[place];
            found.building[std::size_t(found.count)] = sources_.building[place];
        }
        return found;
    }

    const Lanes& lanes_;
    std::size_t size_;
    const ShadowSources& sources_;
    const ShadowMotion& motion_;
    StepTable table_;
    RunRule rule_;
    bool reversed_ = false;
};

// At the interval's ends the sources themselves know; lines do not.
void settle(LaneClaims::Claim& claim, const ShadowSources& sources, std::size_t cell) {
    claim = {sources.heightM[cell] > 0 ? sources.heightM[cell] : nobody, sources.building[cell]};
}

void count(LaneClaims& claims, int cell, StepRange steps, std::vector<std::uint64_t>& cellSteps) {
    for (int step = steps.first; step < steps.end; ++step)
        if (const auto& claim = claims.at(cell, step); claim.heightM < nobody) ++cellSteps[claim.building];
}

}  // namespace

void claimSteps(const Grid& grid, const IntervalSources& sources, int fromStep,
                const std::vector<bool>& wanted, std::span<std::uint64_t> cellSteps,
                const std::stop_token& stop) {
    const ShadowMotion ahead = motionForward(sources.interval), back = motionBackward(sources.interval);
    const Lanes lanes(grid, ahead.shift);
    const Pass forward(grid, lanes, sources.atFirst, ahead), backward(grid, lanes, sources.atLast, back);
    const int steps = sources.interval.steps;
    tbb::combinable<std::vector<std::uint64_t>> sums(
        [&] { return std::vector<std::uint64_t>(cellSteps.size()); });
    tbb::parallel_for(tbb::blocked_range<int>(0, lanes.count(), 8), [&](const auto& range) {
        LaneClaims claims;
        for (int lane = range.begin(); lane < range.end() && !stop.stop_requested(); ++lane) {
            const auto [first, end] = lanes.stretch(lane);
            claims.start(end - first);
            forward.claim(lane, claims);
            backward.claim(lane, claims);
            for (int major = first; major < end; ++major) {
                const std::size_t cell = lanes.cell(lane, major);
                if (!wanted[cell]) continue;
                settle(claims.at(major - first, steps - 1), sources.atLast, cell);
                settle(claims.at(major - first, 0), sources.atFirst, cell);
                count(claims, major - first, {fromStep, steps}, sums.local());
            }
        }
    });
    sums.combine_each([&](const std::vector<std::uint64_t>& sum) {
        for (std::size_t i = 0; i < sum.size(); ++i) cellSteps[i] += sum[i];
    });
}

}  // namespace noonmark
