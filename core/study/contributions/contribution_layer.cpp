#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "core/city/trees/tree.h"
#include "core/study/contributions/place_contributions.h"

namespace noonmark {

namespace {

constexpr int crownCorners = 32;

Place outlineOf(const Building& building) {
    Place outline;
    for (const Part& part : building.parts) outline.polygons.push_back(part.footprint);
    return outline;
}

Place outlineOf(const Tree& tree) {
    Footprint circle;
    for (int i = 0; i < crownCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / crownCorners;
        circle.outer.emplace_back(tree.place + 0.5 * double(tree.crownDiameterM) *
                                                   glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    Place outline;
    outline.polygons.push_back(std::move(circle));
    return outline;
}

void addTexts(ElementTable& table, std::initializer_list<const char*> names) {
    for (const char* name : names) table.columns.push_back({name, std::string()});
}

void addNumbers(ElementTable& table, std::span<const Figure> figures) {
    for (const Figure& figure : figures)
        if (figure.inFiles) table.columns.push_back({std::string(figure.key), 0.0, figure.decimals});
}

// Null: none of them.
void addValues(std::vector<ElementValue>& row, std::span<const Figure> figures, const Contribution* of) {
    for (const Figure& figure : figures)
        if (figure.inFiles)
            row.emplace_back(of != nullptr ? figure.get(of) : std::numeric_limits<double>::quiet_NaN());
}

const Contribution* findOf(const TreeContribution* tree, TreeColumns column) {
    if (tree == nullptr) return nullptr;
    for (const auto& [of, one] : tree->columns)
        if (of == column) return &one;
    return nullptr;
}

// The columns that any of the trees has, evergreens first.
std::vector<TreeColumns> listColumnsOf(const std::vector<TreeContribution>& trees) {
    std::vector<TreeColumns> columns;
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
        if (std::ranges::any_of(trees, [&](const auto& tree) { return findOf(&tree, column) != nullptr; }))
            columns.push_back(column);
    return columns;
}

/// The buildings and trees of a city by their ids in the data.
struct ById {
    std::map<std::string, const Building*> buildings;
    std::map<std::string, const Tree*> trees;
    explicit ById(const City& city) {
        for (const auto& building : city.buildings) buildings.emplace(building->sourceId, building.get());
        if (!city.trees) return;
        for (const Tree& tree : city.trees->trees) trees.emplace(tree.sourceId, &tree);
    }
};

/// Builds the layer of several places.
class PlaceLayer {
public:
    PlaceLayer(const std::vector<ContributionTable>& all, const City& city) : byId_(city) {
        std::vector<TreeContribution> trees;
        for (const ContributionTable& of : all) trees.insert(trees.end(), of.trees.begin(), of.trees.end());
        columns_ = listColumnsOf(trees);
        addTexts(layer_.table, {"place", "kind", "period", "what", "source_id", "name"});
        addNumbers(layer_.table, contributionFigures().rows());
        for (const TreeColumns column : columns_)
            addNumbers(layer_.table, contributionFiguresWithTrees(column));
        layer_.style = contributionStyle();
        for (const ContributionTable& of : all) add(of);
    }
    [[nodiscard]] ContributionLayer take() { return std::move(layer_); }

private:
    void add(const ContributionTable& of) {
        for (const Contribution& row : of.rows)
            if (const auto found = byId_.buildings.find(row.id); found != byId_.buildings.end())
                add(of, outlineOf(*found->second), row, nullptr);
        const TreeColumns ranked = chooseRankedColumn(of.trees, TreeColumns::seasonal);
        for (const TreeContribution& tree : of.trees)
            if (const Contribution* const row = findOf(&tree, ranked))
                if (const auto found = byId_.trees.find(row->id); found != byId_.trees.end())
                    add(of, outlineOf(*found->second), *row, &tree);
    }
    void add(const ContributionTable& of, Place outline, const Contribution& row,
             const TreeContribution* tree) {
        layer_.outlines.push_back(std::move(outline));
        std::vector<ElementValue>& values = layer_.table.rows.emplace_back();
        for (const std::string& text : {of.place, of.kind, of.period.words,
                                        std::string(tree != nullptr ? "tree" : "building"), row.id, row.name})
            values.emplace_back(text);
        addValues(values, contributionFigures().rows(), &row);
        for (const TreeColumns column : columns_)
            addValues(values, contributionFiguresWithTrees(column), findOf(tree, column));
    }

    ById byId_;
    std::vector<TreeColumns> columns_;
    ContributionLayer layer_;
};

}  // namespace

ContributionLayer makeContributionLayer(const std::vector<ContributionTable>& all, const City& city) {
    return PlaceLayer(all, city).take();
}

ContributionLayer makeTreeLayer(const std::vector<TreeContribution>& rows, const City& city) {
    ContributionLayer layer;
    const std::vector<TreeColumns> columns = listColumnsOf(rows);
    addTexts(layer.table, {"source_id", "species"});
    for (const char* name : {"height_m", "crown_m"}) layer.table.columns.push_back({name, 0.0});
    for (const TreeColumns column : columns) addNumbers(layer.table, contributionFiguresWithTrees(column));
    layer.style = contributionStyle("share" + suffixOf(chooseRankedColumn(rows, TreeColumns::seasonal)));
    for (const TreeContribution& row : rows) {
        const Tree& tree = city.trees->trees[row.tree];
        layer.outlines.push_back(outlineOf(tree));
        std::vector<ElementValue>& values = layer.table.rows.emplace_back();
        values = {tree.sourceId, tree.species, double(tree.heightM), double(tree.crownDiameterM)};
        for (const TreeColumns column : columns)
            addValues(values, contributionFiguresWithTrees(column), findOf(&row, column));
    }
    return layer;
}

}  // namespace noonmark
