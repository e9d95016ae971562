#include "core/io/pieces/read_part.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/city/building_heights.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_outline.h"
#include "core/geo/lon_lat.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

std::string describeCrs(const std::string& name, CrsSource source) {
    if (source == CrsSource::file) return name + ", as the file states";
    if (source == CrsSource::user) return name + ", as " + readOption("crs") + " states";
    return name + ", guessed from the numbers";
}

namespace {

constexpr double canopyColumnM = 8, maxColumns = 100'000;

using LocalRings = std::vector<std::vector<glm::dvec2>>;

double areaOfRing(const std::vector<glm::dvec2>& ring) {
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return std::abs(twice) / 2;
}

// Where the rings cross a line of this y, ascending; half-open as crossesRow().
std::vector<double> findRowCrossings(const LocalRings& rings, double y) {
    std::vector<double> crossings;
    for (const std::vector<glm::dvec2>& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
            if ((a.y <= y) != (b.y <= y)) crossings.push_back(a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y));
        }
    std::ranges::sort(crossings);
    return crossings;
}

}  // namespace

void coverWithCanopy(const std::vector<std::vector<LonLat>>& rings, const TreeFacts& facts,
                     std::vector<ReadTree>& trees) {
    if (rings.empty() || rings.front().empty()) return;
    const Frame frame(rings.front().front());
    LocalRings local(rings.size());
    for (std::size_t i = 0; i < rings.size(); ++i)
        for (const LonLat place : rings[i]) local[i].push_back(frame.localFromLonLat(place));
    const double sideM = std::max(canopyColumnM, std::sqrt(areaOfRing(local.front()) / maxColumns));
    double lowM = 0, highM = 0;
    for (const glm::dvec2 point : local.front()) {
        if (!std::isfinite(point.x + point.y)) return;
        lowM = std::min(lowM, point.y);
        highM = std::max(highM, point.y);
    }
    TreeFacts column = facts;
    column.canopyCellM2 = sideM * sideM;
    for (double y = (std::floor(lowM / sideM) + 0.5) * sideM; y < highM; y += sideM) {
        const std::vector<double> crossings = findRowCrossings(local, y);
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
            for (double x = (std::ceil(crossings[i] / sideM - 0.5) + 0.5) * sideM; x < crossings[i + 1];
                 x += sideM)
                trees.push_back({frame.lonLatFromLocal({x, y}), column});
    }
}

namespace {

constexpr float farthestM = 1e6F, deepestM = -2e4F, highestM = 2e4F;

// Null if it is plausible.
const char* whyImplausible(const Building& building) {
    float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
    for (const Part& part : building.parts) {
        if (!std::isfinite(part.bottomM) || !std::isfinite(part.topM)) return "its height is not a number";
        low = std::min(low, part.bottomM), high = std::max(high, part.topM);
    }
    if (building.parts.empty()) return nullptr;
    if (double(high) - double(low) > tallestBuildingM) return "it is higher than 2,000 m";
    if (low < deepestM || high > highestM) return "it lies more than 20 km below or above the ground";
    const Box2 box = bounds(building);
    const bool near = box.low.x >= -farthestM && box.low.y >= -farthestM && box.high.x <= farthestM &&
                      box.high.y <= farthestM;
    return near ? nullptr : "it lies more than 1,000 km from the middle of the city";
}

void warn(const std::string& file, const Building& building, const char* why, Warnings& warnings) {
    warnings.push_back({WarningKind::leftOut, why, fmt::format("{}: {}", file, building.sourceId)});
}

// Keeps the buildings that `isKept` says, with what belongs to each. Returns the number of the others.
template <class Keeps>
std::size_t keepBuildings(FilePiece& piece, const Keeps& isKept) {
    const std::size_t all = piece.buildings.size();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all; ++i) {
        if (!isKept(*piece.buildings[i])) continue;
        if (!piece.groundM.empty()) piece.groundM[kept] = piece.groundM[i];
        if (!piece.roofs.empty() && kept != i) piece.roofs[kept] = std::move(piece.roofs[i]);
        if (kept != i) piece.buildings[kept] = std::move(piece.buildings[i]);
        ++kept;
    }
    piece.buildings.resize(kept);
    if (!piece.groundM.empty()) piece.groundM.resize(kept);
    if (!piece.roofs.empty()) piece.roofs.resize(kept);
    return all - kept;
}

}  // namespace

Result<void> leaveOutImplausible(const std::string& file, FilePiece& piece) {
    const char* lastWhy = nullptr;
    keepBuildings(piece, [&](const Building& building) {
        const char* why = whyImplausible(building);
        if (why == nullptr) return true;
        warn(file, building, why, piece.warnings);
        lastWhy = why;
        return false;
    });
    if (piece.buildings.empty() && lastWhy != nullptr)
        return failure(fmt::format("No building can be used, each because {}", lastWhy), file,
                       "Check the unit of its coordinates and which axis is up");
    return {};
}

void keepExtent(const std::string& file, FilePiece& piece, const Frame& frame, const LonLatBox& extent) {
    const std::size_t out = keepBuildings(piece, [&](const Building& building) {
        const Box2 box = bounds(building);
        LonLatBox place = emptyLonLatBox;
        for (const glm::dvec2 corner : {glm::dvec2(box.low), glm::dvec2(box.low.x, box.high.y),
                                        glm::dvec2(box.high), glm::dvec2(box.high.x, box.low.y)})
            place.add(frame.lonLatFromLocal(corner));
        return place.touches(extent);
    });
    if (out > 0)
        piece.warnings.push_back({WarningKind::leftOut, "buildings outside of " + readOption("extent"),
                                  fmt::format("{} ({})", file, formatThousands(out))});
}

namespace {

using Shared = std::shared_ptr<const Building>;

double boxArea(const Box2& box) {
    if (box.empty()) return 0;
    return double(box.high.x - box.low.x) * double(box.high.y - box.low.y);
}

double sharedArea(const Box2& a, const Box2& b) {
    return boxArea({{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
                    {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}});
}

std::vector<Footprint> outlineOf(const Building& building) {
    std::vector<Footprint> pieces;
    for (const Part& part : building.parts) pieces.push_back(part.footprint);
    return pieces.size() > 1 ? computeUnion(pieces) : pieces;
}

float bottomM(const Building& building) {
    float lowest = 1e30F;
    for (const Part& part : building.parts) lowest = std::min(lowest, part.bottomM);
    return lowest;
}

// Whether they stand side by side in height, rather than one on the other.
bool shareHeights(const Building& a, const Building& b) {
    const float shared = std::min(topM(a), topM(b)) - std::max(bottomM(a), bottomM(b));
    const float lower = std::min(topM(a) - bottomM(a), topM(b) - bottomM(b));
    return shared > lower / 2;
}

bool shareOutlines(const Building& a, const Building& b, bool sameId) {
    constexpr double sameShare = 0.95;
    const auto one = outlineOf(a), other = outlineOf(b);
    const double smaller = std::min(area(one), area(other)), larger = std::max(area(one), area(other));
    if (!sameId && smaller < sameShare * larger) return false;
    const double shared = computeSharedArea(one, other);
    if (shared >= sameShare * larger) return true;
    // Two copies of one building, one of which was cut at the edge of its map, are equally high; a tower on
    // its podium is not.
    constexpr float sameHeightM = 0.5F;
    return sameId && shared > smaller / 2 && std::abs(topM(a) - topM(b)) <= sameHeightM;
}

bool areSame(const Building& a, const Box2& boxA, const Building& b, const Box2& boxB) {
    constexpr double nearlySame = 0.85;  // of boxes, as a first test
    const bool sameId = !a.sourceId.empty() && a.sourceId == b.sourceId;
    const double shared = sharedArea(boxA, boxB);
    if (!sameId && shared < nearlySame * std::max(boxArea(boxA), boxArea(boxB))) return false;
    return shared > 0 && shareHeights(a, b) && shareOutlines(a, b, sameId);
}

int rankOf(HeightSource source) {
    return source == HeightSource::assumed ? 2 : source == HeightSource::levels ? 1 : 0;
}

// Lower is better known.
int rankOf(const Building& building) {
    int worst = 0;
    for (const Part& part : building.parts) worst = std::max(worst, rankOf(part.heightSource));
    return worst;
}

bool isBetter(const Building& a, const Building& b) {
    const int one = rankOf(a), other = rankOf(b);
    if (one != other) return one < other;
    constexpr float sameHeightM = 0.01F;
    return topM(a) > topM(b) + sameHeightM;
}

}  // namespace

std::vector<SameBuilding> findSameBuildings(const std::vector<Shared>& buildings) {
    std::vector<Box2> boxes;
    for (const Shared& building : buildings) boxes.push_back(bounds(*building));
    std::vector<Box2> middles;  // fewer pairs meet: buildings that are the same cover each other's middle
    for (const Box2& box : boxes)
        middles.push_back(box.empty() ? box : Box2{(box.low + box.high) / 2.0F, (box.low + box.high) / 2.0F});
    std::vector<bool> isDropped(buildings.size());
    std::vector<SameBuilding> same;
    for (const auto& [i, j] : findMeetingBoxes(middles, boxes)) {
        if (i == j || isDropped[i] || isDropped[j]) continue;
        if (!areSame(*buildings[i], boxes[i], *buildings[j], boxes[j])) continue;
        const std::size_t first = std::min(i, j), second = std::max(i, j);
        const bool secondKept = isBetter(*buildings[second], *buildings[first]);
        const std::size_t kept = secondKept ? second : first, dropped = secondKept ? first : second;
        same.push_back({kept, dropped, buildings[i]->sourceId == buildings[j]->sourceId});
        isDropped[dropped] = true;
    }
    return same;
}

}  // namespace noonmark
