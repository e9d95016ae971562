#pragma once

#include "scenarios/massing/massing.h"

namespace noonmark {

/// A tower's settings for another lot, and what had to change.
struct CopiedMassing {
    MassingSettings settings;
    bool plateReduced = false;  ///< the other lot, or the podium on it, is smaller than the plate
    bool turnDropped = false;   ///< turned, the plate would leave the other lot
    bool twistDropped = false;  ///< twisted, a volume would leave the other lot
    int setbacksDropped = 0;    ///< from the top: they would leave nothing of the plate
    bool operator==(const CopiedMassing&) const = default;
};

/// Settings that build on `to` the tower that `settings` build on `from`: storeys, heights and setbacks stay,
/// plates keep their area in m2. A plate takes the shape of its lot, so the tower turns with it. What is not
/// possible there is changed as little as CopiedMassing tells. Error, as of makeMassing(): no tower is
/// possible. Some 5 ms for each plate tried.
Result<CopiedMassing> copyMassing(const Footprint& from, const MassingSettings& settings,
                                  const Footprint& to);

}  // namespace noonmark
