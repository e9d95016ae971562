#include "core/engines/common/open_below.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <numbers>

#include "core/city/footprints/plan_areas.h"
#include "core/city/footprints/plan_overlay.h"

namespace noonmark {

namespace {

constexpr float touchM = 0.05F;          // a carrier may end so far below
constexpr MinPiece minimum{0.01, 0.01};  // smaller pieces are drawing inaccuracies

bool meet(const Box2& a, const Box2& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

bool reaches(const Part& lower, const Part& part) {
    return &lower != &part && !lower.isOverhanging && lower.bottomM < part.bottomM &&
           lower.topM >= part.bottomM - touchM;
}

std::vector<Footprint> findCarriers(const Building& building, const Part& part) {
    std::vector<Footprint> carriers;
    const Box2 box = bounds(part.footprint);
    for (const Part& lower : building.parts)
        if (reaches(lower, part) && meet(box, bounds(lower.footprint))) carriers.push_back(lower.footprint);
    return carriers;
}

// A part that is carried by nothing stands on the ground, or was lowered onto it.
void addOpen(const Building& building, const Part& part, std::vector<OpenBelow>& open) {
    const std::vector<Footprint> carriers = findCarriers(building, part);
    if (carriers.empty()) return;
    const double closed = area(part.footprint) - minimum.areaM2;
    const auto carriesAll = [&](const Footprint& carrier) {
        return computeSharedArea(part.footprint, carrier) > closed;
    };
    if (std::ranges::any_of(carriers, carriesAll)) return;
    if (boundAreaOutside({part.footprint}, carriers).maxM2 < minimum.areaM2) return;
    for (const Footprint& piece : cutPiecesOutside({part.footprint}, carriers, minimum))
        open.push_back({piece, bounds(piece), part.bottomM, part.topM});
}

/// Azimuths from `low` to `high`, radians.
struct Arc {
    double low, high;
};

// Half a turn or more if the place is among the corners.
Arc arcOf(const Ring& ring, glm::dvec2 place) {
    const auto azimuthOf = [&](glm::vec2 corner) {
        const glm::dvec2 to = glm::dvec2(corner) - place;
        return std::atan2(to.x, to.y);
    };
    const double first = azimuthOf(ring.front());
    Arc arc{first, first};
    for (const glm::vec2 corner : ring) {
        const double azimuth = first + std::remainder(azimuthOf(corner) - first, 2 * std::numbers::pi);
        arc = {std::min(arc.low, azimuth), std::max(arc.high, azimuth)};
    }
    return arc;
}

}  // namespace

std::vector<OpenBelow> findOpenBelow(const City& city, std::span<const std::uint32_t> buildings) {
    std::vector<std::vector<OpenBelow>> ofEach(buildings.size());
    tbb::parallel_for(std::size_t{0}, buildings.size(), [&](std::size_t i) {
        const Building& building = *city.buildings[buildings[i]];
        if (building.parts.size() < 2) return;
        for (const Part& part : building.parts)
            if (!part.isOverhanging && !part.mesh) addOpen(building, part, ofEach[i]);
    });
    std::vector<OpenBelow> all;
    for (const auto& some : ofEach) all.insert(all.end(), some.begin(), some.end());
    return all;
}

bool isIn(const OpenBelow& open, glm::vec3 eye) {
    constexpr float spareM = 0.05F;
    const glm::vec2 at(eye);
    if (eye.z >= open.bottomM || glm::any(glm::lessThan(at, open.box.low - spareM)) ||
        glm::any(glm::greaterThan(at, open.box.high + spareM)))
        return false;
    return contains(open.piece, glm::dvec2(at)) || distanceTo(open.piece.outer, glm::dvec2(at)) < spareM;
}

SeenOpenBelow seeFrom(const OpenBelow& open, const EyeBox& eyes) {
    constexpr SeenOpenBelow allAround{0, std::numbers::pi, std::numeric_limits<double>::infinity()};
    const double rise = double(open.partTopM) - double(eyes.low.z);
    if (open.bottomM <= eyes.low.z) return {0, 0, 0};
    const glm::dvec2 eye = (glm::dvec2(eyes.low) + glm::dvec2(eyes.high)) / 2.0;
    const double around = glm::distance(glm::dvec2(eyes.high), eye),
                 nearest = distanceTo(open.piece.outer, eye) - around;
    const Arc arc = arcOf(open.piece.outer, eye);
    if (nearest <= 0 || arc.high - arc.low >= std::numbers::pi) return allAround;
    return {(arc.low + arc.high) / 2, (arc.high - arc.low) / 2 + std::asin(around / (around + nearest)),
            rise / nearest};
}

}  // namespace noonmark
