#pragma once

// The folder core/engines/trees has what engines that weigh crowns share: the crowns in reach of receivers,
// the steps in leaf and the shadow of crowns as bits (this file), and those around one receiver and the
// patches of the sun (crowns_around.h).
// core/engines/ray/tree_rays.h weighs them exactly.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/city/city.h"
#include "core/city/trees/tree.h"
#include "core/engines/api/step_sets.h"
#include "core/engines/api/tree_shade.h"
#include "core/receivers/point_receivers.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The parts of a period in each of which the same crowns are in leaf, where some trees have leaf days of
/// their own. Empty where all follow the city's days.
struct LeafPhases {
    std::vector<std::uint16_t> ofStep;              ///< or of each day; in time order
    std::vector<std::vector<std::uint8_t>> inLeaf;  ///< by phase and Crown::season
    [[nodiscard]] bool empty() const { return ofStep.empty(); }
    [[nodiscard]] std::size_t count() const { return empty() ? 1 : inLeaf.size(); }
    [[nodiscard]] std::size_t at(std::size_t step) const { return empty() ? 0 : ofStep[step]; }
    /// Optical depth of a metre of a crown in a phase; without phases that of a crown out of season.
    [[nodiscard]] double perM(std::size_t phase, const Crown& crown) const {
        return !empty() && inLeaf[phase][crown.season] != 0 ? crown.leafOnPerM : crown.leafOffPerM;
    }
};

/// `days`: of the year, 1 to 366, in time order. Empty where there is one season.
LeafPhases findLeafPhases(const LeafSeasons& seasons, std::span<const int> days);
/// The same of the steps of a period.
LeafPhases findLeafPhases(const LeafSeasons& seasons, const SunSteps& sun);

/// The crowns whose shadow can fall on a receiver at some step, and when they are in leaf.
struct CrownScene {
    std::vector<Crown> crowns;
    std::vector<std::uint32_t> trees;  ///< of each crown: index in City::trees
    /// One per step: 1 where trees that lose their leaves have them. All 0 where there are phases: what is
    /// bare by the step's phase then is `phases.perM()`.
    std::vector<std::uint8_t> inLeaf;
    LeafPhases phases;
    [[nodiscard]] bool empty() const { return crowns.empty(); }
};

/// Longest unbroken shadow as a sweep finds it, minutes by receiver.
struct SweptRuns {
    std::vector<float> without, evergreen, seasonal;
};

/// What crowns take of the sun that buildings leave, minutes by set of steps and then by receiver, and with
/// every tree in leaf all year or bare out of season.
struct TakenBySet {
    std::vector<std::vector<float>> evergreen, seasonal;
    SweptRuns runs;             ///< over all sets; empty: not counted
    std::size_t treesUsed = 0;  ///< trees whose shadow can reach a receiver
    std::string how;            ///< in words, for the report
    [[nodiscard]] const std::vector<std::vector<float>>& of(TreeColumns column) const {
        return column == TreeColumns::evergreen ? evergreen : seasonal;
    }
};

/// Whether trees that lose their leaves have them on that day.
bool isInLeaf(const LeafDays& leafDays, CivilDate date);

/// The crowns of these trees of a city, by their indices.
CrownScene makeCrownScene(const City& city, std::vector<std::uint32_t> trees, const SunSteps& sun);

/// O(cells + trees + steps).
CrownScene findCrowns(const City& city, const Receivers& receivers, const SunSteps& sun);
/// Of points on any surface, likewise.
CrownScene findCrowns(const City& city, const SurfacePoints& points, const SunSteps& sun);

/// Which crowns may shade one of these places. `places`: at least one. `lowestTan`: of the lowest sun's
/// altitude. O(places + crowns).
std::vector<std::uint32_t> findCrownsNear(const std::vector<Crown>& crowns, std::span<const glm::vec3> places,
                                          double lowestTan);

/// Both columns as the field without trees, without its cost and warnings.
TreeShade makeTreeShade(const ShadowField& without, std::size_t treesUsed);

/// Adds the shade of a city's trees to masks, which know lit and shaded only.
class CrownMasks {
public:
    CrownMasks() = default;
    /// Of receivers in a box, none of which is lower than `lowestM`. Without crowns where the city's trees
    /// are not weighed. O(trees)
    CrownMasks(const City& city, const Box2& receivers, float lowestM, const SunSteps& sun);

    [[nodiscard]] bool empty() const { return crowns_.empty(); }
    /// Puts into shadow, of what is lit at the steps of a day, those receivers from which crowns take at
    /// least TreeShade::defaultShadedFrom of the sun. `origins`: of the receivers' rays. By the exact path
    /// through each crown, of suns within half a degree once. Uses all cores; some 10 ns for each crown near
    /// the azimuth of each half degree, and some ns for each crown and 64 receivers.
    void addTo(StepMasks& masks, CivilDate day, std::span<const SunStep> steps,
               std::span<const glm::vec3> origins) const;

private:
    std::vector<Crown> crowns_;
    LeafSeasons seasons_{LeafDays{}};
};

}  // namespace noonmark
