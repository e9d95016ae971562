#include "core/accumulate/shadow_claims.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

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
    Pass(const LinePass& pass, const LaneSources& sources, std::vector<double> fraction)
        : pass_(pass), sources_(sources), fraction_(std::move(fraction)) {}

    void claim(int lane, LaneClaims& claims) const {
        OpenRuns runs(pass_.rule);
        const auto draw = [&](const SourceRun& run) { claimRun(run, claims); };
        CellSources before, now;
        for (int at = 0; at < sources_.majors; ++at, before = now) {
            now = sources_.of(0, pass_.reversed ? sources_.majors - 1 - at : at, lane);
            runs.change(at, before, now, draw);
        }
        runs.finish(sources_.majors - 1, before, draw);
    }

private:
    void claimRun(const SourceRun& run, LaneClaims& claims) const {
        const RunSweep sweep(run, pass_.rule, sources_.majors);
        for (int i = 0; i < sweep.count; ++i) {
            const int place = pass_.reversed ? sources_.majors - 1 - run.first - i : run.first + i;
            for (ShadowMask steps = sweep.steps(i, pass_.table); steps != 0; steps &= steps - 1) {
                const int step = std::countr_zero(steps);
                const auto share = float(fraction_[std::size_t(step)]);
                claims.claim(place, step, heightThere(run, pass_.rule.cellsPerMetre, share, i), run.building);
            }
        }
    }

    const LinePass& pass_;
    const LaneSources& sources_;
    std::vector<double> fraction_;
};

// At the interval's ends the sources themselves know; lines do not.
void settle(LaneClaims::Claim& claim, const LaneSources& sources, int major, int lane) {
    const std::size_t line = sources.line(0, major);
    const float height = sources.heightM[line].values[lane];
    claim = {height > 0 ? height : nobody, sources.building[line].values[lane]};
}

void count(LaneClaims& claims, int place, StepRange steps, std::span<std::uint64_t> cellSteps) {
    for (int step = steps.first; step < steps.end; ++step)
        if (const auto& claim = claims.at(place, step); claim.heightM < nobody) ++cellSteps[claim.building];
}

}  // namespace

void claimSteps(const IntervalLines& lines, int fromStep, const std::vector<bool>& wanted,
                std::span<std::uint64_t> cellSteps) {
    const Pass forward(lines.forward, lines.atFirst, motionForward(lines.interval).fraction),
        backward(lines.backward, lines.atLast, motionBackward(lines.interval).fraction);
    const int majors = lines.atFirst.majors, steps = lines.interval.steps;
    LaneClaims claims;
    for (int lane = 0; lane < Lanes::perBlock; ++lane) {
        claims.start(majors);
        forward.claim(lane, claims);
        backward.claim(lane, claims);
        for (int major = 0; major < majors; ++major) {
            if (!wanted[std::size_t(major * Lanes::perBlock + lane)]) continue;
            settle(claims.at(major, steps - 1), lines.atLast, major, lane);
            settle(claims.at(major, 0), lines.atFirst, major, lane);
            count(claims, major, {fromStep, steps}, cellSteps);
        }
    }
}

}  // namespace noonmark
