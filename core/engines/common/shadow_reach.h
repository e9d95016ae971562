#pragma once

// Parts that several engines share. This file finds the buildings whose shadow can reach a receiver;
// changed_buildings.h compares two cities for the caches. engine_in_use.h answers a question with the engine
// that was asked for or chosen. receiver_tiles.h divides a region into tiles and delivers running results.
// sun_packets.h groups sun directions for SIMD. run_counter.h counts shadow and its longest runs.
// open_below.h finds the open air that horizons count as solid.

#include <cstdint>
#include <vector>

#include "core/city/city.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/common/changed_buildings.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// How far shadows fall during a period, for each azimuth that the sun visits.
class ShadowReach {
public:
    /// Reads only the directions of the steps.
    explicit ShadowReach(const SunSteps& sun);

    /// Whether the shadow of an occluder within `box`, up to `heightM` above the lowest ground of
    /// `receivers`, can touch that box at some step. Conservative: never false where a shadow touches; may be
    /// true where none does, because shapes are reduced to boxes and azimuths to whole degrees.
    [[nodiscard]] bool touches(const Box2& box, double heightM, const Box2& receivers) const;

private:
    /// The sun's steps within one degree of azimuth.
    struct Bin {
        glm::dvec2 away;        ///< unit vector in which shadows fall, at the bin's middle
        double lengthPerMetre;  ///< length of the longest shadow per metre of height: 1 / tan of the lowest
                                ///< altitude
    };
    std::vector<Bin> bins_;  ///< only bins that the sun visits
    double longest_ = 0;     ///< largest lengthPerMetre
};

/// Indices of the buildings whose shadow can fall on a receiver at some step, ascending. All others can be
/// left out of any engine without changing its result. O(cells + buildings x azimuth degrees visited); 43,000
/// buildings take milliseconds.
std::vector<std::uint32_t> findBuildingsInReach(const City& city, const Receivers& receivers,
                                                const SunSteps& sun);

/// The same, and counts in `cost` how many are used and how many are out of reach.
std::vector<std::uint32_t> findBuildingsInReach(const City& city, const Receivers& receivers,
                                                const SunSteps& sun, Cost& cost);

/// Indices of the trees whose crown's shadow can fall on a receiver at some step, ascending; none where they
/// are not weighed. O(cells + trees).
std::vector<std::uint32_t> findTreesInReach(const City& city, const Receivers& receivers,
                                            const SunSteps& sun);
/// The same of receivers in a box, none of which is lower than `lowestM`. O(trees)
std::vector<std::uint32_t> findTreesInReach(const City& city, const Box2& receivers, float lowestM,
                                            const SunSteps& sun);

/// Key of Cost::skipped.
inline constexpr const char* buildingsOutOfReach = "buildings whose shadow cannot reach a receiver";
/// Sets in `cost` that `used` of `all` buildings can shade a receiver.
void countInReach(Cost& cost, std::size_t used, std::size_t all);

/// Keeps the receivers that the shadow of any of the buildings may reach at some step and marks the others as
/// outside. Works on tiles of 32 x 32 cells and never drops a receiver that shadow reaches. O(cells + tiles x
/// buildings x degrees of azimuth visited).
Receivers findReached(const Buildings& buildings, const Receivers& receivers, const ShadowReach& reach);

/// Fills the receivers that findReached() dropped with the values of the field with the building, which are
/// the same there. `receivers`: all receivers.
void fillUnreached(ShadowField& without, const ShadowField& with, const Receivers& receivers);

}  // namespace noonmark
