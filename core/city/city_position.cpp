#include "core/city/city_position.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "core/geo/frame.h"

namespace noonmark {

namespace {

constexpr float cellM = 200;         // of the grid that groups buildings: neighbouring cells are one group
constexpr double mainShare = 0.95;   // of the footprint area
constexpr float besideShare = 0.25;  // of the longer side: what lies as near belongs to the main part
constexpr float stepM = 50;          // of the boxes that are tried
constexpr double nearlyDensest = 0.9;

struct Body {
    Box2 box;
    glm::vec2 middle{0};
    double areaM2 = 0;
};

// Parts that stand on others would count their ground twice.
double footprintArea(const Building& building) {
    float lowM = std::numeric_limits<float>::max();
    for (const Part& part : building.parts) lowM = std::min(lowM, part.bottomM);
    double sum = 0;
    for (const Part& part : building.parts)
        if (part.bottomM <= lowM + 1) sum += area(part.footprint);
    return sum;
}

std::vector<Body> listBodies(const City& city) {
    std::vector<Body> bodies;
    bodies.reserve(city.buildings.size());
    for (const auto& building : city.buildings) {
        const Box2 box = bounds(*building);
        if (!box.empty()) bodies.push_back({box, (box.low + box.high) / 2.0F, footprintArea(*building)});
    }
    return bodies;
}

using Square = std::pair<std::int64_t, std::int64_t>;

Square cellOf(glm::vec2 at) {
    return {std::int64_t(std::floor(at.x / cellM)), std::int64_t(std::floor(at.y / cellM))};
}

/// Cells that hold buildings and touch each other, at corners, too.
struct Group {
    Box2 box;
    double areaM2 = 0;
};

/// Groups the cells that hold buildings.
class Grouping {
public:
    explicit Grouping(const std::vector<Body>& bodies) {
        for (const Body& body : bodies) {
            Group& cell = cells_[cellOf(body.middle)];
            cell.box.add(body.box);
            cell.areaM2 += body.areaM2;
        }
    }

    // Largest area first.
    std::vector<Group> list() {
        std::vector<Group> groups;
        while (!cells_.empty()) groups.push_back(takeGroup());
        std::ranges::sort(groups, std::greater(), &Group::areaM2);
        return groups;
    }

private:
    Group takeGroup() {
        Group group;
        std::vector<Square> waiting{cells_.begin()->first};
        while (!waiting.empty()) {
            const auto found = cells_.find(waiting.back());
            waiting.pop_back();
            if (found == cells_.end()) continue;
            group.box.add(found->second.box);
            group.areaM2 += found->second.areaM2;
            const auto [column, row] = found->first;
            cells_.erase(found);
            for (int x = -1; x <= 1; ++x)
                for (int y = -1; y <= 1; ++y) waiting.emplace_back(column + x, row + y);
        }
        return group;
    }

    std::map<Square, Group> cells_;
};

Box2 findMainBox(const std::vector<Body>& bodies) {
    const std::vector<Group> groups = Grouping(bodies).list();
    double whole = 0, held = 0;
    for (const Group& group : groups) whole += group.areaM2;
    Box2 box;
    for (const Group& group : groups) {
        box.add(group.box);
        held += group.areaM2;
        if (held >= mainShare * whole) break;
    }
    return box;
}

Box2 grown(const Box2& box, float byM) { return {box.low - byM, box.high + byM}; }

bool has(const Box2& box, glm::vec2 point) {
    return point.x >= box.low.x && point.x <= box.high.x && point.y >= box.low.y && point.y <= box.high.y;
}

double areaIn(const std::vector<Body>& bodies, const Box2& box) {
    double sum = 0;
    for (const Body& body : bodies)
        if (has(box, body.middle)) sum += body.areaM2;
    return sum;
}

/// Footprint area south-west of each corner of a grid of steps, so that the area in any box takes four sums.
class AreaSums {
public:
    AreaSums(const std::vector<Body>& bodies, const Box2& within)
        : low_(within.low),
          columns_(stepsOf(within.high.x - within.low.x)),
          rows_(stepsOf(within.high.y - within.low.y)),
          sums_(std::size_t(columns_ + 1) * std::size_t(rows_ + 1)) {
        for (const Body& body : bodies)
            if (has(within, body.middle)) {
                const glm::vec2 step = (body.middle - low_) / stepM;
                at(std::min(int(step.x), columns_ - 1) + 1, std::min(int(step.y), rows_ - 1) + 1) +=
                    body.areaM2;
            }
        for (int row = 1; row <= rows_; ++row)
            for (int column = 1; column <= columns_; ++column)
                at(column, row) += at(column - 1, row) + at(column, row - 1) - at(column - 1, row - 1);
    }

    // The first from the south-west among equals.
    [[nodiscard]] glm::vec2 densestCorner(glm::vec2 sizeM) {
        const int wide = std::min(columns_, stepsOf(sizeM.x)), high = std::min(rows_, stepsOf(sizeM.y));
        double maximum = -1;
        glm::vec2 corner = low_;
        for (int row = 0; row + high <= rows_; ++row)
            for (int column = 0; column + wide <= columns_; ++column) {
                const double held = at(column + wide, row + high) - at(column, row + high) -
                                    at(column + wide, row) + at(column, row);
                if (held <= maximum) continue;
                maximum = held;
                corner = low_ + glm::vec2(column, row) * stepM;
            }
        return corner;
    }

private:
    static int stepsOf(float lengthM) { return std::max(1, int(std::ceil(lengthM / stepM))); }

    double& at(int column, int row) {
        return sums_[std::size_t(row) * std::size_t(columns_ + 1) + std::size_t(column)];
    }

    glm::vec2 low_;
    int columns_, rows_;
    std::vector<double> sums_;
};

}  // namespace

MainPart findMainPart(const City& city) {
    const std::vector<Body> bodies = listBodies(city);
    if (bodies.empty()) return {};
    const Box2 maximum = findMainBox(bodies);
    const float side = std::max(maximum.high.x - maximum.low.x, maximum.high.y - maximum.low.y);
    const Box2 near = grown(maximum, std::max(cellM, besideShare * side));
    MainPart part{maximum, 0};
    for (const Body& body : bodies)
        has(near, body.middle) ? part.box.add(body.box) : void(++part.farBuildings);
    return part;
}

Box2 findDensestBox(const City& city, const Box2& within, glm::vec2 sizeM) {
    const std::vector<Body> bodies = listBodies(city);
    const glm::vec2 size = glm::min(sizeM, within.high - within.low);
    const glm::vec2 middle = (within.low + within.high) / 2.0F;
    const Box2 central{middle - size / 2.0F, middle + size / 2.0F};
    const glm::vec2 low = glm::min(AreaSums(bodies, within).densestCorner(size), within.high - size);
    const Box2 densest{low, low + size};
    return areaIn(bodies, central) >= nearlyDensest * areaIn(bodies, densest) ? central : densest;
}

Observer placeObserver(const City& city, glm::dvec2 local) {
    Observer observer{city.frame.lonLatFromLocal(local), city.frame.originElevationM()};
    const glm::dmat2 level = city.frame.localFromEastNorth(observer.place);
    const glm::dvec2 slope = city.terrain ? earthDropSlope(local) : glm::dvec2(0);
    // Columns are the images of east, north and up.
    observer.frameFromPlace = {glm::dvec3(level[0], -glm::dot(slope, level[0])),
                               glm::dvec3(level[1], -glm::dot(slope, level[1])), glm::dvec3(0, 0, 1)};
    return observer;
}

double computeVerticalErrorDeg(double distanceM) {
    return Radians{distanceM / meanEarthRadiusM}.degrees().value;
}

}  // namespace noonmark
