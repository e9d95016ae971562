#pragma once

#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/building.h"

namespace noonmark {

/// Decides, for the parts of one building that start above the ground, whether they stand, are lowered or are
/// overhangs. From the lowest part up: a part is carried, and then stands, if standing parts reach up to its
/// underside below all of its footprint (except 5 % of it and 0.5 m2). Otherwise:
/// - If the gap to the parts that would carry it is at most `carryGapM`, or the gap to the ground at most
///   `groundGapM`, its underside is lowered to close the gap: mapped heights seldom match, and light would
///   pass through a slit that does not exist. Each gives a warning (repaired).
/// - Otherwise it becomes an overhang.
///
/// Parts with `isOverhanging` already set are left unchanged and carry nothing.
struct SettleRules {
    float groundM = 0;       ///< local z of the ground
    float carryGapM = 3.2F;  ///< a storey
    float groundGapM = 2;    ///< lower than a passage
};
void settleParts(std::vector<Part>& parts, const SettleRules& rules, Warnings& warnings);

}  // namespace noonmark
