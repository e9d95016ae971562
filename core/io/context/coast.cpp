#include "core/io/context/coast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "core/city/footprints/geos_shapes.h"
#include "core/city/footprints/plan_lines.h"

namespace noonmark {

namespace {

constexpr double minReachM = 100;
constexpr double reachShare = 0.1;  // of the box's shorter side
constexpr double maxDoubt = 0.01;   // share of an area's coast that may say otherwise: rounding

using Spot = std::pair<double, double>;
using Edge = std::pair<std::pair<float, float>, std::pair<float, float>>;

// As findFaces() rounds its corners.
glm::dvec2 rounded(glm::dvec2 point) { return glm::round(point / overlayGridM) * overlayGridM; }

Edge edgeOf(glm::vec2 from, glm::vec2 to) { return {{from.x, from.y}, {to.x, to.y}}; }

bool isInside(const Box2& box, glm::dvec2 point) {
    return point.x > double(box.low.x) && point.x < double(box.high.x) && point.y > double(box.low.y) &&
           point.y < double(box.high.y);
}

/// The part of a line inside the box (Liang and Barsky).
std::optional<PlanLine> clipLine(const PlanLine& line, const Box2& box) {
    double from = 0, to = 1;
    const glm::dvec2 along = line.b - line.a;
    for (int axis = 0; axis < 2; ++axis) {
        const double low = double(box.low[axis]) - line.a[axis], high = double(box.high[axis]) - line.a[axis];
        if (along[axis] == 0) {
            if (low > 0 || high < 0) return std::nullopt;
            continue;
        }
        const auto [first, last] = std::minmax({low / along[axis], high / along[axis]});
        from = std::max(from, first);
        to = std::min(to, last);
    }
    if (from >= to) return std::nullopt;
    return PlanLine{rounded(line.a + from * along), rounded(line.a + to * along)};
}

/// The nearest point on the sides of a box, for a point inside it.
glm::dvec2 nearestOnSides(const Box2& box, glm::dvec2 point) {
    const glm::dvec2 low(box.low), high(box.high);
    const std::array<glm::dvec2, 4> feet{
        {{low.x, point.y}, {high.x, point.y}, {point.x, low.y}, {point.x, high.y}}};
    return *std::ranges::min_element(feet, {}, [&](glm::dvec2 foot) { return glm::distance(foot, point); });
}

class SeaFinder {
public:
    SeaFinder(const std::vector<CoastLine>& coast, const Box2& box) : box_(box) {
        for (const CoastLine& line : coast)
            for (std::size_t i = 1; i < line.size(); ++i) add({line[i - 1], line[i]});
        continueEnds(coast);
    }

    Sea find() {
        if (directed_.empty()) return std::move(sea_);
        for (Footprint& face : findFaces(linesAndSides()))
            if (isSea(face)) sea_.polygons.push_back(std::move(face));
        return std::move(sea_);
    }

private:
    void add(const PlanLine& line) {
        const auto within = clipLine(line, box_);
        if (!within || within->a == within->b) return;
        lines_.push_back(*within);
        directed_.emplace(edgeOf(glm::vec2(within->a), glm::vec2(within->b)),
                          glm::distance(within->a, within->b));
    }

    // Ends that no other line goes on from: +1 where a line begins, -1 where it ends.
    void continueEnds(const std::vector<CoastLine>& coast) {
        std::map<Spot, int> ends;
        for (const CoastLine& line : coast) {
            if (line.size() < 2) continue;
            ++ends[{line.front().x, line.front().y}];
            --ends[{line.back().x, line.back().y}];
        }
        for (const auto& [spot, net] : ends)
            if (const glm::dvec2 end(spot.first, spot.second); net != 0 && isInside(box_, end))
                continueEnd(end, net);
    }

    void continueEnd(glm::dvec2 end, int net) {
        const glm::dvec2 size(box_.high - box_.low), foot = nearestOnSides(box_, end);
        const double distance = glm::distance(foot, end);
        if (std::abs(net) != 1 || distance > std::max(minReachM, reachShare * std::min(size.x, size.y)))
            return sea_.openEnds.push_back(end);
        sea_.continuedM.push_back(distance);
        net > 0 ? add({foot, end}) : add({end, foot});
    }

    [[nodiscard]] std::vector<PlanLine> linesAndSides() const {
        std::vector<PlanLine> lines = lines_;
        const glm::dvec2 low(box_.low), high(box_.high);
        const std::array<glm::dvec2, 4> corners{{low, {high.x, low.y}, high, {low.x, high.y}}};
        for (std::size_t i = 0; i < 4; ++i)
            lines.push_back({rounded(corners[i]), rounded(corners[(i + 1) % 4])});
        return lines;
    }

    // Metres of coast with the face on its left (land) and on its right (sea).
    void measure(const Ring& ring, double& landM, double& seaM) const {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::vec2 from = ring[i], to = ring[(i + 1) % ring.size()];
            if (const auto left = directed_.find(edgeOf(from, to)); left != directed_.end())
                landM += left->second;
            if (const auto right = directed_.find(edgeOf(to, from)); right != directed_.end())
                seaM += right->second;
        }
    }

    // A footprint lies on the left of its rings.
    bool isSea(const Footprint& face) {
        double landM = 0, seaM = 0;
        measure(face.outer, landM, seaM);
        for (const Ring& hole : face.holes) measure(hole, landM, seaM);
        if (seaM <= maxDoubt * landM || seaM == 0) return false;
        if (landM > maxDoubt * seaM) return ++sea_.contradictions, false;
        return std::ranges::none_of(sea_.openEnds, [&](glm::dvec2 end) { return contains(face, end); });
    }

    Box2 box_;
    std::vector<PlanLine> lines_;
    std::map<Edge, double> directed_;  ///< lengths by their ends
    Sea sea_;
};

}  // namespace

Sea findSea(const std::vector<CoastLine>& coast, const Box2& box) { return SeaFinder(coast, box).find(); }

}  // namespace noonmark
