#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/city/city.h"
#include "core/describe/choice.h"
#include "core/describe/text.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// What of a city stands above a horizontal plane, lowered by its height, so that the plane becomes level
/// ground, on which the exact engines work. `planeM`: metres above the ground, at least 0. Buildings wholly
/// below the plane are left out. Nothing where the city has terrain or a mesh: there, receivers must be
/// raised instead (raiseToPlane()).
std::optional<City> cutAbovePlane(const City& city, double planeM);

/// Raises all receivers to a horizontal plane, metres above the mean of the ground under them.
void raiseToPlane(Receivers& receivers, double planeM);

inline constexpr std::array receiverPlaceChoices{
    Choice{ReceiverPlaces::ground, "ground", NM_TEXT("on the ground")},
    Choice{ReceiverPlaces::roofs, "roofs", NM_TEXT("on roofs")},
    Choice{ReceiverPlaces::both, "both", NM_TEXT("on the ground and roofs")}};

/// "ground", "roofs" or "both": the names on the command line and in files.
inline std::string_view nameOf(ReceiverPlaces places) {
    return keyOf<ReceiverPlaces>(receiverPlaceChoices, places);
}

/// In words: "the ground", "roofs", "the ground and roofs".
std::string_view describe(ReceiverPlaces places);

/// Error for anything but the ground: comparisons and scores of cities support the ground only.
Result<void> checkOnGround(ReceiverPlaces places);

/// The receivers of a region at the places of its settings. The same errors as placeReceiversOnGround().
Result<Receivers> placeReceivers(const City& city, const Region& region, const ReceiverSettings& settings,
                                 const std::stop_token& stop = {});

/// Makes the receivers for `places` from receivers on the ground of a city. A roof is the highest surface of
/// a building at a cell's centre, for cells whose centre is where a part touches the ground: decks over open
/// ground are left out, and so are roof overhangs. O(cells of the buildings + triangles of their meshes).
Receivers placeAtHeights(Receivers onGround, const City& city, ReceiverPlaces places);

}  // namespace noonmark
