#pragma once

// The horizon sweep. This file holds the engine, its settings with their options, and the checks of a study.
// geometry/ groups suns into azimuth bins and collects what may hide them; sweep/ computes horizons block by
// block; overhangs/ adds the parts with open air below, trees/ the crowns; counting/ turns horizons into
// gross shadow and longest runs; cache/ updates a result after an edit; attribution/ charges shadow to
// buildings.

#include "core/base/result.h"
#include "core/describe/field.h"
#include "core/engines/api/engine.h"
#include "core/engines/api/shadow_field.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

struct HorizonSweepSettings {
    static constexpr double minBinDeg = 0.1;
    static constexpr double maxBinDeg = 2;
    /// Mean error of a cell's gross shadow, percent of the period, 0.005 to 1. Bins are as wide as this error
    /// allows in a dense city (azimuth_bins.h), and each bin's width depends on the suns of the period. Half
    /// the error takes twice the time.
    double errorTargetPercent = 0.05;
    /// Width of all bins, degrees, 0.1 to 2, whatever the error; 0: chosen from the error target.
    double binDeg = 0;
    /// Without runs, bins may be wider at the same error of gross shadow.
    ShadowCounts counts = ShadowCounts::grossAndRuns;
    /// Rays look at every step of each longest run, so that none is too long because two walls in one line
    /// have a gap between them that no bin sees.
    bool checksRuns = false;
    bool operator==(const HorizonSweepSettings&) const = default;
};

/// The options of engines that sweep horizons: "error", "bin", "runs" and "check".
const Fields<HorizonSweepSettings>& sweepFields();

/// The engine for long periods. At one azimuth, everything in the city that stands on the ground affects a
/// receiver through one number, the slope of its horizon: the sun is hidden if the tangent of its altitude is
/// lower. The suns of a period are grouped into azimuth bins. For each bin, every wall that faces away from
/// the sun raises the horizons behind it; up to eight neighbouring bins are processed at a time. Each
/// receiver's gross shadow and longest run are then counted from its horizons, step by step and day by day.
///
/// Error: all suns of a bin are placed at their mean azimuth, and their altitudes are rounded to the nearest
/// of 65,535 levels (horizon_code.h: at most 0.0009 deg, negligible beside the first error). Bins are as wide
/// as the error target allows: at 0.05 % of the period a year of 8 h days needs some 410 bins of 0.3 to 2 deg
/// (at most 0.25 to 0.5 deg where longest runs are counted) and is off by 0.03 % on average and 0.2 % at most
/// on the grid sample, 0.05 and 0.2 % on Midtown. A single day needs nearly one bin per minute and is almost
/// exact. Longest runs are right within two steps: rays look at the steps that neighbouring bins leave in
/// doubt (run_decider.h). Bryant Park, a year from sunrise to sunset at steps of 1 minute, all 10,261 cells
/// of 2 m against rays: 0.16 steps on average, at most 2; Times Square the same. Not seen unless runs are
/// checked: a gap between two walls whose tops lie in one line, and light below a general mesh that counts as
/// solid. The result does not depend on the number of threads, on tiles or on the order of buildings.
///
/// Terrain, and general meshes that stand on the ground, raise horizons by those edges of their faces where
/// one face is turned away from a sun of the bin and its neighbour is not; this is exactly the surface that
/// rays hit. Receivers lie at their own heights, a millimetre above the ground or roof, as for rays. The
/// space under a mesh that stands on the ground counts as solid, as under a prism: gaps of up to 2 m
/// (core/city/meshes/mesh_parts.h) let no light through.
///
/// An overhang hides an interval of altitudes: exactly those whose rays it would block. Overhangs are
/// processed prism by prism, and triangle by triangle if they are not prisms. Receivers that see the sun
/// below an overhang are counted step by step.
///
/// Refused, with an error that names another engine: more than 50,000 overhang prisms and triangles in reach
/// (each is examined from every cell that may see it); a setting out of range; days of more than 32,767
/// steps.
///
/// Cost, shared by all cores: the sweep takes some 2 ms per bin of 800 x 800 cells in a dense city; counting
/// runs adds half of that and steps x receivers x some 10 ps. In Midtown the 303 overhangs add some 0.8 ms
/// per bin. Terrain adds more the rougher it is where the sun is low: up to 100 ns per receiver and bin if
/// every metre has a bump of its own. Memory: up to half a GiB, and on each thread some 160 bytes per terrain
/// edge that is an outline for a bin's suns.
class HorizonSweep final : public Engine {
public:
    explicit HorizonSweep(HorizonSweepSettings settings = {});
    [[nodiscard]] std::string_view name() const override { return "Horizon sweep"; }
    [[nodiscard]] EngineCapabilities capabilities() const override { return able; }
    static constexpr EngineCapabilities able{.terrain = true,
                                             .roofs = true,
                                             .sets = true,
                                             .attribution = true,
                                             .trees = true,
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

/// Error if the bin width is out of range.
Result<void> checkBinWidth(double binDeg);

/// Error if a setting is out of range.
Result<void> checkSweepSettings(const HorizonSweepSettings& settings);

/// Error if a day has more steps than can be counted.
Result<void> checkHorizonDays(const SunSteps& sun);

}  // namespace noonmark
