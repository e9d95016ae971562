#include "core/io/trees/read_trees.h"

#include <fmt/format.h>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <utility>

#include "core/describe/text.h"

namespace noonmark {

namespace {

constexpr double sameTreeM = 0.5;

/// Finds trees that are there twice, by squares as wide as the distance.
class PlantedPlaces {
public:
    /// False if a tree stands there already.
    bool plant(glm::dvec2 place) {
        if (isPlanted(place)) return false;
        placeOfSquare_.emplace(keyOf(squareOf(place.x), squareOf(place.y)), place);
        return true;
    }
    [[nodiscard]] bool isPlanted(glm::dvec2 place) const {
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t j = -1; j <= 1; ++j)
                for (auto [at, end] =
                         placeOfSquare_.equal_range(keyOf(squareOf(place.x) + i, squareOf(place.y) + j));
                     at != end; ++at)
                    if (glm::distance(at->second, place) < sameTreeM) return true;
        return false;
    }

private:
    static std::int64_t squareOf(double metres) { return std::int64_t(std::floor(metres / sameTreeM)); }
    static std::uint64_t keyOf(std::int64_t column, std::int64_t row) {
        return std::uint64_t(column) << 32U ^ (std::uint64_t(row) & 0xFFFFFFFFU);
    }
    std::unordered_multimap<std::uint64_t, glm::dvec2> placeOfSquare_;
};

glm::dvec2 findMiddle(const City& city) {
    const Box2 box = bounds(city);
    return box.empty() ? glm::dvec2(0) : glm::dvec2(box.low + box.high) / 2.0;
}

}  // namespace

std::shared_ptr<const Trees> joinTrees(const std::vector<ReadTree>& read, const City& city, double farAwayM,
                                       Warnings& warnings) {
    Trees all =
        city.trees ? *city.trees : Trees{.trees = {}, .leafDays = assumeLeafDays(city.frame.origin().latDeg)};
    // Cells of a canopy raster stand beside trees, and closer to each other than trees do: they are compared
    // with the cells of an earlier reading only.
    PlantedPlaces planted, canopy;
    for (const Tree& tree : all.trees)
        (tree.shape == CrownShape::cylinder ? canopy : planted).plant(tree.place);
    const glm::dvec2 middle = findMiddle(city);
    for (const ReadTree& one : read) {
        const glm::dvec2 place = city.frame.localFromLonLat(one.place);
        if (!(glm::distance(place, middle) <= farAwayM)) {
            const LonLat swapped{one.place.latDeg, one.place.lonDeg};
            const bool areSwapped = std::abs(swapped.latDeg) <= 90 &&
                                    glm::distance(city.frame.localFromLonLat(swapped), middle) <= farAwayM;
            warnings.push_back(
                {WarningKind::leftOut,
                 areSwapped ? NM_TEXT("a tree far from the buildings: its longitude and latitude are swapped")
                            : NM_TEXT("a tree far from the buildings"),
                 one.facts.sourceId});
            continue;
        }
        if (one.facts.canopyCellM2 ? canopy.isPlanted(place) : !planted.plant(place)) {
            warnings.push_back(
                {WarningKind::leftOut, NM_TEXT("a second tree at the same place"), one.facts.sourceId});
            continue;
        }
        Tree tree = completeTree(one.facts);
        tree.place = place;
        tree.groundM = groundAt(city, place);
        all.trees.push_back(std::move(tree));
    }
    if (all.trees.empty()) return nullptr;
    return std::make_shared<const Trees>(std::move(all));
}

}  // namespace noonmark
