#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/city/footprints/footprint.h"
#include "core/engines/api/engine.h"
#include "core/receivers/place.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The shortest distance between two groups of polygons in plan, metres; 0 where they overlap or touch.
/// Infinite where one group is empty. O(sides x sides) for those whose boxes are not farther apart than what
/// was found before.
double measureDistanceM(const std::vector<Footprint>& a, const std::vector<Footprint>& b);

/// Azimuths clockwise from `fromDeg` to `toDeg`, from true north; less than 180 deg wide.
struct AzimuthSector {
    double fromDeg = 0;
    double toDeg = 0;
    bool operator==(const AzimuthSector&) const = default;
};

struct ScreeningSettings {
    /// Length of the longest shadow per metre of height: a rule's (4.3 in New York), or, if empty, that of
    /// the lowest sun of the steps.
    std::optional<double> lengthFactor;
    /// Where, as seen from the proposal, no shadow falls: a rule's (108 to 252 deg in New York), or, if
    /// empty, the widest sector that the sun of the steps leaves free.
    std::optional<AzimuthSector> noShadow;
    double cellM = 2;  ///< of the test of the real reach, 0.25 to 10
};

/// The first test that rules a place out, or that none does.
enum class ScreeningResult {
    outOfLength,  ///< farther away than the longest shadow
    outOfSector,  ///< wholly within the sector in which no shadow falls
    notReached,   ///< no cell is in the proposal's shadow at any step
    reached,
};
/// "beyond the longest shadow", "in the no-shadow sector", "not reached", "reached".
std::string_view nameOf(ScreeningResult result);

/// One place, as screened.
struct ScreenedPlace {
    std::size_t place = 0;  ///< index in the places that were given
    ScreeningResult result = ScreeningResult::reached;
    double distanceM = 0;   ///< between the outlines of the proposal's nearest building and the place
    double azimuthDeg = 0;  ///< from the proposal's middle to that of the place, clockwise from true north
    double longestM = 0;    ///< the longest shadow that was assumed for the building that comes nearest
    double minutes = 0;     ///< steps in which the proposal's shadow reaches it x step length
    std::optional<Instant> first;  ///< the first of these steps
    std::string reason;            ///< in words: "412 m away; the shadow is at most 387 m long"
};

/// Which places the shadow of a proposal can reach, before its effect is computed. The proposal is what
/// stands in `scenario` and not in `baseline`; it is tested as if it stood alone, so a place that other
/// buildings shade anyway counts as reached. Three tests, each for the places that passed those before: the
/// longest shadow, the no-shadow sector, then the real reach with the engine's shadows at all steps. A sliver
/// of shadow narrower than the cells may be missed by the third.
///
/// Error: the scenario adds no building; errors of Engine::shadeSteps(). Four days of minutes over Midtown's
/// places take less than a second.
Result<std::vector<ScreenedPlace>> screenPlaces(const City& baseline, const City& scenario,
                                                std::span<const Place> places, const SunSteps& sun,
                                                const ScreeningSettings& settings, const Engine& engine,
                                                Progress& progress, std::stop_token stop);

/// The widest sector of azimuths, as seen from a building, into which no shadow falls at any step; none if
/// the steps leave less than 1 deg free.
std::optional<AzimuthSector> findNoShadowSector(const SunSteps& sun);

/// Length of the shadow per metre of height at the lowest sun of the steps; 0 without steps.
double findLengthFactor(const SunSteps& sun);

}  // namespace noonmark
