#include "core/measures/places/place_cells.h"

#include <algorithm>
#include <cmath>

#include "core/city/footprints/plan_overlay.h"
#include "core/city/terrain/building_ground.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

void addContacts(const City& city, const Building& building, std::vector<Footprint>& built) {
    for (const Part& part : building.parts) {
        const glm::vec2 corner = part.footprint.outer.empty() ? glm::vec2(0) : part.footprint.outer.front();
        for (Footprint& contact : findGroundContact(part, groundAt(city, glm::dvec2(corner))))
            built.push_back(std::move(contact));
    }
}

/// What the edges that pass through a cell cover of it, in cells: `right` of their own part of the row's
/// height, and `height`, which they cover of every cell farther east.
struct CellEdge {
    std::uint32_t cell = 0;
    double right = 0, height = 0;
};

/// Collects what edges cover, as font rasterisers do: the ground to the east of an edge counts once for an
/// edge that runs south, and is taken off again by one that runs north.
class EdgeWalk {
public:
    explicit EdgeWalk(const Grid& grid) : grid_(grid) {}

    void add(const Ring& ring, bool isHole) {
        const double sign = (signedArea(ring) < 0) == isHole ? 1 : -1;
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            addEdge(inCells(ring[j]), inCells(ring[i]), sign);
    }

    /// Ascending; of each cell one.
    std::vector<CellEdge> collect() {
        std::ranges::sort(edges_, {}, &CellEdge::cell);
        std::vector<CellEdge> sums;
        for (const CellEdge& edge : edges_) {
            if (sums.empty() || sums.back().cell != edge.cell) sums.push_back({edge.cell});
            sums.back().right += edge.right;
            sums.back().height += edge.height;
        }
        return sums;
    }

private:
    [[nodiscard]] glm::dvec2 inCells(glm::vec2 point) const {
        return (glm::dvec2(point) - glm::dvec2(grid_.westM, grid_.southM)) / grid_.cellM;
    }

    void addEdge(glm::dvec2 a, glm::dvec2 b, double sign) {
        if (a.y < b.y) sign = -sign;
        if (a.y > b.y) std::swap(a, b);
        const auto xAt = [&](double y) {
            return std::clamp(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y), std::min(a.x, b.x),
                              std::max(a.x, b.x));
        };
        const int end = int(std::clamp(std::ceil(b.y), 0.0, double(grid_.rows)));
        for (int row = int(std::clamp(std::floor(a.y), 0.0, double(grid_.rows))); row < end; ++row) {
            const double low = std::max(a.y, double(row)), high = std::min(b.y, row + 1.0);
            if (low < high) addInRow(row, xAt(low), xAt(high), sign * (high - low));
        }
    }

    // An edge from column position x to another one, over a height with its sign.
    void addInRow(int row, double x, double otherX, double height) {
        const double west = std::min(x, otherX), east = std::max(x, otherX);
        const int first = columnOf(west), last = columnOf(east);
        for (int column = first; column <= last; ++column) {
            const double from = column == first ? west : column, to = column == last ? east : column + 1.0;
            const double part = east > west ? height * (to - from) / (east - west) : height;
            addInCell(column, row, (from + to) / 2 - column, part);
        }
    }

    // West of the grid an edge covers whole cells, east of it none.
    void addInCell(int column, int row, double middle, double height) {
        if (column >= grid_.columns) return;
        const double right = column < 0 ? 1 : std::clamp(1 - middle, 0.0, 1.0);
        edges_.push_back({std::uint32_t(grid_.index(std::max(column, 0), row)), height * right, height});
    }

    [[nodiscard]] int columnOf(double x) const {
        return int(std::clamp(std::floor(x), -1.0, double(grid_.columns)));
    }

    const Grid& grid_;
    std::vector<CellEdge> edges_;
};

std::vector<CellEdge> collectEdges(const std::vector<Footprint>& polygons, const Grid& grid) {
    EdgeWalk walk(grid);
    for (const Footprint& polygon : polygons) {
        walk.add(polygon.outer, false);
        for (const Ring& hole : polygon.holes) walk.add(hole, true);
    }
    return walk.collect();
}

}  // namespace

std::vector<std::vector<Footprint>> findBuiltGround(std::span<const City* const> cities,
                                                    std::span<const Place> places) {
    std::vector<Box2> ofPlaces;
    for (const Place& place : places) ofPlaces.push_back(bounds(place));
    std::vector<std::vector<Footprint>> built(places.size());
    for (const City* city : cities) {
        std::vector<Box2> ofBuildings;
        for (const auto& building : city->buildings) ofBuildings.push_back(bounds(*building));
        for (const auto& [place, building] : findMeetingBoxes(ofPlaces, ofBuildings))
            addContacts(*city, *city->buildings[building], built[place]);
    }
    return built;
}

std::vector<Footprint> findOpenGround(const Place& place, const std::vector<Footprint>& built) {
    constexpr MinPiece any{1e-6, 0};
    if (built.empty()) return place.polygons;
    const std::vector<Footprint> within = selectMeeting(place.polygons, built);
    if (within.empty()) return place.polygons;
    auto open = cutPiecesOutside(place.polygons, within, any);
    // Nothing also where the overlay fails: then cells under buildings are left out by their centres alone.
    return open.empty() && area(within) < area(place.polygons) ? place.polygons : open;
}

std::vector<CellPart> listCellParts(const std::vector<Footprint>& polygons, const Grid& grid) {
    constexpr double rounding = 1e-6;  // what rounding leaves of a cell that an edge only touches
    std::vector<CellPart> parts;
    const auto add = [&](std::uint32_t cell, double share) {
        if (share > rounding) parts.push_back({cell, share > 1 - rounding ? 1 : share});
    };
    const std::vector<CellEdge> edges = collectEdges(polygons, grid);
    const auto columns = std::uint32_t(grid.columns);
    double covered = 0;  // of each cell up to the row's next edge
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const std::uint32_t cell = edges[i].cell, rowEnd = (cell / columns + 1) * columns;
        add(cell, covered + edges[i].right);
        covered += edges[i].height;
        const bool endsRow = i + 1 == edges.size() || edges[i + 1].cell >= rowEnd;
        const std::uint32_t end = endsRow ? rowEnd : edges[i + 1].cell;
        for (std::uint32_t between = cell + 1; covered > rounding && between < end; ++between)
            add(between, covered);
        if (endsRow) covered = 0;
    }
    return parts;
}

}  // namespace noonmark
