#include "scenarios/massing/tower_design.h"

#include <algorithm>

#include "core/city/terrain/building_ground.h"

namespace noonmark {

namespace {

class TowersInWork {
public:
    void operator()(const Demolish& edit) { towers_.erase(edit.building); }
    void operator()(const Replace& edit) {
        towers_.erase(edit.building);
        add(*edit.with, edit.design);
    }
    void operator()(const AddBuilding& edit) { add(*edit.building, edit.design); }
    void operator()(const ImportMesh& edit) { towers_[edit.shape->sourceId] = {{}, edit.storeyHeightM}; }
    void operator()(const ChangeHeight& edit) {
        const auto found = towers_.find(edit.building);
        if (found == towers_.end()) return;
        found->second.changed = true;
        found->second.heightM = edit.heightM;
    }
    template <class Change>
    requires requires(const Change& edit) { edit.building; }
    void operator()(const Change& edit) {
        if (const auto found = towers_.find(edit.building); found != towers_.end())
            found->second.changed = true;
    }

    template <class OfTree>
    void operator()(const OfTree&) {}

    std::map<std::string, ProposedTower> take() && { return std::move(towers_); }

private:
    void add(const Building& building, const DesignOfShape& design) {
        towers_[building.sourceId] = {design, design ? design->settings.storeyHeightM : 0};
    }

    std::map<std::string, ProposedTower> towers_;
};

}  // namespace

std::map<std::string, ProposedTower> findProposedTowers(std::span<const Edit> edits) {
    TowersInWork work;
    for (const Edit& edit : edits) std::visit(work, edit);
    return std::move(work).take();
}

Result<std::set<std::string>> listProposed(const std::vector<Scenario>& scenarios, const std::string& name) {
    return collectEdits(scenarios, name).map([](const std::vector<Edit>& edits) {
        std::set<std::string> ids;
        for (const auto& [id, tower] : findProposedTowers(edits)) ids.insert(id);
        return ids;
    });
}

namespace {

bool isUpright(const MassingSettings& settings) {
    const auto upright = [](const Setback& setback) { return setback.walls.upright(); };
    return settings.walls.upright() && (!settings.podium || settings.podium->walls.upright()) &&
           std::ranges::all_of(settings.setbacks, upright);
}

}  // namespace

std::optional<MassingFigures> figuresOf(const ProposedTower& tower) {
    if (!tower.design) return std::nullopt;
    MassingSettings settings = tower.design->settings;
    if (tower.heightM > 0 && (!isUpright(settings) || !settings.further.empty())) return std::nullopt;
    if (tower.heightM > 0) settings = withHeight(settings, tower.heightM);
    const auto massing = makeMassing(tower.design->lot, settings);
    return massing ? std::optional(massing->figures) : std::nullopt;
}

namespace {

// A tower without uses is one use without a name. Nothing where the floors are not known.
std::optional<std::vector<UseArea>> usesOf(const ProposedTower& tower) {
    const auto figures = figuresOf(tower);
    if (!figures) return std::nullopt;
    if (!figures->uses.empty()) return figures->uses;
    return std::vector<UseArea>{{{}, figures->storeys, figures->grossFloorM2}};
}

void addTo(std::map<std::string, UseArea>& sums, const UseArea& area) {
    UseArea& sum = sums[area.use];
    sum.use = area.use;
    sum.storeys += area.storeys;
    sum.grossFloorM2 += area.grossFloorM2;
}

}  // namespace

ScenarioUses sumUses(std::span<const Edit> edits) {
    ScenarioUses uses;
    std::map<std::string, UseArea> sums;
    for (const auto& [id, tower] : findProposedTowers(edits)) {
        const auto areas = usesOf(tower);
        uses.towersNotCounted += areas ? 0 : 1;
        for (const UseArea& area : areas.value_or(std::vector<UseArea>())) addTo(sums, area);
    }
    for (const auto& [name, area] : sums) uses.areas.push_back(area);
    std::stable_partition(uses.areas.begin(), uses.areas.end(),
                          [](const UseArea& area) { return !area.use.empty(); });
    return uses;
}

std::optional<double> sumFloorAreaM2(const ScenarioUses& uses) {
    if (uses.areas.empty()) return std::nullopt;
    double sumM2 = 0;
    for (const UseArea& area : uses.areas) sumM2 += area.grossFloorM2;
    return sumM2;
}

std::optional<double> findProposedHeightM(const City& city, std::span<const Edit> edits) {
    const auto towers = findProposedTowers(edits);
    std::optional<double> highestM;
    for (const auto& building : city.buildings)
        if (towers.contains(building->sourceId))
            highestM = std::max(highestM.value_or(0), double(heightM(*building, city)));
    return highestM;
}

}  // namespace noonmark
