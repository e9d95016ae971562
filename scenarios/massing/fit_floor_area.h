#pragma once

#include <optional>

#include "core/describe/field.h"
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

/// What may change so that a tower gets a floor area.
enum class FloorAreaBy { storeys, plate };

/// The gross floor area that a tower shall have; neither of the first two: not stated.
struct FloorAreaTarget {
    std::optional<double> grossFloorM2;
    std::optional<double> floorAreaRatio;  ///< of the lot's area
    FloorAreaBy by = FloorAreaBy::storeys;
    /// The wanted gross floor area on this lot, m2; none: not stated.
    [[nodiscard]] std::optional<double> areaOn(const Footprint& lot) const;
};
const Fields<FloorAreaTarget>& floorAreaFields();

/// The settings with which a tower has a gross floor area of `wantedM2`: with the most storeys that stay
/// within it, or with a plate with which it has that area to 0.1 %. All other settings stay; a height that
/// was stated becomes whole storeys. Error: the settings make no tower, or the smallest floor area that they
/// allow is above the wanted one or the largest below it; the error states it. Takes about 15 times as long
/// as makeMassing().
Result<MassingSettings> fitFloorArea(const Footprint& lot, const MassingSettings& settings, double wantedM2,
                                     FloorAreaBy by);

}  // namespace noonmark
