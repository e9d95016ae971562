#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace noonmark {

/// What was done to a feature that could not be used unchanged.
enum class WarningKind {
    repaired,  ///< its geometry was faulty and could be put right
    clipped,   ///< a piece of it was cut away
    dropped,   ///< it could not be used at all
    leftOut,   ///< it was left out on purpose (underground, far away)
    assumed,   ///< a value was missing or unreadable, and a stated default is used
};
std::string_view nameOf(WarningKind kind);

/// One thing that was done to one feature. The same problem always has the same text in `what`, so that
/// warnings can be counted.
struct Warning {
    WarningKind kind = WarningKind::assumed;
    std::string what;   ///< "outline crossed itself"
    std::string where;  ///< "way 264768896", "midtown.osm.pbf: relation 12, height"
};

using Warnings = std::vector<Warning>;

/// All warnings with the same kind and text.
struct WarningGroup {
    WarningKind kind = WarningKind::assumed;
    std::string what;
    std::vector<std::string> where;  ///< one per warning, in order of occurrence
};

/// Groups in order of first appearance. O(n log n).
std::vector<WarningGroup> groupWarnings(const Warnings& warnings);

/// "28 repaired: outline crossed itself (way 264768896, way 3, ...)"; lists at most `maximum` locations.
std::string lineOf(const WarningGroup& group, std::size_t maximum = 3);

}  // namespace noonmark
