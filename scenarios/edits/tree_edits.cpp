#include "scenarios/edits/tree_edits.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <set>

namespace noonmark {

Result<Tree> designTree(const TreeFacts& facts) {
    Tree tree = completeTree(facts);
    if (facts.crownBaseM && *facts.crownBaseM >= double(tree.heightM))
        return failure("The crown's base lies above the tree's top", fmt::format("{:g} m", *facts.crownBaseM),
                       fmt::format("Give a base below {:g} m", tree.heightM));
    if (facts.heightM) tree.heightSource = TreeSource::designed;
    if (facts.crownDiameterM) tree.crownSource = TreeSource::designed;
    return tree;
}

Result<std::vector<glm::dvec2>> placeTreesAlong(const std::vector<glm::dvec2>& line, double spacingM) {
    if (line.size() < 2)
        return failure("A row needs two corners or more", "the row of trees",
                       "Give its beginning and its end");
    std::vector<glm::dvec2> places;
    double nextM = 0;  // from the current corner
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double lengthM = glm::distance(line[i - 1], line[i]);
        if (double(places.size()) + lengthM / spacingM + 1 > double(maxTreeRow))
            return failure(fmt::format("The row would have more than {} trees", maxTreeRow),
                           "the row of trees", "Give a larger spacing");
        for (; nextM <= lengthM + 1e-6 && lengthM > 0; nextM += spacingM)
            places.push_back(line[i - 1] + (line[i] - line[i - 1]) * (nextM / lengthM));
        nextM -= lengthM;
    }
    return places;
}

std::vector<Edit> makePlantings(const City& city, const Tree& tree, const std::vector<glm::dvec2>& places) {
    std::set<std::string> taken;
    if (city.trees)
        for (const Tree& one : city.trees->trees) taken.insert(one.sourceId);
    std::vector<Edit> edits;
    int number = 1;
    for (const glm::dvec2 place : places) {
        Tree planted = tree;
        planted.place = place;
        do planted.sourceId = fmt::format("planted {}", number++);
        while (taken.contains(planted.sourceId));
        edits.emplace_back(PlantTree{std::move(planted)});
    }
    return edits;
}

std::optional<Edit> makeGrowth(const Tree& tree, double years) {
    const Tree grown = growTree(tree, years);
    if (grown == tree) return std::nullopt;
    return GrowTree{tree.sourceId, years, double(grown.heightM), double(grown.crownBaseM),
                    double(grown.crownDiameterM)};
}

}  // namespace noonmark
