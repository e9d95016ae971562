#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "core/city/city.h"
#include "scenarios/edits/edit.h"
#include "scenarios/massing/massing.h"
#include "scenarios/scenario.h"

namespace noonmark {

/// How a tower was designed: the lot as it was then, and the massing on it. Saved with the edit that builds
/// the tower.
struct TowerDesign {
    std::string lotName;
    Footprint lot;
    MassingSettings settings;
    bool operator==(const TowerDesign&) const = default;
};

/// What is known about a building that a scenario added.
struct ProposedTower {
    DesignOfShape design;      ///< null: not designed here
    double storeyHeightM = 0;  ///< 2 to 10; 0: not known
    bool changed = false;      ///< since it was built: moved, turned, or made higher or lower
    double heightM = 0;        ///< after the last change of its height, above its ground; 0: as designed
};

/// The ids of the buildings that a scenario proposes; none of the existing city. Error: as of
/// collectEdits().
Result<std::set<std::string>> listProposed(const std::vector<Scenario>& scenarios, const std::string& name);

/// The figures of a tower's design at its present height; none: it has no design, or one that no longer
/// describes its floors: leaning walls that a change of height stretched, a setback cut off, or several
/// towers. Some ms.
std::optional<MassingFigures> figuresOf(const ProposedTower& tower);

/// The proposed buildings after all edits of a scenario (collectEdits()), by id. A building
/// that was demolished or replaced later is not among them. O(edits).
std::map<std::string, ProposedTower> findProposedTowers(std::span<const Edit> edits);

/// The gross floor area of a scenario's towers by use.
struct ScenarioUses {
    std::vector<UseArea> areas;  ///< by name of the use, that without a name last; storeys of all towers
    int towersNotCounted = 0;    ///< proposed buildings without figuresOf(): meshes, some changed heights
    bool operator==(const ScenarioUses&) const = default;
};

/// Sums the designs of the scenario's towers; a tower without uses counts as not stated. Some ms per tower.
ScenarioUses sumUses(std::span<const Edit> edits);

/// Gross floor area of all uses, m2; none: no tower whose floors are known.
std::optional<double> sumFloorAreaM2(const ScenarioUses& uses);

/// The greatest height above its ground of the buildings that the edits add, metres; none: they add none.
/// `city`: after the edits. O(buildings).
std::optional<double> findProposedHeightM(const City& city, std::span<const Edit> edits);

}  // namespace noonmark
