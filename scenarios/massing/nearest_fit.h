#pragma once

#include <optional>

#include "scenarios/massing/massing.h"

namespace noonmark {

/// The numbers of a tower that a lot can limit. Those of a setback count with its index.
enum class MassingNumber {
    height,
    storeyHeight,
    turn,
    plate,
    taper,
    twist,
    podiumStoreys,
    podiumPlate,
    podiumTaper,
    podiumTwist,
    setbackAbove,
    setbackInset,
    setbackTaper,
    setbackTwist,
};

/// What made a tower impossible, and the settings nearest to the wanted ones that are possible.
struct NearestFit {
    MassingNumber number = MassingNumber::height;
    std::size_t setback = 0;  ///< from below; of the numbers of a setback
    MassingSettings settings;
};

/// Where `wanted` is impossible on the lot and differs from `possible` in one number: that number, and
/// settings with the value nearest to the wanted one, on a step of 0.1 m, 1 %, 1 degree, 1 m2 or a whole
/// storey, with which a tower can be built. None: more than one number differs, or `possible` is not.
/// Takes about 15 times as long as makeMassing().
std::optional<NearestFit> findNearestFit(const Footprint& lot, const MassingSettings& possible,
                                         const MassingSettings& wanted);

}  // namespace noonmark
