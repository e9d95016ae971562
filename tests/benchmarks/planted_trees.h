#pragma once

#include <array>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "core/city/trees/tree_facts.h"
#include "tests/benchmarks/bench_scene.h"

/// Made inventories of trees.
namespace noonmark::bench {

inline Receivers findSquare(const City& city, double sideM) {
    const Box2 box = bounds(city);
    const glm::vec2 middle = (box.low + box.high) * 0.5F, half(float(sideM / 2));
    return taken(placeReceiversOnGround(city, makeRegionFromLocalBox({middle - half, middle + half}), {}));
}

/// As an inventory of New York has them: stems of 3 to 30 inches, planes and honey locusts above all.
inline TreeFacts makeFacts(std::mt19937& random) {
    constexpr std::array species{
        "Platanus x acerifolia", "Gleditsia triacanthos", "Pyrus calleryana", "Quercus palustris",
        "Tilia cordata",         "Ginkgo biloba",         "Pinus strobus",    "Acer rubrum"};
    std::uniform_real_distribution<double> inches(3, 30);
    return {.species = species[random() % species.size()], .stemDiameterM = inches(random) * 0.0254};
}

/// Trees on open ground, drawn at random.
inline std::vector<Tree> plantOnGround(const City& city, const Receivers& ground, std::size_t count,
                                       std::mt19937& random) {
    std::vector<Tree> trees;
    while (trees.size() < count) {
        const std::uint32_t cell = ground.cells[random() % ground.cells.size()];
        Tree tree = completeTree(makeFacts(random));
        tree.place = glm::dvec2(ground.position(cell));
        tree.groundM = groundAt(city, tree.place);
        trees.push_back(std::move(tree));
    }
    return trees;
}

inline City withTrees(City city, std::vector<Tree> trees) {
    city.trees = std::make_shared<const Trees>(
        Trees{std::move(trees), assumeLeafDays(city.frame.origin().latDeg), true});
    return city;
}

}  // namespace noonmark::bench
