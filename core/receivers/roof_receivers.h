#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/receivers/receivers.h"

namespace noonmark {

/// "ground", "roofs" or "both": of the command line and files.
std::string_view nameOf(ReceiverPlaces places);

inline constexpr std::array allReceiverPlaces{ReceiverPlaces::ground, ReceiverPlaces::roofs,
                                              ReceiverPlaces::both};

/// The places that nameOf() gives this name; nothing where there are none.
std::optional<ReceiverPlaces> parsePlaces(std::string_view name);

/// In words: "the ground", "roofs", "the ground and roofs".
std::string_view describe(ReceiverPlaces places);

/// Error where anything but the ground is asked for: what compares cities or scores them is of the ground.
Result<void> checkOnGround(ReceiverPlaces places);

/// The receivers of a region where its settings ask for them. The same errors as placeReceiversOnGround().
Result<Receivers> receiversIn(const City& city, const Region& region, const ReceiverSettings& settings,
                              const std::stop_token& stop = {});

/// From receivers on the ground of a city those in the places asked for. A roof is the highest surface of a
/// building at a cell's centre, for cells whose centre is where a part meets the ground: decks over open
/// ground are left out, and so are roofs that hang over it. O(cells of the buildings + triangles of their
/// meshes).
Receivers placed(Receivers onGround, const City& city, ReceiverPlaces places);

}  // namespace noonmark
