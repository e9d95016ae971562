#include "core/io/footprints/outline_remainder.h"

#include <algorithm>
#include <limits>

#include "core/city/footprints/plan_overlay.h"

namespace noonmark {

namespace {

using Parts = std::vector<const PlacedFeature*>;

bool isStated(const HeightReading& heights) { return heights.source != HeightSource::assumed; }

// The parts that occupy some of the outline's height.
Parts replacing(const HeightReading& outline, const Parts& parts) {
    if (!isStated(outline)) return parts;
    Parts found;
    for (const PlacedFeature* part : parts)
        if (part->facts.heights.bottomM < outline.topM - 0.01) found.push_back(part);
    return found;
}

bool ownHeightHolds(const HeightReading& outline, const Parts& parts) {
    if (!isStated(outline)) return false;
    double tallest = 0;
    for (const PlacedFeature* part : parts) tallest = std::max(tallest, part->facts.heights.topM);
    const double slack = outline.source == HeightSource::levels ? 1.5 : 1.1;
    return tallest > slack * outline.topM || tallest < 0.5 * outline.topM;
}

double guessedTop(const HeightReading& outline, const Parts& parts) {
    constexpr double far = std::numeric_limits<double>::max();
    double lowestTop = far;
    double lowestUnderside = far;
    for (const PlacedFeature* part : parts) {
        const HeightReading& heights = part->facts.heights;
        if (heights.bottomM <= 0)
            lowestTop = std::min(lowestTop, heights.topM);
        else
            lowestUnderside = std::min(lowestUnderside, heights.bottomM);
    }
    const double top = lowestTop < far ? lowestTop : lowestUnderside;
    return isStated(outline) ? std::min(top, outline.topM) : top;
}

}  // namespace

OutlineRemainder computeRemainder(const PlacedFeature& outline, const Parts& parts) {
    const HeightReading& own = outline.facts.heights;
    OutlineRemainder rest{outline.pieces, own.bottomM, own.topM, own.source, false};
    const Parts covering = replacing(own, parts);
    if (covering.empty()) return rest;
    std::vector<Footprint> cover;
    for (const PlacedFeature* part : covering)
        cover.insert(cover.end(), part->pieces.begin(), part->pieces.end());
    rest.pieces = cutPiecesOutside(outline.pieces, cover, {});
    if (ownHeightHolds(own, covering)) return rest;
    rest.topM = guessedTop(own, covering);
    rest.source = HeightSource::assumed;
    rest.guessed = true;
    if (rest.bottomM > rest.topM - minHeightM) rest.bottomM = 0;
    return rest;
}

}  // namespace noonmark
