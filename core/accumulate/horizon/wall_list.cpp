#include "core/accumulate/horizon/wall_list.h"

#include <fmt/format.h>

#include <glm/common.hpp>

namespace noonmark {

namespace {

class WallBuilder {
public:
    WallBuilder(const Grid& grid, WallList& list) : grid_(grid), list_(list) {}

    void add(const Part& part, std::uint32_t building) {
        StandingPrism prism{.firstWall = std::uint32_t(list_.walls.size()),
                            .topM = part.topM,
                            .building = building,
                            .low = glm::dvec2(1e30),
                            .high = glm::dvec2(-1e30)};
        addRing(part.footprint.outer, prism);
        for (const Ring& hole : part.footprint.holes) addRing(hole, prism);
        prism.wallCount = std::uint32_t(list_.walls.size()) - prism.firstWall;
        list_.prisms.push_back(prism);
    }

private:
    void addRing(const Ring& ring, StandingPrism& prism) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 a = cellsFromLocal(ring[i]);
            list_.walls.push_back({a, cellsFromLocal(ring[(i + 1) % ring.size()])});
            prism.low = glm::min(prism.low, a);
            prism.high = glm::max(prism.high, a);
        }
    }

    [[nodiscard]] glm::dvec2 cellsFromLocal(glm::vec2 local) const {
        return {(double(local.x) - grid_.westM) / grid_.cellM - 0.5,
                (double(local.y) - grid_.southM) / grid_.cellM - 0.5};
    }

    const Grid& grid_;
    WallList& list_;
};

tl::unexpected<Error> notStanding(const Building& building, const Part& part, std::string_view why) {
    const std::string& where = part.sourceId.empty() ? building.sourceId : part.sourceId;
    return failure(
        fmt::format("The horizon sweep takes prisms that stand on the ground, and a part in reach {}", why),
        where, "Choose projected shadows or the ray reference");
}

}  // namespace

Result<void> addStandingWalls(const Building& building, std::uint32_t number, const Grid& grid,
                              WallList& list, OpenParts* open) {
    WallBuilder builder(grid, list);
    for (const Part& part : building.parts) {
        if (part.topM <= 0) continue;
        if (open != nullptr && (part.mesh || part.hangs)) {
            open->push_back(&part);
            continue;
        }
        if (part.mesh) return notStanding(building, part, "is a general mesh");
        if (part.hangs) return notStanding(building, part, "has open air below it");
        builder.add(part, number);
    }
    return {};
}

Result<WallList> standingWalls(const City& city, std::span<const std::uint32_t> buildings, const Grid& grid,
                               OpenParts* open) {
    WallList list;
    for (const std::uint32_t index : buildings)
        if (const auto added = addStandingWalls(*city.buildings[index], index, grid, list, open); !added)
            return tl::make_unexpected(added.error());
    return list;
}

}  // namespace noonmark
