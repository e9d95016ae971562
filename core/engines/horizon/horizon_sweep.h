#pragma once

#include "core/engines/api/engine.h"
#include "core/engines/api/shadow_counts.h"

namespace noonmark {

struct HorizonSweepSettings {
    static constexpr double minErrorPercent = 0.005;
    static constexpr double maxErrorPercent = 1;
    static constexpr double minBinDeg = 0.1;
    static constexpr double maxBinDeg = 2;
    /// Mean error of a cell's gross shadow, percent of the period, 0.005 to 1: bins are as wide as it lets
    /// them be in a dense city (bin_cuts.h), each as the period's own suns need. Half of it: twice
    /// the time.
    double errorTargetPercent = 0.05;
    /// Width of all bins, degrees, 0.1 to 2, whatever the error; 0: as the error target asks.
    double binDeg = 0;
    /// Without runs bins may be wider at the same error of gross shadow.
    ShadowCounts counts = ShadowCounts::grossAndRuns;
    /// Rays look along each longest run, too: none is too long for a gap that no bin sees.
    bool checksRuns = false;
    bool operator==(const HorizonSweepSettings&) const = default;
};

/// Long periods. All that a city which stands on the ground does to a receiver at one azimuth
/// is one number, the slope of its horizon: the sun is hidden where the tangent of its altitude is below. The
/// suns of a period are put into bins of azimuth; for each bin every wall that faces away from the sun raises
/// the horizons behind it, up to eight neighbouring bins at a time; then each receiver's gross and longest
/// shadow are counted from its horizons, step by step and day by day.
///
/// Error: that all suns of a bin are taken at their mean azimuth, and their altitudes at the nearest of
/// 65,535 levels (horizon_code.h: 0.0009 deg at most, too little to see beside the first). Bins are
/// as wide as the error target lets them be: at 0.05 % of the period a year of 8 h days needs some 410 of
/// 0.3 to 2 deg and is off by 0.03 % in the mean and 0.2 % at most on the grid sample, 0.05 and 0.2 % on
/// Midtown; a single day needs one for nearly each minute, and is all but exact. The longest run has no
/// target: where neighbouring bins leave it in doubt by more than 2 % of the longest day, and a step, rays
/// decide it (run_doubts.h), except below parts that hang. A gap narrower than a bin that no bin sees
/// is missed: single cells are off by up to half a day at steps of a minute, unless runs are checked.
/// Midtown, a year of 8 h days: 0.04 % of a day in the mean and one step at most at a step of 10 minutes,
/// 0.08 % and 6.5 % at a step of 1 minute, 0.03 % and 0.8 % where runs are checked. The answer does not
/// depend on the number of threads, on tiles or on the order of buildings.
///
/// Terrain, and general meshes that stand, raise horizons by the edges of their faces, wherever one is turned
/// away from a sun of the bin and its neighbour is not: exactly the surface that rays meet. Receivers lie at
/// their own heights, a millimetre above the ground or roof like those of rays. What is under a mesh that
/// stands counts as solid, as under a prism: gaps of up to 2 m (core/city/meshes/mesh_parts.h) let no light
/// through.
///
/// Parts that hang hide an interval of altitudes, prism by prism and what is no prism triangle by triangle:
/// just those whose rays they would stop. Receivers that see the sun below such a part are counted step by
/// step.
///
/// Refused, with an error that names another engine: more than 50,000 prisms and triangles of parts that hang
/// in reach (each is looked at from every cell that may see it); a setting out of range; days of more than
/// 32,767 steps.
///
/// Cost, each shared by all cores: some 2 ms for each bin of 800 x 800 cells in a dense city for the sweep,
/// and where runs are counted half as much again and steps x receivers x some 10 ps; in Midtown some 0.8 ms a
/// bin for the 303 parts that hang. On terrain more by as much as it is rough where the
/// sun is low: up to 100 ns a receiver and bin where every metre has a bump of its own. Memory: up to half a
/// GiB, and on each thread some 160
/// bytes for each edge of the terrain that a bin's suns make an outline.
class HorizonSweep final : public Engine {
public:
    explicit HorizonSweep(HorizonSweepSettings settings = {});
    [[nodiscard]] std::string_view name() const override { return "Horizon sweep"; }
    [[nodiscard]] EngineCapabilities capabilities() const override { return able; }
    static constexpr EngineCapabilities able{.terrain = true,
                                             .roofs = true,
                                             .sets = true,
                                             .attribution = true,
                                             .cache = true,
                                             .independence = Independence::onLevelGround};
    [[nodiscard]] const HorizonSweepSettings& settings() const { return settings_; }

protected:
    [[nodiscard]] Result<ShadowField> compute(const City& city, const Receivers& receivers,
                                              const SunSteps& sun, Progress& progress,
                                              std::stop_token stop) const override;
    [[nodiscard]] Result<ShadowBreakdown> computeBreakdown(const City& city, const Receivers& receivers,
                                                           const SunSteps& sun, const StepSets& sets,
                                                           bool byBuilding, Progress& progress,
                                                           std::stop_token stop) const override;

private:
    HorizonSweepSettings settings_;
};

}  // namespace noonmark
