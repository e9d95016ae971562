#pragma once

#include <array>
#include <string_view>

#include "core/describe/choice.h"
#include "core/describe/text.h"
#include "core/receivers/receivers.h"

namespace noonmark {

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
