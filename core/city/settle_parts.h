#pragma once

#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/building.h"

namespace noonmark {

/// Parts of one building that start above the ground, and what becomes of them. From the lowest up: a part is
/// carried where standing parts reach up to its underside below all of its footprint (but 5 % of it and 0.5
/// m2), and then stands. Else:
/// - Up to `carryGapM` above what would carry it, or up to `groundGapM` above the ground, its underside is
/// lowered to close
///   the gap: mapped heights seldom meet, and light would fall through a slit that is not there. A warning
///   each (mended).
/// - Otherwise it hangs.
/// Parts whose `hangs` is set already are left as they are, and carry nothing.
struct SettleRules {
    float groundM = 0;       ///< local z of the ground
    float carryGapM = 3.2F;  ///< a storey
    float groundGapM = 2;    ///< lower than a passage
};
void settleParts(std::vector<Part>& parts, const SettleRules& rules, Warnings& warnings);

}  // namespace noonmark
