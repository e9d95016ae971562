#include "app/window/view/ground_lines.h"

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

}  // namespace

std::vector<GroundLine> makeGroundLines(const Region& region, const City& city) {
    std::vector<GroundLine> lines;
    for (const Footprint& polygon : region.polygons) {
        lines.push_back(lineOf(polygon.outer, city, true));
        for (const Ring& hole : polygon.holes) lines.push_back(lineOf(hole, city, true));
    }
    return lines;
}

GroundLine makeGroundLine(const std::vector<glm::vec3>& points, const City& city, bool closed) {
    return lineOf(Ring(points.begin(), points.end()), city, closed);
}

}  // namespace noonmark
