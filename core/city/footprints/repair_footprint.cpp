#include "core/city/footprints/repair_footprint.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace noonmark {

namespace {

constexpr std::size_t maxPairs = 30'000'000;

// A side of a ring; the sweep runs along `x`.
struct OutlineSide {
    glm::dvec2 from{};
    glm::dvec2 to{};
    double lowX = 0, highX = 0, lowY = 0, highY = 0;
};

double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool haveCommonEnd(const OutlineSide& a, const OutlineSide& b) {
    return a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
}

// Rounding may decide a touch either way: the count is only compared with a rough limit.
bool meet(const OutlineSide& a, const OutlineSide& b) {
    if (a.highY < b.lowY || b.highY < a.lowY || haveCommonEnd(a, b)) return false;
    return turn(a.from, a.to, b.from) * turn(a.from, a.to, b.to) <= 0 &&
           turn(b.from, b.to, a.from) * turn(b.from, b.to, a.to) <= 0;
}

OutlineSide sideOf(glm::dvec2 from, glm::dvec2 to) {
    return {from,
            to,
            std::min(from.x, to.x),
            std::max(from.x, to.x),
            std::min(from.y, to.y),
            std::max(from.y, to.y)};
}

// Chooses the sweep axis along which fewer sides overlap: the one in which they are shorter in total.
bool sweepsAlongY(const std::vector<RawRing>& rings) {
    glm::dvec2 sum(0);
    for (const RawRing& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) sum += glm::abs(ring[(i + 1) % ring.size()] - ring[i]);
    return sum.y < sum.x;
}

std::vector<OutlineSide> sidesOf(const std::vector<RawRing>& rings) {
    const bool alongY = sweepsAlongY(rings);
    const auto turned = [&](glm::dvec2 p) { return alongY ? glm::dvec2(p.y, p.x) : p; };
    std::vector<OutlineSide> sides;
    for (const RawRing& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            sides.push_back(sideOf(turned(ring[i]), turned(ring[(i + 1) % ring.size()])));
    std::ranges::sort(sides, {}, &OutlineSide::lowX);
    return sides;
}

}  // namespace

bool areTangled(const std::vector<RawRing>& rings) {
    std::vector<OutlineSide> open;  // sides that may still reach the current side
    std::size_t crossings = 0;
    std::size_t pairs = 0;
    for (const OutlineSide& side : sidesOf(rings)) {
        std::erase_if(open, [&](const OutlineSide& other) { return other.highX < side.lowX; });
        for (const OutlineSide& other : open) crossings += meet(side, other) ? 1 : 0;
        pairs += open.size();
        if (crossings > maxCrossings || pairs > maxPairs) return true;
        open.push_back(side);
    }
    return false;
}

}  // namespace noonmark
