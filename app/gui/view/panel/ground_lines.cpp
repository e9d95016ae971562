#include "app/gui/view/panel/ground_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

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
    const auto isThere = [&](const Building& gone) {
        return std::ranges::any_of(changes.added.buildings,
                                   [&](const auto& added) { return added->sourceId == gone.sourceId; });
    };
    Region outlines;
    for (const std::uint32_t index : changes.gone)
        if (const Building& gone = *drawn.buildings[index]; !isThere(gone))
            for (const Part& part : gone.parts)
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

}  // namespace noonmark
