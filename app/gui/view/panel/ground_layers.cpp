#include "app/gui/view/panel/ground_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/city/footprints/repair_footprint.h"

namespace noonmark {

namespace {

constexpr float liftM = 0.3F;

glm::vec3 onGround(glm::vec2 point, const City& city) {
    return {point, groundAt(city, glm::dvec2(point)) + liftM};
}

// On flat ground a straight line needs only its ends.
int splitIntoPieces(float lengthM, const City& city) {
    if (!city.terrain) return 1;
    return std::clamp(int(std::ceil(double(lengthM) / city.terrain->grid.cellM)), 1, 1000);
}

void addPiece(std::vector<glm::vec3>& line, glm::vec2 from, glm::vec2 to, const City& city) {
    const int pieces = splitIntoPieces(glm::distance(from, to), city);
    for (int i = 0; i < pieces; ++i)
        line.push_back(onGround(from + (to - from) * (float(i) / float(pieces)), city));
}

GroundLine lineOf(const Ring& ring, const City& city, bool closed) {
    GroundLine line;
    line.closed = closed;
    if (ring.empty()) return line;
    for (std::size_t i = 1; i < ring.size(); ++i) addPiece(line.points, ring[i - 1], ring[i], city);
    if (closed)
        addPiece(line.points, ring.back(), ring.front(), city);
    else
        line.points.push_back(onGround(ring.back(), city));
    return line;
}

// The middle of the widest piece of the polygon on the line from west to east at `y`.
glm::dvec2 findMiddleOfWidest(const Footprint& polygon, double y) {
    std::vector<double> crossings;
    const auto add = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 a(ring[i]), b(ring[(i + 1) % ring.size()]);
            if ((a.y <= y) != (b.y <= y)) crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
        }
    };
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
    std::ranges::sort(crossings);
    glm::dvec2 best(polygon.outer.front());
    double widest = 0;
    for (std::size_t i = 1; i < crossings.size(); i += 2)
        if (crossings[i] - crossings[i - 1] > widest) {
            widest = crossings[i] - crossings[i - 1];
            best = {(crossings[i] + crossings[i - 1]) / 2, y};
        }
    return best;
}

}  // namespace

std::vector<GroundLine> makeGroundLines(const Region& region, const City& city) {
    std::vector<GroundLine> lines;
    for (const Footprint& polygon : region.polygons) {
        lines.push_back(lineOf(polygon.outer, city, true));
        for (const Ring& hole : polygon.holes) lines.push_back(lineOf(hole, city, true));
    }
    return lines;
}

std::vector<GroundLine> makeDemolishedLines(const CityArrays& drawn, const ArrayDifference& changes,
                                            const City& city) {
    const auto isThere = [&](const Building& removed) {
        return std::ranges::any_of(changes.added.buildings,
                                   [&](const auto& added) { return added->sourceId == removed.sourceId; });
    };
    Region outlines;
    for (const std::uint32_t index : changes.removed)
        if (const Building& removed = *drawn.buildings[index]; !isThere(removed))
            for (const Part& part : removed.parts)
                if (!part.isOverhanging) outlines.polygons.push_back(part.footprint);
    return makeGroundLines(outlines, city);
}

glm::dvec2 findMarkPoint(const Footprint& polygon) {
    glm::dvec2 sum{0};
    double twice = 0;
    const glm::dvec2 origin(polygon.outer.front());
    for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
        const glm::dvec2 a = glm::dvec2(polygon.outer[i]) - origin;
        const glm::dvec2 b = glm::dvec2(polygon.outer[(i + 1) % polygon.outer.size()]) - origin;
        const double cross = a.x * b.y - a.y * b.x;
        sum += (a + b) * cross;
        twice += cross;
    }
    const glm::dvec2 centre = twice == 0 ? origin : origin + sum / (3 * twice);
    if (contains(polygon, centre)) return centre;
    return findMiddleOfWidest(polygon, centre.y);
}

GroundLine makeGroundLine(const std::vector<glm::vec3>& points, const City& city, bool closed) {
    return lineOf(Ring(points.begin(), points.end()), city, closed);
}

namespace {

constexpr int pixelsAlongSide = 24;

// Pixels along the four sides of the picture, in order.
std::vector<glm::dvec2> borderPixels(const ViewLens& lens) {
    const std::array<glm::dvec2, 4> corners{
        {{0, lens.heightPx}, {lens.widthPx, lens.heightPx}, {lens.widthPx, 0}, {0, 0}}};
    std::vector<glm::dvec2> pixels;
    for (std::size_t side = 0; side < 4; ++side)
        for (int i = 0; i < pixelsAlongSide; ++i)
            pixels.push_back(corners[side] +
                             (corners[(side + 1) % 4] - corners[side]) * (double(i) / pixelsAlongSide));
    return pixels;
}

// Sutherland-Hodgman clipping: the part of a ring on the inner side of one side of the box.
template <class Inside, class Cut>
RawRing clippedBy(const RawRing& ring, Inside inside, Cut cut) {
    RawRing clipped;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 from = ring[i];
        const glm::dvec2 to = ring[(i + 1) % ring.size()];
        if (inside(from)) clipped.push_back(from);
        if (inside(from) != inside(to)) clipped.push_back(cut(from, to));
    }
    return clipped;
}

RawRing clippedBy(const RawRing& ring, int axis, double border, double sign) {
    return clippedBy(
        ring, [=](glm::dvec2 p) { return sign * (p[axis] - border) >= 0; },
        [=](glm::dvec2 a, glm::dvec2 b) { return a + (b - a) * ((border - a[axis]) / (b[axis] - a[axis])); });
}

RawRing clippedTo(const Box2& box, RawRing ring) {
    for (int axis = 0; axis < 2; ++axis) {
        ring = clippedBy(ring, axis, double(box.low[axis]), 1);
        ring = clippedBy(ring, axis, double(box.high[axis]), -1);
    }
    return ring;
}

}  // namespace

Region visibleGround(const CameraPose& pose, const ViewLens& lens, const ViewBounds& bounds) {
    RawRing ring;
    for (const glm::dvec2 pixel : borderPixels(lens)) {
        ViewRay ray = makeRayThrough(pose, lens, pixel);
        // The ground may begin behind the eye of a parallel projection.
        if (pose.isParallel()) ray.origin -= 1e6 * ray.direction;
        // Rays above the horizon are lowered to meet the ground far outside any city.
        ray.direction.z = std::min(ray.direction.z, -1e-3);
        if (const auto hit = findPlaneHit(ray, pose.target.z)) ring.emplace_back(hit->x, hit->y);
    }
    const RawRing within = clippedTo(bounds.box, std::move(ring));
    if (within.size() < 3) return {};
    return {"the ground in view", repairFootprint({within}).pieces};
}

}  // namespace noonmark
