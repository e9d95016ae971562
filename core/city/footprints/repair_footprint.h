#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/footprints/footprint.h"

namespace noonmark {

/// A ring as read from a file, local metres, closed or not.
using RawRing = std::vector<glm::dvec2>;

/// No building, place or region has an outline of more points, holes included; readers refuse it, since its
/// repair would take seconds to minutes.
inline constexpr std::size_t maxOutlinePoints = 100'000;

/// The outcome of repairing a polygon.
struct RepairedFootprint {
    std::vector<Footprint> pieces;  ///< disjoint, each simple and oriented; none if nothing usable was left
    WarningKind kind = WarningKind::repaired;
    std::string what;  ///< what was wrong, as text for a Warning; empty if the polygon was valid
};

/// Makes a polygon with holes valid, in GEOS's sense. An invalid polygon goes through MakeValid (the
/// outline's interior minus the holes' interiors), slivers under 0.01 m2 are dropped, repeated points merged,
/// and the orientation corrected. Every point is a float32, and the result is valid as such: if rounding
/// makes points coincide or edges cross, all points are snapped to float32's step (1 mm at 10 km). A hole
/// that lies wholly outside is most often a second outline: it becomes a piece of its own, and `what` says
/// so. An outline without an interior gives no pieces. `rings[0]` is the outer ring, the others are holes.
/// Refused, with no pieces: rings with more than maxCrossings crossings (areTangled()), and coordinates
/// over 1e8 m or not finite. About 5 us for a valid polygon of few points.
RepairedFootprint repairFootprint(const std::vector<RawRing>& rings);

/// No building outline has more crossings than this; making such a polygon valid would take seconds to
/// minutes.
inline constexpr std::size_t maxCrossings = 2000;

/// Whether the sides of the rings cross or touch more than maxCrossings times, not counting the common
/// points of neighbouring sides. Also true if so many sides lie beside one another that counting would take
/// over 0.2 s. Points must be finite.
bool areTangled(const std::vector<RawRing>& rings);

}  // namespace noonmark
