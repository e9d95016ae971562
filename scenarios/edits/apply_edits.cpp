#include "scenarios/edits/apply_edits.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "core/city/building_heights.h"
#include "core/city/terrain/building_ground.h"
#include "core/city/trees/tree_facts.h"
#include "core/describe/field_values.h"
#include "core/io/terrain/buildings_on_terrain.h"

namespace noonmark {

namespace {

std::vector<std::size_t> matching(const City& city, const std::string& text, std::string Building::*field) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < city.buildings.size(); ++i)
        if ((*city.buildings[i]).*field == text) found.push_back(i);
    return found;
}

// A building whose id or name begins like `text`; empty where none does.
std::string nearOne(const City& city, const std::string& text) {
    for (std::size_t letters = text.size(); letters >= 3; --letters)
        for (const auto& building : city.buildings)
            for (const std::string& word : {building->sourceId, building->name})
                if (word.starts_with(text.substr(0, letters))) return word;
    return {};
}

// Warnings about several files name a building after its file, "town.gpkg: feature 15"; in the project the
// second of an id is "feature 15 (2)". Empty for other texts.
std::vector<std::string> idsWithoutFile(const City& city, const std::string& text) {
    const std::size_t colon = text.find(": ");
    if (colon == text.npos) return {};
    const std::string id = text.substr(colon + 2);
    std::vector<std::string> ids;
    for (const auto& building : city.buildings)
        if (building->sourceId == id || building->sourceId.starts_with(id + " ("))
            ids.push_back(building->sourceId);
    return ids;
}

// As a project file holds it. volatile: GCC 12 leaves out both conversions where it vectorises a pair of
// them.
double roundToFloat(double value) {
    const volatile float rounded = float(value);
    return double(rounded);
}

// All cells of a canopy raster may have one id, so the last copy of each is remembered.
Trees withUniqueIds(Trees trees, const City& city) {
    std::unordered_set<std::string> used;
    std::unordered_map<std::string, int> copies;
    for (Tree& tree : trees.trees) {
        const std::string own = tree.sourceId.empty() ? "tree" : tree.sourceId;
        int& copy = copies.try_emplace(own, 1).first->second;
        std::string id = own;
        while (!used.insert(id).second) id = fmt::format("{} ({})", own, ++copy);
        tree.sourceId = std::move(id);
        tree.place = {roundToFloat(tree.place.x), roundToFloat(tree.place.y)};
        tree.groundM = groundAt(city, tree.place);
    }
    return trees;
}

}  // namespace

City makeIdsUnique(City city) {
    std::unordered_set<std::string> used;
    for (auto& building : city.buildings) {
        const std::string own = building->sourceId.empty() ? "building" : building->sourceId;
        std::string id = own;
        for (int copy = 2; !used.insert(id).second; ++copy) id = fmt::format("{} ({})", own, copy);
        if (id == building->sourceId) continue;
        Building renamed = *building;
        renamed.sourceId = id;
        building = std::make_shared<const Building>(std::move(renamed));
    }
    if (city.trees) city.trees = std::make_shared<const Trees>(withUniqueIds(*city.trees, city));
    return city;
}

Result<std::size_t> findTree(const City& city, const std::string& id) {
    if (!city.trees || city.trees->trees.empty())
        return failure("The city has no trees", id, "Read some: noonmark-cli project tree import");
    const std::vector<Tree>& trees = city.trees->trees;
    const auto found = std::ranges::find(trees, id, &Tree::sourceId);
    if (found == trees.end())
        return failure("There is no such tree", id, "Ids are listed by: noonmark-cli project tree list");
    return std::size_t(found - trees.begin());
}

Result<std::size_t> findBuilding(const City& city, const std::string& idOrName) {
    if (const auto byId = matching(city, idOrName, &Building::sourceId); byId.size() == 1)
        return byId.front();
    const auto byName = matching(city, idOrName, &Building::name);
    if (byName.size() == 1) return byName.front();
    const auto ofFile = byName.empty() ? idsWithoutFile(city, idOrName) : std::vector<std::string>();
    if (ofFile.size() == 1) return matching(city, ofFile.front(), &Building::sourceId).front();
    if (ofFile.size() > 1)
        return failure(fmt::format("{} buildings of several files have this id", ofFile.size()), idOrName,
                       fmt::format("Give one of: {}", fmt::join(ofFile, ", ")));
    if (byName.empty()) {
        const std::string near = nearOne(city, idOrName);
        return failure("There is no such building", idOrName,
                       near.empty() ? "Give the id or the name of a building of the scenario"
                                    : fmt::format("Did you mean '{}'?", near));
    }
    std::vector<std::string> ids;
    for (const std::size_t i : byName) ids.push_back(city.buildings[i]->sourceId);
    return failure(fmt::format("{} buildings have this name", ids.size()), idOrName,
                   fmt::format("Give an id: {}", fmt::join(ids, ", ")));
}

namespace {

using Shared = std::shared_ptr<const Building>;

double lowestGround(const Building& building, const City& city) {
    return city.terrain ? double(findLowestGround(building, *city.terrain)) : 0.0;
}

// A city while edits are applied to it; records which buildings were removed and added.
class CityInWork {
public:
    explicit CityInWork(const City& city) : edited_{city, {}} {}

    Result<void> operator()(const Demolish& edit) {
        return with(edit.building, [&](std::size_t i) -> Result<void> {
            take(buildings()[i]);
            buildings().erase(buildings().begin() + std::ptrdiff_t(i));
            return {};
        });
    }

    Result<void> operator()(const Replace& edit) {
        return with(edit.building, [&](std::size_t i) {
            return fresh(*edit.with, edit.building).map([&](Building building) {
                put(i, std::move(building));
            });
        });
    }

    Result<void> operator()(const AddBuilding& edit) { return add(*edit.building); }

    Result<void> operator()(const ImportMesh& edit) {
        const double scale = edit.placement.scale;
        if (!(scale >= 0.001 && scale <= 1000))
            return failure(fmt::format("A mesh cannot be scaled by {:g}", scale), edit.file,
                           "Give a scale of 0.001 to 1000");
        const Building there = placeBuilding(*edit.shape, edit.placement);
        if (double(topM(there)) > tallestBuildingM)
            return failure(fmt::format("The building would be {:.0f} m high", topM(there)), edit.file,
                           fmt::format("Give a smaller scale: at most {:g} m are allowed", tallestBuildingM));
        return add(there);
    }

    Result<void> operator()(const ChangeHeight& edit) {
        return with(edit.building, [&](std::size_t i) {
            const Building& old = *buildings()[i];
            return withHeight(old, double(findGroundUnder(old, edited_.city)), edit.heightM)
                .map([&](Building building) { put(i, std::move(building)); });
        });
    }

    Result<void> operator()(const Move& edit) { return relocate(edit.building, {.byM = edit.byM}); }

    Result<void> operator()(const Rotate& edit) {
        return with(edit.building, [&](std::size_t i) {
            return relocate(edit.building,
                            {.about = findMiddle(*buildings()[i]), .clockwiseDeg = edit.clockwiseDeg});
        });
    }

    Result<void> operator()(const PlantTree& edit) {
        if (edit.tree.sourceId.empty()) return failure("The new tree has no id", edit.tree.species);
        if (findTree(edit.tree.sourceId) != nullptr)
            return failure("Another tree has this id", edit.tree.sourceId, "Choose another one");
        return onGround(edit.tree).map([&](Tree tree) {
            treeOfId_[tree.sourceId] = trees().size();
            trees().push_back(std::move(tree));
        });
    }

    Result<void> operator()(const FellTree& edit) {
        return withTree(edit.tree, [&](Tree& tree) -> Result<void> {
            felled_.insert(std::size_t(&tree - trees().data()));
            treeOfId_.erase(edit.tree);
            return {};
        });
    }

    Result<void> operator()(const ReplaceTree& edit) {
        return change(edit.tree, [&](Tree& tree) {
            Tree with = edit.with;
            with.sourceId = tree.sourceId;
            with.place = tree.place;
            tree = std::move(with);
        });
    }

    Result<void> operator()(const MoveTree& edit) {
        return change(edit.tree, [&](Tree& tree) { tree.place += edit.byM; });
    }

    Result<void> operator()(const GrowTree& edit) {
        return change(edit.tree, [&](Tree& tree) {
            tree.heightM = float(edit.heightM);
            tree.crownBaseM = float(edit.crownBaseM);
            tree.crownDiameterM = float(edit.crownDiameterM);
            tree.heightSource = tree.crownSource = TreeSource::estimated;
        });
    }

    EditedCity take() && {
        if (!felled_.empty()) {
            std::size_t at = 0;
            std::erase_if(trees(), [&](const Tree&) { return felled_.contains(at++); });
        }
        if (trees_ && trees_->trees.empty()) edited_.city.trees.reset();
        if (trees_ && !trees_->trees.empty())
            edited_.city.trees = std::make_shared<const Trees>(*std::move(trees_));
        return std::move(edited_);
    }

private:
    // Copied before the first edit of a tree. Felled ones stay until take(), so that positions hold.
    std::vector<Tree>& trees() {
        if (trees_) return trees_->trees;
        const City& city = edited_.city;
        trees_ = city.trees ? *city.trees
                            : Trees{.trees = {}, .leafDays = assumeLeafDays(city.frame.origin().latDeg)};
        for (std::size_t i = 0; i < trees_->trees.size(); ++i)
            treeOfId_.emplace(trees_->trees[i].sourceId, i);
        return trees_->trees;
    }

    Tree* findTree(const std::string& id) {
        std::vector<Tree>& all = trees();
        const auto found = treeOfId_.find(id);
        return found == treeOfId_.end() ? nullptr : &all[found->second];
    }

    template <class Change>
    Result<void> withTree(const std::string& id, Change&& change) {
        Tree* const found = findTree(id);
        if (found == nullptr)
            return failure("There is no such tree", id, "It may have been felled by an earlier edit");
        return change(*found);
    }

    template <class Change>
    Result<void> change(const std::string& id, Change&& how) {
        return withTree(id, [&](Tree& tree) {
            Tree changed = tree;
            how(changed);
            return onGround(std::move(changed)).map([&](Tree there) { tree = std::move(there); });
        });
    }

    // Error: measures that no tree has.
    [[nodiscard]] Result<Tree> onGround(Tree tree) const {
        const std::span<const Field> measures = treeFactFields().rows();
        if (!isPlausibleTreeHeight(double(tree.heightM)) || !isPlausibleCrown(double(tree.crownDiameterM)))
            return failure(fmt::format("A tree cannot be {:g} m high with a crown {:g} m wide", tree.heightM,
                                       tree.crownDiameterM),
                           tree.sourceId,
                           fmt::format("Give a height of {} and a crown of {}",
                                       rangeText(fieldWithKey(measures, "height_m")),
                                       rangeText(fieldWithKey(measures, "crown_diameter_m"))));
        if (!(tree.crownBaseM >= 0 && tree.crownBaseM < tree.heightM))
            return failure("The crown's base lies above the tree's top", tree.sourceId,
                           "Give a base of 0 m or more, below the height");
        if (!(std::abs(tree.place.x) <= 1e6 && std::abs(tree.place.y) <= 1e6))
            return failure("The tree stands too far away", tree.sourceId, "Give a place in the city");
        tree.groundM = groundAt(edited_.city, tree.place);
        return tree;
    }

    std::vector<Shared>& buildings() { return edited_.city.buildings; }

    template <class Change>
    Result<void> with(const std::string& id, Change&& change) {
        const auto is = [&](const Shared& building) { return building->sourceId == id; };
        const auto found = std::ranges::find_if(buildings(), is);
        if (found == buildings().end())
            return failure("There is no such building", id, "It may have been demolished by an earlier edit");
        if (std::find_if(found + 1, buildings().end(), is) != buildings().end())
            return failure("Two buildings have this id", id, "Give every building a unique id");
        return change(std::size_t(found - buildings().begin()));
    }

    // A copy of `shape` on its ground. `leaving`: the id that the edit frees.
    Result<Building> fresh(const Building& shape, const std::string& leaving) {
        if (shape.parts.empty()) return failure("The new building has no parts", shape.sourceId);
        if (shape.sourceId.empty()) return failure("The new building has no id", shape.name);
        const auto clashes = [&](const Shared& other) {
            return other->sourceId == shape.sourceId && other->sourceId != leaving;
        };
        if (std::ranges::any_of(buildings(), clashes))
            return failure("Another building has this id", shape.sourceId, "Choose another name");
        return liftBuilding(shape, lowestGround(shape, edited_.city));
    }

    Result<void> add(const Building& shape) {
        return fresh(shape, {}).map([&](Building building) {
            buildings().push_back(std::make_shared<const Building>(std::move(building)));
            edited_.changes.added.push_back(buildings().back());
        });
    }

    Result<void> relocate(const std::string& id, const Placement& placement) {
        const auto finite = [](double value) { return std::abs(value) <= 1e6; };
        if (!finite(placement.byM.x) || !finite(placement.byM.y) || !finite(placement.clockwiseDeg))
            return failure("The building cannot be moved or turned that far", id,
                           "Give at most 1,000,000 metres or degrees");
        return with(id, [&](std::size_t i) -> Result<void> {
            const Building& old = *buildings()[i];
            const Building there = placeBuilding(old, placement);
            const City& city = edited_.city;
            put(i, liftBuilding(there, lowestGround(there, city) - lowestGround(old, city)));
            return {};
        });
    }

    void put(std::size_t i, Building building) {
        take(buildings()[i]);
        buildings()[i] = std::make_shared<const Building>(std::move(building));
        edited_.changes.added.push_back(buildings()[i]);
    }

    void take(const Shared& building) {
        if (std::erase(edited_.changes.added, building) == 0) edited_.changes.removed.push_back(building);
    }

    EditedCity edited_;
    std::optional<Trees> trees_;  // of the city, once an edit changes them
    std::unordered_map<std::string, std::size_t> treeOfId_;
    std::unordered_set<std::size_t> felled_;
};

}  // namespace

Result<EditedCity> applyEdits(const City& city, std::span<const Edit> edits) {
    CityInWork work(city);
    for (std::size_t i = 0; i < edits.size(); ++i)
        if (const auto done = std::visit(work, edits[i]); !done)
            return failure(done.error().what,
                           fmt::format("edit {} ({}): {}", i + 1, formatText(edits[i]), done.error().where),
                           done.error().advice);
    return std::move(work).take();
}

ChangedVolume computeVolume(const CityChanges& changes) {
    ChangedVolume volume;
    for (const auto* list : {&changes.removed, &changes.added})
        for (const auto& building : *list) {
            volume.box.add(bounds(*building));
            volume.topM = std::max(volume.topM, topM(*building));
        }
    return volume;
}

}  // namespace noonmark
